#include "export_support.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <deque>
#include <limits>
#include <sstream>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/charts/chart_surface.h"
#include "tests/support/test_meshes.h"

namespace chartflood::test {

namespace {

/// Along the mean normal, not yet scaled.
std::vector<glm::dvec2> project(const ChartSurface& s) {
  glm::dvec3 normal(0);
  for (const auto& t : s.triangles) {
    normal +=
        glm::cross(s.positions[t[1]] - s.positions[t[0]], s.positions[t[2]] - s.positions[t[0]]);
  }
  normal = glm::length(normal) > 0 ? glm::normalize(normal) : glm::dvec3(0, 0, 1);
  const glm::dvec3 other = std::fabs(normal.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 x = glm::normalize(glm::cross(other, normal)), y = glm::cross(normal, x);
  std::vector<glm::dvec2> flat;
  for (const glm::dvec3& p : s.positions) flat.emplace_back(glm::dot(p, x), glm::dot(p, y));
  return flat;
}

/// Into the cell of a grid of n x n.
void fit(std::vector<glm::dvec2>& points, std::size_t chart, std::size_t n) {
  glm::dvec2 low(std::numeric_limits<double>::max()), high(-low);
  for (const glm::dvec2& p : points) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  const double extent = std::max({high.x - low.x, high.y - low.y, 1e-300});
  const glm::dvec2 cell(static_cast<double>(chart % n), static_cast<double>(chart / n));
  for (glm::dvec2& p : points) {
    p = (cell + 0.05 + 0.9 * (p - low) / extent) / static_cast<double>(n);
  }
}

void layFlat(Charted& charted) {
  const std::size_t count = charted.charts.charts.size();
  std::size_t n = 1;
  while (n * n < count) ++n;
  charted.atlas.uv.clear();
  for (std::size_t c = 0; c < count; ++c) {
    charted.atlas.uv.push_back(project(charted.charts.charts[c].surface));
    fit(charted.atlas.uv.back(), c, n);
  }
  charted.atlas.textureSize = 512;
}

}  // namespace

Charted chartedMesh(std::shared_ptr<const Mesh> mesh, std::vector<Index> label) {
  Charted out{std::move(mesh), std::move(label), {}, {}};
  std::size_t count = 0;
  for (const Index chart : out.label) {
    if (chart != kNone) count = std::max(count, std::size_t{chart} + 1);
  }
  for (ChartSurface& surface : extractCharts(*out.mesh, out.label, count)) {
    CutChart chart;
    chart.before = chart.topology = topologyOf(surface);
    chart.surface = std::move(surface);
    out.charts.charts.push_back(std::move(chart));
  }
  layFlat(out);
  return out;
}

Charted inPatches(std::shared_ptr<const Mesh> mesh, std::size_t size) {
  std::vector<Index> label(mesh->faceCount(), kNone);
  Index chart = 0;
  for (Index seed = 0; seed < mesh->faceCount(); ++seed) {
    if (label[seed] != kNone) continue;
    std::deque<Index> queue{seed};
    label[seed] = chart;
    std::size_t taken = 1;
    while (!queue.empty()) {
      const Index face = queue.front();
      queue.pop_front();
      for (Index side = 3 * mesh->triangleBegin(face); side < 3 * mesh->triangleBegin(face + 1);
           ++side) {
        const Index other = mesh->opposite()[side];
        if (other == kNone || taken == size || label[mesh->faceOf(other / 3)] != kNone) continue;
        label[mesh->faceOf(other / 3)] = chart;
        queue.push_back(mesh->faceOf(other / 3));
        ++taken;
      }
    }
    ++chart;
  }
  return chartedMesh(std::move(mesh), std::move(label));
}

void cutAlong(Charted& charted, Index chart, const std::vector<Index>& meshSides) {
  CutChart cut = charted.charts.charts[chart];
  std::vector<Index> local;
  for (Index side = 0; side < cut.surface.opposite.size(); ++side) {
    for (const Index wanted : meshSides) {
      if (cut.surface.meshSide(side) == wanted) local.push_back(side);
    }
  }
  openAlong(cut.surface, local);
  cut.topology = topologyOf(cut.surface);
  cut.cuts.push_back({CutReason::Loop, meshSides, 0});
  charted.charts.charts.put(chart, std::move(cut));
  layFlat(charted);
}

std::shared_ptr<const Mesh> oddMesh() {
  const std::vector<glm::dvec3> points{{0, 0, 0},
                                       {1, 0, 0},
                                       {1, 1, 1e-30},
                                       {0, 1, -1e-300},
                                       {0.1, 0.2, 1.0 / 3},
                                       {-1, -1, -123456.789},
                                       {2, 0.30000000000000004, 5e-324},
                                       {-0.0, 7, 1e30},
                                       {3, 3, 3},
                                       {4, 3, 3},
                                       {4, 4, 3},
                                       {3, 4, 3},
                                       {2.5, 3.5, 3},
                                       {9, 9, 9}};
  return meshOf(points, {{0, 1, 2, 3},            // a quad
                         {0, 0, 1},               // dropped
                         {1, 0, 4},               // shares its edge with two others
                         {0, 1, 5},               // so does this one
                         {2, 2, 6, 6, 1},         // one triangle
                         {3, 7, 3, 2, 6},         // a spike to a vertex and back
                         {8, 9, 10, 11, 12, 12},  // a pentagon that lists its last corner twice
                         {9, 8, 9},               // dropped
                         {10, 9, 7},              // a triangle
                         {12, 8, 5, 7, 11, 4}});  // a hexagon
}

ObjFile parseObj(const std::string& text) {
  ObjFile out;
  std::string group, material, line;
  const auto number = [](std::istream& in) {
    std::string word;
    in >> word;
    return std::strtod(word.c_str(), nullptr);
  };
  for (std::istringstream lines(text); std::getline(lines, line);) {
    std::istringstream in(line);
    std::string key;
    in >> key;
    if (key == "v") {
      const double x = number(in), y = number(in), z = number(in);
      out.vertices.emplace_back(x, y, z);
    } else if (key == "vt") {
      const double u = number(in), v = number(in);
      out.texture.emplace_back(u, v);
    } else if (key == "g") {
      in >> group;
    } else if (key == "usemtl") {
      in >> material;
    } else if (key == "l") {
      Index a = 0, b = 0;
      in >> a >> b;
      out.lines.push_back({group, a - 1, b - 1});
    } else if (key == "f") {
      std::vector<ObjCorner>& face = out.faces.emplace_back();
      for (std::string word; in >> word;) {
        const std::size_t slash = word.find('/');
        const Index texture = slash == std::string::npos
                                  ? kNone
                                  : static_cast<Index>(std::stoul(word.substr(slash + 1)) - 1);
        face.push_back({static_cast<Index>(std::stoul(word) - 1), texture});
      }
      out.group.push_back(group);
      out.material.push_back(material);
    }
  }
  return out;
}

long TextureTopology::euler() const {
  return static_cast<long>(points.size()) - static_cast<long>(edges.size()) +
         static_cast<long>(faces);
}

std::size_t TextureTopology::boundaryLoops() const {
  std::map<Index, Index> root;
  const auto find = [&](Index i) {
    while (root[i] != i) i = root[i] = root[root[i]];
    return i;
  };
  for (const auto& [edge, uses] : edges) {
    if (uses != 1) continue;
    for (const Index end : {edge.first, edge.second}) root.try_emplace(end, end);
    root[find(edge.first)] = find(edge.second);
  }
  std::set<Index> roots;
  for (const auto& entry : root) roots.insert(find(entry.first));
  return roots.size();
}

std::map<std::string, TextureTopology> textureTopologies(const ObjFile& obj) {
  std::map<std::string, TextureTopology> charts;
  for (std::size_t f = 0; f < obj.faces.size(); ++f) {
    TextureTopology& chart = charts[obj.group[f]];
    ++chart.faces;
    const auto& face = obj.faces[f];
    for (std::size_t i = 0; i < face.size(); ++i) {
      const Index a = face[i].texture, b = face[(i + 1) % face.size()].texture;
      chart.points.insert(a);
      ++chart.edges[std::minmax(a, b)];
    }
  }
  return charts;
}

PlyFile parsePly(const std::string& bytes) {
  PlyFile out;
  const std::string last = "end_header\n";
  const std::size_t data = bytes.find(last) + last.size();
  out.header = bytes.substr(0, data);
  const auto countAfter = [&](const std::string& words) {
    const std::size_t at = out.header.find(words);
    return at == std::string::npos ? 0 : std::stoul(out.header.substr(at + words.size()));
  };
  ByteReader in(std::string_view(bytes).substr(data));
  const bool single = out.header.find("property float x") != std::string::npos;
  const bool wide = out.header.find("list int int") != std::string::npos;
  const bool split = out.header.find("property float s\nproperty float t\n") != std::string::npos;
  const auto count = [&] {
    return wide ? static_cast<std::size_t>(in.take<std::int32_t>()) : in.take<std::uint8_t>();
  };
  out.vertices.resize(countAfter("element vertex "));
  for (glm::dvec3& p : out.vertices) {
    for (int axis = 0; axis < 3; ++axis) p[axis] = single ? in.take<float>() : in.take<double>();
    if (!split) continue;
    const float s = in.take<float>(), t = in.take<float>();
    out.texture.emplace_back(s, t);
  }
  out.faces.resize(countAfter("element face "));
  for (PlyFile::Face& face : out.faces) {
    face.vertices.resize(count());
    for (Index& v : face.vertices) v = in.take<Index>();
    face.chart = in.take<std::int32_t>();
    face.texture.resize(count() / 2);
    for (glm::vec2& uv : face.texture) {
      uv.x = in.take<float>();
      uv.y = in.take<float>();
    }
  }
  out.finished = in.finished();
  return out;
}

}  // namespace chartflood::test
