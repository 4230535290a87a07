#pragma once
/// Normals in 32 bits, as GL_INT_2_10_10_10_REV with normalisation has them.

#include <algorithm>
#include <cstdint>

#include <glm/vec3.hpp>

namespace chartflood {

inline std::uint32_t packNormal(const glm::vec3& n) {
  const auto component = [](float value) {
    const double scaled = 511.0 * std::clamp(value, -1.0f, 1.0f);
    // No call of the library: there are nine of these for each triangle.
    const auto rounded = static_cast<std::int32_t>(scaled + (scaled < 0 ? -0.5 : 0.5));
    return static_cast<std::uint32_t>(rounded) & 0x3FFu;
  };
  return component(n.x) | component(n.y) << 10 | component(n.z) << 20;
}

inline glm::vec3 unpackNormal(std::uint32_t packed) {
  const auto component = [&](int shift) {
    const auto bits = static_cast<std::int32_t>(packed << (22 - shift)) >> 22;  // with its sign
    return static_cast<float>(bits) / 511.0f;
  };
  return {component(0), component(10), component(20)};
}

}  // namespace chartflood
