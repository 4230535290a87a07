#pragma once
/// What plots are made of: frame, axes, bars of charts. Drawn as shapes; nothing is kept.

#include <functional>
#include <string>
#include <vector>

#include "app/gui/widgets/ui.h"

namespace chartflood {

/// Where a plot's data are drawn, in window coordinates.
struct PlotArea {
  ImVec2 low, high;  ///< top left, bottom right
  bool hovered = false;

  float width() const { return high.x - low.x; }
  float height() const { return high.y - low.y; }
};

/// The words around a plot.
struct PlotWords {
  const char* title = "";
  const char* label = "";  ///< in the probe
  const char* help = "";   ///< tooltip of the title
  std::string readout;     ///< the line under the title: a figure of what is pointed at; "": none
};

/// Values from the bottom to the top of a plot.
struct ValueAxis {
  double low = 0, high = 1;
  const char* pattern = "%.3g";  ///< of the numbers, with their unit

  /// Height of a value in the area, kept inside.
  float y(const PlotArea& area, double value) const;
};

/// The smallest of 1, 2, 3, 4, 5, 6, 8 times a power of ten that is not below `value`.
double niceTop(double value);
/// One number in a printf pattern.
std::string formatted(const char* pattern, double value);

/// Title, readout and an empty plot with lines at the bottom, middle and top of the axis.
PlotArea beginPlot(const Ui& ui, const PlotWords& words, const ValueAxis& axis, float height);
/// Instead of a plot: a low box with a sentence that says what is missing.
void emptyPlot(const Ui& ui, const PlotWords& words, const std::string& text);

/// A label below the area.
struct PlotTick {
  float x = 0;
  std::string text;
};
/// Draws the labels, ascending by x, leaving out those that would touch the one before.
void bottomTicks(const Ui& ui, const PlotArea& area, const std::vector<PlotTick>& ticks,
                 float below = 0);
/// A dashed line over the whole width at a value.
void levelLine(const Ui& ui, const PlotArea& area, float y);

/// A chart's colour, made lighter or darker where it could not be told from the ground of plots.
ImU32 chartColor(const Ui& ui, Index chart);
/// The nearest colour that differs from a ground by a contrast of at least 3 (WCAG 2.1, 1.4.11):
/// lighter on dark grounds, darker on light ones.
ImU32 legibleOn(ImU32 ground, ImU32 color);

/// One bar a chart.
struct ChartBars {
  std::vector<double> values;  ///< NaN: the chart has none
  double level = 0;            ///< marked by a line, where `hasLevel`
  bool hasLevel = false;
};
/// Order of the bars from the left.
std::vector<Index> barOrder(const std::vector<double>& values, bool byValue);
/// Draws the bars and links them: the bar under the mouse points at its chart, a click selects it.
/// Where there are more charts than pixels a bar shows the largest of its neighbours.
void drawChartBars(const Ui& ui, const PlotArea& area, const ValueAxis& axis,
                   const ChartBars& bars);

}  // namespace chartflood
