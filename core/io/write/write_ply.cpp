#include "core/io/write/write_ply.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/io/text/text_blocks.h"
#include "core/io/write/split_vertices.h"

namespace chartflood {

namespace {

static_assert(std::endian::native == std::endian::little);

bool fitsFloat(double x) {
  if (!std::isfinite(x)) return true;
  return std::fabs(x) <= std::numeric_limits<float>::max() &&
         static_cast<double>(static_cast<float>(x)) == x;
}

bool fitsFloat(const InputMesh& input) {
  return std::all_of(input.positions.begin(), input.positions.end(), [](const glm::dvec3& p) {
    return fitsFloat(p.x) && fitsFloat(p.y) && fitsFloat(p.z);
  });
}

std::size_t largestFace(const InputMesh& input) {
  if (input.faceStart.empty()) return 3;
  std::size_t most = 0;
  for (std::size_t f = 0; f < input.faceCount(); ++f) most = std::max(most, input.face(f).size());
  return most;
}

class PlyWriter {
 public:
  PlyWriter(const ChartedMesh& charted, const PlyOptions& options)
      : m_(charted), input_(charted.mesh.input()), places_(chartPlaces(charted)) {
    for (std::size_t c = 0; c < m_.chartCount(); ++c) {
      hasTexture_ = hasTexture_ || !m_.uv(c).empty();
    }
    split_ = hasTexture_ && options.vertices == PlyVertices::SplitAtSeams;
    if (split_) vertices_ = splitVertices(m_, places_);
    singlePrecision_ = fitsFloat(input_);
    wideCounts_ = 2 * largestFace(input_) > 255;
  }

  std::string write() {
    writeHeader();
    const std::size_t vertex = (singlePrecision_ ? 12 : 24) + (split_ ? 8 : 0);
    bytes_.reserve(bytes_.size() + vertex * vertexCount() +
                   (hasTexture_ ? 12 : 4) * input_.corners.size() +
                   (wideCounts_ ? 12 : 6) * input_.faceCount());
    writeVertices();
    writeFaces();
    return std::move(bytes_);
  }

 private:
  void writeHeader();
  void writeVertices();
  char* writeVertex(char* out, std::size_t vertex) const;
  void writeFaces();
  char* writeFace(char* out, std::size_t face) const;
  char* writeCount(char* out, std::size_t count) const;
  std::size_t vertexCount() const {
    return input_.positions.size() + (split_ ? vertices_.copyOf.size() : 0);
  }
  /// Of a place; (0, 0) where there is none.
  glm::vec2 texture(Index chart, Index place) const {
    if (chart == kNone || m_.uv(chart).empty()) return glm::vec2(0);
    return m_.uv(chart)[place - places_.begin[chart]];
  }

  const ChartedMesh& m_;
  const InputMesh& input_;
  ChartPlaces places_;
  SplitVertices vertices_;
  bool hasTexture_ = false, split_ = false, singlePrecision_ = true, wideCounts_ = false;
  std::string bytes_;
};

void PlyWriter::writeHeader() {
  const std::string real = singlePrecision_ ? "float" : "double";
  const std::string count = wideCounts_ ? "int" : "uchar";
  bytes_ = "ply\nformat binary_little_endian 1.0\ncomment charts by chartflood";
  if (split_) {
    bytes_ += "\ncomment the first " + std::to_string(input_.positions.size()) +
              " vertices are those of the input, the others repeat them at seams";
  }
  bytes_ += "\nelement vertex " + std::to_string(vertexCount());
  for (const char* axis : {" x", " y", " z"}) bytes_ += "\nproperty " + real + axis;
  if (split_) bytes_ += "\nproperty float s\nproperty float t";
  bytes_ += "\nelement face " + std::to_string(input_.faceCount()) + "\nproperty list " + count +
            " int vertex_indices\nproperty int chart\nproperty list " + count +
            " float texcoord\nend_header\n";
}

char* PlyWriter::writeVertex(char* out, std::size_t vertex) const {
  const std::size_t known = input_.positions.size();
  const glm::dvec3& p =
      input_.positions[vertex < known ? vertex : vertices_.copyOf[vertex - known]];
  for (int axis = 0; axis < 3; ++axis) {
    out = singlePrecision_ ? writeRaw(out, static_cast<float>(p[axis])) : writeRaw(out, p[axis]);
  }
  if (!split_) return out;
  const glm::vec2 uv = texture(vertices_.chart[vertex], vertices_.place[vertex]);
  return writeRaw(writeRaw(out, uv.x), uv.y);
}

void PlyWriter::writeVertices() {
  const auto bound = [](std::size_t begin, std::size_t end) { return (end - begin) * 32; };
  appendBlocks(bytes_, vertexCount(), bound, [&](std::size_t begin, std::size_t end, char* out) {
    for (std::size_t v = begin; v < end; ++v) out = writeVertex(out, v);
    return out;
  });
}

char* PlyWriter::writeCount(char* out, std::size_t count) const {
  return wideCounts_ ? writeRaw(out, static_cast<std::int32_t>(count))
                     : writeRaw(out, static_cast<std::uint8_t>(count));
}

char* PlyWriter::writeFace(char* out, std::size_t face) const {
  const std::span<const Index> vertices = input_.face(face);
  const std::size_t first = static_cast<std::size_t>(vertices.data() - input_.corners.data());
  const Index chart = places_.chart[face];
  out = writeCount(out, vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    out = writeRaw(out, split_ ? vertices_.corner[first + i] : vertices[i]);
  }
  out = writeRaw(out, chart == kNone ? std::int32_t{-1} : static_cast<std::int32_t>(chart));
  if (chart == kNone || m_.uv(chart).empty()) return writeCount(out, 0);
  out = writeCount(out, 2 * vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const glm::vec2 uv = texture(chart, places_.corner[first + i]);
    out = writeRaw(writeRaw(out, uv.x), uv.y);
  }
  return out;
}

void PlyWriter::writeFaces() {
  const auto bound = [&](std::size_t begin, std::size_t end) {
    std::size_t corners = 0;
    for (std::size_t f = begin; f < end; ++f) corners += input_.face(f).size();
    return corners * 12 + (end - begin) * 12;
  };
  appendBlocks(bytes_, input_.faceCount(), bound,
               [&](std::size_t begin, std::size_t end, char* out) {
                 for (std::size_t f = begin; f < end; ++f) out = writeFace(out, f);
                 return out;
               });
}

}  // namespace

std::string plyBytes(const ChartedMesh& charted, const PlyOptions& options) {
  return PlyWriter(charted, options).write();
}

}  // namespace chartflood
