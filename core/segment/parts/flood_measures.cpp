#include "core/segment/parts/flood_measures.h"

#include <numeric>
#include <utility>

#include "core/flood/build_flood_graph.h"
#include "core/gauss/compute_gauss_area.h"

namespace chartflood {

namespace {

/// Without a call of the library for each face.
std::int64_t rounded(double value) {
  return static_cast<std::int64_t>(value + (value < 0 ? -0.5 : 0.5));
}

std::int64_t wholeUnits(double steradians) { return rounded(steradians * 0x1p40); }

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

FloodMeasures::FloodMeasures(std::shared_ptr<const Mesh> mesh,
                             std::shared_ptr<const GaussArea> gauss)
    : mesh_(std::move(mesh)), gauss_(std::move(gauss)), first_(mesh_->faceCount() + 1, 0) {
  const std::size_t faces = mesh_->faceCount();
  const FaceValues gaussAreas = faceGaussArea(*mesh_, *gauss_);
  const FaceValues surfaces = faceAreas(*mesh_);
  const double unit = std::ldexp(std::accumulate(surfaces.begin(), surfaces.end(), 0.0), -50);
  if (unit > 0) surfaceUnit_ = unit;
  area_.resize(faces);
  surface_.resize(faces);
  for (std::size_t f = 0; f < faces; ++f) {
    area_[f] = wholeUnits(gaussAreas[f]);
    surface_[f] = rounded(surfaces[f] / surfaceUnit_);
  }
  std::vector<std::pair<Index, Element>> all;
  for (std::size_t i = 0; i < gauss_->sharpEdges.size(); ++i) {
    const Index left = mesh_->faceOf(gauss_->sharpEdges[i] / 3);
    const Index right = mesh_->faceOf(mesh_->opposite()[gauss_->sharpEdges[i]] / 3);
    if (left == right) continue;  // inside a polygon: part of its face
    all.push_back({left, {wholeUnits(gauss_->edge[i]), right, kNone}});
    all.push_back({right, {wholeUnits(gauss_->edge[i]), left, kNone}});
  }
  for (std::size_t i = 0; i < gauss_->corners.size(); ++i) {
    const Element corner{wholeUnits(gauss_->corner[i]), kNone, gauss_->corners[i]};
    facesAround(*mesh_, corner.vertex, [&](Index face) { all.push_back({face, corner}); });
  }
  for (const auto& [face, element] : all) ++first_[face + 1];
  for (std::size_t f = 0; f < faces; ++f) first_[f + 1] += first_[f];
  elements_.resize(all.size());
  std::vector<Index> next(first_.begin(), first_.end() - 1);
  for (const auto& [face, element] : all) elements_[next[face]++] = element;
}

}  // namespace chartflood
