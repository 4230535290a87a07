#include "app/host/view_settings.h"

#include <algorithm>
#include <array>

namespace chartflood {

namespace {

constexpr std::array kModes = {
    ColorMode::Shaded,      ColorMode::Charts,         ColorMode::Gauss,
    ColorMode::GaussVertex, ColorMode::GaussEdge,      ColorMode::GaussFace,
    ColorMode::Balance,     ColorMode::FloodTime,      ColorMode::FloodOrder,
    ColorMode::Stretch,     ColorMode::AreaDistortion, ColorMode::AngleDistortion,
    ColorMode::Checkerboard};

constexpr std::array kGauss = {ColorMode::Gauss, ColorMode::GaussVertex, ColorMode::GaussEdge,
                               ColorMode::GaussFace};
constexpr std::array kFlood = {ColorMode::FloodTime, ColorMode::FloodOrder};

}  // namespace

std::span<const ColorMode> availableColorModes() { return kModes; }

std::span<const ColorMode> colorModeFamily(ColorMode mode) {
  if (std::find(kGauss.begin(), kGauss.end(), mode) != kGauss.end()) return kGauss;
  if (std::find(kFlood.begin(), kFlood.end(), mode) != kFlood.end()) return kFlood;
  const auto single = std::find(kModes.begin(), kModes.end(), mode);
  if (single == kModes.end()) return {};
  return {&*single, 1};
}

}  // namespace chartflood
