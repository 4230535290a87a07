#include "app/gui/panels/plot_widgets.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

#include "app/gui/widgets/widgets.h"

namespace chartflood {

namespace {

constexpr double kLeastContrast = 3;  // of shapes against their ground

/// Relative luminance as in the contrast rule of WCAG 2.
double luminance(const ImVec4& color) {
  const auto linear = [](float c) {
    const auto value = static_cast<double>(c);
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(color.x) + 0.7152 * linear(color.y) + 0.0722 * linear(color.z);
}

/// A label of the left axis at its right end.
void axisNumber(const Ui& ui, const PlotArea& area, float y, const std::string& text) {
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  ImGui::GetWindowDrawList()->AddText({area.low.x - size.x - ui.px(6), std::round(y - size.y / 2)},
                                      ui.theme.palette.dim, text.c_str());
}

/// Bars as drawn: several charts share one where there are more charts than pixels.
struct Columns {
  const std::vector<Index>& order;
  std::size_t count;
  float step;

  std::size_t first(std::size_t column) const { return column * order.size() / count; }
  /// The chart of a column with the largest value.
  Index chart(std::size_t column, const std::vector<double>& values) const {
    Index best = order[first(column)];
    for (std::size_t i = first(column); i < first(column + 1); ++i) {
      if (!(values[order[i]] <= values[best])) best = order[i];
    }
    return best;
  }
};

void drawBar(const Ui& ui, const PlotArea& area, float x, float step, float y, Index chart) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Palette& p = ui.theme.palette;
  const float gap = step > ui.px(5) ? ui.px(1) : 0;
  const bool hovered = ui.state.hoveredChart() == chart;
  const bool selected = ui.state.selectedChart == chart;
  const ImVec2 low{x + gap, std::min(y, area.high.y - 1)}, high{x + step - gap, area.high.y};
  if (hovered || selected) {
    list.AddRectFilled({x, area.low.y}, {x + step, area.high.y},
                       hovered ? p.controlActive : p.control);
  }
  list.AddRectFilled(low, high, chartColor(ui, chart));
  if (!hovered && !selected) return;
  // A frame and a mark below: never by colour alone.
  list.AddRect({low.x - 1, low.y - 1}, {high.x + 1, high.y}, p.text, 0, 0,
               ui.px(hovered ? 2.0f : 1.0f));
  const float middle = (low.x + high.x) / 2, size = ui.px(4);
  if (selected) {
    list.AddTriangleFilled({middle, area.high.y + 1}, {middle - size, area.high.y + 1 + size},
                           {middle + size, area.high.y + 1 + size}, p.text);
  }
}

void barNumbers(const Ui& ui, const PlotArea& area, const Columns& columns, bool byValue) {
  ImGui::PushFont(ui.theme.small);
  const std::string widest = std::to_string(columns.order.size());
  const float room = ImGui::CalcTextSize(widest.c_str()).x + ui.px(6);
  ImGui::PopFont();
  std::size_t stride = 1;
  // Steps of 1, 2, 5, 10, 20, ..
  for (std::size_t i = 0; columns.step * static_cast<float>(stride) < room && i < 30; ++i) {
    stride = i % 3 == 1 ? stride * 5 / 2 : stride * 2;
  }
  std::vector<PlotTick> ticks;
  const bool shared = columns.count < columns.order.size();
  if (byValue && stride > 1) {
    // Numbers out of order help only where each bar has its own.
    ticks.push_back({(area.low.x + area.high.x) / 2, "charts, largest first"});
  } else if (shared) {
    ticks.push_back({(area.low.x + area.high.x) / 2, "charts by number"});
  } else {
    for (std::size_t i = 0; i < columns.count; i += stride) {
      ticks.push_back({area.low.x + (static_cast<float>(i) + 0.5f) * columns.step,
                       std::to_string(columns.order[i])});
    }
  }
  bottomTicks(ui, area, ticks, ui.px(5));
}

/// Title and readout in small letters below.
void plotHeading(const Ui& ui, const PlotWords& words) {
  ImGui::PushFont(ui.theme.strong);
  ImGui::TextUnformatted(words.title);
  ImGui::PopFont();
  tooltip(ui, std::string("title/") + words.label, words.title, words.help);
  if (words.readout.empty()) return;
  ImGui::PushFont(ui.theme.small);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, ui.px(3)));
  fittedText(ui, words.readout, ImGui::GetContentRegionAvail().x, ui.theme.palette.dim);
  ui.probe.item(std::string("readout/") + words.label);
  ImGui::PopStyleVar();
  ImGui::PopFont();
}

}  // namespace

float ValueAxis::y(const PlotArea& area, double value) const {
  const double share = std::clamp((value - low) / (high - low), 0.0, 1.0);
  return area.high.y - area.height() * static_cast<float>(share);
}

double niceTop(double value) {
  const double power = std::pow(10, std::floor(std::log10(std::max(value, 1e-12))));
  for (const double factor : {1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0}) {
    if (value <= factor * power * (1 + 1e-9)) return factor * power;
  }
  return 10 * power;
}

std::string formatted(const char* pattern, double value) {
  char text[64];
  std::snprintf(text, sizeof text, pattern, value);
  return text;
}

PlotArea beginPlot(const Ui& ui, const PlotWords& words, const ValueAxis& axis, float height) {
  plotHeading(ui, words);
  const float width = ImGui::GetContentRegionAvail().x;
  ImGui::PushFont(ui.theme.small);
  float left = 0;
  for (int i = 0; i <= 2; ++i) {
    const std::string text = formatted(axis.pattern, axis.low + (axis.high - axis.low) * i / 2);
    left = std::max(left, ImGui::CalcTextSize(text.c_str()).x);
  }
  const ImVec2 low = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton(words.label, {width, height});
  ui.probe.item(words.label);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(low, {low.x + width, low.y + height}, ui.theme.palette.bar, ui.px(3));
  PlotArea area{{low.x + left + ui.px(12), low.y + ui.px(10)},
                {low.x + width - ui.px(10), low.y + height - ui.px(21)},
                ImGui::IsItemHovered()};
  ui.probe.rectangle(std::string("bars/") + words.label, area.low, area.high);
  for (int i = 0; i <= 2; ++i) {
    const double value = axis.low + (axis.high - axis.low) * i / 2;
    const float y = std::round(axis.y(area, value));
    list.AddLine({area.low.x, y}, {area.high.x, y}, ui.theme.palette.line);
    axisNumber(ui, area, y, formatted(axis.pattern, value));
  }
  ImGui::PopFont();
  return area;
}

void emptyPlot(const Ui& ui, const PlotWords& words, const std::string& text) {
  plotHeading(ui, words);
  const ImVec2 low = ImGui::GetCursorScreenPos(), pad{ui.px(10), ui.px(8)};
  const float width = ImGui::GetContentRegionAvail().x;
  const float wrap = width - 2 * pad.x;
  const ImVec2 size = ImGui::CalcTextSize(text.c_str(), nullptr, false, wrap);
  ImGui::InvisibleButton(words.label, {width, size.y + 2 * pad.y});
  ui.probe.item(words.label);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(low, ImGui::GetItemRectMax(), ui.theme.palette.bar, ui.px(3));
  list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), {low.x + pad.x, low.y + pad.y},
               ui.theme.palette.dim, text.c_str(), nullptr, wrap);
}

void bottomTicks(const Ui& ui, const PlotArea& area, const std::vector<PlotTick>& ticks,
                 float below) {
  ImGui::PushFont(ui.theme.small);
  float taken = -1e9f;
  for (const PlotTick& tick : ticks) {
    const float width = ImGui::CalcTextSize(tick.text.c_str()).x;
    const float left = std::max(area.low.x - ui.px(6), area.low.x - width / 2);
    const float x = std::round(
        std::clamp(tick.x - width / 2, left, std::max(left, area.high.x + ui.px(6) - width)));
    if (x < taken) continue;
    ImGui::GetWindowDrawList()->AddText({x, area.high.y + ui.px(1) + below}, ui.theme.palette.dim,
                                        tick.text.c_str());
    taken = x + width + ui.px(6);
  }
  ImGui::PopFont();
}

void levelLine(const Ui& ui, const PlotArea& area, float y) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float dash = ui.px(6);
  for (float x = area.low.x; x < area.high.x; x += 2 * dash) {
    const ImVec2 from{x, y}, to{std::min(x + dash, area.high.x), y};
    list.AddLine(from, to, ui.theme.palette.bar, ui.px(3.5f));
    list.AddLine(from, to, ui.theme.palette.front, ui.px(1.5f));
  }
}

ImU32 legibleOn(ImU32 groundColor, ImU32 color) {
  const double ground = luminance(ImGui::ColorConvertU32ToFloat4(groundColor));
  const float end = ground < 0.2 ? 1 : 0;  // lighter on dark grounds, darker on light ones
  ImVec4 c = ImGui::ColorConvertU32ToFloat4(color);
  const auto contrast = [&] {
    const double own = luminance(c);
    return (std::max(own, ground) + 0.05) / (std::min(own, ground) + 0.05);
  };
  for (int i = 0; i < 20 && contrast() < kLeastContrast; ++i) {
    c.x += 0.06f * (end - c.x);
    c.y += 0.06f * (end - c.y);
    c.z += 0.06f * (end - c.z);
  }
  return ImGui::ColorConvertFloat4ToU32(c);
}

ImU32 chartColor(const Ui& ui, Index chart) {
  const std::vector<ImU32>& colors = ui.memory.chartColors;
  return chart < colors.size() ? legibleOn(ui.theme.palette.bar, colors[chart])
                               : ui.theme.palette.accent;
}

std::vector<Index> barOrder(const std::vector<double>& values, bool byValue) {
  std::vector<Index> order(values.size());
  std::iota(order.begin(), order.end(), Index{0});
  if (!byValue) return order;
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) {
    // Charts without a value come last.
    if (std::isnan(values[a]) || std::isnan(values[b]))
      return !std::isnan(values[a]) && std::isnan(values[b]);
    return values[a] > values[b];
  });
  return order;
}

void drawChartBars(const Ui& ui, const PlotArea& area, const ValueAxis& axis,
                   const ChartBars& bars) {
  if (bars.values.empty() || area.width() < 1) return;
  const bool byValue = ui.state.panels.barsByValue;
  const std::vector<Index> order = barOrder(bars.values, byValue);
  const std::size_t count = std::min(order.size(), static_cast<std::size_t>(area.width()));
  const Columns columns{order, count, area.width() / static_cast<float>(count)};
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  for (std::size_t i = 0; i < count; ++i) {
    const float x = area.low.x + static_cast<float>(i) * columns.step;
    const Index chart = columns.chart(i, bars.values);
    if (area.hovered && mouse.x >= x && mouse.x < x + columns.step) {
      ui.pointAt(chart);
      if (ImGui::IsItemClicked(0)) ui.run("select-chart " + std::to_string(chart));
    }
    if (!std::isnan(bars.values[chart])) {
      drawBar(ui, area, x, columns.step, axis.y(area, bars.values[chart]), chart);
    }
  }
  if (bars.hasLevel) levelLine(ui, area, axis.y(area, bars.level));
  barNumbers(ui, area, columns, byValue);
}

}  // namespace chartflood
