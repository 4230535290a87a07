#pragma once
/// A comparison of methods as a table of plain text.

#include <span>
#include <string>
#include <vector>

#include "core/model/comparison.h"

namespace chartflood {

/// Two tables: charts as each method leaves them, and with the same borders for all.
std::string comparisonText(std::span<const ComparisonRow> rows);

/// The few lines under a method's picture.
std::vector<std::string> comparisonCaption(const ComparisonRow& row);

}  // namespace chartflood
