#include "tests/core/pack/laid_charts.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace chartflood::test {

void LaidCharts::add(const Polygon& vertices, const std::vector<std::array<Index, 3>>& triangles) {
  CutChart chart;
  ChartSurface& s = chart.surface;
  s.triangles = triangles;
  s.opposite.assign(3 * triangles.size(), kNone);
  std::map<std::pair<Index, Index>, Index> sides;
  for (Index side = 0; side < s.opposite.size(); ++side) {
    sides[{s.sideStart(side), s.sideEnd(side)}] = side;
  }
  for (Index side = 0; side < s.opposite.size(); ++side) {
    const auto other = sides.find({s.sideEnd(side), s.sideStart(side)});
    if (other != sides.end()) s.opposite[side] = other->second;
  }
  for (Index t = 0; t < triangles.size(); ++t) s.meshTriangle.push_back(t);
  for (Index v = 0; v < vertices.size(); ++v) {
    s.meshVertex.push_back(v);
    s.positions.emplace_back(vertices[v].x, vertices[v].y, 0);
  }
  charts.charts.push_back(std::move(chart));
  unwrap.charts.push_back({vertices, {}, ""});
}

void LaidCharts::addFan(const Polygon& polygon) {
  std::vector<std::array<Index, 3>> triangles;
  for (Index i = 1; i + 1 < polygon.size(); ++i) triangles.push_back({0, i, i + 1});
  add(polygon, triangles);
}

void LaidCharts::addRectangle(double width, double height) {
  addFan({{0, 0}, {width, 0}, {width, height}, {0, height}});
}

void LaidCharts::addRing(double inner, double outer, int parts) {
  Polygon vertices;
  std::vector<std::array<Index, 3>> triangles;
  for (int i = 0; i <= parts; ++i) {
    const double angle = 2 * std::numbers::pi * (i + 0.005) / (parts + 0.01);
    vertices.push_back(inner * glm::dvec2(std::cos(angle), std::sin(angle)));
    vertices.push_back(outer * glm::dvec2(std::cos(angle), std::sin(angle)));
  }
  for (Index i = 0; i < static_cast<Index>(parts); ++i) {
    triangles.push_back({2 * i, 2 * i + 1, 2 * i + 3});
    triangles.push_back({2 * i, 2 * i + 3, 2 * i + 2});
  }
  add(vertices, triangles);
}

void LaidCharts::addCross(double halfWidth) {
  Polygon vertices{{0, 0}};
  for (const glm::dvec2& arm : {glm::dvec2(1, 0), {0, 1}, {-1, 0}, {0, -1}}) {
    const glm::dvec2 left = halfWidth * glm::dvec2(-arm.y, arm.x);
    vertices.push_back(halfWidth * arm - left);
    vertices.push_back(arm - left);
    vertices.push_back(arm + left);
  }
  std::vector<std::array<Index, 3>> triangles;
  for (Index i = 0; i < 12; ++i) triangles.push_back({0, 1 + i, 1 + (i + 1) % 12});
  add(vertices, triangles);
}

void LaidCharts::addBlob(double radius, Rng& rng) {
  constexpr int kCorners = 40;
  const auto unit = [&rng] { return rng.below(1000) / 1000.0; };
  double wave[3], shift[3];
  for (int k = 0; k < 3; ++k) wave[k] = 0.2 * unit(), shift[k] = 6.28 * unit();
  const int arm = static_cast<int>(rng.below(3 * kCorners));
  Polygon polygon{{0, 0}};
  for (int i = 0; i <= kCorners; ++i) {
    const double angle = 2 * std::numbers::pi * (i % kCorners) / kCorners;
    double r = radius * (1 + 0.05 * ((i % kCorners) * 7 % 5 - 2) / 2.0);
    for (int k = 0; k < 3; ++k) r += radius * wave[k] * std::sin((k + 2) * angle + shift[k]);
    if (i == arm) r *= 2;
    polygon.push_back(r * glm::dvec2(std::cos(angle), std::sin(angle)));
  }
  polygon.pop_back();
  std::vector<std::array<Index, 3>> triangles;
  for (Index i = 0; i < kCorners; ++i) triangles.push_back({0, 1 + i, 1 + (i + 1) % kCorners});
  add(polygon, triangles);
}

void LaidCharts::addUnlaid() {
  addRectangle(1, 1);
  unwrap.charts.back() = {{}, {}, "The chart is a ring."};
}

std::shared_ptr<const Atlas> LaidCharts::layout(const LayoutOptions& options) const {
  Progress progress;
  return layoutAtlas(charts, unwrap, options, progress);
}

double coveredArea(const LaidCharts& laid, const Atlas& atlas) {
  double sum = 0;
  for (std::size_t k = 0; k < atlas.uv.size(); ++k) {
    if (atlas.uv[k].empty()) continue;
    for (const auto& t : laid.charts.charts[k].surface.triangles) {
      double twice = 0;
      for (int i = 0; i < 3; ++i) {
        const glm::dvec2 &p = atlas.uv[k][t[i]], &q = atlas.uv[k][t[(i + 1) % 3]];
        twice += p.x * q.y - p.y * q.x;
      }
      sum += std::abs(twice) / 2;
    }
  }
  return sum;
}

namespace {

/// Whether a triangle (any orientation, pixel units) and the pixel (x, y) have a point in common.
bool touches(const glm::dvec2 (&p)[3], int x, int y) {
  const double turn = (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[1].y - p[0].y) * (p[2].x - p[0].x);
  for (int k = 0; k < 3; ++k) {
    const glm::dvec2 &a = p[k], &b = p[(k + 1) % 3];
    const double nx = (a.y - b.y) * (turn < 0 ? -1 : 1), ny = (b.x - a.x) * (turn < 0 ? -1 : 1);
    const double cornerX = nx > 0 ? x + 1 : x, cornerY = ny > 0 ? y + 1 : y;
    if (nx * (cornerX - a.x) + ny * (cornerY - a.y) < 0) return false;
  }
  return true;
}

}  // namespace

RasterCheck checkRaster(const LaidCharts& laid, const Atlas& atlas, int size, int reach) {
  RasterCheck check;
  std::vector<int> owner(static_cast<std::size_t>(size) * static_cast<std::size_t>(size), -1);
  const auto at = [&](int x, int y) -> int& {
    return owner[static_cast<std::size_t>(y) * static_cast<std::size_t>(size) +
                 static_cast<std::size_t>(x)];
  };
  for (std::size_t k = 0; k < atlas.uv.size(); ++k) {
    if (atlas.uv[k].empty()) continue;
    for (const auto& t : laid.charts.charts[k].surface.triangles) {
      glm::dvec2 p[3];
      for (int i = 0; i < 3; ++i) p[i] = atlas.uv[k][t[i]] * static_cast<double>(size);
      const int x0 = static_cast<int>(std::floor(std::min({p[0].x, p[1].x, p[2].x})));
      const int x1 = static_cast<int>(std::floor(std::max({p[0].x, p[1].x, p[2].x})));
      const int y0 = static_cast<int>(std::floor(std::min({p[0].y, p[1].y, p[2].y})));
      const int y1 = static_cast<int>(std::floor(std::max({p[0].y, p[1].y, p[2].y})));
      check.emptyBorder = std::min({check.emptyBorder, x0, y0, size - 1 - x1, size - 1 - y1});
      for (int y = std::max(y0, 0); y <= std::min(y1, size - 1); ++y) {
        for (int x = std::max(x0, 0); x <= std::min(x1, size - 1); ++x) {
          if (!touches(p, x, y)) continue;
          int& pixel = at(x, y);
          if (pixel >= 0 && pixel != static_cast<int>(k)) ++check.sharedPixels;
          pixel = static_cast<int>(k);
        }
      }
    }
  }
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const int mine = at(x, y);
      if (mine < 0) continue;
      for (int v = std::max(0, y - reach); v <= std::min(size - 1, y + reach); ++v) {
        for (int u = std::max(0, x - reach); u <= std::min(size - 1, x + reach); ++u) {
          if (at(u, v) < 0 || at(u, v) == mine) continue;
          check.emptyBetween =
              std::min(check.emptyBetween, std::max(std::abs(u - x), std::abs(v - y)) - 1);
        }
      }
    }
  }
  return check;
}

}  // namespace chartflood::test
