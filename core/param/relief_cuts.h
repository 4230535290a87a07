#pragma once
/// Slits a chart inside where it would stretch too much.

#include <optional>

#include "core/base/progress.h"
#include "core/model/chart_set.h"
#include "core/param/flat_attempt.h"

namespace chartflood {

/// A chart laid flat within a limit, as far as cuts can bring it there.
struct RelievedChart {
  FlatAttempt flat;
  std::optional<CutChart> chart;  ///< with its relief cuts, if it got any
};

/// Lays a disk flat, and while it stretches more than `limit`, cuts from where it is squeezed most
/// to the boundary. Cuts that do not help are taken back and others tried from other places; the
/// end is a map within the limit, or the best one when no more cuts help or too many were made.
/// Free maps are tried out loosely, without a look at whether the chart covers itself, and laid
/// flat in earnest once they are within the limit. \return anything when cancelled
RelievedChart layFlatWithin(double limit, const CutChart& chart, UnwrapOptions::Boundary boundary,
                            const Progress& progress);

}  // namespace chartflood
