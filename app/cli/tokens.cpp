#include "app/cli/tokens.h"

#include <algorithm>
#include <utility>

#include <CLI/CLI.hpp>

#include "core/base/error.h"
#include "core/base/spelling.h"
#include "core/session/settings/parameters.h"

namespace chartflood {

namespace {

const OptionInfo* findOption(std::span<const OptionInfo> table, std::string_view name) {
  const auto found = std::find_if(table.begin(), table.end(),
                                  [&](const OptionInfo& row) { return row.name == name; });
  return found == table.end() ? nullptr : &*found;
}

[[noreturn]] void refuseMissingValue(const OptionInfo& option) {
  throw UsageError("--" + option.name + " needs a value: --" + option.name + "=" + option.value +
                   ".");
}

[[noreturn]] void refuseUnknown(const std::string& word, std::span<const OptionInfo> table) {
  const std::string spelled = word.substr(0, word.find('='));
  const std::string name = spelled.substr(std::min(spelled.find_first_not_of('-'), spelled.size()));
  std::vector<std::string> names;
  for (const OptionInfo& row : table) names.push_back(row.name);
  const std::string nearest = nearestSpelling(name, names);
  throw UsageError("There is no option " + spelled + ": " +
                   (nearest.empty() ? "--help lists all." : "did you mean --" + nearest + "?"));
}

/// The parser takes the word after "--name=" for the value; an empty value is a mistake here.
void refuseEmptyValues(std::span<const std::string> words, std::span<const OptionInfo> table) {
  for (const std::string& word : words) {
    if (word == "--") return;
    if (!word.starts_with("--") || word.find('=') != word.size() - 1) continue;
    const OptionInfo* option = findOption(table, word.substr(2, word.size() - 3));
    if (option == nullptr) continue;
    if (option->isSwitch()) {
      throw UsageError(word + " needs a value: --" + option->name + "=on or off.");
    }
    refuseMissingValue(*option);
  }
}

}  // namespace

Tokens readTokens(std::span<const std::string> words, std::span<const OptionInfo> table) {
  refuseEmptyValues(words, table);
  CLI::App parser;
  parser.set_help_flag();
  parser.allow_extras();
  std::vector<std::pair<const OptionInfo*, CLI::Option*>> options;
  std::vector<std::string> texts(table.size());
  for (std::size_t i = 0; i < table.size(); ++i) {
    const std::string name = (table[i].name == "help" ? "-h,--" : "--") + table[i].name;
    CLI::Option* option =
        table[i].isSwitch() ? parser.add_flag(name) : parser.add_option(name, texts[i]);
    if (!table[i].isSwitch()) option->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
    options.emplace_back(&table[i], option);
  }
  Tokens tokens;
  parser.add_option("files", tokens.files);
  try {
    parser.parse(std::vector<std::string>(words.rbegin(), words.rend()));
  } catch (const CLI::ArgumentMismatch&) {
    // Every option takes exactly one value, so only the last word can lack one.
    const OptionInfo* option = findOption(table, words.back().substr(2));
    if (option != nullptr) refuseMissingValue(*option);
    throw;
  }
  for (const std::string& word : parser.remaining()) {
    if (word != "--") refuseUnknown(word, table);
  }
  for (const auto& [row, option] : options) {
    if (option->count() > 0) tokens.values[row->name] = option->results().back();
  }
  return tokens;
}

}  // namespace chartflood
