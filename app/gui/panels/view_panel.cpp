// Overlays, colour map and camera.

#include <cmath>
#include <string>

#include "app/gui/panels/panels.h"
#include "app/gui/widgets.h"
#include "render/color_map.h"

namespace chartflood {

namespace {

/// Switches in two columns.
void overlaySwitches(const Ui& ui) {
  static constexpr const char* kLines[] = {"seams",   "seeds",     "edges",  "sharp-edges",
                                           "numbers", "color-bar", "smooth", "orthographic"};
  const float half = ImGui::GetContentRegionAvail().x / 2;
  const float left = ImGui::GetCursorPosX();
  int column = 0;
  for (const char* line : kLines) {
    if (column == 1) {
      ImGui::SameLine();
      ImGui::SetCursorPosX(left + half);
    }
    column = 1 - column;
    switchRow(ui, ui.actions.find(line)->title.c_str(), ui.actions.checked(line, ui.state), line);
  }
}

void colorMapRow(const Ui& ui) {
  const RenderSettings& settings = ui.state.view.render;
  const ColorMap* chosen = findColorMap(settings.colorMap);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Colour map");
  ImGui::SameLine(std::round(ImGui::GetWindowContentRegionMax().x * 0.5f));
  ImGui::SetNextItemWidth(-1);
  const bool open =
      ImGui::BeginCombo("##colormap", chosen == nullptr ? "Automatic" : chosen->label);
  ui.probe.item("colormap");
  if (!open) return;
  if (ImGui::Selectable("Automatic", chosen == nullptr)) ui.run("colormap auto");
  for (const ColorMap& map : colorMapTable()) {
    if (ImGui::Selectable(map.label, &map == chosen)) ui.run(std::string("colormap ") + map.id);
    if (!map.colorBlindSafe) {
      tooltip(ui, map.id, "", "Not readable with every kind of colour vision.");
    }
  }
  ImGui::EndCombo();
}

}  // namespace

void viewPanel(const Ui& ui) {
  if (!section(ui, "View")) return;
  overlaySwitches(ui);
  colorMapRow(ui);
}

}  // namespace chartflood
