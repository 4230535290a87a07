#pragma once
/// The values of colour modes and their ranges, for the model, for pictures and for plots alike.
/// No GL.

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "core/model/chart_stats.h"
#include "core/model/flood_record.h"
#include "core/model/mesh.h"
#include "core/model/segmentation.h"
#include "core/model/unwrap.h"
#include "render/scene/color_modes.h"
#include "render/scene/gauss_values.h"
#include "render/scene/render_settings.h"
#include "render/scene/scalar_range.h"
#include "render/scene/uv_layout.h"

namespace chartflood {

/// What values are made from; parts may be null.
struct ModeSource {
  std::shared_ptr<const Mesh> mesh;
  std::shared_ptr<const GaussValues> gauss;
  std::shared_ptr<const Segmentation> segmentation;
  /// Of the charts at another moment, in place of the areas of `segmentation`.
  std::shared_ptr<const ChartStats> stats;
  std::shared_ptr<const FloodRecord> record;
  std::size_t recorded = 0;  ///< entries that `record` had
  std::size_t taken = 0;     ///< the first so many of them are to be counted
  std::shared_ptr<const Unwrap> unwrap;
  std::shared_ptr<const UvLayout> layout;

  bool operator==(const ModeSource&) const = default;
};

/// One value an element of the mode's domain, NaN for none; triangles and charts weigh their area,
/// creases their length, corners 1.
struct ModeValues {
  std::vector<WeightedValue> values;
  ScalarRange range;  ///< with title, unit and scale
};

/// True when the mode has something to show; a part that does not fit the mesh is none.
bool canShow(ColorMode mode, const ModeSource& source);
/// The source without what the mode has no use for: while it stays, so do the values.
ModeSource neededBy(ColorMode mode, const ModeSource& source);
/// The values of a mode at a moment; none where canShow() is false and for modes without values.
ModeValues modeValues(ColorMode mode, const ModeSource& source);
/// The mode whose values an element of the mode's domain shows: for modes of all kinds of elements
/// that of the one kind.
ColorMode modeOfElement(ColorMode mode, ValueDomain element);

/// The ends that the mode's rule finds for these values, with its title, unit and scale.
ScalarRange modeRange(ColorMode mode, std::span<const WeightedValue> values);
/// The range with what the settings choose instead.
ScalarRange chosenRange(ScalarRange range, const RenderSettings& settings);

}  // namespace chartflood
