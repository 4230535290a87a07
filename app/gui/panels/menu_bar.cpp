// The menus: every entry is an action of the registry.

#include <filesystem>
#include <string>

#include "app/gui/panels/color_mode_combo.h"
#include "app/gui/panels/panels.h"
#include "app/gui/widgets/widgets.h"
#include "app/host/script/command.h"
#include "core/samples/samples.h"

namespace chartflood {

namespace {

void recentMenu(const Ui& ui) {
  const std::vector<std::string> recent = ui.state.preferences.recentFiles;
  if (!beginMenu(ui, "Open recent", !recent.empty())) return;
  for (const std::string& file : recent) {
    actionMenuItem(ui, "open " + quotedArgument(file),
                   std::filesystem::path(file).filename().string());
  }
  ImGui::EndMenu();
}

void fileMenu(const Ui& ui) {
  if (!beginMenu(ui, "File")) return;
  actionMenuItem(ui, "browse");
  recentMenu(ui);
  if (beginMenu(ui, "Samples")) {
    for (const SampleInfo& sample : sampleTable()) {
      actionMenuItem(ui, std::string("sample ") + sample.id, sample.title);
    }
    ImGui::EndMenu();
  }
  actionMenuItem(ui, "reload");
  ImGui::Separator();
  actionMenuItem(ui, "save-session");
  actionMenuItem(ui, "save-session-as");
  ImGui::Separator();
  for (const char* line : {"export-mesh", "export-uv", "export-seams", "export-labels"}) {
    actionMenuItem(ui, line);
  }
  actionMenuItem(ui, "export-report");
  ImGui::Separator();
  actionMenuItem(ui, "picture-dialog");
  actionMenuItem(ui, "turntable");
  actionMenuItem(ui, "flood-film");
  actionMenuItem(ui, "screenshot", "Save picture as last time");
  actionMenuItem(ui, "screenshot bare=on", "Save picture without helpers");
  ImGui::Separator();
  actionMenuItem(ui, "quit");
  ImGui::EndMenu();
}

void editMenu(const Ui& ui) {
  if (!beginMenu(ui, "Edit")) return;
  const std::string undo = ui.state.undoHistory().undoName();
  const std::string redo = ui.state.undoHistory().redoName();
  actionMenuItem(ui, "undo", undo.empty() ? "Undo" : "Undo " + undo);
  actionMenuItem(ui, "redo", redo.empty() ? "Redo" : "Redo " + redo);
  ImGui::Separator();
  actionMenuItem(ui, "roll-seed");
  actionMenuItem(ui, "reset-all");
  ImGui::Separator();
  actionMenuItem(ui, "copy-command");
  actionMenuItem(ui, "copy-figures");
  actionMenuItem(ui, "copy-charts");
  ImGui::Separator();
  presetMenu(ui);
  actionMenuItem(ui, "preferences");
  ImGui::EndMenu();
}

void seedsMenu(const Ui& ui) {
  if (!beginMenu(ui, "Seeds")) return;
  actionMenuItem(ui, "tool select", "Select charts");
  actionMenuItem(ui, "tool seeds", "Work on seeds");
  actionMenuItem(ui, "tool hints", "Paint hints on edges");
  ImGui::Separator();
  actionMenuItem(ui, "add-seed-in-view");
  actionMenuItem(ui, "delete-seed", "Delete the one under the mouse");
  actionMenuItem(ui, "choose-seed next", "Choose the next one");
  actionMenuItem(ui, "spread-seeds");
  ImGui::Separator();
  actionMenuItem(ui, "lock-seed", "Lock the one under the mouse");
  actionMenuItem(ui, "clear-locks");
  actionMenuItem(ui, "clear-hints");
  ImGui::Separator();
  actionMenuItem(ui, "copy-seeds");
  ImGui::EndMenu();
}

void checkerMenu(const Ui& ui) {
  if (!beginMenu(ui, "Checkerboard of")) return;
  actionMenuItem(ui, "checker-kind squares", "Squares");
  actionMenuItem(ui, "checker-kind numbers", "Numbered squares");
  actionMenuItem(ui, "checker-kind circles", "Circles");
  actionMenuItem(ui, "checker-kind picture", "Picture (drop one onto the window)");
  actionMenuItem(ui, "use-checkerboard");
  ImGui::Separator();
  for (const char* squares : {"10", "20", "40", "80"}) {
    actionMenuItem(ui, std::string("checker-size ") + squares, std::string(squares) + " squares");
  }
  ImGui::Separator();
  actionMenuItem(ui, "checker-in-texture");
  actionMenuItem(ui, "checker-tint");
  ImGui::EndMenu();
}

void coloursMenu(const Ui& ui) {
  if (!beginMenu(ui, "Colours")) return;
  colorModeMenu(ui);
  ImGui::EndMenu();
}

void showMenu(const Ui& ui) {
  if (!beginMenu(ui, "Show")) return;
  for (const char* overlay : {"seams", "cuts", "edges", "sharp-edges", "seeds", "numbers",
                              "color-bar", "legend", "problems"}) {
    actionMenuItem(ui, overlay);
  }
  checkerMenu(ui);
  ImGui::EndMenu();
}

void chartsMenu(const Ui& ui) {
  if (!beginMenu(ui, "Charts")) return;
  for (const char* line : {"previous-chart", "next-chart", "isolate", "hide-chart",
                           "show-all-charts", "chart-in-texture"}) {
    actionMenuItem(ui, line);
  }
  ImGui::EndMenu();
}

void cameraMenu(const Ui& ui) {
  if (!beginMenu(ui, "Camera")) return;
  actionMenuItem(ui, "frame-selection");
  actionMenuItem(ui, "frame-all");
  actionMenuItem(ui, "orthographic");
  if (beginMenu(ui, "Standard views")) {
    for (const char* view : {"oblique", "front", "back", "left", "right", "top", "bottom"}) {
      std::string title = view;
      title[0] = static_cast<char>(title[0] - 'a' + 'A');
      actionMenuItem(ui, std::string("view ") + view, title);
    }
    ImGui::EndMenu();
  }
  if (beginMenu(ui, "Upright axis")) {
    actionMenuItem(ui, "up-axis y", "Y");
    actionMenuItem(ui, "up-axis z", "Z");
    ImGui::EndMenu();
  }
  if (beginMenu(ui, "Mouse like")) {
    choiceMenuItems(ui, "navigation");
    ImGui::Separator();
    actionMenuItem(ui, "trackball");
    ImGui::EndMenu();
  }
  ImGui::EndMenu();
}

void textureMenu(const Ui& ui) {
  if (!beginMenu(ui, "Texture pane")) return;
  for (const char* line : {"uv-fill", "uv-frame", "frame-uv"}) actionMenuItem(ui, line);
  ImGui::EndMenu();
}

void interfaceMenu(const Ui& ui) {
  if (!beginMenu(ui, "Interface")) return;
  if (beginMenu(ui, "Theme")) {
    choiceMenuItems(ui, "theme");
    ImGui::EndMenu();
  }
  if (beginMenu(ui, "Simulate colour blindness")) {
    for (const ColorVisionInfo& kind : colorVisionTable()) {
      actionMenuItem(ui, std::string("simulate ") + kind.id, kind.label);
    }
    ImGui::EndMenu();
  }
  if (beginMenu(ui, "Size of the interface")) {
    actionMenuItem(ui, "ui-scale auto", "As the screen proposes");
    for (const char* percent : {"75", "100", "125", "150", "175", "200", "250"}) {
      actionMenuItem(ui, std::string("ui-scale ") + percent, std::string(percent) + " %");
    }
    ImGui::EndMenu();
  }
  ImGui::Separator();
  for (const char* line :
       {"right-pane", "next-tab", "sphere-linked", "hide-panels", "full-screen"}) {
    actionMenuItem(ui, line);
  }
  ImGui::EndMenu();
}

void viewMenu(const Ui& ui) {
  if (!beginMenu(ui, "View")) return;
  coloursMenu(ui);
  showMenu(ui);
  chartsMenu(ui);
  cameraMenu(ui);
  textureMenu(ui);
  interfaceMenu(ui);
  ImGui::EndMenu();
}

/// How far "Step many" goes.
void stepSizeMenu(const Ui& ui) {
  if (!beginMenu(ui, "Step many takes")) return;
  choiceMenuItems(ui, "many");
  ImGui::EndMenu();
}

void filmMenu(const Ui& ui) {
  if (!beginMenu(ui, "Film of the run")) return;
  for (const char* line : {"step", "step-chart", "step-many", "back", "back-many", "finish",
                           "first", "last", "run-start", "run-end"}) {
    actionMenuItem(ui, line);
  }
  stepSizeMenu(ui);
  actionMenuItem(ui, "reduced-motion");
  ImGui::EndMenu();
}

void runMenu(const Ui& ui) {
  if (!beginMenu(ui, "Run")) return;
  actionMenuItem(ui, "explore");
  actionMenuItem(ui, "play");
  filmMenu(ui);
  ImGui::Separator();
  for (const char* line : {"run", "iteration", "stop", "best", "unwrap"}) {
    actionMenuItem(ui, line);
  }
  ImGui::Separator();
  for (const char* line : {"more-charts", "fewer-charts", "find-charts", "charts-from-creases"}) {
    actionMenuItem(ui, line);
  }
  ImGui::Separator();
  actionMenuItem(ui, "watch-handles");
  ImGui::Separator();
  actionMenuItem(ui, "reset-flood");
  actionMenuItem(ui, "reset-seeds");
  ImGui::EndMenu();
}

void compareMenu(const Ui& ui) {
  if (!beginMenu(ui, "Compare")) return;
  actionMenuItem(ui, "compare-methods");
  ImGui::Separator();
  for (const char* slot : {"A", "B", "C"}) {
    actionMenuItem(ui, std::string("store ") + slot, std::string("Store as ") + slot);
  }
  ImGui::Separator();
  for (const StoredResult& each : ui.state.compare.stored) {
    actionMenuItem(ui, "use " + each.name, "Use " + each.name);
  }
  actionMenuItem(ui, "swap");
  ImGui::Separator();
  for (const char* line : {"side-by-side", "wipe"}) actionMenuItem(ui, line);
  ImGui::Separator();
  for (const char* line : {"link-cameras", "link-colors", "link-range", "link-checker"}) {
    actionMenuItem(ui, line);
  }
  ImGui::Separator();
  actionMenuItem(ui, "clear-compare");
  ImGui::EndMenu();
}

void helpMenu(const Ui& ui) {
  if (!beginMenu(ui, "Help")) return;
  actionMenuItem(ui, "find-action");
  actionMenuItem(ui, "keys");
  actionMenuItem(ui, "first-steps");
  actionMenuItem(ui, "log");
  ImGui::Separator();
  actionMenuItem(ui, "about");
  ImGui::EndMenu();
}

/// The model's name at the right end.
void modelName(const Ui& ui) {
  const std::string name = ui.state.modelName() + (ui.state.unsaved() ? " *" : "");
  const float width = ImGui::CalcTextSize(name.c_str()).x + ui.px(12);
  const float left = ImGui::GetWindowWidth() - width;
  if (name.empty() || left < ImGui::GetCursorPosX() + ui.px(20)) return;
  ImGui::SetCursorPosX(left);
  ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.palette.dim);
  ImGui::TextUnformatted(name.c_str());
  ImGui::PopStyleColor();
}

}  // namespace

void menuBar(const Ui& ui) {
  if (!ImGui::BeginMenuBar()) return;
  fileMenu(ui);
  editMenu(ui);
  viewMenu(ui);
  seedsMenu(ui);
  runMenu(ui);
  compareMenu(ui);
  helpMenu(ui);
  modelName(ui);
  ImGui::EndMenuBar();
}

}  // namespace chartflood
