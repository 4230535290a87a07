#include "core/segment/parts/flood_cursor.h"

#include <algorithm>
#include <utility>

#include "core/base/check.h"

namespace chartflood {

FloodCursor::FloodCursor(std::shared_ptr<const FloodMeasures> measures)
    : measures_(std::move(measures)), mesh_(&measures_->mesh()), label_(mesh_->faceCount(), kNone) {
}

double FloodCursor::gaussArea(std::size_t chart) const {
  return measures_->steradians(area_[chart]);
}

double FloodCursor::area(std::size_t chart) const {
  return measures_->surfaceArea(surface_[chart]);
}

/// Whether the chart holds all faces of the element.
bool FloodCursor::holds(const FloodMeasures::Element& element, Index chart) const {
  if (element.across != kNone) return label_[element.across] == chart;
  const Index first = mesh_->vertexSide()[element.vertex];
  Index side = first;
  do {
    if (label_[mesh_->faceOf(side / 3)] != chart) return false;
    side = mesh_->turn(side);
  } while (side != kNone && side != first);
  return true;
}

/// Adds or subtracts what its chart has by this face.
void FloodCursor::change(Index face, std::int64_t sign) {
  const Index chart = label_[face];
  std::int64_t area = measures_->area(face);
  for (const FloodMeasures::Element& element : measures_->elements(face)) {
    if (holds(element, chart)) area += element.area;
  }
  area_[chart] += sign * area;
  surface_[chart] += sign * measures_->surface(face);
}

/// Visits the chart across each side of the face, kNone while that is dry.
template <class Visit>
void FloodCursor::acrossSides(Index face, const Visit& visit) const {
  const Index end = 3 * mesh_->triangleBegin(face + 1);
  for (Index side = 3 * mesh_->triangleBegin(face); side < end; ++side) {
    const Index opposite = mesh_->opposite()[side];
    if (opposite == kNone) continue;
    const Index other = mesh_->faceOf(opposite / 3);
    if (other != face) visit(label_[other]);
  }
}

void FloodCursor::take(Index face, Index chart) {
  if (chart >= faces_.size()) {
    faces_.resize(chart + 1, 0);
    openSides_.resize(chart + 1, 0);
    area_.resize(chart + 1, 0);
    surface_.resize(chart + 1, 0);
  }
  acrossSides(face,
              [&](Index other) { other == kNone ? ++openSides_[chart] : --openSides_[other]; });
  label_[face] = chart;
  ++faces_[chart];
  change(face, 1);
}

void FloodCursor::giveBack(Index face) {
  change(face, -1);
  const Index chart = std::exchange(label_[face], kNone);
  --faces_[chart];
  acrossSides(face,
              [&](Index other) { other == kNone ? --openSides_[chart] : ++openSides_[other]; });
}

/// Carries out one step of the refinement, or takes it back.
void FloodCursor::playSeam(std::size_t step, bool back) {
  const SeamStep& s = seams_->steps[step];
  for (std::size_t k = s.toB; k < s.end; ++k) {
    const Index face = seams_->faces[k];
    giveBack(face);
    take(face, (k < s.toA) == back ? s.a : s.b);
  }
}

void FloodCursor::refine(const std::shared_ptr<const SeamRecord>& seams, std::size_t step) {
  CF_CHECK(record_ && step_ == label_.size());
  if (seams != seams_) {
    while (seamStep_ > 0) playSeam(--seamStep_, true);
    seams_ = seams;
  }
  const std::size_t wanted = seams_ ? std::min(step, seams_->steps.size()) : 0;
  while (seamStep_ < wanted) playSeam(seamStep_++, false);
  while (seamStep_ > wanted) playSeam(--seamStep_, true);
}

void FloodCursor::go(const std::shared_ptr<const FloodRecord>& record, std::size_t step) {
  if (record != record_) {
    record_ = record;
    seams_.reset();
    seamStep_ = 0;
    step_ = 0;
    std::fill(label_.begin(), label_.end(), kNone);
    faces_.clear();
    openSides_.clear();
    area_.clear();
    surface_.clear();
  } else if (seamStep_ > 0) {
    refine(nullptr, 0);
  }
  const std::size_t wanted = record_ ? std::min(step, record_->size()) : 0;
  for (; step_ < wanted; ++step_) take((*record_)[step_].face, (*record_)[step_].chart);
  for (; step_ > wanted; --step_) giveBack((*record_)[step_ - 1].face);
}

}  // namespace chartflood
