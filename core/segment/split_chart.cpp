#include "core/segment/split_chart.h"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>

#include "core/flood/build_flood_graph.h"

namespace chartflood {

ChartSplitter::ChartSplitter(const Mesh& mesh, const GaussArea& gauss,
                             std::span<const double> faceGauss, std::vector<Index> label,
                             std::size_t charts)
    : mesh_(mesh), faceGauss_(faceGauss), area_(faceAreas(mesh)), center_(faceCentroids(mesh)),
      gaussTotal_(gauss.triangleTotal), label_(std::move(label)), charts_(charts),
      distance_(mesh.faceCount(), 0), nearest_(mesh.faceCount(), kNone) {
  for (Index f = 0; f < label_.size(); ++f) charts_[label_[f]].faces.push_back(f);
  for (Index c = 0; c < charts_.size(); ++c) measure(c);
}

/// Sums over the chart's faces; Euler number = triangles - inner edges + inner vertices.
void ChartSplitter::measure(Index number) {
  Chart& chart = charts_[number];
  chart.area = chart.gauss = 0;
  chart.euler = 0;
  const auto opposite = mesh_.opposite();
  const auto inside = [&](Index side) { return label_[mesh_.faceOf(side / 3)] == number; };
  for (const Index f : chart.faces) {
    chart.area += area_[f];
    chart.gauss += faceGauss_[f];
    chart.euler += static_cast<int>(mesh_.triangleBegin(f + 1) - mesh_.triangleBegin(f));
    for (Index s = 3 * mesh_.triangleBegin(f); s < 3 * mesh_.triangleBegin(f + 1); ++s) {
      if (opposite[s] != kNone && s < opposite[s] && inside(opposite[s])) --chart.euler;
      if (mesh_.vertexSide()[mesh_.sideStart(s)] != s) continue;  // each vertex once
      Index turn = mesh_.turn(s);
      while (turn != kNone && turn != s && inside(turn)) turn = mesh_.turn(turn);
      if (turn == s) ++chart.euler;
    }
  }
}

double ChartSplitter::need(const Chart& chart) const {
  const double gauss = gaussTotal_ > 0 ? chart.gauss / gaussTotal_ : 0;
  const double area = mesh_.surfaceArea() > 0 ? chart.area / mesh_.surfaceArea() : 0;
  const double topology = 1 + std::clamp(1.0 - chart.euler, 0.0, 2.0);
  return (gauss + area) / 2 * topology;
}

void ChartSplitter::search(const Chart& chart, std::span<const Index> sources) {
  for (const Index f : chart.faces) distance_[f] = std::numeric_limits<double>::infinity();
  heap_.clear();
  for (const Index f : sources) {
    distance_[f] = 0;
    nearest_[f] = f;
    heap_.emplace_back(0.0, f);
  }
  const auto later = std::greater<std::pair<double, Index>>();
  std::make_heap(heap_.begin(), heap_.end(), later);
  while (!heap_.empty()) {
    std::pop_heap(heap_.begin(), heap_.end(), later);
    const auto [distance, f] = heap_.back();
    heap_.pop_back();
    if (distance > distance_[f]) continue;
    for (Index s = 3 * mesh_.triangleBegin(f); s < 3 * mesh_.triangleBegin(f + 1); ++s) {
      const Index other = mesh_.opposite()[s];
      if (other == kNone) continue;
      const Index g = mesh_.faceOf(other / 3);
      if (label_[g] != label_[f]) continue;
      const double to = distance + glm::length(center_[f] - center_[g]);
      if (!(to < distance_[g])) continue;
      distance_[g] = to;
      nearest_[g] = nearest_[f];
      heap_.emplace_back(to, g);
      std::push_heap(heap_.begin(), heap_.end(), later);
    }
  }
}

Index ChartSplitter::farthest(const Chart& chart) const {
  return *std::max_element(chart.faces.begin(), chart.faces.end(), [&](Index f, Index g) {
    return distance_[f] < distance_[g];  // the first of equals
  });
}

bool ChartSplitter::splitNext(Rng& rng) {
  Index best = kNone;
  double most = -1;
  for (Index c = 0; c < charts_.size(); ++c) {
    if (charts_[c].faces.size() < 2 || !(need(charts_[c]) > most)) continue;
    best = c;
    most = need(charts_[c]);
  }
  if (best == kNone) return false;
  Chart& chart = charts_[best];
  search(chart, std::array{chart.faces[rng.below(static_cast<std::uint32_t>(chart.faces.size()))]});
  const Index one = farthest(chart);
  search(chart, std::array{one});
  Index two = farthest(chart);
  if (two == one) two = chart.faces[chart.faces.front() == one ? 1 : 0];  // all in one place
  search(chart, std::array{one, two});
  const Index number = static_cast<Index>(charts_.size());
  Chart other;
  std::vector<Index> rest;
  for (const Index f : chart.faces) (nearest_[f] == two ? other.faces : rest).push_back(f);
  for (const Index f : other.faces) label_[f] = number;
  chart.faces = std::move(rest);
  charts_.push_back(std::move(other));
  measure(best);
  measure(number);
  return true;
}

}  // namespace chartflood
