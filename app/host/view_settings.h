#pragma once
/// How the model and its texture are looked at: plain values, saved with a session, never undone.

#include <span>
#include <vector>

#include "core/base/index.h"
#include "render/camera.h"
#include "render/color_vision.h"
#include "render/render_settings.h"
#include "render/uv_camera.h"

namespace chartflood {

struct ViewSettings {
  RenderSettings render;
  Camera camera;
  UvStyle uv;
  UvCamera uvCamera;
  std::vector<Index> chartColors;          ///< number of each chart's colour in the palette
  bool isolate = false;                    ///< only the selected chart is shown
  bool frameWhenLoaded = true;             ///< the camera has yet to be set up for a new model
  std::vector<glm::dvec3> pointsToFrame;   ///< the camera has yet to come close to these
  bool sphereLinked = true;                ///< the Gauss sphere turns with the model
  ColorVision vision = ColorVision::Full;  ///< pictures on the screen are shown as seen with it
  Camera sphereCamera;  ///< how it is seen otherwise; only the orientation counts
};

/// The colour modes whose values are computed, in the order of the menu.
std::span<const ColorMode> availableColorModes();

/// The modes that share a number key with this one, itself included; the sub-choice key cycles
/// through them.
std::span<const ColorMode> colorModeFamily(ColorMode mode);

}  // namespace chartflood
