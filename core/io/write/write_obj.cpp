#include "core/io/write/write_obj.h"

#include <array>

#include "core/io/text/obj_vertices.h"
#include "core/io/text/text_blocks.h"

namespace chartflood {

namespace {

constexpr std::size_t kLongestTexture = 3 + 2 * (kLongestReal + 1);
constexpr std::size_t kLongestCorner = 2 * (kLongestWhole + 1);
/// "g NAME", "usemtl NAME" and what stands around the corners.
constexpr std::size_t kLongestSwitch = 64;

class ObjWriter {
 public:
  ObjWriter(const ChartedMesh& charted, const ObjOptions& options)
      : m_(charted), input_(charted.mesh.input()), places_(chartPlaces(charted)),
        materials_(!options.materialFile.empty()) {
    if (materials_) text_ = "mtllib " + options.materialFile + "\n";
    // Only charts that are laid flat have texture coordinates.
    std::size_t next = 1;
    for (std::size_t c = 0; c < m_.chartCount(); ++c) {
      textureBegin_.push_back(m_.uv(c).empty() ? 0 : next);
      next += m_.uv(c).size();
    }
    textureCount_ = next - 1;
  }

  std::string write() {
    reserve();
    appendObjVertices(text_, input_.positions);
    for (std::size_t c = 0; c < m_.chartCount(); ++c) writeTexture(m_.uv(c));
    writeFaces();
    return std::move(text_);
  }

 private:
  void reserve();
  void writeTexture(std::span<const glm::dvec2> uv);
  void writeFaces();
  bool switches(std::size_t face) const;
  char* writeGroup(char* out, std::size_t face) const;
  char* writeFace(char* out, std::size_t face) const;

  const ChartedMesh& m_;
  const InputMesh& input_;
  ChartPlaces places_;
  bool materials_;
  std::vector<std::size_t> textureBegin_;  ///< first `vt` of each chart, from 1; 0: none
  std::size_t textureCount_ = 0;
  std::string text_;
};

/// Room for nearly everything, so that the text seldom moves; what stays unused costs nothing.
void ObjWriter::reserve() {
  const std::size_t corner =
      digitsOf(input_.positions.size()) + 1 + (textureCount_ > 0 ? digitsOf(textureCount_) + 1 : 0);
  text_.reserve(65 * input_.positions.size() + 45 * textureCount_ + corner * input_.corners.size() +
                2 * input_.faceCount() + 4096);
}

void ObjWriter::writeTexture(std::span<const glm::dvec2> uv) {
  const auto bound = [](std::size_t begin, std::size_t end) {
    return (end - begin) * kLongestTexture;
  };
  appendBlocks(text_, uv.size(), bound, [&](std::size_t begin, std::size_t end, char* out) {
    for (std::size_t v = begin; v < end; ++v) {
      out = writeText(out, "vt ");
      out = writeReal(out, uv[v].x);
      *out++ = ' ';
      out = writeReal(out, uv[v].y);
      *out++ = '\n';
    }
    return out;
  });
}

bool ObjWriter::switches(std::size_t face) const {
  if (face == 0 || places_.chart[face] != places_.chart[face - 1]) return true;
  return !places_.dropped.empty() && places_.dropped[face] != places_.dropped[face - 1];
}

char* ObjWriter::writeGroup(char* out, std::size_t face) const {
  const Index chart = places_.chart[face];
  const bool dropped = !places_.dropped.empty() && places_.dropped[face];
  const std::string name = chart != kNone ? chartName(chart) : dropped ? "dropped" : "free";
  out = writeText(writeText(writeText(out, "g "), name), "\n");
  if (materials_) out = writeText(writeText(writeText(out, "usemtl "), name), "\n");
  return out;
}

char* ObjWriter::writeFace(char* out, std::size_t face) const {
  const std::span<const Index> vertices = input_.face(face);
  const Index chart = places_.chart[face];
  const std::size_t texture = chart == kNone ? 0 : textureBegin_[chart];
  const Index* place =
      places_.corner.data() + static_cast<std::size_t>(vertices.data() - input_.corners.data());
  *out++ = 'f';
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    *out++ = ' ';
    out = writeWhole(out, std::size_t{vertices[i]} + 1);
    if (texture == 0) continue;
    *out++ = '/';
    out = writeWhole(out, texture + (place[i] - places_.begin[chart]));
  }
  *out++ = '\n';
  return out;
}

void ObjWriter::writeFaces() {
  const auto bound = [&](std::size_t begin, std::size_t end) {
    std::size_t corners = 0;
    for (std::size_t f = begin; f < end; ++f) corners += input_.face(f).size();
    return corners * kLongestCorner + (end - begin) * kLongestSwitch;
  };
  appendBlocks(text_, input_.faceCount(), bound,
               [&](std::size_t begin, std::size_t end, char* out) {
                 for (std::size_t f = begin; f < end; ++f) {
                   if (switches(f)) out = writeGroup(out, f);
                   out = writeFace(out, f);
                 }
                 return out;
               });
}

}  // namespace

std::string objText(const ChartedMesh& charted, const ObjOptions& options) {
  return ObjWriter(charted, options).write();
}

std::string materialText(std::span<const std::uint32_t> colorOfChart) {
  std::string text;
  std::array<char, kLongestReal> digits;
  const auto add = [&](const std::string& name, std::uint32_t color) {
    text += "newmtl " + name + "\nKd";
    for (const unsigned shift : {16u, 8u, 0u}) {
      const double share = std::round(((color >> shift) & 255u) / 255.0 * 1e4) / 1e4;
      text.append(" ").append(digits.data(), writeReal(digits.data(), share));
    }
    text += "\n";
  };
  for (std::size_t c = 0; c < colorOfChart.size(); ++c) {
    add(chartName(static_cast<Index>(c)), colorOfChart[c]);
  }
  for (const char* name : {"dropped", "free"}) add(name, 0x808080);
  return text;
}

}  // namespace chartflood
