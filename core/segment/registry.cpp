#include "core/segment/registry.h"

#include <array>

#include "core/segment/t_flooding.h"

namespace chartflood {

std::span<const Segmenter> segmenterTable() {
  static const std::array<Segmenter, 1> table = {{
      {"t-flooding", "t-flooding",
       "Yamauchi, Gumhold, Zayer, Seidel: Mesh segmentation driven by Gaussian curvature, 2005",
       makeTFlooding},
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
