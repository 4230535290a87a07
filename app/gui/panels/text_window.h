#pragma once
/// The frame of windows that stand over the others until they are closed.

#include <functional>
#include <string_view>

#include "app/gui/widgets/ui.h"

namespace chartflood {

/// A window in the middle that Esc or its cross closes by running `line`. Noted under its title.
void textWindow(const Ui& ui, const char* title, std::string_view line, ImVec2 size,
                const std::function<void()>& content);

}  // namespace chartflood
