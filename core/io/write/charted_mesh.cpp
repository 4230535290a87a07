#include "core/io/write/charted_mesh.h"

#include <algorithm>
#include <utility>

#include "core/base/check.h"
#include "core/base/parallel.h"

namespace chartflood {

namespace {

constexpr std::size_t kCopyBlock = 1 << 14;

void check(const ChartedMesh& m) {
  CF_CHECK(m.label.size() == m.mesh.faceCount());
  for (const Index chart : m.label) CF_CHECK(chart == kNone || chart < m.chartCount());
  CF_CHECK(m.atlas.uv.empty() || m.atlas.uv.size() == m.chartCount());
  for (std::size_t c = 0; c < m.chartCount(); ++c) {
    CF_CHECK(m.uv(c).empty() || m.uv(c).size() == m.surface(c).vertexCount());
  }
}

/// Place of each corner of the mesh's triangles.
std::vector<Index> trianglePlaces(const ChartedMesh& m, std::span<const Index> begin) {
  std::vector<Index> place(3 * m.mesh.triangleCount(), kNone);
  parallelFor(m.chartCount(), [&](std::size_t c) {
    const ChartSurface& s = m.surface(c);
    for (std::size_t t = 0; t < s.triangleCount(); ++t) {
      for (std::size_t i = 0; i < 3; ++i) {
        place[3 * s.meshTriangle[t] + i] = begin[c] + s.triangles[t][i];
      }
    }
  });
  return place;
}

/// Corners of one polygon of the input that no triangle has: vertices that are repeated.
void placeTheRest(std::span<const Index> vertices, std::span<Index> corners) {
  const std::size_t count = corners.size();
  std::vector<Index> extra(count, kNone);
  for (std::size_t i = 0; i < count; ++i) {
    if (corners[i] != kNone) continue;
    for (std::size_t j = 0; j < count && extra[i] == kNone; ++j) {
      if (vertices[j] == vertices[i]) extra[i] = corners[j];
    }
    // A spike that runs to a vertex and back has no area in the texture either.
    for (std::size_t back = 1; back < count && extra[i] == kNone; ++back) {
      extra[i] = corners[(i + count - back) % count];
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (corners[i] == kNone) corners[i] = extra[i];
  }
}

/// The face of the mesh for each face of the input; empty when they are the same.
std::vector<Index> meshFaces(const Mesh& mesh) {
  std::vector<Index> face;
  if (mesh.faceCount() == mesh.input().faceCount()) return face;
  face.resize(mesh.input().faceCount(), kNone);
  for (Index f = 0; f < mesh.faceCount(); ++f) face[mesh.inputFace(f)] = f;
  return face;
}

}  // namespace

std::string chartName(Index chart) {
  std::string digits = std::to_string(chart);
  if (digits.size() < 3) digits.insert(0, 3 - digits.size(), '0');
  return "chart_" + digits;
}

ChartPlaces chartPlaces(const ChartedMesh& m) {
  check(m);
  const InputMesh& input = m.mesh.input();
  ChartPlaces out;
  out.begin.push_back(0);
  for (std::size_t c = 0; c < m.chartCount(); ++c) {
    out.begin.push_back(out.begin.back() + static_cast<Index>(m.surface(c).vertexCount()));
  }
  std::vector<Index> places = trianglePlaces(m, out.begin);
  const std::vector<Index> meshFace = meshFaces(m.mesh);
  if (m.mesh.cornersAsInput()) {
    // Corners of the input are those of the mesh's triangles.
    out.chart.assign(m.label.begin(), m.label.end());
    out.corner = std::move(places);
    return out;
  }
  out.chart.resize(input.faceCount(), kNone);
  out.corner.resize(input.corners.size(), kNone);
  if (!meshFace.empty()) {
    out.dropped.resize(input.faceCount());
    for (std::size_t f = 0; f < meshFace.size(); ++f) out.dropped[f] = meshFace[f] == kNone;
  }
  parallelBlocks(input.faceCount(), kCopyBlock, [&](std::size_t first, std::size_t last) {
    for (std::size_t f = first; f < last; ++f) {
      const Index face = meshFace.empty() ? static_cast<Index>(f) : meshFace[f];
      if (face == kNone || m.label[face] == kNone) continue;
      out.chart[f] = m.label[face];
      const std::span<const Index> vertices = input.face(f);
      const std::size_t corner = static_cast<std::size_t>(vertices.data() - input.corners.data());
      const Index end = 3 * m.mesh.triangleBegin(face + 1);
      for (Index side = 3 * m.mesh.triangleBegin(face); side < end; ++side) {
        out.corner[m.mesh.inputCorner(side)] = places[side];
      }
      const std::size_t count = vertices.size();
      const std::size_t triangles = (end - 3 * m.mesh.triangleBegin(face)) / 3;
      if (triangles + 2 != count) {
        placeTheRest(vertices, std::span(out.corner).subspan(corner, count));
      }
    }
  });
  return out;
}

}  // namespace chartflood
