#include "core/segment/registry.h"

#include <array>

#include "core/segment/growth/mcgim.h"
#include "core/segment/growth/vsa.h"
#include "core/segment/t_flooding.h"

namespace chartflood {

std::span<const Segmenter> segmenterTable() {
  static const std::array<Segmenter, 3> table = {{
      {"t-flooding", "t-flooding",
       "Yamauchi, Gumhold, Zayer, Seidel: Mesh segmentation driven by Gaussian curvature, 2005",
       makeTFlooding},
      {"vsa", "Variational shape approximation",
       "Cohen-Steiner, Alliez, Desbrun: Variational shape approximation, 2004", makeVsa},
      {"mcgim", "Multi-chart geometry images",
       "Sander, Wood, Gortler, Snyder, Hoppe: Multi-chart geometry images, 2003", makeMcgim},
  }};
  return table;
}

const Segmenter* findSegmenter(std::string_view id) {
  for (const Segmenter& segmenter : segmenterTable()) {
    if (id == segmenter.id) return &segmenter;
  }
  return nullptr;
}

}  // namespace chartflood
