#pragma once
/// The values of colour modes and their ranges, for pictures and for plots alike. No GL.

#include <span>
#include <vector>

#include "render/scene/scalar_range.h"

namespace chartflood {

/// Gauss area of each chart against the mean, per cent: 0 carries the mean. Zeros where the mean
/// vanishes.
std::vector<float> balanceValues(std::span<const double> gaussArea);
/// Symmetric range for balanceValues().
ScalarRange balanceRange(std::span<const float> balance);

/// Range of an unwrap's distortion (Stretch, AreaDistortion, AngleDistortion): from the undistorted
/// value on, the tail of the surface cut at 98 %. One value and one area a triangle.
ScalarRange distortionRange(ColorMode mode, std::span<const float> values,
                            std::span<const double> areas);

/// The range with what the settings choose instead.
ScalarRange chosenRange(ScalarRange range, const RenderSettings& settings);

}  // namespace chartflood
