#include "render/scene/render_settings.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "core/base/check.h"
#include "core/base/error.h"
#include "render/scene/color_map.h"

namespace chartflood {

namespace {

constexpr ColorModeInfo kModes[] = {
    {ColorMode::Shaded, "shaded", "Plain shaded", "", "", ScalarScale::Linear, "",
     "The shape alone."},
    {ColorMode::Charts, "charts", "Charts", "", "", ScalarScale::Linear, "",
     "One colour a chart; neighbours differ."},
    {ColorMode::GaussVertex, "gauss-vertex", "Gauss area: vertices", "Gauss area of vertices", "sr",
     ScalarScale::Root, "ember", "Corners, larger and redder the more area their normals span."},
    {ColorMode::GaussEdge, "gauss-edge", "Gauss area: edges", "Gauss area of edges, per length",
     "sr/d", ScalarScale::Root, "ember",
     "Creases, thicker and redder the more area their normals span; d is the model's diagonal."},
    {ColorMode::GaussFace, "gauss-face", "Gauss area: faces", "Gauss area per area", "sr/d\u00B2",
     ScalarScale::Linear, "ember",
     "How much area the normals of a face span for its size; d is the model's diagonal."},
    {ColorMode::Gauss, "gauss", "Gauss area: all", "Gauss area", "", ScalarScale::Linear, "ember",
     "Vertices, edges and faces together, each kind on its own range."},
    {ColorMode::Balance, "balance", "Balance", "Gauss area of charts against the mean", "%",
     ScalarScale::Linear, "blue-orange",
     "White charts carry the mean, blue ones less, orange more."},
    {ColorMode::FloodTime, "flood-time", "Flood time", "Time within its chart", "",
     ScalarScale::Linear, "viridis", "When a face was taken, as a share of its chart's own time."},
    {ColorMode::FloodOrder, "flood-order", "Flood order", "Share of all faces taken", "",
     ScalarScale::Linear, "viridis", "When a face was taken, counted over all charts."},
    {ColorMode::Stretch, "stretch", "Stretch", "Stretch (L2)", "", ScalarScale::Log, "ember",
     "How much a face is stretched by the unwrap; 1 is not at all."},
    {ColorMode::AreaDistortion, "area-distortion", "Area distortion", "Area distortion, log2", "",
     ScalarScale::Linear, "purple-green", "White faces keep their share of area."},
    {ColorMode::AngleDistortion, "angle-distortion", "Angle distortion", "Angle distortion", "",
     ScalarScale::Log, "ember", "Longer over shorter axis of a small circle; 1 is round."},
    {ColorMode::Checkerboard, "checkerboard", "Checkerboard", "", "", ScalarScale::Linear, "",
     "Squares of the texture: they stay square and of one size where the unwrap is good."},
};

constexpr const char* kCheckerKinds[] = {"squares", "numbers", "circles", "picture"};

glm::vec3 toVector(const Rgb8& c) { return glm::vec3(c[0], c[1], c[2]) / 255.0f; }

bool parseHex(std::string_view text, glm::vec3& color) {
  if (text.starts_with('#')) text.remove_prefix(1);
  std::uint32_t hex = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), hex, 16);
  if (text.size() != 6 || error != std::errc() || end != text.data() + text.size()) return false;
  color = toVector(rgb8(hex));
  return true;
}

bool parseTriple(std::string_view text, glm::vec3& color) {
  std::array<int, 3> parts{};
  const char* at = text.data();
  const char* const end = at + text.size();
  for (std::size_t i = 0; i < 3; ++i) {
    const auto [next, error] = std::from_chars(at, end, parts[i]);
    if (error != std::errc() || parts[i] < 0 || parts[i] > 255) return false;
    at = next;
    if (i < 2) {
      if (at == end || *at != ',') return false;
      ++at;
    }
  }
  color = glm::vec3(parts[0], parts[1], parts[2]) / 255.0f;
  return at == end;
}

}  // namespace

std::span<const ColorModeInfo> colorModeTable() { return kModes; }

const ColorModeInfo& colorModeInfo(ColorMode mode) {
  const ColorModeInfo& info = kModes[static_cast<std::size_t>(mode)];
  CF_CHECK(info.mode == mode);
  return info;
}

const ColorModeInfo* findColorMode(std::string_view id) {
  const auto found = std::find_if(std::begin(kModes), std::end(kModes),
                                  [&](const ColorModeInfo& m) { return m.id == id; });
  return found == std::end(kModes) ? nullptr : &*found;
}

bool showsDistortion(ColorMode mode) {
  return mode == ColorMode::Stretch || mode == ColorMode::AreaDistortion ||
         mode == ColorMode::AngleDistortion;
}

bool needsUnwrap(ColorMode mode) {
  return showsDistortion(mode) || mode == ColorMode::Checkerboard;
}

CheckerKind checkerKindFromId(std::string_view id) {
  const auto found = std::find(std::begin(kCheckerKinds), std::end(kCheckerKinds), id);
  if (found == std::end(kCheckerKinds)) {
    throw UsageError("There is no checkerboard of " + std::string(id) +
                     "; choose squares, numbers, circles or picture.");
  }
  return static_cast<CheckerKind>(found - std::begin(kCheckerKinds));
}

const char* checkerKindId(CheckerKind kind) {
  return kCheckerKinds[static_cast<std::size_t>(kind)];
}

Background backgroundFromText(std::string_view text) {
  Background background;
  if (text == "dark") return background;
  if (text == "transparent") {
    background.transparent = true;
    return background;
  }
  glm::vec3 color(0);
  if (text == "white")
    color = glm::vec3(1);
  else if (text != "black" && !parseHex(text, color) && !parseTriple(text, color)) {
    throw UsageError("\"" + std::string(text) +
                     "\" is no colour; write transparent, dark, white, black, #RRGGBB or R,G,B.");
  }
  background.bottom = background.top = color;
  return background;
}

}  // namespace chartflood
