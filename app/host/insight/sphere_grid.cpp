#include "app/host/insight/sphere_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "app/host/insight/sphere_patch.h"
#include "core/gauss/spherical_polygon.h"

namespace chartflood {

namespace {

constexpr float kQuarter = std::numbers::pi_v<float> / 4;

/// The axes of a side of the cube: its normal, then the two along it.
struct Axes {
  int normal, u, v;
  float sign;
};

Axes axesOf(int side) {
  const int normal = side / 2;
  return {normal, (normal + 1) % 3, (normal + 2) % 3, side % 2 == 0 ? 1.0f : -1.0f};
}

/// A corner of the grid. Equal steps in angle keep the cells alike.
glm::vec3 gridPoint(int side, int i, int j) {
  const Axes axes = axesOf(side);
  const auto along = [](int k) {
    return std::tan(kQuarter * (2 * static_cast<float>(k) / SphereGrid::kCells - 1));
  };
  glm::vec3 p(0);
  p[axes.normal] = axes.sign;
  p[axes.u] = along(i);
  p[axes.v] = along(j);
  return glm::normalize(p);
}

int cellAlong(float slope) {
  const float place = (std::atan(slope) / kQuarter + 1) / 2 * SphereGrid::kCells;
  return std::clamp(static_cast<int>(place), 0, SphereGrid::kCells - 1);
}

std::array<glm::vec3, 4> cellCorners(std::size_t cell) {
  const int perSide = SphereGrid::kCells * SphereGrid::kCells;
  const int side = static_cast<int>(cell) / perSide, rest = static_cast<int>(cell) % perSide;
  const int i = rest / SphereGrid::kCells, j = rest % SphereGrid::kCells;
  return {gridPoint(side, i, j), gridPoint(side, i + 1, j), gridPoint(side, i + 1, j + 1),
          gridPoint(side, i, j + 1)};
}

double cellArea(const std::array<glm::vec3, 4>& c) {
  return std::abs(signedTriangleArea(c[0], c[1], c[2])) +
         std::abs(signedTriangleArea(c[0], c[2], c[3]));
}

}  // namespace

SphereGrid::SphereGrid() : area_(std::size_t{6} * kCells * kCells, -1.0f) {}

std::size_t SphereGrid::cellOf(const glm::vec3& d) const {
  const glm::vec3 size = glm::abs(d);
  const int normal = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const int side = 2 * normal + (d[normal] < 0 ? 1 : 0);
  const Axes axes = axesOf(side);
  const float length = std::max(size[normal], 1e-20f);
  const int i = cellAlong(d[axes.u] / length), j = cellAlong(d[axes.v] / length);
  return static_cast<std::size_t>((side * kCells + i) * kCells + j);
}

void SphereGrid::add(const glm::vec3& direction, float area) {
  float& cell = area_[cellOf(direction)];
  cell = std::max(cell, 0.0f) + area;
}

void SphereGrid::touch(const glm::vec3& direction) { add(direction, 0); }

std::vector<SphereFacet> SphereGrid::facets() const {
  std::vector<SphereFacet> facets;
  for (std::size_t cell = 0; cell < area_.size(); ++cell) {
    if (area_[cell] < 0) continue;
    const std::array<glm::vec3, 4> corners = cellCorners(cell);
    facets.push_back({corners, 4, area_[cell] / static_cast<float>(cellArea(corners))});
  }
  return facets;
}

double SphereGrid::reached() const {
  double sum = 0;
  for (std::size_t cell = 0; cell < area_.size(); ++cell) {
    if (area_[cell] >= 0) sum += cellArea(cellCorners(cell));
  }
  return sum;
}

}  // namespace chartflood
