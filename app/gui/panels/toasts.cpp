// Sentences over the 3D view, and the card of first steps.

#include <algorithm>
#include <cmath>
#include <iterator>

#include "app/gui/panels/panels.h"
#include "app/gui/widgets/widgets.h"

namespace chartflood {

namespace {

constexpr ImGuiWindowFlags kOverlay = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                      ImGuiWindowFlags_NoSavedSettings |
                                      ImGuiWindowFlags_AlwaysAutoResize |
                                      ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav;

ImU32 kindColor(const Palette& palette, Notice::Kind kind) {
  switch (kind) {
  case Notice::Kind::Error:
    return palette.error;
  case Notice::Kind::Warning:
    return palette.warning;
  case Notice::Kind::Info:
    break;
  }
  return palette.accent;
}

/// The text with words that are wider than a line, as paths are, cut to their ends.
std::string withEndsOfWords(const std::string& text, float width) {
  std::string fitted;
  std::size_t from = 0;
  while (from < text.size()) {
    const std::size_t to = std::min(text.find(' ', from), text.size());
    std::string word = text.substr(from, to - from);
    if (ImGui::CalcTextSize(word.c_str()).x > width) {
      std::size_t cut = 0;
      const auto tail = [&] { return "\u2026" + word.substr(cut); };
      while (cut < word.size() && ImGui::CalcTextSize(tail().c_str()).x > width) {
        // Not within a letter.
        do ++cut;
        while (cut < word.size() && (static_cast<unsigned char>(word[cut]) & 0xC0) == 0x80);
      }
      word = tail();
    }
    fitted += word;
    if (to < text.size()) fitted += ' ';
    from = to + 1;
  }
  return fitted;
}

/// Draws one toast above `bottomRight`; returns its height.
float drawToast(const Ui& ui, std::size_t index, ImVec2 bottomRight, float width) {
  const Toast toast = ui.state.notices.toasts()[index];
  const std::string name = "toast " + std::to_string(index);
  ImGui::SetNextWindowPos({bottomRight.x - width, bottomRight.y}, ImGuiCond_Always, {0, 1});
  ImGui::SetNextWindowSize({width, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, ui.px(5));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.px(14), ui.px(9)));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, ui.theme.palette.bar);
  ImGui::Begin(name.c_str(), nullptr, kOverlay & ~ImGuiWindowFlags_AlwaysAutoResize);
  const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  ImGui::GetWindowDrawList()->AddRectFilled(low, {low.x + ui.px(4), low.y + size.y},
                                            kindColor(ui.theme.palette, toast.kind), ui.px(5),
                                            ImDrawFlags_RoundCornersLeft);
  const float side = ui.px(24);
  ImGui::PushTextWrapPos(width - side - ui.px(16));
  const float words = width - side - ui.px(16) - ImGui::GetCursorPosX();
  ImGui::TextUnformatted(withEndsOfWords(toast.text, words).c_str());
  ImGui::PopTextWrapPos();
  ImGui::SetCursorPos({width - side - ui.px(8), ui.px(6)});
  ImGui::PushStyleColor(ImGuiCol_Button, IM_COL32(0, 0, 0, 0));
  iconButton(ui, Icon::Close, "close-toast " + std::to_string(index), {side, side});
  ImGui::PopStyleColor();
  ui.probe.rectangle(name, low, {low.x + size.x, low.y + size.y});
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(2);
  ui.wakeIn(std::max(0.0, Notices::lasting(toast.kind) - toast.age));
  return size.y;
}

}  // namespace

void toasts(const Ui& ui, ImVec2 areaMin, ImVec2 areaMax) {
  // In the corner above the line that says what the mouse does, the newest lowest.
  const float margin = ui.px(12), hints = ui.px(34);
  const float width = std::min(ui.px(380), areaMax.x - areaMin.x - 2 * margin);
  float y = areaMax.y - hints;
  for (std::size_t i = ui.state.notices.toasts().size(); i-- > 0;) {
    y -= drawToast(ui, i, {areaMax.x - margin, y}, width) + ui.px(6);
  }
}

void firstStepsCard(const Ui& ui, ImVec2 areaMin, ImVec2 areaMax) {
  if (!ui.state.panels.firstCard) return;
  static constexpr const char* kKeys[][2] = {{"Space", "watch it flood"},
                                             {"1 \u2013 9", "choose what to see"},
                                             {"G", "add and move seeds"},
                                             {"F12", "save a picture"}};
  // In the corner, so that most of the model stands beside it.
  const float width = std::min(ui.px(268), areaMax.x - areaMin.x - ui.px(24));
  ImGui::SetNextWindowPos({areaMin.x + ui.px(12), areaMax.y - ui.px(44)}, 0, {0, 1});
  ImGui::SetNextWindowSize({width, 0});
  ImGui::SetNextWindowBgAlpha(0.94f);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, ui.px(8));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.px(14), ui.px(12)));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, ui.theme.palette.bar);
  ImGui::Begin("first steps", nullptr, kOverlay & ~ImGuiWindowFlags_AlwaysAutoResize);
  ImGui::PushFont(ui.theme.strong);
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted("Cuts a model into charts that lie flat. Drop yours here.");
  ImGui::PopTextWrapPos();
  ImGui::PopFont();
  ImGui::Spacing();
  const float half = (ImGui::GetContentRegionAvail().x - ui.px(6)) / 2;
  ImGui::PushStyleColor(ImGuiCol_Button, ui.theme.palette.accentSoft);
  textButton(ui, "Open a model\u2026", "browse", {half, 0});
  ImGui::PopStyleColor();
  ImGui::SameLine(0, ui.px(6));
  textButton(ui, "Checkerboard", "color-mode checkerboard", {half, 0});
  ImGui::Spacing();
  for (const auto& [key, words] : kKeys) {
    ImGui::PushFont(ui.theme.strong);
    ImGui::TextUnformatted(key);
    ImGui::PopFont();
    ImGui::SameLine(ui.px(84));
    ImGui::TextUnformatted(words);
  }
  ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.palette.dim);
  ImGui::TextUnformatted("A click here or any key closes this.");
  ImGui::PopStyleColor();
  const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  ui.probe.rectangle("first-steps", low, {low.x + size.x, low.y + size.y});
  const bool beside = !ImGui::IsAnyItemHovered();
  if (ImGui::IsWindowHovered() && beside && ImGui::IsMouseClicked(0)) ui.run("first-steps off");
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(2);
}

}  // namespace chartflood
