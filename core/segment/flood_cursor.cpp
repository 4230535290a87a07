#include "core/segment/flood_cursor.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/base/check.h"
#include "core/flood/build_flood_graph.h"
#include "core/gauss/compute_gauss_area.h"

namespace chartflood {

namespace {

std::int64_t wholeUnits(double steradians) { return std::llround(std::ldexp(steradians, 40)); }

/// Each face around the vertex once.
template <class Visit>
void facesAround(const Mesh& mesh, Index vertex, const Visit& visit) {
  const Index first = mesh.vertexSide()[vertex];
  Index last = kNone, begin = mesh.faceOf(first / 3), side = first;
  do {
    const Index face = mesh.faceOf(side / 3);
    // The triangles of a polygon follow upon each other, around the start as well.
    if (face != last && (face != begin || side == first)) visit(face);
    last = face;
    side = mesh.turn(side);
  } while (side != kNone && side != first);
}

}  // namespace

FloodCursor::FloodCursor(std::shared_ptr<const Mesh> mesh, std::shared_ptr<const GaussArea> gauss)
    : mesh_(std::move(mesh)), firstElement_(mesh_->faceCount() + 1, 0),
      label_(mesh_->faceCount(), kNone) {
  for (const double area : faceGaussArea(*mesh_, *gauss)) faceArea_.push_back(wholeUnits(area));
  const std::vector<double> surface = faceAreas(*mesh_);
  surfaceUnit_ = std::ldexp(std::accumulate(surface.begin(), surface.end(), 0.0), -50);
  if (!(surfaceUnit_ > 0)) surfaceUnit_ = 1;
  for (const double area : surface) faceSurface_.push_back(std::llround(area / surfaceUnit_));
  std::vector<std::pair<Index, Element>> all;
  for (std::size_t i = 0; i < gauss->sharpEdges.size(); ++i) {
    const Index left = mesh_->faceOf(gauss->sharpEdges[i] / 3);
    const Index right = mesh_->faceOf(mesh_->opposite()[gauss->sharpEdges[i]] / 3);
    if (left == right) continue;  // inside a polygon: part of its face
    all.push_back({left, {wholeUnits(gauss->edge[i]), right, kNone}});
    all.push_back({right, {wholeUnits(gauss->edge[i]), left, kNone}});
  }
  for (std::size_t i = 0; i < gauss->corners.size(); ++i) {
    const Element corner{wholeUnits(gauss->corner[i]), kNone, gauss->corners[i]};
    facesAround(*mesh_, corner.vertex, [&](Index face) { all.push_back({face, corner}); });
  }
  for (const auto& [face, element] : all) ++firstElement_[face + 1];
  for (std::size_t f = 0; f < mesh_->faceCount(); ++f) firstElement_[f + 1] += firstElement_[f];
  elements_.resize(all.size());
  std::vector<Index> next(firstElement_.begin(), firstElement_.end() - 1);
  for (const auto& [face, element] : all) elements_[next[face]++] = element;
}

double FloodCursor::gaussArea(std::size_t chart) const {
  return std::ldexp(static_cast<double>(area_[chart]), -40);
}

double FloodCursor::area(std::size_t chart) const {
  return static_cast<double>(surface_[chart]) * surfaceUnit_;
}

/// Whether the chart holds all faces of the element.
bool FloodCursor::holds(const Element& element, Index chart) const {
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
  std::int64_t area = faceArea_[face];
  for (Index i = firstElement_[face]; i < firstElement_[face + 1]; ++i) {
    if (holds(elements_[i], chart)) area += elements_[i].area;
  }
  area_[chart] += sign * area;
  surface_[chart] += sign * faceSurface_[face];
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
