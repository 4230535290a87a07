// The Gauss sphere: where the normals of a chart lie. Their area is the Gauss area that the method
// shares out (paper section 3.2).

#include <algorithm>
#include <cmath>
#include <string>

#include "app/gui/panels/panels.h"
#include "app/gui/panels/plot_widgets.h"
#include "app/gui/panels/sphere_drawing.h"
#include "app/gui/widgets/widgets.h"

namespace chartflood {

namespace {

constexpr float kFigureRows = 5;

/// The chart that is shown: pointed at, else selected.
Index shownChart(const AppState& state) {
  const Index hovered = state.hoveredChart();
  const Index chart = hovered != kNone ? hovered : state.selectedChart;
  const auto& stats = state.results().chartStats;
  return stats && chart < stats->charts.size() ? chart : kNone;
}

void turn(const Ui& ui, float radius) {
  if (!ImGui::IsItemActive()) return;
  const ImVec2 delta = ImGui::GetIO().MouseDelta;
  if (delta.x == 0 && delta.y == 0) return;
  ViewSettings& view = ui.state.view;
  Camera& camera = view.sphereLinked ? view.camera : view.sphereCamera;
  // The place under the mouse follows it, near the middle.
  camera.orbit(static_cast<double>(delta.x / radius), static_cast<double>(delta.y / radius));
}

void drawDots(const Ui& ui, const SphereDrawing& sphere, Index shown) {
  const auto dots = ui.state.insight().dots(ui.state.results());
  if (!dots) return;
  const float size = std::max(1.0f, (shown == kNone ? 2.4f : 1.9f) * ui.theme.scale);
  const ImU32 alpha = IM_COL32(0, 0, 0, shown == kNone ? 210 : 130);
  const ImU32 dry = ui.theme.palette.dim;
  for (const SphereDot& dot : *dots) {
    const Index chart = ui.state.chartOfFace(dot.face);
    if (chart == shown && shown != kNone) continue;
    const ImU32 color = chart == kNone ? dry : chartColor(ui, chart);
    sphere.dot(dot.normal, Half::Front, (color & ~IM_COL32_A_MASK) | alpha, size);
  }
}

void drawHalf(const Ui& ui, const SphereDrawing& sphere, const SpherePatch& patch, Half half) {
  const bool front = half == Half::Front;
  const ImU32 color = chartColor(ui, patch.chart);
  const ImU32 line = ui.theme.palette.text;
  const auto with = [&](ImU32 c, int alpha) {
    return (c & ~IM_COL32_A_MASK) | (static_cast<ImU32>(alpha) << IM_COL32_A_SHIFT);
  };
  sphere.facets(patch.facets, half, color, front ? 0.45f : 0.14f);
  sphere.arcs(patch.arcs, half, with(line, front ? 170 : 50));
  for (const auto& corner : patch.corners) {
    sphere.outline(corner, half, with(line, front ? 230 : 60));
  }
  for (const glm::vec3& n : patch.points) {
    if (front) sphere.point(n, half, with(line, 230), ui.px(3.2f));
    sphere.point(n, half, with(color, front ? 255 : 90), ui.px(front ? 2.2f : 2.6f));
  }
}

void drawSphere(const Ui& ui, float side, Index shown) {
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  ImGui::InvisibleButton("sphere", {width, side});
  ui.probe.item("sphere");
  const float radius = side / 2 - ui.px(14);
  if (radius < 8) return;
  turn(ui, radius);
  const ViewSettings& view = ui.state.view;
  Camera camera = view.sphereLinked ? view.camera : view.sphereCamera;
  camera.up = view.camera.up;
  const SphereDrawing sphere(ui, {std::round(low.x + width / 2), std::round(low.y + side / 2)},
                             radius, camera);
  const auto patch = shown == kNone ? nullptr : ui.state.insight().patch(ui.state.results(), shown);
  const ImU32 ink = ui.theme.palette.text & ~IM_COL32_A_MASK;
  sphere.ball();
  sphere.grid(Half::Back, ink | IM_COL32(0, 0, 0, 14));
  if (patch) drawHalf(ui, sphere, *patch, Half::Back);
  sphere.grid(Half::Front, ink | IM_COL32(0, 0, 0, 38));
  drawDots(ui, sphere, shown);
  if (patch) drawHalf(ui, sphere, *patch, Half::Front);
  sphere.axes();
}

/// A dim name and a figure at the right edge.
void figureRow(const Ui& ui, const char* name, const std::string& value) {
  const float width = ImGui::GetContentRegionAvail().x;
  const float used = ImGui::CalcTextSize(value.c_str()).x;
  const float left = ImGui::GetCursorPosX();
  fittedText(ui, name, width - used - ui.px(8), ui.theme.palette.dim);
  ImGui::SameLine(left + width - used);
  ImGui::TextUnformatted(value.c_str());
  ui.probe.item(std::string("figure/") + name);
}

void chartFigures(const Ui& ui, Index chart) {
  const Results& results = ui.state.results();
  const ChartStats& stats = *results.chartStats;
  const double area = stats.charts[chart].gaussArea;
  const double total = results.gaussArea ? results.gaussArea->total() : 0;
  figureRow(ui, "Gauss area", formatted("%.4g sr", area));
  figureRow(ui, "Share of the total",
            total > 0 ? formatted("%.1f %%", 100 * area / total) : "\u2013");
  figureRow(ui, "Against the mean",
            stats.balanceDefined ? formatted("%.0f %%", 100 * area / stats.gaussMean) : "\u2013");
  const auto patch = ui.state.insight().patch(results, chart);
  if (!patch) return;
  const double all = std::max(patch->area(), 1e-300);
  figureRow(ui, "Faces, creases, corners",
            formatted("%.0f", 100 * patch->faceArea / all) +
                formatted(" / %.0f", 100 * patch->edgeArea / all) +
                formatted(" / %.0f %%", 100 * patch->cornerArea / all));
}

void heading(const Ui& ui, Index shown) {
  const float line = ImGui::GetTextLineHeight();
  ImGui::PushFont(ui.theme.strong);
  if (shown == kNone) {
    ImGui::TextUnformatted("All charts");
  } else {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float chip = ui.px(12), top = low.y + std::round((line - chip) / 2);
    ImGui::GetWindowDrawList()->AddRectFilled({low.x, top}, {low.x + chip, top + chip},
                                              chartColor(ui, shown), ui.px(3));
    ImGui::Dummy({chip, line});
    ImGui::SameLine(0, ui.px(6));
    ImGui::TextUnformatted(("Chart " + std::to_string(shown)).c_str());
  }
  ui.probe.item("sphere-chart");
  ImGui::PopFont();
}

void allFigures(const Ui& ui) {
  const Results& results = ui.state.results();
  if (results.gaussArea) {
    figureRow(ui, "Gauss area of the model", formatted("%.4g sr", results.gaussArea->total()));
  }
  ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.palette.dim);
  ImGui::TextWrapped("Point at a chart, or select one, to see where its normals lie.");
  ImGui::PopStyleColor();
}

}  // namespace

void spherePanel(const Ui& ui) {
  if (!ui.state.hasMesh()) {
    ImGui::PushStyleColor(ImGuiCol_Text, ui.theme.palette.dim);
    ImGui::TextWrapped("The normals of the model appear here, on the unit sphere.");
    ImGui::PopStyleColor();
    return;
  }
  const Index shown = shownChart(ui.state);
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const float figures = kFigureRows * ImGui::GetTextLineHeightWithSpacing() +
                        ImGui::GetFrameHeightWithSpacing() + ui.px(10);
  drawSphere(ui, std::max(ui.px(120), std::min(room.x, room.y - figures)), shown);
  heading(ui, shown);
  if (shown == kNone) {
    allFigures(ui);
  } else {
    chartFigures(ui, shown);
  }
  ImGui::Dummy({0, ui.px(2)});
  switchRow(ui, "Turn with the model", ui.state.view.sphereLinked, "sphere-linked");
}

}  // namespace chartflood
