#pragma once
/// All options of the command line, as a table: for reading, for --help and for the tests of the
/// documentation.

#include <span>
#include <string>
#include <vector>

namespace chartflood {

struct OptionInfo {
  std::string name;   ///< without dashes
  std::string value;  ///< what stands for the value in --help; "" for a switch
  std::string group;  ///< heading in --help
  std::string help;

  bool isSwitch() const { return value.empty(); }
};

/// Every option, in the order of --help. The parameters come from their own table.
std::span<const OptionInfo> optionTable();

/// Ids of the colour modes that can be drawn, in the order of the menu.
std::vector<std::string> colorModeIds();

}  // namespace chartflood
