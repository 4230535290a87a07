#pragma once
/// One line of a script: an action's id and its arguments. Menus, buttons, keys, scripts and tests
/// all speak in such lines.

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

namespace chartflood {

/// Arguments by name, as text; the action's own table says of what type each is.
using ArgumentMap = std::map<std::string, std::string, std::less<>>;

struct Command {
  std::string action;     ///< "" for an empty line or a comment
  ArgumentMap arguments;  ///< a word without "=" goes under "0", "1", ..

  bool operator==(const Command&) const = default;
};

/// Reads `action value key=value key="two words"`; `#` starts a comment. Within double quotes a
/// backslash keeps the next character as it is.
/// \throws UsageError for an open quote, a repeated key or a key without a name.
Command parseCommand(std::string_view line);

/// The line that parseCommand reads back.
std::string commandText(const Command& command);

/// The value as it stands in a line: in quotes when it needs them.
std::string quotedArgument(std::string_view value);

}  // namespace chartflood
