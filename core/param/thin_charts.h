#pragma once
/// Lays charts of thin triangles flat, which the equations of maps follow badly.

#include <optional>

#include "core/base/progress.h"
#include "core/model/chart_set.h"
#include "core/param/relief_cuts.h"

namespace chartflood {

/// Lays a chart flat with a free boundary where thin triangles ask for more than maps can do. What
/// is made of these is mostly developable: such a chart is unfolded exactly where it can be, opened
/// at its cones and rims when it may be cut. Where only some triangles are thin, so much that they
/// might flip when places are rounded, the equations widen them; that stretches nothing that has an
/// area. \return nothing where maps do as well
std::optional<RelievedChart> layThinFlat(const CutChart& chart, bool mayCut,
                                         const Progress& progress);

}  // namespace chartflood
