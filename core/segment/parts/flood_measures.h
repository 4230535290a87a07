#pragma once
/// What the areas of a flood are counted from: Gauss areas and surfaces of single faces in whole
/// units, whose sums do not depend on their order.

#include <cmath>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/model/gauss_area.h"
#include "core/model/mesh.h"

namespace chartflood {

/// Never changes, so that threads can share it. Gauss areas are in units of 2^-40 sr, surfaces in
/// 2^-50 of the whole surface.
class FloodMeasures {
 public:
  /// A sharp edge of a face, or one of its corners.
  struct Element {
    std::int64_t area = 0;
    Index across = kNone;  ///< face across the edge; kNone: a corner
    Index vertex = kNone;  ///< of a corner
  };

  /// Cost: linear.
  FloodMeasures(std::shared_ptr<const Mesh> mesh, std::shared_ptr<const GaussArea> gauss);

  const Mesh& mesh() const { return *mesh_; }
  const std::shared_ptr<const GaussArea>& gaussArea() const { return gauss_; }
  std::int64_t area(Index face) const { return area_[face]; }
  std::int64_t surface(Index face) const { return surface_[face]; }
  std::span<const Element> elements(Index face) const {
    return std::span(elements_).subspan(first_[face], first_[face + 1] - first_[face]);
  }
  double steradians(std::int64_t area) const { return std::ldexp(static_cast<double>(area), -40); }
  /// Model units.
  double surfaceArea(std::int64_t surface) const {
    return static_cast<double>(surface) * surfaceUnit_;
  }

 private:
  std::shared_ptr<const Mesh> mesh_;
  std::shared_ptr<const GaussArea> gauss_;
  double surfaceUnit_ = 1;
  std::vector<std::int64_t> area_, surface_;
  std::vector<Index> first_;  ///< element of each face, and the end
  std::vector<Element> elements_;
};

}  // namespace chartflood
