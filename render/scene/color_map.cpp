#include "render/scene/color_map.h"

#include <algorithm>
#include <cmath>

namespace chartflood {

namespace {

constexpr const char* kMatplotlib = "S. van der Walt and N. Smith, matplotlib 1.5, public domain";
constexpr const char* kBrewer = "C. Brewer, ColorBrewer 2.0 (RdBu, PuOr, PRGn)";

constexpr std::uint32_t kViridis[] = {0x440154, 0x481A6C, 0x472F7D, 0x414487, 0x39568C, 0x31688E,
                                      0x2A788E, 0x23888E, 0x1F988B, 0x22A884, 0x35B779, 0x54C568,
                                      0x7AD151, 0xA5DB36, 0xD2E21B, 0xFDE725};
constexpr std::uint32_t kCividis[] = {0x00204D, 0x00336F, 0x39486B, 0x575C6D, 0x707173,
                                      0x8A8779, 0xA69D75, 0xC4B56C, 0xE4CF5B, 0xFFEA46};
constexpr std::uint32_t kMagma[] = {0x000004, 0x0B0924, 0x20114B, 0x3B0F70, 0x57157E, 0x721F81,
                                    0x8C2981, 0xA8327D, 0xC43C75, 0xDE4968, 0xF1605D, 0xFA7F5E,
                                    0xFE9F6D, 0xFEBF84, 0xFDDE9F, 0xFCFDBF};
constexpr std::uint32_t kGrey[] = {0x1E1E1E, 0xF5F5F5};
constexpr std::uint32_t kEmber[] = {0xF2EFE6, 0xFBE6A2, 0xFED976, 0xFEB24C, 0xFD8D3C,
                                    0xFC4E2A, 0xE31A1C, 0xBD0026, 0x800026};
constexpr std::uint32_t kBlueOrange[] = {0x053061, 0x2166AC, 0x4393C3, 0x92C5DE, 0xD1E5F0, 0xF7F7F7,
                                         0xFEE0B6, 0xFDB863, 0xE08214, 0xB35806, 0x7F3B08};
constexpr std::uint32_t kPurpleGreen[] = {0x40004B, 0x762A83, 0x9970AB, 0xC2A5CF,
                                          0xE7D4E8, 0xF7F7F7, 0xD9F0D3, 0xA6DBA0,
                                          0x5AAE61, 0x1B7837, 0x00441B};
constexpr std::uint32_t kPaper[] = {0x0000FF, 0x00FFFF, 0x00FF00, 0xFFFF00, 0xFF0000};

constexpr ColorMap kMaps[] = {
    {"viridis", "Viridis", false, true, kMatplotlib, kViridis},
    {"cividis", "Cividis", false, true, "J. Nunez, C. Anderton, R. Renslow, PLOS ONE 13(7), 2018",
     kCividis},
    {"magma", "Magma", false, true, kMatplotlib, kMagma},
    {"ember", "Ember", false, true, "C. Brewer, ColorBrewer 2.0 (YlOrRd), from a paler end",
     kEmber},
    {"grey", "Grey", false, true, "two greys", kGrey},
    {"blue-orange", "Blue - white - orange", true, true, kBrewer, kBlueOrange},
    {"purple-green", "Purple - white - green", true, true, kBrewer, kPurpleGreen},
    {"paper", "Paper: blue to red (not colour-blind safe)", false, false,
     "likeness of the paper's figure 5", kPaper},
};

float decode(float c) { return c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f); }

glm::vec3 toVector(std::uint32_t hex) {
  const Rgb8 c = rgb8(hex);
  return glm::vec3(c[0], c[1], c[2]) / 255.0f;
}

}  // namespace

glm::vec3 ColorMap::at(float t) const {
  const float place = std::clamp(t, 0.0f, 1.0f) * static_cast<float>(controls.size() - 1);
  const std::size_t left = std::min(static_cast<std::size_t>(place), controls.size() - 2);
  const float share = place - static_cast<float>(left);
  return toVector(controls[left]) * (1 - share) + toVector(controls[left + 1]) * share;
}

std::span<const ColorMap> colorMapTable() { return kMaps; }

const ColorMap* findColorMap(std::string_view id) {
  const auto found = std::find_if(std::begin(kMaps), std::end(kMaps),
                                  [&](const ColorMap& m) { return m.id == id; });
  return found == std::end(kMaps) ? nullptr : &*found;
}

float lightness(const glm::vec3& color) {
  const float y = 0.2126f * decode(color.x) + 0.7152f * decode(color.y) + 0.0722f * decode(color.z);
  return y > 0.008856f ? 116 * std::cbrt(y) - 16 : 903.3f * y;
}

}  // namespace chartflood
