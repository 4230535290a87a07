#pragma once
/// The values behind the colours of the model, in the same range and the same colours.

#include <cstddef>

#include "app/gui/widgets/ui.h"
#include "app/host/insight/histogram.h"

namespace chartflood {

/// Draws one histogram; `number` tells several of one mode apart.
void histogramPlot(const Ui& ui, const ModeHistogram& plot, std::size_t number, float height);
/// The plot of a mode without values.
void emptyHistogram(const Ui& ui);

}  // namespace chartflood
