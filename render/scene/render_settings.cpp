#include "render/scene/render_settings.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "core/base/error.h"
#include "render/scene/color_map.h"

namespace chartflood {

namespace {

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
