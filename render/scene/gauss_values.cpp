#include "render/scene/gauss_values.h"

#include <algorithm>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "render/scene/mode_values.h"

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

namespace {

void fillFaces(const Mesh& mesh, const GaussArea& gauss, GaussValues& out) {
  const std::vector<double> density = smoothDensity(mesh, gauss);
  std::vector<WeightedValue> weighted;
  weighted.reserve(density.size());
  for (std::size_t t = 0; t < density.size(); ++t) {
    weighted.push_back({density[t], mesh.triangleArea()[t]});
  }
  out.faceRange = modeRange(ColorMode::GaussFace, weighted);
  out.faces.assign(density.begin(), density.end());
}

void fillEdges(const Mesh& mesh, const GaussArea& gauss, GaussValues& out) {
  std::vector<WeightedValue> weighted;
  out.edges.reserve(2 * gauss.sharpEdges.size());
  for (std::size_t i = 0; i < gauss.sharpEdges.size(); ++i) {
    const glm::dvec3& a = mesh.positions()[mesh.sideStart(gauss.sharpEdges[i])];
    const glm::dvec3& b = mesh.positions()[mesh.sideEnd(gauss.sharpEdges[i])];
    const double length = std::max(glm::distance(a, b), 1e-12);
    const double value = gauss.edge[i] / length;
    weighted.push_back({value, length});
    out.edges.emplace_back(glm::vec3(a), static_cast<float>(value));
    out.edges.emplace_back(glm::vec3(b), 0.0f);
  }
  out.edgeRange = modeRange(ColorMode::GaussEdge, weighted);
}

void fillVertices(const Mesh& mesh, const GaussArea& gauss, GaussValues& out) {
  std::vector<WeightedValue> weighted;
  for (std::size_t i = 0; i < gauss.corners.size(); ++i) {
    out.vertices.emplace_back(glm::vec3(mesh.positions()[gauss.corners[i]]),
                              static_cast<float>(gauss.corner[i]));
    out.vertices.emplace_back(0.0f);
    weighted.push_back({gauss.corner[i], 1});
  }
  out.vertexRange = modeRange(ColorMode::GaussVertex, weighted);
}

}  // namespace

GaussValues gaussValues(const Mesh& mesh, const GaussArea& gauss) {
  GaussValues values;
  fillFaces(mesh, gauss, values);
  fillEdges(mesh, gauss, values);
  fillVertices(mesh, gauss, values);
  return values;
}

}  // namespace chartflood
