#pragma once
/// Charts that are split in two, the largest and most curved first.

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "core/base/index.h"
#include "core/base/rng.h"
#include "core/model/face_values.h"
#include "core/model/gauss_area.h"
#include "core/model/mesh.h"

namespace chartflood {

class ChartSplitter {
 public:
  /// What splits heed.
  struct Rules {
    std::span<const Index> partner = {};     ///< faces that stay together, kNone: none; empty: none
    std::span<const std::size_t> most = {};  ///< as in PartShares
    std::span<const std::uint8_t> dear = {};  ///< 1: sides that are dear to cross; empty: none
    double across = 1;  ///< what a step over these is longer by, in widths of the chart
  };
  /// \param faceGauss faceGaussArea() of the mesh
  /// \param rules must outlive it
  ChartSplitter(const Mesh& mesh, const GaussArea& gauss, std::span<const double> faceGauss,
                std::vector<Index> label, std::size_t charts, const Rules& rules);

  std::size_t count() const { return charts_.size(); }
  std::span<const Index> labels() const { return label_; }
  /// Splits the chart with the greatest (half its share of Gauss area + half its share of area)
  /// * (1 + min(2, 1 - Euler number)), so that rings go first, between two faces far from each
  /// other. Charts of parts that have the most they may come last. False when no chart has two
  /// faces that may be parted. \param rng chooses the face from which the first of the two is the
  /// farthest
  bool splitNext(Rng& rng);

 private:
  struct Chart {
    std::vector<Index> faces;
    double area = 0;
    double gauss = 0;  ///< of its faces
    int euler = 0;
    std::size_t units = 0;  ///< faces, where two that stay together count once
  };
  void measure(Index chart);
  double need(const Chart& chart) const;
  Index mostNeedy() const;
  /// The face that stands for itself and its partner.
  Index unitOf(Index face) const;
  Index other(const Chart& chart, Index unit) const;
  void divide(Index number, Index one, Index two);
  /// Distances over face centres inside a chart; each face learns which source is nearest.
  void search(const Chart& chart, std::span<const Index> sources);
  void relax(Index f, Index own, double distance);
  Index farthest(const Chart& chart) const;

  const Mesh& mesh_;
  std::span<const double> faceGauss_;
  FaceValues area_;
  std::vector<glm::dvec3> center_;
  double gaussTotal_ = 0;
  std::vector<Index> label_;
  std::vector<Chart> charts_;
  Rules rules_;
  std::vector<std::size_t> chartsOfPart_;
  double across_ = 0;             ///< what a step over a dear side is longer by
  std::vector<double> distance_;  ///< of units
  std::vector<Index> nearest_;    ///< of units
  std::vector<std::pair<double, Index>> heap_;
};

}  // namespace chartflood
