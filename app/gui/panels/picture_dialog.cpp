// What pictures are like, and the button that takes one.

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "app/gui/panels/panels.h"
#include "app/gui/widgets.h"
#include "app/host/command.h"
#include "app/host/standard_paths.h"

namespace chartflood {

namespace {

using Choices = std::initializer_list<std::pair<const char*, const char*>>;

std::string value(const Ui& ui, const char* key) {
  return pictureValue(ui.state.preferences.picture, key);
}

std::string setLine(const char* key, const std::string& text) {
  return std::string("picture-set ") + key + ' ' + quotedArgument(text);
}

void dialogLabel(const Ui& ui, const char* words) {
  ImGui::AlignTextToFramePadding();
  ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.palette.dim);
  ImGui::TextUnformatted(words);
  ImGui::PopStyleColor();
  ImGui::SameLine(ui.px(92));
}

/// One of several, as round buttons in a row.
void choiceRow(const Ui& ui, const char* words, const char* key, Choices choices) {
  dialogLabel(ui, words);
  bool first = true;
  for (const auto& [id, label] : choices) {
    if (!first) ImGui::SameLine(0, ui.px(14));
    first = false;
    const std::string line = setLine(key, id);
    ImGui::PushID(line.c_str());
    if (ImGui::RadioButton(label, value(ui, key) == id)) ui.run(line);
    ImGui::PopID();
    ui.probe.item(line);
  }
}

void tick(const Ui& ui, const char* words, const char* key) {
  bool on = value(ui, key) == "on";
  ImGui::PushID(key);
  if (ImGui::Checkbox(words, &on)) ui.run(setLine(key, on ? "on" : "off"));
  ImGui::PopID();
  ui.probe.item(std::string("picture/") + key);
}

/// A text. Names are set with every letter, numbers when they are typed to their end.
void textField(const Ui& ui, const char* key, const char* hint, float width, bool atOnce) {
  char text[512];
  const std::string now = value(ui, key);
  text[now.copy(text, sizeof text - 1)] = '\0';
  ImGui::SetNextItemWidth(width);
  ImGui::PushID(key);
  // Dear ImGui keeps what is typed while the field has the keyboard.
  const bool edited = ImGui::InputTextWithHint("##text", hint, text, sizeof text);
  if (atOnce ? edited : ImGui::IsItemDeactivatedAfterEdit()) ui.run(setLine(key, text));
  ImGui::PopID();
  ui.probe.item(std::string("picture/") + key);
}

void sizeRow(const Ui& ui, const PictureExtent& extent) {
  const PictureSettings& settings = ui.state.preferences.picture;
  const char* label = "";
  for (const PictureSizeChoice& each : pictureSizes()) {
    if (settings.size == each.id) label = each.label;
  }
  dialogLabel(ui, "Size");
  ImGui::SetNextItemWidth(ui.px(170));
  const bool open = ImGui::BeginCombo("##size", label);
  ui.probe.item("picture/size");
  if (open) {
    for (const PictureSizeChoice& each : pictureSizes()) {
      if (ImGui::Selectable(each.label, settings.size == each.id)) ui.run(setLine("size", each.id));
      ui.probe.item(setLine("size", each.id));
    }
    ImGui::EndCombo();
  }
  ImGui::SameLine(0, ui.px(12));
  if (settings.size != "own") {
    ImGui::Text("%d x %d pixels", extent.width, extent.height);
    return;
  }
  textField(ui, "width", "", ui.px(62), false);
  ImGui::SameLine(0, ui.px(4));
  ImGui::TextUnformatted("x");
  ImGui::SameLine(0, ui.px(4));
  textField(ui, "height", "", ui.px(62), false);
  ImGui::SameLine(0, ui.px(8));
  tick(ui, "Lock ratio", "lock-ratio");
}

void keepRow(const Ui& ui) {
  dialogLabel(ui, "Keep");
  const std::pair<const char*, const char*> helpers[] = {
      {"Colour bar", "legend"}, {"Seeds", "seeds"}, {"Seams", "seams"}, {"Numbers", "numbers"}};
  bool first = true;
  for (const auto& [words, key] : helpers) {
    if (!first) ImGui::SameLine(0, ui.px(12));
    first = false;
    tick(ui, words, key);
  }
}

/// Pictures in a row: how many, and what they show.
void rowsRow(const Ui& ui) {
  dialogLabel(ui, "In a row");
  textField(ui, "frames", "", ui.px(62), false);
  ImGui::SameLine(0, ui.px(6));
  ImGui::TextUnformatted("pictures");
  ImGui::SameLine(0, ui.px(14));
  textButton(ui, "Turntable", "turntable", {ui.px(104), 0});
  ImGui::SameLine(0, ui.px(8));
  textButton(ui, "Flood film", "flood-film", {ui.px(104), 0});
}

void buttons(const Ui& ui) {
  const ImVec2 size{ui.px(104), 0};
  ImGui::SetCursorPosX(ImGui::GetWindowContentRegionMax().x - 3 * size.x - 2 * ui.px(8));
  textButton(ui, "Copy command", "copy-command", size);
  ImGui::SameLine(0, ui.px(8));
  textButton(ui, "Close", "picture-dialog off", size);
  ImGui::SameLine(0, ui.px(8));
  ImGui::PushStyleColor(ImGuiCol_Button, ui.theme.palette.accentSoft);
  textButton(ui, "Save PNG", "screenshot", size);
  ImGui::PopStyleColor();
}

}  // namespace

void pictureDialog(const Ui& ui) {
  if (!ui.state.panels.picture) return;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const ImVec2 size{std::min(ui.px(560), screen.x - ui.px(16)), 0};
  ImGui::SetNextWindowPos({std::round(screen.x / 2), std::round(screen.y / 2)}, ImGuiCond_Appearing,
                          {0.5f, 0.5f});
  ImGui::SetNextWindowSize(size);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.px(16), ui.px(12)));
  bool open = true;
  const bool shown = ImGui::Begin("Picture", &open,
                                  ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse |
                                      ImGuiWindowFlags_NoSavedSettings);
  ImGui::PopStyleVar();
  if (shown) {
    const PictureSettings& settings = ui.state.preferences.picture;
    const PictureExtent extent =
        pictureExtent(settings, ui.state.panels.viewWidth, ui.state.panels.viewHeight);
    choiceRow(ui, "View", "view",
              {{"3d", "Model"}, {"uv", "Texture"}, {"both", "Both"}, {"ab", "A | B"}});
    sizeRow(ui, extent);
    choiceRow(ui, "Smoothing", "smooth", {{"1", "1x"}, {"2", "2x"}, {"4", "4x"}});
    choiceRow(ui, "Ground", "ground",
              {{"theme", "As shown"},
               {"white", "White"},
               {"black", "Black"},
               {"transparent", "Transparent"}});
    keepRow(ui);
    dialogLabel(ui, "Name");
    textField(ui, "name", PictureSettings{}.name.c_str(), ImGui::GetContentRegionAvail().x, true);
    dialogLabel(ui, "Folder");
    textField(ui, "folder", picturesFolder().c_str(), ImGui::GetContentRegionAvail().x, true);
    rowsRow(ui);
    ImGui::Spacing();
    buttons(ui);
    const bool escape = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false);
    if (escape && ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows) &&
        !ImGui::IsAnyItemActive()) {
      open = false;
    }
  }
  ImGui::End();
  if (!open) ui.run("picture-dialog off");
}

}  // namespace chartflood
