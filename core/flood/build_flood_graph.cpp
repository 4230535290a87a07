#include "core/flood/build_flood_graph.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include <glm/geometric.hpp>

#include "core/base/parallel.h"
#include "core/gauss/compute_gauss_area.h"

namespace chartflood {

namespace {

constexpr std::size_t kFaceBlock = 1 << 13;

/// f(|K|) of equation 7 over its geometric middle.
class Slowness {
 public:
  Slowness(const FloodSpeeds& speeds, double maxCurvature)
      : power_(speeds.power), epsilon_(speeds.epsilon), maxCurvature_(maxCurvature) {
    const double middle = std::sqrt(epsilon_ * (1 + epsilon_));
    centre_ = middle > 0 ? 1 / middle : 1;
  }
  double operator()(double curvature) const {
    const double x = (std::min(1.0, curvature / maxCurvature_) + epsilon_) * centre_;
    double value = 0;
    if (power_ == 1) {
      value = x;
    } else if (power_ == 2) {
      value = x * x;
    } else if (power_ == 3) {
      value = x * x * x;
    } else {
      value = std::pow(x, power_);
    }
    // Beyond these bounds no order in single precision is left to keep.
    return std::clamp(value, 1e-25, 1e25);
  }

 private:
  double power_, epsilon_, maxCurvature_, centre_ = 1;
};

/// Everything the two layouts are filled from.
struct GraphSource {
  const Mesh& mesh;
  FaceValues faceGauss, faceArea;
  RawVector<glm::dvec3> centroid;
  std::vector<float> sideGain;  ///< Gauss area of each side's edge; empty when no edge has any
  std::vector<Index> cornerOf;  ///< corner number of each vertex; empty when there are none
  double floor = 0;
  Slowness slowness;
  RawVector<double> faceSlowness;  ///< of each face, entered over an edge without Gauss area

  void tableSlowness() {
    faceSlowness.resize(mesh.faceCount());
    parallelBlocks(mesh.faceCount(), kFaceBlock, [&](std::size_t begin, std::size_t end) {
      for (std::size_t f = begin; f < end; ++f) faceSlowness[f] = slownessOf(f, 0);
    });
  }
  double slownessOf(std::size_t face, double edge) const {
    return slowness((faceGauss[face] + edge) / std::max(floor, faceArea[face]));
  }
  float edgeGain(Index side) const { return sideGain.empty() ? 0.0f : sideGain[side]; }
  Index corner(Index vertex) const { return cornerOf.empty() ? kNone : cornerOf[vertex]; }
  float gain(Index face, double eta) const {
    return static_cast<float>(faceGauss[face] + eta * faceArea[face]);
  }
  float delay(Index from, Index to, Index side) const {
    const double edge = sideGain.empty() ? 0.0 : sideGain[side];
    const double slow = edge > 0 ? slownessOf(to, edge) : faceSlowness[to];
    return static_cast<float>(glm::length(centroid[from] - centroid[to]) * slow);
  }
};

void fillPacked(const GraphSource& source, FloodGraph& graph) {
  const Mesh& mesh = source.mesh;
  const auto opposite = mesh.opposite();
  graph.faces.resize(graph.faceCount);
  parallelBlocks(graph.faceCount, kFaceBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Index face = static_cast<Index>(i);
      FloodFace& record = graph.faces[i];
      for (Index k = 0; k < 3; ++k) {
        const Index other = opposite[3 * face + k];
        record.neighbour[k] = other == kNone ? kNone : 4 * (other / 3) + other % 3;
        record.delay[k] = other == kNone ? 0.0f : source.delay(face, other / 3, 3 * face + k);
      }
      record.gain = source.gain(face, graph.eta);
      record.extra = 0;
    }
  });
  graph.extras.push_back({});
  if (source.sideGain.empty() && source.cornerOf.empty()) return;
  for (Index face = 0; face < graph.faceCount; ++face) {
    FloodExtra extra{};
    bool needed = false;
    for (Index k = 0; k < 3; ++k) {
      extra.edge[k] = source.edgeGain(3 * face + k);
      extra.corner[k] = source.corner(mesh.triangles()[face][k]);
      needed = needed || extra.edge[k] > 0 || extra.corner[k] != kNone;
    }
    if (!needed) continue;
    graph.faces[face].extra = static_cast<Index>(graph.extras.size());
    graph.extras.push_back(extra);
  }
}

void fillArcs(const GraphSource& source, FloodGraph& graph) {
  const Mesh& mesh = source.mesh;
  const auto opposite = mesh.opposite();
  graph.gain.resize(graph.faceCount);
  graph.atMeshBorder.assign(graph.faceCount, 0);
  graph.arcBegin.push_back(0);
  graph.cornerBegin.push_back(0);
  std::vector<Index> arcOfSide(opposite.size(), kNone);
  std::vector<Index> touched;
  for (Index face = 0; face < graph.faceCount; ++face) {
    graph.gain[face] = source.gain(face, graph.eta);
    touched.clear();
    for (Index s = 3 * mesh.triangleBegin(face); s < 3 * mesh.triangleBegin(face + 1); ++s) {
      const Index corner = source.corner(mesh.sideStart(s));
      if (corner != kNone) touched.push_back(corner);
      if (opposite[s] == kNone) {
        graph.atMeshBorder[face] = 1;
        continue;
      }
      const Index other = mesh.faceOf(opposite[s] / 3);
      if (other == face) continue;
      arcOfSide[s] = static_cast<Index>(graph.arcs.size());
      graph.arcs.push_back({other, opposite[s], source.delay(face, other, s), source.edgeGain(s)});
    }
    graph.arcBegin.push_back(static_cast<Index>(graph.arcs.size()));
    std::sort(touched.begin(), touched.end());
    for (std::size_t i = 0; i < touched.size();) {
      std::size_t next = i;
      while (next < touched.size() && touched[next] == touched[i]) ++next;
      graph.corners.push_back({touched[i], static_cast<Index>(next - i)});
      i = next;
    }
    graph.cornerBegin.push_back(static_cast<Index>(graph.corners.size()));
  }
  for (FloodArc& arc : graph.arcs) arc.reverse = arcOfSide[arc.reverse];
}

}  // namespace

FaceValues faceAreas(const Mesh& mesh) {
  const auto area = mesh.triangleArea();
  if (mesh.facesAreTriangles()) return FaceValues(area);
  std::vector<double> out(mesh.faceCount(), 0);
  for (Index t = 0; t < mesh.triangleCount(); ++t) out[mesh.faceOf(t)] += area[t];
  return FaceValues(std::move(out));
}

namespace {

void fillCentroids(const Mesh& mesh, std::span<glm::dvec3> out) {
  const auto positions = mesh.positions();
  const auto area = mesh.triangleArea();
  parallelBlocks(mesh.faceCount(), kFaceBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f) {
      const Index first = mesh.triangleBegin(static_cast<Index>(f));
      const Index last = mesh.triangleBegin(static_cast<Index>(f) + 1);
      glm::dvec3 weighted(0), plain(0);
      double total = 0;
      for (Index t = first; t < last; ++t) {
        const auto& v = mesh.triangles()[t];
        const glm::dvec3 centre = (positions[v[0]] + positions[v[1]] + positions[v[2]]) / 3.0;
        weighted += centre * area[t];
        plain += centre;
        total += area[t];
      }
      const bool one = last - first == 1;
      out[f] = one || !(total > 0) ? plain / static_cast<double>(last - first) : weighted / total;
    }
  });
}

}  // namespace

std::vector<glm::dvec3> faceCentroids(const Mesh& mesh) {
  std::vector<glm::dvec3> out(mesh.faceCount());
  fillCentroids(mesh, out);
  return out;
}

FloodGraph buildFloodGraph(const Mesh& mesh, const GaussArea& gauss, const FloodSpeeds& speeds,
                           FloodLayout layout) {
  FloodGraph graph;
  graph.speeds = speeds;
  graph.faceCount = mesh.faceCount();
  const double counted = speeds.areaShare * std::max(gauss.total(), 4 * std::numbers::pi);
  graph.eta = mesh.surfaceArea() > 0 ? counted / mesh.surfaceArea() : 0;

  GraphSource source{mesh,
                     faceGaussArea(mesh, gauss),
                     faceAreas(mesh),
                     RawVector<glm::dvec3>(),
                     {},
                     {},
                     smallestArea(mesh),
                     Slowness(speeds, gauss.maxCurvature),
                     {}};
  source.tableSlowness();
  source.centroid.resize(mesh.faceCount());
  fillCentroids(mesh, source.centroid);
  if (!gauss.sharpEdges.empty()) {
    source.sideGain.assign(3 * mesh.triangleCount(), 0.0f);
    for (std::size_t i = 0; i < gauss.sharpEdges.size(); ++i) {
      const Index side = gauss.sharpEdges[i];
      source.sideGain[side] = static_cast<float>(gauss.edge[i]);
      source.sideGain[mesh.opposite()[side]] = static_cast<float>(gauss.edge[i]);
    }
  }
  for (std::size_t i = 0; i < gauss.corners.size(); ++i) {
    if (!(gauss.corner[i] > 0)) continue;
    if (source.cornerOf.empty()) source.cornerOf.assign(mesh.vertexCount(), kNone);
    source.cornerOf[gauss.corners[i]] = static_cast<Index>(graph.cornerGain.size());
    graph.cornerGain.push_back(static_cast<float>(gauss.corner[i]));
    Index times = 0;
    const Index first = mesh.vertexSide()[gauss.corners[i]];
    Index side = first;
    do {
      ++times;
      side = mesh.turn(side);
    } while (side != first);
    graph.cornerTimes.push_back(times);
  }
  if (layout == FloodLayout::Automatic && mesh.facesAreTriangles()) {
    fillPacked(source, graph);
  } else {
    fillArcs(source, graph);
  }
  return graph;
}

}  // namespace chartflood
