// What pictures are like, and the button that takes one.

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <imgui_internal.h>

#include "app/gui/panels/panels.h"
#include "app/gui/views/picture_preview.h"
#include "app/gui/widgets/widgets.h"
#include "app/host/actions/action_needs.h"
#include "app/host/script/command.h"
#include "app/host/settings/standard_paths.h"
#include "core/base/text.h"

namespace chartflood {

namespace {

/// Keys of the picture's settings that have a place of their own here.
const Setting<PictureSettings>& settingOf(const char* key) {
  return *findSetting(pictureSettingTable(), key);
}

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
void choiceRow(const Ui& ui, const char* key) {
  const Setting<PictureSettings>& setting = settingOf(key);
  dialogLabel(ui, setting.title);
  bool first = true;
  for (const SettingChoice& each : setting.value.domain.choices) {
    if (!first) ImGui::SameLine(0, ui.px(14));
    first = false;
    const std::string line = setLine(key, each.id);
    ImGui::PushID(line.c_str());
    if (ImGui::RadioButton(each.label.c_str(), value(ui, key) == each.id)) ui.run(line);
    ImGui::PopID();
    ui.probe.item(line);
  }
}

void tick(const Ui& ui, const char* key) {
  bool on = value(ui, key) == "on";
  ImGui::PushID(key);
  if (ImGui::Checkbox(settingOf(key).title, &on)) ui.run(setLine(key, switchWord(on)));
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
  if (settings.view == "window") label = pictureSizes().front().label;
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
  if (settings.size != "own" || settings.view == "window") {
    ImGui::Text("%d x %d pixels", extent.width, extent.height);
    return;
  }
  textField(ui, "width", "", ui.px(62), false);
  ImGui::SameLine(0, ui.px(4));
  ImGui::TextUnformatted("x");
  ImGui::SameLine(0, ui.px(4));
  textField(ui, "height", "", ui.px(62), false);
  ImGui::SameLine(0, ui.px(8));
  tick(ui, "lock-ratio");
}

void keepRow(const Ui& ui) {
  dialogLabel(ui, "Keep");
  bool first = true;
  for (const char* key : {"scalar-bar", "seed-marks", "seams", "numbers"}) {
    if (!first) ImGui::SameLine(0, ui.px(12));
    first = false;
    tick(ui, key);
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

constexpr float kPreviewWidth = 240, kPreviewHeight = 135;

/// Light and dark squares: what shows through a transparent ground.
void checkered(const Ui& ui, ImVec2 low, ImVec2 high) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float step = ui.px(8);
  list.AddRectFilled(low, high, IM_COL32(150, 150, 150, 255));
  list.PushClipRect(low, high, true);
  for (int row = 0; low.y + static_cast<float>(row) * step < high.y; ++row) {
    for (int column = row % 2; low.x + static_cast<float>(column) * step < high.x; column += 2) {
      const ImVec2 at{low.x + static_cast<float>(column) * step,
                      low.y + static_cast<float>(row) * step};
      list.AddRectFilled(at, {at.x + step, at.y + step}, IM_COL32(185, 185, 185, 255));
    }
  }
  list.PopClipRect();
}

void centered(const Ui& ui, ImVec2 low, ImVec2 high, const std::string& words) {
  const float wrap = high.x - low.x - 2 * ui.px(10);
  const ImVec2 size = ImGui::CalcTextSize(words.c_str(), nullptr, false, wrap);
  const ImVec2 at{std::round((low.x + high.x - size.x) / 2),
                  std::round((low.y + high.y - size.y) / 2)};
  ImGui::GetWindowDrawList()->AddText(nullptr, 0, at, ui.theme.palette.dim, words.c_str(), nullptr,
                                      wrap);
}

/// The picture as it will be, as large as it fits into its place.
void previewBox(const Ui& ui, PreviewSource* previews, const PictureExtent& extent) {
  const ImVec2 place = ImGui::GetCursorScreenPos();
  const ImVec2 room{ui.px(kPreviewWidth), ui.px(kPreviewHeight)};
  ImGui::Dummy(room);
  ui.probe.item("picture/preview");
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(place, {place.x + room.x, place.y + room.y}, ui.theme.palette.bar, ui.px(3));
  const std::string& view = ui.state.preferences.picture.view;
  std::string reason = ui.actions.refusal("screenshot", ui.state);
  if (reason.empty()) reason = pictureRefusal(ui.state, view);
  const ImVec2 end{place.x + room.x, place.y + room.y};
  if (!reason.empty()) return centered(ui, place, end, reason);
  const auto width = static_cast<float>(extent.width), height = static_cast<float>(extent.height);
  const float smaller = std::min(room.x / width, room.y / height);
  const ImVec2 size{std::max(1.0f, std::round(width * smaller)),
                    std::max(1.0f, std::round(height * smaller))};
  const ImVec2 low{std::round(place.x + (room.x - size.x) / 2),
                   std::round(place.y + (room.y - size.y) / 2)};
  const ImVec2 high{low.x + size.x, low.y + size.y};
  ui.probe.rectangle("picture/shown", low, high);
  if (previews == nullptr) return;
  const ImVec2 pixels = ImGui::GetIO().DisplayFramebufferScale;
  const auto parts = previews->preview(ui.state, extent, static_cast<int>(size.x * pixels.x),
                                       static_cast<int>(size.y * pixels.y), ui.theme.scale);
  if (ui.state.preferences.picture.ground == "transparent" && view != "window") {
    checkered(ui, low, high);
  }
  for (const PreviewPart& part : parts) {
    list.AddImage(part.texture, {low.x + part.left * size.x, low.y},
                  {low.x + part.right * size.x, high.y}, {part.from, 1}, {part.to, 0});
  }
  list.AddRect({low.x - 1, low.y - 1}, {high.x + 1, high.y + 1}, ui.theme.palette.line);
  if (!previews->upToDate()) ui.wakeIn(0.05);
}

/// Beside the preview, as high as it is.
void buttons(const Ui& ui, float top) {
  const float gap = ui.px(8), height = ImGui::GetFrameHeight();
  const ImVec2 size{ui.px(104), 0};
  const float right = ImGui::GetWindowContentRegionMax().x;
  const float low = top + ui.px(kPreviewHeight) - height;
  ImGui::SetCursorPos({right - 2 * size.x - gap, low - height - gap});
  textButton(ui, "Copy command", "copy-command", {2 * size.x + gap, 0});
  ImGui::SetCursorPos({right - 2 * size.x - gap, low});
  textButton(ui, "Close", "picture-dialog off", size);
  ImGui::SameLine(0, gap);
  ImGui::PushStyleColor(ImGuiCol_Button, ui.theme.palette.accentSoft);
  textButton(ui, "Save PNG", "screenshot", size);
  ImGui::PopStyleColor();
}

/// What a picture of the window has no choice of.
void viewRows(const Ui& ui, const PictureExtent& extent) {
  const bool window = ui.state.preferences.picture.view == "window";
  if (window) {
    ImGui::PushStyleVar(ImGuiStyleVar_Alpha, ImGui::GetStyle().Alpha * 0.42f);
    ImGui::PushItemFlag(ImGuiItemFlags_Disabled, true);
  }
  sizeRow(ui, extent);
  choiceRow(ui, "supersampling");
  choiceRow(ui, "background");
  keepRow(ui);
  if (window) {
    ImGui::PopItemFlag();
    ImGui::PopStyleVar();
  }
}

}  // namespace

void pictureDialog(const Ui& ui, PreviewSource* previews) {
  if (!ui.state.panels.picture) return;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const ImVec2 size{std::min(ui.px(560), screen.x - ui.px(16)), 0};
  ImGui::SetNextWindowPos({std::round(screen.x / 2), std::round(screen.y / 2)}, ImGuiCond_Appearing,
                          {0.5f, 0.5f});
  ImGui::SetNextWindowSize(size);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(ui.px(16), ui.px(12)));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  bool open = true;
  const bool shown = ImGui::Begin(kPictureDialog, &open,
                                  ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse |
                                      ImGuiWindowFlags_NoSavedSettings);
  ImGui::PopStyleVar(2);
  if (shown) {
    const PictureSettings& settings = ui.state.preferences.picture;
    const PictureExtent extent = wantedExtent(ui.state, settings);
    choiceRow(ui, "view");
    viewRows(ui, extent);
    dialogLabel(ui, "Name");
    textField(ui, "name", PictureSettings{}.name.c_str(), ImGui::GetContentRegionAvail().x, true);
    dialogLabel(ui, "Folder");
    textField(ui, "folder", picturesFolder().c_str(), ImGui::GetContentRegionAvail().x, true);
    rowsRow(ui);
    ImGui::Spacing();
    const float top = ImGui::GetCursorPosY();
    previewBox(ui, previews, extent);
    buttons(ui, top);
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
