#pragma once
/// What numbers of charts cost and give, of those that were tried.

#include "app/gui/widgets/ui.h"

namespace chartflood {

/// Stretch and seam length over the number of charts; a click uses a number. Nothing is drawn while
/// none was tried.
void chartCountPlot(const Ui& ui, float height);

}  // namespace chartflood
