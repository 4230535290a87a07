#include "core/segment/registry.h"

#include <array>

#include "core/base/check.h"
#include "core/segment/growth/mcgim.h"
#include "core/segment/growth/vsa.h"
#include "core/segment/t_flooding.h"

namespace chartflood {

std::span<const Segmenter> segmenterTable() {
  static const std::array<Segmenter, 3> table = {{
      {.id = "t-flooding",
       .title = "T-flooding",
       .shortTitle = "t-flooding",
       .reference = "Yamauchi, Gumhold, Zayer, Seidel: Mesh segmentation driven by Gaussian "
                    "curvature, 2005",
       .make = makeTFlooding,
       .beginsWithAllSeeds = true,
       .balances = true,
       .knowsCreases = true,
       .knowsFast = true,
       .refinesByDefault = true},
      {.id = "vsa",
       .title = "Variational shape approximation",
       .shortTitle = "VSA",
       .reference = "Cohen-Steiner, Alliez, Desbrun: Variational shape approximation, 2004",
       .make = makeVsa,
       .noCycles = "Variational shape approximation stops where it fits no better."},
      {.id = "mcgim",
       .title = "Multi-chart geometry images",
       .shortTitle = "MCGIM",
       .reference = "Sander, Wood, Gortler, Snyder, Hoppe: Multi-chart geometry images, 2003",
       .make = makeMcgim},
  }};
  return table;
}

const Segmenter* findSegmenter(std::string_view id) {
  for (const Segmenter& segmenter : segmenterTable()) {
    if (id == segmenter.id) return &segmenter;
  }
  return nullptr;
}

const Segmenter& segmenterOf(std::string_view id) {
  const Segmenter* segmenter = findSegmenter(id);
  CF_CHECK(segmenter != nullptr);
  return *segmenter;
}

std::vector<const char*> comparedMethods() {
  std::vector<const char*> ids;
  for (const Segmenter& segmenter : segmenterTable()) ids.insert(ids.begin(), segmenter.id);
  return ids;
}

}  // namespace chartflood
