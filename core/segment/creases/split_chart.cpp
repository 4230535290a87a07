#include "core/segment/creases/split_chart.h"

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
                             std::size_t charts, const Rules& rules)
    : mesh_(mesh), faceGauss_(faceGauss), area_(faceAreas(mesh)), center_(faceCentroids(mesh)),
      gaussTotal_(gauss.triangleTotal), label_(std::move(label)), charts_(charts), rules_(rules),
      chartsOfPart_(mesh.componentCount(), 0), distance_(mesh.faceCount(), 0),
      nearest_(mesh.faceCount(), kNone) {
  for (Index f = 0; f < label_.size(); ++f) {
    charts_[label_[f]].faces.push_back(f);
    const Index unit = unitOf(f);
    if (unit != f) center_[unit] = (center_[unit] + center_[f]) / 2.0;
  }
  for (Index c = 0; c < charts_.size(); ++c) {
    measure(c);
    if (!charts_[c].faces.empty()) ++chartsOfPart_[mesh.faceComponent()[charts_[c].faces.front()]];
  }
}

Index ChartSplitter::unitOf(Index face) const {
  return rules_.partner.empty() ? face : std::min(face, rules_.partner[face]);
}

/// Sums over the chart's faces; Euler number = triangles - inner edges + inner vertices.
void ChartSplitter::measure(Index number) {
  Chart& chart = charts_[number];
  chart.area = chart.gauss = 0;
  chart.euler = 0;
  chart.units = 0;
  const auto opposite = mesh_.opposite();
  const auto inside = [&](Index side) { return label_[mesh_.faceOf(side / 3)] == number; };
  for (const Index f : chart.faces) {
    chart.area += area_[f];
    chart.units += unitOf(f) == f;
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
  across_ = rules_.across * std::sqrt(chart.area);
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
    const Index partner = rules_.partner.empty() ? kNone : rules_.partner[f];
    for (const Index own : {f, partner}) {
      if (own != kNone) relax(f, own, distance);
    }
  }
}

/// Offers the ways out of a face of the unit f.
void ChartSplitter::relax(Index f, Index own, double distance) {
  const auto later = std::greater<std::pair<double, Index>>();
  for (Index s = 3 * mesh_.triangleBegin(own); s < 3 * mesh_.triangleBegin(own + 1); ++s) {
    const Index other = mesh_.opposite()[s];
    if (other == kNone) continue;
    const Index next = mesh_.faceOf(other / 3), g = unitOf(next);
    if (label_[next] != label_[own]) continue;
    double to = distance + glm::length(center_[f] - center_[g]);
    if (!rules_.dear.empty() && rules_.dear[s] != 0) to += across_;
    if (!(to < distance_[g])) continue;
    distance_[g] = to;
    nearest_[g] = nearest_[f];
    heap_.emplace_back(to, g);
    std::push_heap(heap_.begin(), heap_.end(), later);
  }
}

Index ChartSplitter::farthest(const Chart& chart) const {
  const Index face =
      *std::max_element(chart.faces.begin(), chart.faces.end(), [&](Index f, Index g) {
        return distance_[unitOf(f)] < distance_[unitOf(g)];  // the first of equals
      });
  return unitOf(face);
}

Index ChartSplitter::mostNeedy() const {
  Index best = kNone;
  double most = -1;
  bool bestFull = true;
  for (Index c = 0; c < charts_.size(); ++c) {
    if (charts_[c].units < 2) continue;
    const Index part = mesh_.faceComponent()[charts_[c].faces.front()];
    const bool full = !rules_.most.empty() && chartsOfPart_[part] >= rules_.most[part];
    if (full != bestFull ? full : !(need(charts_[c]) > most)) continue;
    best = c;
    most = need(charts_[c]);
    bestFull = full;
  }
  return best;
}

Index ChartSplitter::other(const Chart& chart, Index unit) const {
  return unitOf(*std::find_if(chart.faces.begin(), chart.faces.end(),
                              [&](Index f) { return unitOf(f) != unit; }));
}

bool ChartSplitter::splitNext(Rng& rng) {
  const Index best = mostNeedy();
  if (best == kNone) return false;
  const Chart& chart = charts_[best];
  search(chart, std::array{unitOf(
                    chart.faces[rng.below(static_cast<std::uint32_t>(chart.faces.size()))])});
  const Index one = farthest(chart);
  search(chart, std::array{one});
  Index two = farthest(chart);
  if (two == one) two = other(chart, one);  // all in one place
  search(chart, std::array{one, two});
  divide(best, one, two);
  return true;
}

/// Parts a chart in what is nearer to the one unit and what is nearer to the other.
void ChartSplitter::divide(Index best, Index one, Index two) {
  const Index number = static_cast<Index>(charts_.size());
  Chart& chart = charts_[best];
  Chart other;
  std::vector<Index> rest;
  for (const Index f : chart.faces) {
    (nearest_[unitOf(f)] == two ? other.faces : rest).push_back(f);
  }
  for (const Index f : other.faces) label_[f] = number;
  chart.faces = std::move(rest);
  charts_.push_back(std::move(other));
  measure(best);
  measure(number);
  ++chartsOfPart_[mesh_.faceComponent()[one]];
}

}  // namespace chartflood
