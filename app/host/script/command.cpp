#include "app/host/script/command.h"

#include <optional>
#include <utility>
#include <vector>

#include "core/base/error.h"

namespace chartflood {

namespace {

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

/// A word of a line, and where its first unquoted "=" stands.
struct Word {
  std::string text;
  std::optional<std::size_t> equals;
};

/// Takes the next word off `line`; nothing at its end or at a comment.
std::optional<Word> takeWord(std::string_view& line) {
  while (!line.empty() && isBlank(line.front())) line.remove_prefix(1);
  if (line.empty() || line.front() == '#') return std::nullopt;
  Word word;
  bool inQuotes = false;
  std::size_t at = 0;
  for (; at < line.size() && (inQuotes || !isBlank(line[at])); ++at) {
    if (line[at] == '"') {
      inQuotes = !inQuotes;
    } else if (inQuotes && line[at] == '\\' && at + 1 < line.size()) {
      word.text += line[++at];
    } else {
      if (!inQuotes && line[at] == '=' && !word.equals) word.equals = word.text.size();
      word.text += line[at];
    }
  }
  if (inQuotes) throw UsageError("A quote is opened and never closed in '" + word.text + "'.");
  line.remove_prefix(at);
  return word;
}

void storeArgument(Command& command, const Word& word, std::size_t& nextPosition) {
  std::string name = word.equals ? word.text.substr(0, *word.equals) : "";
  std::string value = word.equals ? word.text.substr(*word.equals + 1) : word.text;
  if (word.equals && name.empty()) {
    throw UsageError("The argument '" + word.text + "' has no name before '='.");
  }
  if (!word.equals) name = std::to_string(nextPosition++);
  if (!command.arguments.emplace(name, std::move(value)).second) {
    throw UsageError("The argument '" + name + "' is given twice.");
  }
}

}  // namespace

Command parseCommand(std::string_view line) {
  Command command;
  std::size_t nextPosition = 0;
  if (auto action = takeWord(line)) command.action = action->text;
  while (auto word = takeWord(line)) storeArgument(command, *word, nextPosition);
  return command;
}

std::string quotedArgument(std::string_view value) {
  const bool plain = !value.empty() && value.find_first_of(" \t\"\\#=") == std::string_view::npos;
  if (plain) return std::string(value);
  std::string text = "\"";
  for (char c : value) {
    if (c == '"' || c == '\\') text += '\\';
    text += c;
  }
  return text + '"';
}

std::string commandText(const Command& command) {
  std::string text = command.action;
  for (std::size_t i = 0; command.arguments.count(std::to_string(i)) != 0; ++i) {
    text += ' ' + quotedArgument(command.arguments.find(std::to_string(i))->second);
  }
  for (const auto& [name, value] : command.arguments) {
    const bool positional = name.find_first_not_of("0123456789") == std::string::npos;
    if (!positional) text += ' ' + name + '=' + quotedArgument(value);
  }
  return text;
}

}  // namespace chartflood
