#pragma once
/// Splits the words of a command line into options and file names.

#include <map>
#include <span>
#include <string>
#include <vector>

#include "app/cli/option_table.h"

namespace chartflood {

/// What was written, still as text.
struct Tokens {
  /// By option name without dashes; of an option given twice the last value. Switches without a
  /// value are "true".
  std::map<std::string, std::string, std::less<>> values;
  std::vector<std::string> files;

  bool has(std::string_view name) const { return values.find(name) != values.end(); }
  /// The value, "" when it was not given.
  std::string text(std::string_view name) const {
    const auto found = values.find(name);
    return found == values.end() ? std::string() : found->second;
  }
};

/// Reads `--name=value`, `--name value`, switches `--name` and `--name=false`, and file names;
/// after
/// `--` every word is a file name.
/// \throws UsageError for an unknown option (with the nearest spelling) or a missing value.
Tokens readTokens(std::span<const std::string> words, std::span<const OptionInfo> table);

}  // namespace chartflood
