#include "core/charts/chart_stats.h"

#include <glm/geometric.hpp>

#include "core/segment/parts/balance.h"

namespace chartflood {

namespace {

/// Follows charts over the mesh; counts what Euler numbers and border loops are made of.
class ChartSurvey {
 public:
  ChartSurvey(const Mesh& mesh, const Segmentation& segmentation)
      : mesh_(mesh), label_(segmentation.label), charts_(segmentation.chartCount) {}

  std::vector<ChartFigures> run() {
    countFaces();
    countSides();
    countVertices();
    countLoops();
    countPieces();
    for (ChartFigures& chart : charts_) {
      chart.disk = chart.connected && chart.euler == 1 && chart.boundaryLoops == 1;
    }
    return std::move(charts_);
  }
  double seamLength() const { return seamLength_; }

 private:
  Index chartOf(Index triangle) const { return label_[mesh_.faceOf(triangle)]; }
  /// True when the chart of the side's triangle goes on across it.
  bool glued(Index side) const {
    const Index other = mesh_.opposite()[side];
    return other != kNone && chartOf(other / 3) == chartOf(side / 3);
  }

  void countFaces() {
    const double unit = mesh_.scale() * mesh_.scale();
    for (Index f = 0; f < mesh_.faceCount(); ++f) {
      if (label_[f] != kNone) ++charts_[label_[f]].faces;
    }
    for (Index t = 0; t < mesh_.triangleCount(); ++t) {
      if (chartOf(t) == kNone) continue;
      ChartFigures& chart = charts_[chartOf(t)];
      chart.area += mesh_.triangleArea()[t] * unit;
      ++chart.euler;
    }
  }

  void countSides() {
    const auto positions = mesh_.positions();
    for (Index s = 0; s < 3 * mesh_.triangleCount(); ++s) {
      const Index chart = chartOf(s / 3);
      if (chart == kNone) continue;
      const bool inner = glued(s);
      if (inner && s > mesh_.opposite()[s]) continue;
      --charts_[chart].euler;
      if (inner) continue;
      const double length =
          glm::length(positions[mesh_.sideStart(s)] - positions[mesh_.sideEnd(s)]) * mesh_.scale();
      charts_[chart].perimeter += length;
      const Index other = mesh_.opposite()[s];
      // A border between two charts is met from both; one towards free faces is no seam yet.
      if (other != kNone && chartOf(other / 3) != kNone) seamLength_ += length / 2;
    }
  }

  /// A vertex of a chart is a run of its corners around a mesh vertex, joined by glued edges.
  void countVertices() {
    for (Index s = 0; s < 3 * mesh_.triangleCount(); ++s) {
      // The first corner of a run has no glued edge behind it.
      if (chartOf(s / 3) != kNone && !glued(s)) ++charts_[chartOf(s / 3)].euler;
    }
    // Where one chart holds the whole fan of an interior vertex there is no first corner.
    for (Index v = 0; v < mesh_.vertexCount(); ++v) {
      const Index first = mesh_.vertexSide()[v];
      if (first == kNone || chartOf(first / 3) == kNone) continue;
      Index side = first;
      do {
        if (!glued(side)) break;
        side = mesh_.turn(side);
      } while (side != kNone && side != first);
      if (side == first && glued(first)) ++charts_[chartOf(first / 3)].euler;
    }
  }

  void countLoops() {
    std::vector<bool> seen(3 * mesh_.triangleCount(), false);
    for (Index s = 0; s < seen.size(); ++s) {
      if (seen[s] || chartOf(s / 3) == kNone || glued(s)) continue;
      ++charts_[chartOf(s / 3)].boundaryLoops;
      for (Index side = s; !seen[side];) {
        seen[side] = true;
        side = Mesh::nextSide(side);
        while (glued(side)) side = Mesh::nextSide(mesh_.opposite()[side]);
      }
    }
  }

  void countPieces() {
    std::vector<bool> reached(mesh_.faceCount(), false);
    std::vector<bool> met(charts_.size(), false);
    std::vector<Index> stack;
    for (Index f = 0; f < mesh_.faceCount(); ++f) {
      if (reached[f] || label_[f] == kNone) continue;
      if (met[label_[f]]) charts_[label_[f]].connected = false;
      met[label_[f]] = true;
      reached[f] = true;
      stack.push_back(f);
      while (!stack.empty()) {
        const Index face = stack.back();
        stack.pop_back();
        const Index end = 3 * mesh_.triangleBegin(face + 1);
        for (Index s = 3 * mesh_.triangleBegin(face); s < end; ++s) {
          if (!glued(s)) continue;
          const Index next = mesh_.faceOf(mesh_.opposite()[s] / 3);
          if (reached[next]) continue;
          reached[next] = true;
          stack.push_back(next);
        }
      }
    }
  }

  const Mesh& mesh_;
  const std::vector<Index>& label_;
  std::vector<ChartFigures> charts_;
  double seamLength_ = 0;
};

}  // namespace

ChartStats measureCharts(const Mesh& mesh, const Segmentation& segmentation) {
  ChartStats stats;
  ChartSurvey survey(mesh, segmentation);
  stats.charts = survey.run();
  stats.seamLength = survey.seamLength();
  stats.surfaceArea = mesh.surfaceArea() * mesh.scale() * mesh.scale();
  for (std::size_t c = 0; c < stats.charts.size(); ++c) {
    stats.charts[c].seedFace = segmentation.seeds[c];
    stats.charts[c].gaussArea = segmentation.areas.gaussArea[c];
  }
  const Balance balance = balanceOf(segmentation.areas.gaussArea);
  stats.gaussMean = balance.mean;
  stats.gaussStd = balance.std;
  stats.gaussStdEq3 = balance.stdEq3;
  stats.balanceDefined = balance.defined;
  stats.gaussMaxOverMean = balance.defined ? balance.max / balance.mean : 0;
  stats.onSeams = segmentation.areas.onSeams;
  return stats;
}

}  // namespace chartflood
