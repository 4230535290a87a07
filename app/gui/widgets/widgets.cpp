#include "app/gui/widgets/widgets.h"

#include <algorithm>
#include <cmath>

#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include "app/host/script/command.h"

namespace chartflood {

namespace {

constexpr double kTooltipDelay = 0.5;

const Action* actionOf(const Ui& ui, std::string_view line) {
  return ui.actions.find(parseCommand(line).action);
}

/// About as large as the words will be.
ImVec2 tooltipSize(const Ui& ui, std::string_view title, std::string_view text, float wrap,
                   ImVec2 padding) {
  const auto sizeOf = [&](std::string_view words, ImFont* font) {
    if (words.empty()) return ImVec2(0, 0);
    ImGui::PushFont(font);
    const ImVec2 size = ImGui::CalcTextSize(words.data(), words.data() + words.size(), false, wrap);
    ImGui::PopFont();
    return ImVec2(size.x, size.y + ImGui::GetStyle().ItemSpacing.y);
  };
  const ImVec2 head = sizeOf(title, ui.theme.strong), body = sizeOf(text, ImGui::GetFont());
  return {std::max(head.x, body.x) + 2 * padding.x, head.y + body.y + 2 * padding.y};
}

/// Beside what it explains: below or above the last widget and within the width of its panel where
/// that is wide enough, to the right of a menu.
void placeTooltip(const Ui& ui, ImVec2 size) {
  const ImGuiWindow& window = *GImGui->CurrentWindow;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  const float gap = ui.px(6);
  const bool menu = (window.Flags & (ImGuiWindowFlags_ChildMenu | ImGuiWindowFlags_Popup)) != 0;
  ImVec2 place(low.x, high.y + gap);
  if (menu) {
    place = {window.Pos.x + window.Size.x + gap, low.y};
    if (place.x + size.x > screen.x) place.x = window.Pos.x - size.x - gap;
  } else {
    const bool inPanel = size.x <= window.Size.x;
    const float right = inPanel ? window.Pos.x + window.Size.x : screen.x;
    place.x = std::min(place.x, right - size.x);
    if (place.y + size.y > screen.y) place.y = low.y - size.y - gap;
  }
  ImGui::SetNextWindowPos({std::max(0.0f, std::round(std::min(place.x, screen.x - size.x))),
                           std::max(0.0f, std::round(std::min(place.y, screen.y - size.y)))});
}

/// Title with key, help and, where it cannot run, the reason.
void actionTooltip(const Ui& ui, std::string_view line, const std::string& reason) {
  const Action* action = actionOf(ui, line);
  if (action == nullptr) return;
  const std::string key = ui.actions.shortcut(line);
  const std::string title = key.empty() ? action->title : action->title + "   " + key;
  tooltip(ui, line, title, reason.empty() ? action->help : action->help + "\n" + reason);
}

/// Runs a widget greyed out when `reason` is not empty. Hovering still works there.
template <typename Widget>
bool guarded(const std::string& reason, Widget&& widget) {
  if (reason.empty()) return widget();
  ImGui::PushStyleVar(ImGuiStyleVar_Alpha, ImGui::GetStyle().Alpha * 0.42f);
  ImGui::PushItemFlag(ImGuiItemFlags_Disabled, true);
  widget();
  ImGui::PopItemFlag();
  ImGui::PopStyleVar();
  return false;
}

}  // namespace

void tooltip(const Ui& ui, std::string_view label, std::string_view title, std::string_view text) {
  const bool focused = ImGui::IsItemFocused() && GImGui->NavDisableHighlight == false;
  if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled) && !focused) return;
  if (ImGui::IsItemActive() || ImGui::IsMouseDown(0)) return;
  UiMemory& memory = ui.memory;
  if (memory.hovered != label) {
    memory.hovered = label;
    memory.hoveredSince = ImGui::GetTime();
  }
  memory.hoveredSeen = true;
  const double rested = ImGui::GetTime() - memory.hoveredSince;
  if (rested < kTooltipDelay) return ui.wakeIn(kTooltipDelay - rested);
  const ImVec2 padding(ui.px(10), ui.px(8));
  const float frame = 2 * padding.x + ui.px(8), panel = GImGui->CurrentWindow->Size.x;
  const float room = panel >= ui.px(220) ? panel : ImGui::GetIO().DisplaySize.x;
  const float wrap = std::min(ui.px(320), room - frame);
  placeTooltip(ui, tooltipSize(ui, title, text, wrap, padding));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
  ImGui::BeginTooltip();
  ui.probe.rectangle("tooltip", ImGui::GetWindowPos(),
                     {ImGui::GetWindowPos().x + ImGui::GetWindowSize().x,
                      ImGui::GetWindowPos().y + ImGui::GetWindowSize().y});
  ImGui::PushTextWrapPos(padding.x + wrap);
  if (!title.empty()) {
    ImGui::PushFont(ui.theme.strong);
    ImGui::TextUnformatted(title.data(), title.data() + title.size());
    ImGui::PopFont();
  }
  if (!text.empty()) ImGui::TextUnformatted(text.data(), text.data() + text.size());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
  ImGui::PopStyleVar();
}

void iconButton(const Ui& ui, Icon icon, std::string_view line, ImVec2 size) {
  const std::string reason = ui.actions.refusal(line, ui.state);
  const std::string id = "##" + std::string(line);
  const bool clicked = guarded(reason, [&] {
    const bool pressed = ImGui::Button(id.c_str(), size);
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    const ImVec2 center{(low.x + high.x) / 2, (low.y + high.y) / 2};
    drawIcon(*ImGui::GetWindowDrawList(), icon, center, ui.px(15),
             ImGui::GetColorU32(ImGuiCol_Text));
    return pressed;
  });
  ui.probe.item(line);
  actionTooltip(ui, line, reason);
  if (clicked) ui.run(line);
}

void textButton(const Ui& ui, const char* words, std::string_view line, ImVec2 size) {
  const std::string reason = ui.actions.refusal(line, ui.state);
  ImGui::PushID(line.data(), line.data() + line.size());
  const bool clicked = guarded(reason, [&] { return ImGui::Button(words, size); });
  ImGui::PopID();
  ui.probe.item(line);
  actionTooltip(ui, line, reason);
  if (clicked) ui.run(line);
}

bool beginMenu(const Ui& ui, const char* name, bool enabled) {
  if (!ImGui::BeginMenu(name, enabled)) {
    ui.probe.item(std::string("menu/") + name);
    return false;
  }
  // As high as its entries want it, where the screen leaves less.
  const ImGuiWindow& body = *GImGui->CurrentWindow;
  const float wanted = body.ContentSizeIdeal.y + 2 * body.WindowPadding.y;
  ui.probe.rectangle(std::string("menu-body/") + name, body.Pos,
                     {body.Pos.x + body.Size.x, body.Pos.y + std::max(body.Size.y, wanted)});
  return true;
}

void actionMenuItem(const Ui& ui, std::string_view line, const std::string& title) {
  const Action* action = actionOf(ui, line);
  if (action == nullptr) return;
  const std::string reason = ui.actions.refusal(line, ui.state);
  const std::string key = ui.actions.shortcut(line);
  ImGui::PushID(line.data(), line.data() + line.size());
  const bool clicked =
      ImGui::MenuItem(title.empty() ? action->title.c_str() : title.c_str(), key.c_str(),
                      ui.actions.checked(line, ui.state), reason.empty());
  ImGui::PopID();
  ui.probe.item("menu/" + std::string(line));
  tooltip(ui, line, "", reason.empty() ? action->help : reason);
  if (clicked) ui.run(line);
}

void choiceMenuItems(const Ui& ui, std::string_view action) {
  const ArgumentInfo& choice = ui.actions.find(action)->arguments.front();
  for (std::size_t i = 0; i < choice.choices.size(); ++i) {
    const std::string& label = i < choice.labels.size() ? choice.labels[i] : choice.choices[i];
    actionMenuItem(ui, std::string(action) + ' ' + choice.choices[i], label);
  }
}

void rowLabel(const char* words, float share) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(words);
  ImGui::SameLine(std::round(ImGui::GetWindowContentRegionMax().x * share));
}

void switchRow(const Ui& ui, const char* words, bool on, std::string_view line) {
  const std::string reason = ui.actions.refusal(line, ui.state);
  ImGui::PushID(line.data(), line.data() + line.size());
  const bool clicked = guarded(reason, [&] { return ImGui::Checkbox(words, &on); });
  ImGui::PopID();
  ui.probe.item(line);
  actionTooltip(ui, line, reason);
  if (clicked) ui.run(line);
}

bool section(const Ui& ui, const char* title, bool openAtFirst, bool openNow,
             const std::string& stale) {
  ImGui::Dummy({0, ui.px(1)});
  ImGui::PushFont(ui.theme.strong);
  ImGui::PushStyleColor(ImGuiCol_Header, ui.theme.palette.bar);
  ImGui::PushStyleColor(ImGuiCol_HeaderHovered, ui.theme.palette.control);
  ImGui::SetNextItemOpen(openAtFirst || openNow, openNow ? ImGuiCond_Always : ImGuiCond_Once);
  const bool open = ImGui::CollapsingHeader(title, ImGuiTreeNodeFlags_SpanAvailWidth);
  ImGui::PopStyleColor(2);
  ImGui::PopFont();
  ui.probe.item(std::string("section/") + title);
  if (stale.empty()) return open;
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  const ImVec2 at{high.x - ui.px(14), (low.y + high.y) / 2};
  const float radius = ui.px(4);
  ImGui::GetWindowDrawList()->AddCircleFilled(at, radius, ui.theme.palette.front);
  ui.probe.rectangle(std::string("stale/") + title, {at.x - radius, at.y - radius},
                     {at.x + radius, at.y + radius});
  tooltip(ui, std::string("section/") + title, "", stale);
  return open;
}

void splitter(const Ui& ui, const char* label, ImVec2 position, float height, float& width,
              bool right, float least, float most) {
  const float grip = ui.px(6);
  ImGui::SetNextWindowPos({position.x - grip / 2, position.y});
  ImGui::SetNextWindowSize({grip, height});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
  ImGui::Begin(label, nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBackground |
                   ImGuiWindowFlags_NoNav);
  ImGui::InvisibleButton("grip", {grip, height});
  ui.probe.item(label);
  const bool active = ImGui::IsItemActive();
  if (active || ImGui::IsItemHovered()) {
    ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    ImGui::GetWindowDrawList()->AddRectFilled({position.x - 1, position.y},
                                              {position.x + 1, position.y + height},
                                              ui.theme.palette.accent);
  }
  if (active) width += right ? -ImGui::GetIO().MouseDelta.x : ImGui::GetIO().MouseDelta.x;
  width = std::clamp(width, least, std::max(least, most));
  ImGui::End();
  ImGui::PopStyleVar(2);
}

void fittedText(const Ui& ui, const std::string& text, float width, ImU32 color) {
  ImVec2 at = ImGui::GetCursorScreenPos();
  at.y += GImGui->CurrentWindow->DC.CurrLineTextBaseOffset;
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  ImGui::Dummy({std::min(size.x, width), size.y});
  ImGui::PushStyleColor(ImGuiCol_Text, color);
  ImGui::RenderTextEllipsis(ImGui::GetWindowDrawList(), at, {at.x + width, at.y + size.y},
                            at.x + width, at.x + width, text.c_str(), nullptr, &size);
  ImGui::PopStyleColor();
  if (size.x <= width) return;
  ui.probe.item("cut/" + text);
  tooltip(ui, text, "", text);
}

std::string grouped(std::size_t number) {
  std::string digits = std::to_string(number), text;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > 0 && (digits.size() - i) % 3 == 0) text += "\u00a0";
    text += digits[i];
  }
  return text;
}

}  // namespace chartflood
