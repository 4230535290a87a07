#pragma once
/// Figures of charts as text for other programs.

#include <string>

#include "core/base/index.h"
#include "core/session/session.h"

namespace chartflood {

/// A comma-separated table with a heading: all figures of every chart, one line each, full
/// precision, a point for decimals; texture figures are empty where a chart is not laid flat.
/// Lengths and areas in model units, Gauss area in steradians. "" without charts.
std::string chartsCsv(const Results& results);

/// The same of one chart, one "name: value" a line. \pre the chart exists
std::string chartFigures(const Results& results, Index chart);

}  // namespace chartflood
