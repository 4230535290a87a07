#include "core/io/write/write_seams.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/base/check.h"
#include "core/io/text/obj_vertices.h"
#include "core/io/text/text_blocks.h"

namespace chartflood {

namespace {

using Edge = std::pair<Index, Index>;

/// The ends of a side by number of the input, smaller one first.
Edge inputEdge(const Mesh& mesh, Index side) {
  const Index a = mesh.inputVertex(mesh.sideStart(side)), b = mesh.inputVertex(mesh.sideEnd(side));
  return std::minmax(a, b);
}

/// Borders between charts in the order of their sides, then edges that gluing parted.
std::vector<Edge> chartBorders(const ChartedMesh& m) {
  std::vector<Edge> seams, open;
  const auto label = [&](Index side) { return m.label[m.mesh.faceOf(side / 3)]; };
  const std::span<const Index> opposite = m.mesh.opposite();
  for (Index side = 0; side < opposite.size(); ++side) {
    if (opposite[side] == kNone) {
      open.push_back(inputEdge(m.mesh, side));
    } else if (side < opposite[side] && label(side) != label(opposite[side])) {
      seams.push_back(inputEdge(m.mesh, side));
    }
  }
  std::sort(open.begin(), open.end());
  for (std::size_t i = 1; i < open.size(); ++i) {
    const bool first = i < 2 || open[i - 2] != open[i];
    if (open[i] == open[i - 1] && first) seams.push_back(open[i]);
  }
  return seams;
}

void appendLines(std::string& text, const char* group, const std::vector<Edge>& edges) {
  if (edges.empty()) return;
  text.append("g ").append(group).append("\n");
  const auto bound = [](std::size_t begin, std::size_t end) {
    return (end - begin) * (4 + 2 * kLongestWhole);
  };
  appendBlocks(text, edges.size(), bound, [&](std::size_t begin, std::size_t end, char* out) {
    for (std::size_t e = begin; e < end; ++e) {
      out = writeWhole(writeText(out, "l "), std::size_t{edges[e].first} + 1);
      out = writeWhole(writeText(out, " "), std::size_t{edges[e].second} + 1);
      *out++ = '\n';
    }
    return out;
  });
}

}  // namespace

std::string seamsText(const ChartedMesh& m) {
  CF_CHECK(m.label.size() == m.mesh.faceCount());
  std::vector<Edge> cuts;
  for (const CutChart& chart : m.charts.charts) {
    for (const Cut& cut : chart.cuts) {
      for (const Index side : cut.sides) cuts.push_back(inputEdge(m.mesh, side));
    }
  }
  std::string text;
  appendObjVertices(text, m.mesh.input().positions);
  appendLines(text, "seams", chartBorders(m));
  appendLines(text, "cuts", cuts);
  return text;
}

}  // namespace chartflood
