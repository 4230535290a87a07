#pragma once
/// t-flooding written down as plainly as possible, to compare the fast floods with: ordered sets
/// instead of heaps, whole fans walked for every gain, nothing cached.

#include <algorithm>
#include <limits>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "core/model/flood_graph.h"
#include "core/model/mesh.h"

namespace chartflood::test {

/// Labels of one round over a mesh of triangles, from the delays and gains of `graph` (arcs
/// layout).
inline std::vector<Index> plainFlood(const FloodGraph& graph, std::span<const Index> seeds,
                                     std::span<const double> offsets, bool lookahead) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  const std::size_t charts = seeds.size();
  std::vector<Index> label(graph.faceCount, kNone);
  std::vector<std::set<std::pair<float, Index>>> offered(charts);
  std::vector<std::set<Index>> known(charts);  // faces that a chart has a time for
  std::vector<double> balance(offsets.begin(), offsets.end());
  std::vector<std::vector<Index>> facesOfCorner(graph.cornerGain.size());
  for (Index f = 0; f < graph.faceCount; ++f) {
    for (Index i = graph.cornerBegin[f]; i < graph.cornerBegin[f + 1]; ++i) {
      facesOfCorner[graph.corners[i].corner].push_back(f);
    }
  }
  const auto gain = [&](Index face, Index chart) {
    double sum = static_cast<double>(graph.gain[face]);
    for (Index a = graph.arcBegin[face]; a < graph.arcBegin[face + 1]; ++a) {
      if (label[graph.arcs[a].face] == chart) sum += static_cast<double>(graph.arcs[a].edgeGain);
    }
    for (Index i = graph.cornerBegin[face]; i < graph.cornerBegin[face + 1]; ++i) {
      bool whole = true;
      for (const Index other : facesOfCorner[graph.corners[i].corner]) {
        whole = whole && (other == face || label[other] == chart);
      }
      if (whole) sum += static_cast<double>(graph.cornerGain[graph.corners[i].corner]);
    }
    return sum;
  };
  const auto take = [&](Index face, Index chart, float time) {
    balance[chart] += gain(face, chart);
    label[face] = chart;
    known[chart].insert(face);
    for (Index a = graph.arcBegin[face]; a < graph.arcBegin[face + 1]; ++a) {
      const FloodArc& arc = graph.arcs[a];
      if (label[arc.face] != kNone || !known[chart].insert(arc.face).second) continue;
      offered[chart].insert({time + arc.delay, arc.face});
    }
  };
  // A chart's key is set when it has taken a face; when another chart takes the face it looked
  // ahead at, the key is mended only once the chart's turn comes.
  std::vector<double> key(charts, kNever);
  const auto rank = [&](Index c) {
    while (!offered[c].empty() && label[offered[c].begin()->second] != kNone) {
      offered[c].erase(offered[c].begin());
    }
    key[c] = kNever;
    if (offered[c].empty()) return;
    key[c] = balance[c] + (lookahead ? gain(offered[c].begin()->second, c) : 0.0);
  };
  for (Index c = 0; c < charts; ++c) take(seeds[c], c, 0);
  for (Index c = 0; c < charts; ++c) rank(c);
  while (true) {
    const auto least = std::min_element(key.begin(), key.end());
    if (*least == kNever) return label;
    const Index next = static_cast<Index>(least - key.begin());
    const auto [time, face] = *offered[next].begin();
    if (label[face] == kNone) {
      offered[next].erase(offered[next].begin());
      take(face, next, time);
    }
    rank(next);
  }
}

}  // namespace chartflood::test
