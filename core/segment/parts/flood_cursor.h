#pragma once
/// Labels and areas of the charts at any moment of a flood's log and of the refinement after it.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/model/flood_record.h"
#include "core/model/mesh.h"
#include "core/model/seam_record.h"
#include "core/segment/parts/flood_measures.h"

namespace chartflood {

/// Stands at a moment and goes to another by taking or giving back the faces between them. Areas
/// are counted as in chartAreas() (paper equation 2), in the whole units of FloodMeasures: their
/// sums do not depend on the way that led to a moment.
class FloodCursor {
 public:
  /// Dry at first.
  explicit FloodCursor(std::shared_ptr<const FloodMeasures> measures);

  /// To the moment after the first `step` faces of `record`; null: all dry. Cost: the steps between
  /// two moments of one record, else `step` and what was taken before.
  void go(const std::shared_ptr<const FloodRecord>& record, std::size_t step);
  /// From a whole flood to the moment after the first `step` steps of the refinement of its
  /// borders. \pre `seams` begins with the labels of the flood. Cost: the faces of the steps
  /// between.
  void refine(const std::shared_ptr<const SeamRecord>& seams, std::size_t step);

  const std::shared_ptr<const FloodMeasures>& measures() const { return measures_; }
  const std::shared_ptr<const FloodRecord>& record() const { return record_; }
  std::size_t step() const { return step_; }
  /// Chart of each face, kNone while dry.
  std::span<const Index> labels() const { return label_; }
  /// Charts that have taken a face since the record was begun: their numbers are below this.
  std::size_t chartCount() const { return faces_.size(); }
  std::size_t faces(std::size_t chart) const { return faces_[chart]; }
  /// Sides of the chart's faces with a dry face across: where it can grow.
  std::size_t openSides(std::size_t chart) const { return openSides_[chart]; }
  /// A(c), steradians.
  double gaussArea(std::size_t chart) const;
  /// Surface of the chart, model units; exact to 2^-50 of the whole surface a face.
  double area(std::size_t chart) const;

 private:
  bool holds(const FloodMeasures::Element& element, Index chart) const;
  void take(Index face, Index chart);
  void giveBack(Index face);
  void change(Index face, std::int64_t sign);
  void playSeam(std::size_t step, bool back);
  template <class Visit>
  void acrossSides(Index face, const Visit& visit) const;

  std::shared_ptr<const FloodMeasures> measures_;
  const Mesh* mesh_;  ///< of the measures
  std::shared_ptr<const FloodRecord> record_;
  std::size_t step_ = 0;
  std::shared_ptr<const SeamRecord> seams_;
  std::size_t seamStep_ = 0;
  std::vector<Index> label_;
  std::vector<std::size_t> faces_, openSides_;
  std::vector<std::int64_t> area_, surface_;
};

}  // namespace chartflood
