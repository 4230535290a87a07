// Rows of the parameter table, and the bar slider they are made of.

#include <algorithm>
#include <cmath>

#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include "app/gui/widgets/widgets.h"
#include "app/host/script/command.h"
#include "app/host/settings/slider_scale.h"
#include "core/base/text.h"

namespace chartflood {

namespace {

constexpr float kDimmed = 0.4f;  ///< opacity of a row that says nothing with the present values

/// The colour with the opacity of what is being drawn.
ImU32 faded(ImU32 color) { return ImGui::GetColorU32(color); }

void drawBar(const Ui& ui, const BarSlider& slider, const ImRect& box, bool hot, bool active) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Palette& p = ui.theme.palette;
  const float rounding = ImGui::GetStyle().FrameRounding;
  list.AddRectFilled(box.Min, box.Max, faded(active || hot ? p.controlHovered : p.control),
                     rounding);
  const float x = box.Min.x + static_cast<float>(slider.fraction) * box.GetWidth();
  if (x > box.Min.x + 1) {
    list.PushClipRect(box.Min, {x, box.Max.y}, true);
    list.AddRectFilled(box.Min, box.Max, faded(p.accentSoft), rounding);
    list.PopClipRect();
    if (hot || active) list.AddRectFilled({x - 1, box.Min.y}, {x + 1, box.Max.y}, faded(p.accent));
  }
  if (ImGui::GetStyle().FrameBorderSize > 0) {
    list.AddRect(box.Min, box.Max, faded(p.line), rounding, 0, ImGui::GetStyle().FrameBorderSize);
  }
  if (slider.changed) ImGui::PushFont(ui.theme.strong);
  const ImVec2 size = ImGui::CalcTextSize(slider.text.c_str());
  list.AddText(
      {std::round(box.GetCenter().x - size.x / 2), std::round(box.GetCenter().y - size.y / 2)},
      faded(p.text), slider.text.c_str());
  if (slider.changed) ImGui::PopFont();
}

/// The text field that takes the bar's place while a value is typed.
void typeInto(const Ui& ui, const BarSlider& slider, float width) {
  UiMemory& memory = ui.memory;
  ImGui::SetNextItemWidth(width);
  if (memory.typingBegins) ImGui::SetKeyboardFocusHere();
  const bool entered =
      ImGui::InputText(("##type" + slider.label).c_str(), &memory.typed,
                       ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  ui.probe.item(slider.label);
  const bool left = !memory.typingBegins && ImGui::IsItemDeactivated();
  memory.typingBegins = false;
  if (entered) slider.typed(memory.typed);
  if (entered || left) memory.typing.clear();
}

void beginTyping(const Ui& ui, const BarSlider& slider) {
  ui.memory.typing = slider.label;
  ui.memory.typed = slider.text;
  ui.memory.typingBegins = true;
  ui.wakeIn(0);
}

/// Left and Right move by a step, with Shift by ten, Enter types, while the bar has the keyboard.
/// Up and Down lead to other rows.
void useKeys(const Ui& ui, const BarSlider& slider) {
  if (!ImGui::IsItemFocused() || GImGui->NavDisableHighlight) return;
  if (GImGui->NavActivateId == ImGui::GetItemID() && slider.typed && !ImGui::IsMouseDown(0)) {
    beginTyping(ui, slider);
  }
  if (!slider.nudged) return;
  const int steps = ImGui::GetIO().KeyShift ? 10 : 1;
  for (const auto& [key, direction] :
       {std::pair(ImGuiKey_LeftArrow, -1), {ImGuiKey_RightArrow, 1}}) {
    if (!ImGui::IsKeyPressed(ImGui::GetKeyIndex(key))) continue;
    ImGui::NavMoveRequestCancel();  // the keyboard stays with the bar
    slider.nudged(direction * steps);
  }
}

/// Text, then a subscript after "_", both from `x` on; returns the width.
float drawSymbol(const Ui& ui, const std::string& symbol, ImVec2 at) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const std::size_t bar = symbol.find('_');
  const std::string head = symbol.substr(0, bar);
  list.AddText(at, faded(ui.theme.palette.dim), head.c_str());
  float width = ImGui::CalcTextSize(head.c_str()).x;
  if (bar == std::string::npos) return width;
  ImGui::PushFont(ui.theme.small);
  const std::string sub = symbol.substr(bar + 1);
  list.AddText({at.x + width, at.y + ui.px(5)}, faded(ui.theme.palette.dim), sub.c_str());
  width += ImGui::CalcTextSize(sub.c_str()).x;
  ImGui::PopFont();
  return width;
}

/// Places of a row's parts: label | control | reset.
struct RowLayout {
  float left, control, width, reset;

  RowLayout(const Ui& ui, float extra = 0) {
    left = ImGui::GetCursorPosX();
    const float all = ImGui::GetContentRegionAvail().x;
    const float button = ImGui::GetFrameHeight();
    control = left + std::round(all * 0.5f);
    reset = left + all - button;
    width = reset - control - ui.px(4) - extra;
  }
};

void parameterLabel(const Ui& ui, const ParameterInfo& info, const RowLayout& row) {
  ImGui::SetCursorPosX(row.left);
  ImGui::AlignTextToFramePadding();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::TextUnformatted(info.label);
  ui.probe.item(std::string("label/") + info.id);
  if (*info.symbol != '\0') {
    drawSymbol(ui, info.symbol,
               {at.x + ImGui::CalcTextSize(info.label).x + ui.px(6),
                at.y + ImGui::GetStyle().FramePadding.y});
  }
  std::string help = info.help;
  if (*info.source != '\0') help += std::string("\nPaper, section ") + info.source;
  tooltip(ui, std::string("label/") + info.id, std::string(info.label) + "   --" + info.id, help);
  ImGui::SameLine();
  ImGui::SetCursorPosX(row.control);
}

std::string setLine(const ParameterInfo& info, const std::string& value, bool dragging) {
  return std::string("set ") + info.id + ' ' + quotedArgument(value) + (dragging ? " drag=on" : "");
}

void numberControl(const Ui& ui, const ParameterInfo& info, double value, bool changed,
                   float width) {
  auto textOf = [&info](double number) {
    const bool whole = std::holds_alternative<int Parameters::*>(info.member);
    return whole ? parameterText(static_cast<int>(std::lround(number))) : parameterText(number);
  };
  BarSlider slider;
  slider.label = info.id;
  slider.fraction = sliderFraction(info, value);
  slider.text = sliderText(info, value);
  slider.changed = changed;
  slider.moved = [&](double fraction, bool dragging) {
    ui.run(setLine(info, textOf(sliderValue(info, fraction)), dragging));
  };
  slider.typed = [&](const std::string& text) {
    const std::size_t unit = std::min(text.find("\u00b0"), text.find(' '));
    ui.run(setLine(info, text.substr(0, unit), false));
  };
  slider.nudged = [&](int steps) {
    double next = sliderValue(info, slider.fraction + 0.01 * steps);
    const bool whole = std::holds_alternative<int Parameters::*>(info.member);
    // A hundredth of the way may be less than one.
    if (whole && std::abs(next - value) < std::abs(steps)) next = value + steps;
    next = std::clamp(next, std::min(value, sliderValue(info, 0)),
                      std::max(value, sliderValue(info, 1)));
    if (next != value) ui.run(setLine(info, textOf(next), false));
  };
  slider.reset = [&] { ui.run(std::string("reset ") + info.id); };
  barSlider(ui, slider, width);
}

/// A number instead of one of the choices, taken when it has been typed.
void numberField(const Ui& ui, const ParameterInfo& info, const std::string& value) {
  char text[32] = "";
  std::snprintf(text, sizeof text, "%s", std::atof(value.c_str()) > 0 ? value.c_str() : "");
  const bool done = ImGui::InputTextWithHint(
      (std::string("##") + info.id + " number").c_str(), info.orNumber, text, sizeof text,
      ImGuiInputTextFlags_CharsScientific | ImGuiInputTextFlags_EnterReturnsTrue);
  ui.probe.item(std::string(info.id) + "/number");
  if (!done) return;
  ui.run(setLine(info, text, false));
  ImGui::CloseCurrentPopup();
}

void choiceControl(const Ui& ui, const ParameterInfo& info, const std::string& value, float width) {
  const auto present =
      std::find_if(info.choices.begin(), info.choices.end(),
                   [&](const ParameterChoice& choice) { return value == choice.id; });
  const char* shown = present == info.choices.end() ? value.c_str() : present->label;
  ImGui::SetNextItemWidth(width);
  const bool open = ImGui::BeginCombo((std::string("##") + info.id).c_str(), shown);
  ui.probe.item(info.id);
  if (!open) return;
  for (const ParameterChoice& choice : info.choices) {
    if (ImGui::Selectable(choice.label, value == choice.id)) {
      ui.run(setLine(info, choice.id, false));
    }
    ui.probe.item(std::string(info.id) + '/' + choice.id);
  }
  if (*info.orNumber != '\0') numberField(ui, info, value);
  ImGui::EndCombo();
}

void resetButton(const Ui& ui, const ParameterInfo& info, const RowLayout& row) {
  ImGui::SameLine();
  ImGui::SetCursorPosX(row.reset);
  const float side = ImGui::GetFrameHeight();
  ImGui::PushStyleColor(ImGuiCol_Button, IM_COL32(0, 0, 0, 0));
  iconButton(ui, Icon::Reset, std::string("reset ") + info.id, {side, side});
  ImGui::PopStyleColor();
}

}  // namespace

void barSlider(const Ui& ui, const BarSlider& slider, float width) {
  if (ui.memory.typing == slider.label) return typeInto(ui, slider, width);
  const ImVec2 size{width, ImGui::GetFrameHeight()};
  ImGui::InvisibleButton(("##" + slider.label).c_str(), size);
  const bool active = ImGui::IsItemActive();
  const bool released = ImGui::IsItemDeactivated();
  const ImRect box(ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
  drawBar(ui, slider, box, ImGui::IsItemHovered(), active);
  ui.probe.item(slider.label);
  useKeys(ui, slider);
  const ImGuiIO& io = ImGui::GetIO();
  if (ImGui::IsItemActivated() && io.KeyCtrl && slider.typed) {
    ImGui::ClearActiveID();
    return beginTyping(ui, slider);
  }
  if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0) && slider.reset) {
    ImGui::ClearActiveID();
    return slider.reset();
  }
  const double place = std::clamp((io.MousePos.x - box.Min.x) / box.GetWidth(), 0.0f, 1.0f);
  const bool byMouse = GImGui->ActiveIdSource == ImGuiInputSource_Mouse;
  if (active && byMouse && io.MouseDown[0]) slider.moved(place, true);
  if (released && io.MouseReleased[0]) slider.moved(place, false);
}

void parameterRow(const Ui& ui, const ParameterInfo& info) {
  const Parameters shown = inForce(ui.state.document().parameters, ui.state.results().features);
  const ParameterValue value = parameterValue(shown, info);
  const bool changed = !isDefault(ui.state.document().parameters, info);
  const bool dice = std::string_view(info.id) == "rng-seed";
  const float side = ImGui::GetFrameHeight();
  const RowLayout row(ui, dice ? side + ui.px(4) : 0);
  const std::string unused = whyUnused(ui.state.document().parameters, info);
  if (!unused.empty()) ImGui::PushStyleVar(ImGuiStyleVar_Alpha, kDimmed);
  const bool wanted = ui.state.panels.shownParameter == info.id;
  if (wanted) ui.state.panels.shownParameter.clear();
  parameterLabel(ui, info, row);
  if (wanted) {
    ImGui::SetScrollHereY(0.3f);
    ImGui::SetKeyboardFocusHere();
    GImGui->NavDisableHighlight = false;
  }
  if (const bool* on = std::get_if<bool>(&value)) {
    bool flag = *on;
    if (ImGui::Checkbox((std::string("##") + info.id).c_str(), &flag)) {
      ui.run(setLine(info, switchWord(flag), false));
    }
    ui.probe.item(info.id);
  } else if (const std::string* text = std::get_if<std::string>(&value)) {
    choiceControl(ui, info, *text, row.width);
  } else {
    numberControl(ui, info, asNumber(value), changed, row.width);
  }
  if (!unused.empty()) ImGui::PopStyleVar();  // what says why is not dimmed
  const char* hint = "Ctrl+click types a value, a double click brings the default.";
  const bool number = std::holds_alternative<int>(value) || std::holds_alternative<double>(value);
  tooltip(ui, info.id, info.label,
          (unused.empty() ? "" : unused + "\n") + info.help +
              (number ? std::string("\n") + hint : ""));
  if (dice) {
    ImGui::SameLine(0, ui.px(4));
    iconButton(ui, Icon::Dice, "roll-seed", {side, side});
  }
  if (changed) resetButton(ui, info, row);
}

}  // namespace chartflood
