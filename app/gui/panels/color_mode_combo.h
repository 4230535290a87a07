#pragma once
/// The choice of what the colours say, as a combo box and as menu entries.

#include "app/gui/widgets/ui.h"

namespace chartflood {

void colorModeCombo(const Ui& ui, float width);
void colorModeMenu(const Ui& ui);

}  // namespace chartflood
