#pragma once
/// The controls that panels are made of. Each shows a value of the state and emits a script line;
/// none keeps a value of its own. Each notes its rectangle under its label.

#include <functional>
#include <string>
#include <string_view>

#include "app/gui/widgets/icons.h"
#include "app/gui/widgets/ui.h"
#include "core/session/settings/parameters.h"

namespace chartflood {

/// Shows `text` over the last widget after half a second of resting on it.
void tooltip(const Ui& ui, std::string_view label, std::string_view title, std::string_view text);

/// A button with a picture that runs `line`; greyed with the reason when it cannot run.
void iconButton(const Ui& ui, Icon icon, std::string_view line, ImVec2 size);
/// A button with words that runs `line`.
void textButton(const Ui& ui, const char* words, std::string_view line, ImVec2 size = {0, 0});

/// A menu, in the bar or in another one, noted as "menu/NAME", and as "menu-body/NAME" when it is
/// open; to be ended by ImGui::EndMenu() then.
bool beginMenu(const Ui& ui, const char* name, bool enabled = true);

/// A menu entry for `line` with its key, tick and reason; `title` "" takes the action's own.
void actionMenuItem(const Ui& ui, std::string_view line, const std::string& title = "");

/// One entry for each choice of an action's first argument, by its label.
void choiceMenuItems(const Ui& ui, std::string_view action);

/// The label of a row; the control follows at that share of the width.
void rowLabel(const char* words, float share);

/// A tick box that runs `line` when clicked.
void switchRow(const Ui& ui, const char* words, bool on, std::string_view line);

/// What a bar slider has to know.
struct BarSlider {
  std::string label;     ///< unique; also its name in the probe
  double fraction;       ///< where it stands, 0 to 1
  std::string text;      ///< the value as shown
  bool changed = false;  ///< the value differs from its default
  /// Called with the place under the mouse while it is dragged, and once more on release with
  /// `dragging` false.
  std::function<void(double fraction, bool dragging)> moved;
  /// Called with what was typed after Ctrl+click or Enter; none: cannot be typed into.
  std::function<void(const std::string&)> typed;
  /// Called with the steps that arrow keys ask for while it has the keyboard; may be empty.
  std::function<void(int)> nudged = {};
  /// Called on a double click; may be empty.
  std::function<void()> reset = {};
};

/// A horizontal bar that fills up to the value, which stands on it.
void barSlider(const Ui& ui, const BarSlider& slider, float width);

/// A row of the parameter table: label, symbol, control, reset. Fits the present width.
void parameterRow(const Ui& ui, const ParameterInfo& info);

/// A heading that folds what follows, unfolded when `openNow`; returns whether it is open. With
/// `stale` it carries a dot, and the words are its tooltip.
bool section(const Ui& ui, const char* title, bool openAtFirst = true, bool openNow = false,
             const std::string& stale = "");

/// A vertical line between two panels that can be dragged; changes `width` of the left one, or of
/// the right one when `right`.
void splitter(const Ui& ui, const char* label, ImVec2 position, float height, float& width,
              bool right, float least, float most);

/// Text cut at `width` with an ellipsis; the whole text is its tooltip when it was cut, and it is
/// noted as "cut/<text>".
void fittedText(const Ui& ui, const std::string& text, float width, ImU32 color);

/// Number with thin spaces between thousands: "69 451".
std::string grouped(std::size_t number);

}  // namespace chartflood
