#include "app/gui/panels/histogram_plot.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "app/gui/panels/plot_widgets.h"
#include "render/scene/color_map.h"

namespace chartflood {

namespace {

constexpr double kTowering = 4;  // times the next bin
constexpr const char* kHelp =
    "How often each value occurs, over the range of the colour bar. What lies outside is counted "
    "at the ends.";

/// The colour that the model has at a place of the colour bar.
ImU32 mapColor(const RenderSettings& settings, float t) {
  const char* own = colorModeInfo(settings.colorMode).colorMap;
  const ColorMap* map = findColorMap(settings.colorMap.empty() ? own : settings.colorMap.c_str());
  if (map == nullptr) return IM_COL32(128, 128, 128, 255);
  if (settings.colorSteps > 1) {
    const auto steps = static_cast<float>(settings.colorSteps);
    t = std::min(std::floor(t * steps), steps - 1) / (steps - 1);
  }
  const glm::vec3 c = map->at(settings.invertColorMap ? 1 - t : t);
  return ImGui::ColorConvertFloat4ToU32({c.x, c.y, c.z, 1});
}

std::string withUnit(const ScalarRange& range, double value) {
  return formatted("%.3g", value) + (range.unit.empty() ? "" : ' ' + range.unit);
}

std::string binReadout(const ModeHistogram& plot, std::size_t bin) {
  const auto bins = static_cast<double>(plot.histogram.share.size());
  const double from = valueAt(plot.range, static_cast<double>(bin) / bins);
  const double to = valueAt(plot.range, static_cast<double>(bin + 1) / bins);
  return formatted("%.3g", from) + " to " + withUnit(plot.range, to) + ": " +
         formatted("%.2g %% ", 100 * plot.histogram.share[bin]) + plot.weight;
}

std::string restReadout(const ModeHistogram& plot) {
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
  if (plot.range.hasMean) add("mean " + withUnit(plot.range, plot.range.mean));
  const Histogram& h = plot.histogram;
  if (h.above > 0.0005) add(formatted("%.1f %% above the range", 100 * h.above));
  if (h.below > 0.0005) add(formatted("%.1f %% below", 100 * h.below));
  if (h.missing > 0.0005) add(formatted("%.1f %% without a value", 100 * h.missing));
  return text.empty() ? "share " + plot.weight : text;
}

/// Top of the axis in per cent. One bin that towers over all others is cut off, or it would press
/// them to the ground.
double axisTop(std::vector<double> share) {
  std::sort(share.begin(), share.end(), std::greater<>());
  const double most = 100 * share[0], next = 100 * share[1];
  if (!(most > 0)) return 1;
  return next > 0 && most > kTowering * next ? niceTop(1.2 * next) : niceTop(most);
}

/// Says how high a bin is that was cut off.
void drawCut(const Ui& ui, const PlotArea& area, float x, float step, double percent) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ImGui::PushFont(ui.theme.small);
  const std::string text = formatted("\u2191 %.0f %%", percent);
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  const bool right = x + step + ui.px(4) + size.x < area.high.x;
  const ImVec2 at{right ? x + step + ui.px(4) : x - ui.px(4) - size.x, area.low.y + ui.px(1)};
  list.AddRectFilled({at.x - ui.px(2), at.y}, {at.x + size.x + ui.px(2), at.y + size.y},
                     ui.theme.palette.bar);
  list.AddText(at, ui.theme.palette.text, text.c_str());
  ImGui::PopFont();
}

/// The bin under the mouse where the plot stood in the last frame; `bins` when none.
std::size_t binUnderMouse(const PlotArea& area, std::size_t bins) {
  const float share = (ImGui::GetIO().MousePos.x - area.low.x) / std::max(1.0f, area.width());
  if (share < 0 || share >= 1) return bins;
  return std::min(bins - 1, static_cast<std::size_t>(share * static_cast<float>(bins)));
}

void drawBins(const Ui& ui, const PlotArea& area, const ValueAxis& axis, const Histogram& h,
              std::size_t under) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Palette& p = ui.theme.palette;
  const std::size_t bins = h.share.size();
  const float step = area.width() / static_cast<float>(bins), strip = ui.px(5);
  std::vector<ImVec2> outline;
  for (std::size_t i = 0; i < bins; ++i) {
    const float x0 = area.low.x + static_cast<float>(i) * step, x1 = x0 + step;
    const float y = axis.y(area, 100 * h.share[i]);
    const ImU32 color =
        mapColor(ui.state.view.render, (static_cast<float>(i) + 0.5f) / static_cast<float>(bins));
    if (h.share[i] > 0) list.AddRectFilled({x0, y}, {x1, area.high.y}, color);
    list.AddRectFilled({x0, area.high.y}, {x1, area.high.y + strip}, color);
    // A line must not turn back on itself, or its joints bulge.
    if (outline.empty() || outline.back().y != y) outline.push_back({x0, y});
    outline.push_back({x1, y});
  }
  // The outline is seen where a colour is as dark as the ground.
  list.AddPolyline(outline.data(), static_cast<int>(outline.size()), p.dim, 0, ui.px(1));
  for (std::size_t i = 0; i < bins; ++i) {
    if (100 * h.share[i] <= axis.high * 1.001) continue;
    drawCut(ui, area, area.low.x + static_cast<float>(i) * step, step, 100 * h.share[i]);
  }
  if (under >= bins) return;
  const float x = area.low.x + static_cast<float>(under) * step;
  list.AddRect({x - 1, area.low.y}, {x + step + 1, area.high.y + strip}, p.text, 0, 0, ui.px(1));
}

}  // namespace

void histogramPlot(const Ui& ui, const ModeHistogram& plot, std::size_t number, float height) {
  const std::vector<double>& share = plot.histogram.share;
  const ValueAxis axis{0, axisTop(share), "%.3g %%"};
  const std::string label = "plot/values" + (number == 0 ? "" : std::to_string(number));
  const std::string title =
      plot.range.title + (plot.range.unit.empty() ? "" : ", " + plot.range.unit);
  std::size_t& under = ui.memory.binUnderMouse[number % ui.memory.binUnderMouse.size()];
  PlotWords words{title.c_str(), label.c_str(), kHelp,
                  under < share.size() ? binReadout(plot, under) : restReadout(plot)};
  const PlotArea area = beginPlot(ui, words, axis, height);
  const std::size_t now = area.hovered ? binUnderMouse(area, share.size()) : share.size();
  if (now != under) ui.wakeIn(0);  // the readout stands above
  under = now;
  drawBins(ui, area, axis, plot.histogram, under);
  std::vector<PlotTick> ticks;
  for (const ScalarTick& tick :
       scalarTicks(plot.range, static_cast<int>(area.width() / ui.px(60)))) {
    ticks.push_back({area.low.x + static_cast<float>(tick.place) * area.width(), tick.label});
  }
  bottomTicks(ui, area, ticks, ui.px(5));
}

void emptyHistogram(const Ui& ui) {
  const ColorModeInfo& info = colorModeInfo(ui.state.view.render.colorMode);
  const bool valued = *info.colorMap != '\0';
  const PlotWords words{valued ? info.title : "Values of the colours", "plot/values", kHelp, ""};
  emptyPlot(ui, words,
            valued ? "Not computed yet."
                   : "The colours show no values now. Keys 3 to 8 choose some.");
}

}  // namespace chartflood
