#include "app/gui/widgets/file_browser.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <system_error>

#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include "app/gui/widgets/widgets.h"
#include "app/host/files/export_files.h"
#include "app/host/script/command.h"
#include "app/host/settings/standard_paths.h"
#include "core/base/text.h"
#include "core/io/mesh_formats.h"
#include "core/session/files/session_io.h"

namespace chartflood {

namespace {

/// A format that can be written, and what it keeps.
struct WrittenFormat {
  std::string ending;  ///< ".obj"
  std::string title, keeps;
};

/// What a chosen file is for: the action that takes it, how a new name begins to end, and the
/// formats to choose from.
struct Purpose {
  const char* action;
  std::string nameEnd;
  std::vector<WrittenFormat> formats = {};
};

std::vector<WrittenFormat> meshesWritten() {
  std::vector<WrittenFormat> formats;
  for (const MeshFormat& format : meshFormats()) {
    if (format.write == nullptr) continue;
    formats.push_back({std::string(".") + format.extension, format.title, format.keeps});
  }
  return formats;
}

Purpose purposeOf(PanelState::Browse browse) {
  using Browse = PanelState::Browse;
  switch (browse) {
  case Browse::SaveSession:
    return {"save-session", kSessionEnding};
  case Browse::SaveMesh:
    return {"export-mesh", "_uv" + meshesWritten().front().ending, meshesWritten()};
  case Browse::SaveUv:
    return {"export-uv",
            "_uv.png",
            {{".png", "Picture (PNG)", "As many pixels as the texture has."},
             {".svg", "Drawing (SVG)", "Outlines that stay sharp at any size."}}};
  case Browse::SaveSeams:
    return {"export-seams",
            "_seams.obj",
            {{".obj", "Wavefront OBJ", "Borders between charts and cuts as lines."}}};
  case Browse::SaveLabels:
    return {"export-labels",
            "_labels.txt",
            {{".txt", "Text", "The chart of each face of the file, one number a line."}}};
  case Browse::SaveReport:
    return {"export-report", "_report.json", {{".json", "JSON", "Parameters and all figures."}}};
  case Browse::Open:
  case Browse::Nothing:
    break;
  }
  return {"open", ""};
}

const WrittenFormat* formatOf(const std::vector<WrittenFormat>& formats, const std::string& name) {
  const std::string ending = lowerCase(std::filesystem::path(name).extension().string());
  const auto found = std::find_if(formats.begin(), formats.end(), [&](const WrittenFormat& format) {
    return format.ending == ending;
  });
  return found == formats.end() ? nullptr : &*found;
}

bool isMesh(const std::string& name) {
  return findMeshFormat(std::filesystem::path(name).extension().string()) != nullptr;
}

std::string sizeText(std::uintmax_t bytes) {
  constexpr std::array kUnits = {"B", "kB", "MB", "GB"};
  auto value = static_cast<double>(bytes);
  std::size_t unit = 0;
  while (value >= 1000 && unit + 1 < kUnits.size()) {
    value /= 1000;
    ++unit;
  }
  char text[32];
  std::snprintf(text, sizeof text, unit == 0 || value >= 100 ? "%.0f %s" : "%.1f %s", value,
                kUnits[unit]);
  return text;
}

}  // namespace

void FileBrowser::begin(const Ui& ui) {
  purpose_ = ui.state.panels.browse;
  problem_.clear();
  confirmed_ = false;
  focusName_ = true;
  name_.clear();
  if (saving()) name_ = ui.state.modelName() + purposeOf(purpose_).nameEnd;
  std::filesystem::path start = folder_;
  // Results belong beside what they are made from.
  if (saving() && ui.state.hasMesh() && ui.state.modelIsFile()) {
    const std::filesystem::path model = ui.state.results().mesh->input().file;
    start = std::filesystem::absolute(model).parent_path();
  }
  const std::vector<std::string>& recent = ui.state.preferences.recentFiles;
  if (start.empty() && !recent.empty()) start = std::filesystem::path(recent.front()).parent_path();
  std::error_code error;
  if (start.empty() || !std::filesystem::is_directory(start, error)) start = homeFolder();
  enter(start);
}

void FileBrowser::enter(const std::filesystem::path& folder) {
  std::error_code error;
  const std::filesystem::path real = std::filesystem::canonical(folder, error);
  if (error || !std::filesystem::is_directory(real, error)) {
    problem_ = "There is no folder " + folder.string() + '.';
    return;
  }
  folder_ = real;
  folderText_ = real.string();
  problem_.clear();
  selected_.clear();
  if (!saving()) name_.clear();
  focusName_ = true;
  list();
}

void FileBrowser::list() {
  entries_.clear();
  std::error_code error;
  std::filesystem::directory_iterator it(folder_, error);
  if (error) problem_ = "The folder cannot be read: " + error.message() + '.';
  for (; !error && it != std::filesystem::directory_iterator(); it.increment(error)) {
    Entry entry;
    entry.name = it->path().filename().string();
    if (entry.name.starts_with('.')) continue;
    std::error_code unknown;
    entry.folder = it->is_directory(unknown);
    if (!entry.folder) entry.bytes = it->is_regular_file(unknown) ? it->file_size(unknown) : 0;
    const bool wanted = entry.folder || saving() || isMesh(entry.name) || isSessionFile(entry.name);
    if (wanted) entries_.push_back(std::move(entry));
  }
  std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
    if (a.folder != b.folder) return a.folder;
    return lowerCase(a.name) < lowerCase(b.name);
  });
}

bool FileBrowser::matches(const Entry& entry) const {
  return saving() || name_.empty() ||
         lowerCase(entry.name).find(lowerCase(name_)) != std::string::npos;
}

/// The window stays open where that failed, with the reason.
void FileBrowser::choose(const Ui& ui, const std::filesystem::path& file) {
  const std::string model =
      ui.state.hasMesh() && ui.state.modelIsFile() ? ui.state.results().mesh->input().file : "";
  std::string line =
      std::string(purposeOf(purpose_).action) + " file=" + quotedArgument(file.string());
  // That it is the model itself was said before it was confirmed.
  const bool session = purpose_ == PanelState::Browse::SaveSession;
  if (saving() && !session && isSameFile(file, model)) line += " overwrite=on";
  if (ui.state.perform(ui.actions, line)) {
    ui.state.panels.browse = PanelState::Browse::Nothing;
  } else if (!ui.state.notices.toasts().empty()) {
    problem_ = ui.state.notices.toasts().back().text;
    confirmed_ = false;
  }
}

void FileBrowser::activate(const Ui& ui, const Entry& entry) {
  if (entry.folder) return enter(folder_ / entry.name);
  if (!saving()) return choose(ui, folder_ / entry.name);
  name_ = entry.name;
  confirmed_ = false;
}

void FileBrowser::accept(const Ui& ui) {
  if (saving()) return save(ui);
  std::error_code error;
  const std::filesystem::path typed = folder_ / std::filesystem::path(name_);
  if (!name_.empty() && std::filesystem::is_directory(typed, error)) return enter(typed);
  if (!name_.empty() && std::filesystem::is_regular_file(typed, error)) return choose(ui, typed);
  const auto chosen = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) {
    return entry.name == selected_ && matches(entry);
  });
  if (chosen != entries_.end()) return activate(ui, *chosen);
  const auto match = std::find_if(entries_.begin(), entries_.end(),
                                  [&](const Entry& entry) { return matches(entry); });
  if (name_.empty() || match == entries_.end()) {
    problem_ =
        name_.empty() ? "Choose a file first." : "No file here is called like " + name_ + '.';
    return;
  }
  activate(ui, *match);
}

void FileBrowser::save(const Ui& ui) {
  if (name_.empty()) return;
  std::error_code error;
  std::filesystem::path typed = folder_ / std::filesystem::path(name_);
  if (std::filesystem::is_directory(typed, error)) return enter(typed);
  const std::vector<WrittenFormat> formats = purposeOf(purpose_).formats;
  if (!formats.empty() && typed.extension().empty()) {
    name_ += formats.front().ending;
    typed += formats.front().ending;
  }
  if (!formats.empty() && formatOf(formats, name_) == nullptr) {
    std::string endings;
    for (const WrittenFormat& format : formats) {
      endings += (endings.empty() ? "" : ", ") + format.ending;
    }
    problem_ = "A name ends in " + endings + " here: choose a format.";
    return;
  }
  if (std::filesystem::exists(typed, error) && !confirmed_) {
    confirmed_ = true;
    const std::string model = ui.state.hasMesh() ? ui.state.results().mesh->input().file : "";
    const bool over = isSameFile(typed, model);
    problem_ = name_ +
               (over ? " is the model itself, and not all of it is written. " : " exists. ") +
               "Press Save again to replace it.";
    return;
  }
  choose(ui, typed);
}

/// Up and Down go through the entries while the name has the keyboard.
void FileBrowser::moveSelection() {
  const int step = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_DownArrow)) ? 1
                   : ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_UpArrow)) ? -1
                                                                               : 0;
  if (step == 0) return;
  ImGui::NavMoveRequestCancel();  // the name keeps the keyboard
  std::vector<std::string> names;
  for (const Entry& entry : entries_) {
    if (matches(entry)) names.push_back(entry.name);
  }
  if (names.empty()) return;
  const auto found = std::find(names.begin(), names.end(), selected_);
  const auto last = static_cast<std::ptrdiff_t>(names.size()) - 1;
  const std::ptrdiff_t place =
      found == names.end() ? (step > 0 ? 0 : last) : found - names.begin() + step;
  selected_ = names[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(place, 0, last))];
  if (saving()) {
    ImGui::ClearActiveID();  // a field that is typed into keeps its own words
    name_ = selected_;
    focusName_ = true;
  }
  showSelected_ = true;
}

/// The formats as buttons, the chosen one marked, and what it keeps.
void FileBrowser::drawFormats(const Ui& ui) {
  const std::vector<WrittenFormat> formats = purposeOf(purpose_).formats;
  if (formats.empty()) return;
  const WrittenFormat* chosen = formatOf(formats, name_);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Format");
  for (const WrittenFormat& format : formats) {
    ImGui::SameLine();
    const bool marked = &format == chosen;
    if (marked) ImGui::PushStyleColor(ImGuiCol_Button, ui.theme.palette.accentSoft);
    if (ImGui::Button(format.title.c_str())) {
      name_ = std::filesystem::path(name_).replace_extension(format.ending).string();
      confirmed_ = false;
      problem_.clear();
    }
    if (marked) ImGui::PopStyleColor();
    ui.probe.item("browser-format/" + format.ending);
  }
  ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.palette.dim);
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(chosen == nullptr ? "Choose a format." : chosen->keeps.c_str());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
}

void FileBrowser::drawRecent(const Ui& ui) {
  ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.palette.dim);
  ImGui::TextUnformatted("Recent");
  ImGui::PopStyleColor();
  const std::vector<std::string> recent = ui.state.preferences.recentFiles;
  for (const std::string& file : recent) {
    std::string label = std::filesystem::path(file).filename().string();
    label.append("##").append(file);
    if (ImGui::Selectable(label.c_str())) choose(ui, file);
    tooltip(ui, file, "", file);
  }
}

void FileBrowser::drawPlaces(const Ui& ui, float width) {
  ImGui::BeginChild("places", {width, 0});
  if (ImGui::Selectable("Home")) enter(homeFolder());
  ui.probe.item("browser/home");
  std::error_code error;
  const std::filesystem::path here = std::filesystem::current_path(error);
  if (!error && ImGui::Selectable("Where started")) enter(here);
  if (ImGui::Selectable("Computer")) enter("/");
  ImGui::Spacing();
  if (!saving() && !ui.state.preferences.recentFiles.empty()) drawRecent(ui);
  ImGui::EndChild();
}

void FileBrowser::drawEntries(const Ui& ui) {
  const ImGuiTableFlags flags = ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg;
  if (!ImGui::BeginTable("entries", 2, flags)) return;
  ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableSetupColumn("size", ImGuiTableColumnFlags_WidthFixed, ui.px(76));
  const std::vector<Entry> entries = entries_;  // activating one may list another folder
  for (const Entry& entry : entries) {
    if (!matches(entry)) continue;
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    const float height = ImGui::GetTextLineHeight();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const bool isSelected = selected_ == entry.name;
    const bool chosen = ImGui::Selectable(("##" + entry.name).c_str(), isSelected,
                                          ImGuiSelectableFlags_SpanAllColumns |
                                              ImGuiSelectableFlags_AllowDoubleClick);
    if (isSelected && showSelected_) {
      ImGui::SetScrollHereY();
      showSelected_ = false;
    }
    ui.probe.item("browser/" + entry.name);
    drawIcon(*ImGui::GetWindowDrawList(), entry.folder ? Icon::Folder : Icon::File,
             {at.x + height / 2, at.y + height / 2}, height * 0.8f, ui.theme.palette.dim);
    ImGui::SameLine(height + ui.px(12));
    ImGui::TextUnformatted(entry.name.c_str());
    ImGui::TableNextColumn();
    if (!entry.folder) ImGui::TextUnformatted(sizeText(entry.bytes).c_str());
    if (!chosen) continue;
    if (ImGui::IsMouseDoubleClicked(0)) {
      activate(ui, entry);
      continue;
    }
    selected_ = entry.name;
    if (saving() && !entry.folder) name_ = entry.name;
    confirmed_ = false;
    focusName_ = true;  // typing and Enter go on from here
  }
  ImGui::EndTable();
}

void FileBrowser::drawName(const Ui& ui) {
  const float button = ui.px(96);
  const char* words = saving() ? "Save" : "Open";
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(saving() ? "Name" : "Name or part of it");
  ImGui::SameLine();
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - 2 * button - ui.px(16));
  if (focusName_) ImGui::SetKeyboardFocusHere();
  focusName_ = false;
  moveSelection();
  const bool entered = ImGui::InputText("##name", &name_, ImGuiInputTextFlags_EnterReturnsTrue);
  if (ImGui::IsItemEdited()) {
    confirmed_ = false;
    problem_.clear();
    selected_.clear();
  }
  ui.probe.item("browser-name");
  ImGui::SameLine();
  ImGui::PushStyleColor(ImGuiCol_Button, ui.theme.palette.accentSoft);
  const bool pressed = ImGui::Button(words, {button, 0});
  ImGui::PopStyleColor();
  ui.probe.item("browser-accept");
  ImGui::SameLine();
  textButton(ui, "Cancel", "close-browser", {button, 0});
  ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.palette.warning);
  fittedText(ui, problem_, ImGui::GetContentRegionAvail().x, ui.theme.palette.warning);
  ui.probe.item("browser-problem");
  ImGui::PopStyleColor();
  if (entered || pressed) accept(ui);
}

void FileBrowser::drawFolder(const Ui& ui) {
  const float side = ImGui::GetFrameHeight();
  if (ImGui::Button("##up", {side, side})) enter(folder_.parent_path());
  ui.probe.item("browser-up");
  const ImVec2 low = ImGui::GetItemRectMin();
  drawIcon(*ImGui::GetWindowDrawList(), Icon::Up, {low.x + side / 2, low.y + side / 2}, ui.px(14),
           ui.theme.palette.text);
  ImGui::SameLine();
  ImGui::SetNextItemWidth(-1);
  if (ImGui::InputText("##folder", &folderText_, ImGuiInputTextFlags_EnterReturnsTrue)) {
    enter(folderText_);
  }
  ui.probe.item("browser-folder");
}

void FileBrowser::draw(const Ui& ui) {
  const PanelState::Browse wanted = ui.state.panels.browse;
  if (wanted == PanelState::Browse::Nothing) {
    purpose_ = wanted;
    return;
  }
  if (purpose_ != wanted) begin(ui);
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, ImGuiCond_Appearing, {0.5f, 0.5f});
  ImGui::SetNextWindowSize(
      {std::min(ui.px(760), screen.x - ui.px(20)), std::min(ui.px(480), screen.y - ui.px(20))},
      ImGuiCond_Appearing);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, ui.px(6));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  bool open = true;
  const char* title = saving() ? "Save as###browser" : "Open a model or session###browser";
  ImGui::Begin(title, &open, ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse);
  drawFolder(ui);
  float bottom = ImGui::GetFrameHeightWithSpacing() + ImGui::GetTextLineHeightWithSpacing();
  if (!purposeOf(purpose_).formats.empty()) bottom *= 2;
  ImGui::BeginChild("middle", {0, -bottom});
  drawPlaces(ui, ui.px(150));
  ImGui::SameLine();
  ImGui::BeginChild("files");
  drawEntries(ui);
  ImGui::EndChild();
  ImGui::EndChild();
  drawFormats(ui);
  drawName(ui);
  const bool escaped = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false);
  ImGui::End();
  ImGui::PopStyleVar(2);
  if (!open || escaped) ui.run("close-browser");
}

}  // namespace chartflood
