#pragma once
/// The parameter table as a page of the documentation.

#include <string>

namespace chartflood {

/// A Markdown table with one row a parameter: label, symbol, option, range, default and what it
/// does; then one with the presets.
std::string parameterPage();

}  // namespace chartflood
