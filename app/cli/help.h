#pragma once
/// What --help says.

#include <string>

namespace chartflood {

/// All options by group, 100 columns wide, ending with worked examples.
std::string helpText();

}  // namespace chartflood
