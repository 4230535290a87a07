#pragma once
/// How the model and its texture are looked at: plain values, saved with a session, never undone.

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/index.h"
#include "render/scene/camera.h"
#include "render/scene/color_vision.h"
#include "render/scene/render_settings.h"
#include "render/scene/uv_camera.h"

namespace chartflood {

/// How one colour mode's values become colours.
struct LegendChoice {
  std::string colorMap;  ///< id of a map; "": the mode's own
  bool invert = false;
  int steps = 0;                                   ///< flat steps; 0: smooth
  bool clamp = true;                               ///< false: faces out of the range are grey
  std::optional<ScalarScale> scale;                ///< nothing: the mode's own
  std::optional<std::pair<double, double>> range;  ///< nothing: from the values

  bool operator==(const LegendChoice&) const = default;
};

struct ViewSettings {
  RenderSettings render;
  Camera camera;
  UvStyle uv;
  UvCamera uvCamera;
  std::vector<Index> chartColors;  ///< number of each chart's colour in the palette
  unsigned recolored = 0;  ///< times that these were changed by hand: the renderer takes them over
  std::map<ColorMode, LegendChoice> legends;  ///< of the modes that are not shown now
  std::string checkerFile;                    ///< of the picture on the checkerboard; "": none
  std::vector<Index> hiddenCharts;            ///< put away by hand, ascending
  bool isolate = false;                       ///< only the selected chart is shown
  bool frameWhenLoaded = true;                ///< the camera has yet to be set up for a new model
  std::vector<glm::dvec3> pointsToFrame;      ///< the camera has yet to come close to these
  bool sphereLinked = true;                   ///< the Gauss sphere turns with the model
  ColorVision vision = ColorVision::Full;     ///< pictures on the screen are shown as seen with it
  Camera sphereCamera;  ///< how it is seen otherwise; only the orientation counts
};

/// The choices of the mode that is shown.
LegendChoice presentLegend(const RenderSettings& render);
void setLegend(RenderSettings& render, const LegendChoice& choice);
/// Shows another mode with the legend that it had.
void showColorMode(ViewSettings& view, ColorMode mode);

}  // namespace chartflood
