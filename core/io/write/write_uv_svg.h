#pragma once
/// The layout of the charts in the texture as SVG.

#include <cstdint>
#include <span>
#include <string>

#include "core/io/write/charted_mesh.h"

namespace chartflood {

struct UvSvgOptions {
  int size = 0;  ///< side of the square in pixels; 0: the atlas's texture size, or 1024 without one
  std::span<const std::uint32_t> colors{};  ///< of each chart, 0xRRGGBB; missing ones are grey
  double lineWidth = 1.5;                   ///< pixels
  bool fill = true;
  bool numbers = true;
  bool transparent = false;  ///< without the white background
};

/// One square of `size` pixels that is the texture: u from 0 to 1 runs to the right, v from 0 to 1
/// upwards. Every chart that is laid flat is a group `chart_000`, .. with one closed path, the
/// boundary of its surface (cuts are run along on both sides), and its number inside.
/// Coordinates are rounded to 1/1000 pixel.
/// Cost: linear in the surfaces; the place of a number about 50 times its chart's outline.
std::string uvSvgText(const ChartedMesh& charted, const UvSvgOptions& options = {});

}  // namespace chartflood
