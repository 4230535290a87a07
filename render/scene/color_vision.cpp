#include "render/scene/color_vision.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/matrix.hpp>

namespace chartflood {

namespace {

constexpr std::array kKinds = {
    ColorVisionInfo{ColorVision::Full, "off", "Off"},
    ColorVisionInfo{ColorVision::RedBlind, "red", "Red blindness"},
    ColorVisionInfo{ColorVision::GreenBlind, "green", "Green blindness"},
    ColorVisionInfo{ColorVision::BlueBlind, "blue", "Blue blindness"},
};

float toLinear(float c) {
  return c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f);
}

float toSrgb(float c) {
  c = std::clamp(c, 0.0f, 1.0f);
  return c <= 0.0031308f ? 12.92f * c : 1.055f * std::pow(c, 1 / 2.4f) - 0.055f;
}

}  // namespace

std::span<const ColorVisionInfo> colorVisionTable() { return kKinds; }

const ColorVisionInfo& colorVisionInfo(ColorVision vision) {
  return kKinds[static_cast<std::size_t>(vision)];
}

const ColorVisionInfo* findColorVision(std::string_view id) {
  const auto found = std::find_if(kKinds.begin(), kKinds.end(),
                                  [&](const ColorVisionInfo& kind) { return kind.id == id; });
  return found == kKinds.end() ? nullptr : &*found;
}

glm::mat3 visionMatrix(ColorVision vision) {
  // By rows as printed; glm takes columns.
  switch (vision) {
  case ColorVision::RedBlind:
    return glm::transpose(glm::mat3(0.152286f, 1.052583f, -0.204868f,  //
                                    0.114503f, 0.786281f, 0.099216f,   //
                                    -0.003882f, -0.048116f, 1.051998f));
  case ColorVision::GreenBlind:
    return glm::transpose(glm::mat3(0.367322f, 0.860646f, -0.227968f,  //
                                    0.280085f, 0.672501f, 0.047413f,   //
                                    -0.011820f, 0.042940f, 0.968881f));
  case ColorVision::BlueBlind:
    return glm::transpose(glm::mat3(1.255528f, -0.076749f, -0.178779f,  //
                                    -0.078411f, 0.930809f, 0.147602f,   //
                                    0.004733f, 0.691367f, 0.303900f));
  case ColorVision::Full:
    break;
  }
  return glm::mat3(1);
}

glm::vec3 seenColor(const glm::vec3& color, ColorVision vision) {
  const glm::vec3 seen =
      visionMatrix(vision) * glm::vec3(toLinear(color.x), toLinear(color.y), toLinear(color.z));
  return {toSrgb(seen.x), toSrgb(seen.y), toSrgb(seen.z)};
}

}  // namespace chartflood
