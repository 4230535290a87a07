#include "render/gauss_layer.h"

#include <algorithm>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace chartflood {

namespace {

/// How far values are averaged: a share of the bounding box diagonal.
constexpr double kReach = 0.01;
constexpr int kMostRounds = 40;

/// One round of exchange with the neighbours that no crease separates; sums stay as they are.
void exchange(const Mesh& mesh, const std::vector<bool>& barrier, std::vector<double>& amount) {
  const std::vector<double> old = amount;
  for (Index side = 0; side < 3 * mesh.triangleCount(); ++side) {
    const Index other = mesh.opposite()[side];
    if (other == kNone || barrier[side]) continue;
    amount[side / 3] += (old[other / 3] - old[side / 3]) / 6;
  }
}

}  // namespace

std::vector<double> smoothDensity(const Mesh& mesh, const GaussArea& gauss) {
  std::vector<bool> barrier(3 * mesh.triangleCount(), false);
  for (const Index side : gauss.sharpEdges) {
    barrier[side] = true;
    if (mesh.opposite()[side] != kNone) barrier[mesh.opposite()[side]] = true;
  }
  const double meanArea = mesh.surfaceArea() / static_cast<double>(mesh.triangleCount());
  std::vector<double> amount = gauss.triangle;
  std::vector<double> area(mesh.triangleArea().begin(), mesh.triangleArea().end());
  // A random walk over triangles of edge e comes about e sqrt(n) / 2 far in n rounds.
  const double rounds = 4 * kReach * kReach / std::max(2.3 * meanArea, 1e-12);
  for (int i = 0; i < std::min(static_cast<int>(rounds), kMostRounds); ++i) {
    exchange(mesh, barrier, amount);
    exchange(mesh, barrier, area);
  }
  const double smallest = std::max(1e-9 * meanArea, 1e-300);
  for (std::size_t t = 0; t < amount.size(); ++t) amount[t] /= std::max(area[t], smallest);
  return amount;
}

GaussLayer::GaussLayer(const Mesh& mesh, const GaussArea& gauss) {
  uploadFaces(mesh, gauss);
  uploadEdges(mesh, gauss);
  uploadVertices(mesh, gauss);
}

void GaussLayer::uploadFaces(const Mesh& mesh, const GaussArea& gauss) {
  const std::vector<double> density = smoothDensity(mesh, gauss);
  std::vector<WeightedValue> weighted;
  weighted.reserve(density.size());
  for (std::size_t t = 0; t < density.size(); ++t) {
    weighted.push_back({density[t], mesh.triangleArea()[t]});
  }
  faceRange_ = rangeFromZero(weighted);
  const std::vector<float> values(density.begin(), density.end());
  faceValues_.upload<float>(GL_R32F, values);
}

void GaussLayer::uploadEdges(const Mesh& mesh, const GaussArea& gauss) {
  edgeCount_ = gauss.sharpEdges.size();
  std::vector<glm::vec4> ends;
  std::vector<WeightedValue> weighted;
  ends.reserve(2 * edgeCount_);
  for (std::size_t i = 0; i < edgeCount_; ++i) {
    const glm::dvec3& a = mesh.positions()[mesh.sideStart(gauss.sharpEdges[i])];
    const glm::dvec3& b = mesh.positions()[mesh.sideEnd(gauss.sharpEdges[i])];
    const double length = std::max(glm::distance(a, b), 1e-12);
    const double value = gauss.edge[i] / length;
    weighted.push_back({value, length});
    ends.emplace_back(glm::vec3(a), static_cast<float>(value));
    ends.emplace_back(glm::vec3(b), 0.0f);
  }
  edgeRange_ = rangeFromZero(weighted);
  edges_.upload<glm::vec4>(GL_RGBA32F, ends);
}

void GaussLayer::uploadVertices(const Mesh& mesh, const GaussArea& gauss) {
  vertexCount_ = gauss.corners.size();
  std::vector<glm::vec4> points;
  std::vector<WeightedValue> weighted;
  for (std::size_t i = 0; i < vertexCount_; ++i) {
    points.emplace_back(glm::vec3(mesh.positions()[gauss.corners[i]]),
                        static_cast<float>(gauss.corner[i]));
    points.emplace_back(0.0f);
    weighted.push_back({gauss.corner[i], 1});
  }
  vertexRange_ = rangeFromZero(weighted);
  vertices_.upload<glm::vec4>(GL_RGBA32F, points);
}

}  // namespace chartflood
