#include "core/io/write/write_glb.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "core/base/check.h"
#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/charts/chart_surface.h"
#include "core/gauss/sector_normals.h"
#include "core/io/write/glb_container.h"

namespace chartflood {

namespace {

static_assert(std::endian::native == std::endian::little);

/// What goes into the buffer.
struct GlbArrays {
  std::vector<glm::vec3> position, normal;
  std::vector<glm::vec2> texture;  ///< empty: no chart is laid flat
  std::vector<float> chart;
  std::vector<std::uint32_t> corner;
};

/// A surface and where its vertices and triangles go.
struct Part {
  const ChartSurface& surface;
  std::span<const glm::dvec2> uv;
  float chart;
  std::size_t firstVertex, firstTriangle;
};

class Collector {
 public:
  Collector(const ChartedMesh& charted, const GlbOptions& options)
      : mesh_(charted.mesh), normals_(computeCornerNormals(charted.mesh, options.sharpAngle)) {
    addRest(charted.label);
    for (std::size_t c = 0; c < charted.chartCount(); ++c) {
      add(charted.surface(c), charted.uv(c), static_cast<float>(c));
    }
    for (const ChartSurface& surface : rest_) add(surface, {}, -1.0f);
  }

  GlbArrays collect() {
    out_.position.resize(vertexCount_);
    out_.normal.resize(vertexCount_);
    if (hasTexture_) out_.texture.resize(vertexCount_);
    out_.chart.resize(vertexCount_);
    out_.corner.resize(3 * triangleCount_);
    parallelFor(parts_.size(), [&](std::size_t p) { fill(parts_[p]); });
    return std::move(out_);
  }

 private:
  /// Faces without chart become a surface of their own.
  void addRest(std::span<const Index> label) {
    if (std::find(label.begin(), label.end(), kNone) == label.end()) return;
    std::vector<Index> free(label.size());
    for (std::size_t f = 0; f < label.size(); ++f) free[f] = label[f] == kNone ? 0 : kNone;
    rest_ = extractCharts(mesh_, free, 1);
  }
  void add(const ChartSurface& surface, std::span<const glm::dvec2> uv, float chart) {
    CF_CHECK(uv.empty() || uv.size() == surface.vertexCount());
    parts_.push_back({surface, uv, chart, vertexCount_, triangleCount_});
    vertexCount_ += surface.vertexCount();
    triangleCount_ += surface.triangleCount();
    hasTexture_ = hasTexture_ || !uv.empty();
  }
  void fill(const Part& part);
  void fillNormals(const Part& part);

  const Mesh& mesh_;
  const CornerNormals normals_;
  std::vector<ChartSurface> rest_;
  std::vector<Part> parts_;
  std::size_t vertexCount_ = 0, triangleCount_ = 0;
  bool hasTexture_ = false;
  GlbArrays out_;
};

glm::vec3 singlePrecision(const glm::dvec3& p) {
  constexpr double kLargest = std::numeric_limits<float>::max();
  if (std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)}) > kLargest) {
    throw Error("Could not write GLB: its numbers have single precision, and a coordinate of the "
                "mesh is too large for that; write OBJ or PLY instead.");
  }
  return p;
}

void Collector::fill(const Part& part) {
  const ChartSurface& s = part.surface;
  for (std::size_t v = 0; v < s.vertexCount(); ++v) {
    const std::size_t at = part.firstVertex + v;
    out_.position[at] =
        singlePrecision(mesh_.input().positions[mesh_.inputVertex(s.meshVertex[v])]);
    out_.chart[at] = part.chart;
    if (!hasTexture_) continue;
    const glm::dvec2 uv = part.uv.empty() ? glm::dvec2(0) : part.uv[v];
    out_.texture[at] = glm::dvec2(uv.x, 1 - uv.y);
  }
  for (std::size_t t = 0; t < s.triangleCount(); ++t) {
    // Faces that were turned over run as in the file again.
    const bool turned = mesh_.turned(mesh_.faceOf(s.meshTriangle[t]));
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t corner = turned && i > 0 ? 3 - i : i;
      out_.corner[3 * (part.firstTriangle + t) + i] =
          static_cast<std::uint32_t>(part.firstVertex + s.triangles[t][corner]);
    }
  }
  fillNormals(part);
}

/// The mean over the vertex's corners in the chart, by area: the corners' normals are smooth up to
/// the creases of the whole mesh.
void Collector::fillNormals(const Part& part) {
  const ChartSurface& s = part.surface;
  std::vector<glm::dvec3> sum(s.vertexCount(), glm::dvec3(0));
  for (std::size_t t = 0; t < s.triangleCount(); ++t) {
    const Index triangle = s.meshTriangle[t];
    for (std::size_t i = 0; i < 3; ++i) {
      const glm::dvec3 normal(normals_.normal[3 * triangle + i]);
      sum[s.triangles[t][i]] += mesh_.triangleArea()[triangle] * normal;
      // For the case that the sum vanishes.
      out_.normal[part.firstVertex + s.triangles[t][i]] = glm::vec3(normal);
    }
  }
  for (std::size_t v = 0; v < s.vertexCount(); ++v) {
    const double length = glm::length(sum[v]);
    if (length > 0 && std::isfinite(length)) {
      out_.normal[part.firstVertex + v] = glm::vec3(sum[v] / length);
    }
  }
}

}  // namespace

std::string glbBytes(const ChartedMesh& charted, const GlbOptions& options) {
  const GlbArrays arrays = Collector(charted, options).collect();
  GlbContainer file;
  const int indices = file.addIndices(arrays.corner);
  file.addAttribute("POSITION", arrays.position, true);
  file.addAttribute("NORMAL", arrays.normal, false);
  if (!arrays.texture.empty()) file.addAttribute("TEXCOORD_0", arrays.texture);
  file.addAttribute("_CHART", arrays.chart);
  return file.finish(indices, arrays.texture.empty() ? "" : options.texturePng);
}

}  // namespace chartflood
