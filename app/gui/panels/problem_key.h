#pragma once
/// What the marks of problems on the model mean.

#include "app/gui/widgets/ui.h"
#include "app/host/insight/problems.h"

namespace chartflood {

/// The pattern or line of a kind as a picture has it, in a square of this side.
void problemSwatch(const Ui& ui, ProblemKind kind, ImVec2 low, float side);

/// One line: swatch and words; a click shows the next place of the kind. `width` of the line.
void problemRow(const Ui& ui, const Problem& problem, float width, const char* scope);

/// The key of all marks that are shown, at the left of the 3D view from `areaMin` on.
void problemKey(const Ui& ui, ImVec2 areaMin);

}  // namespace chartflood
