#pragma once
/// Everything that can be chosen about a picture, as plain values.

#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "core/base/index.h"
#include "render/scene/color_modes.h"

namespace chartflood {

class Image;

/// How fine a checkerboard can be.
inline constexpr double kFewestCheckerSquares = 1, kMostCheckerSquares = 1000;
inline constexpr int kMostCheckerRepeats = 64;

/// What stands on the checkerboard.
enum class CheckerKind {
  Squares,
  Numbers,  ///< squares with a letter for the column and a digit for the row
  Circles,  ///< one disc in each square: it shows in which direction the surface is stretched
  Picture,  ///< the user's own, in place of the squares
};
/// "squares", "numbers", "circles", "picture". \throws UsageError otherwise.
CheckerKind checkerKindFromId(std::string_view id);
const char* checkerKindId(CheckerKind kind);

/// The ground behind the model; sRGB in [0, 1].
struct Background {
  glm::vec3 bottom{0.137f};
  glm::vec3 top{0.212f};
  bool transparent = false;  ///< no ground at all

  bool operator==(const Background&) const = default;
};
/// "transparent", "dark", "white", "black", "#RRGGBB", "RRGGBB" or "R,G,B" with 0-255.
/// \throws UsageError for anything else.
Background backgroundFromText(std::string_view text);

/// Widths are in pixels of a screen at 100 %; pictures multiply them by `pixelScale`.
struct RenderSettings {
  ColorMode colorMode = ColorMode::Charts;
  std::string colorMap;  ///< id of a map; "": the mode's own
  bool invertColorMap = false;
  int colorSteps = 0;                              ///< flat steps on the map; 0: smooth
  bool clampColors = true;                         ///< false: faces out of the range are grey
  std::optional<ScalarScale> scale;                ///< nothing: the mode's own
  std::optional<std::pair<double, double>> range;  ///< nothing: from the values
  std::string palette = "muted";                   ///< chart colours

  bool seams = true;        ///< lines between charts
  bool cuts = true;         ///< lines along which a chart is opened
  bool edges = false;       ///< mesh edges
  bool sharpEdges = false;  ///< creases
  bool seedMarks = true;
  bool numbers = false;   ///< chart numbers on the model
  bool scalarBar = true;  ///< in modes that have one
  bool problems = false;  ///< marks of Renderer::setMarks()
  bool lighting = true;   ///< false: flat colours, for measuring
  bool smoothNormals = true;

  Background background;
  float pixelScale = 1;  ///< of all widths and letters
  float seamWidth = 1.8f;
  float cutWidth = 2.0f;
  float edgeWidth = 1.0f;
  float textSize = 13.0f;  ///< height of an em
  float seedRadius = 8.0f;

  /// Squares of the checkerboard along the diagonal of the model's bounding box, of one size on
  /// the whole surface; with `checkerInTexture` along a side of the texture.
  float checkerSquares = 40;
  bool checkerInTexture = false;
  CheckerKind checkerKind = CheckerKind::Squares;
  std::shared_ptr<const Image> checkerPicture;  ///< of CheckerKind::Picture; null: squares instead
  float checkerRepeats = 1;                     ///< pictures along a side of the texture
  float checkerTint = 0.55f;  ///< how far the two greys lean towards the chart's colour, 0 to 1

  /// Shows the recorded flood with only the first so many faces taken; nothing: the labels.
  std::optional<std::size_t> playhead;
  bool front = true;  ///< the faces taken last are bright

  Index flashFace = kNone;            ///< stands out, for a moment
  Index hoverFace = kNone;            ///< drawn brighter, its chart a little
  Index hoverChart = kNone;           ///< drawn a little brighter where no face is
  std::vector<Index> selectedCharts;  ///< when not empty, the others step back
  std::vector<Index> hiddenCharts;    ///< not drawn at all

  bool operator==(const RenderSettings&) const = default;
};

/// What a picture of the texture shows beside RenderSettings.
struct UvStyle {
  bool fill = true;           ///< false: outlines alone
  bool frame = true;          ///< the texture's border with numbers, and a grid
  float outlineWidth = 1.4f;  ///< of the charts' borders; pixels as in RenderSettings

  bool operator==(const UvStyle&) const = default;
};

/// Whether a list of charts, as the settings keep them, holds one.
inline bool holdsChart(const std::vector<Index>& charts, Index chart) {
  return std::find(charts.begin(), charts.end(), chart) != charts.end();
}

}  // namespace chartflood
