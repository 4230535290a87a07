#pragma once
/// Words that mean the same wherever they are read: on and off, and letters of either case.

#include <optional>
#include <string>
#include <string_view>

namespace chartflood {

/// True for "on", "true", "yes" and "1", false for "off", "false", "no" and "0", nothing for other
/// words.
std::optional<bool> switchValue(std::string_view word);

/// "on" or "off".
const char* switchWord(bool on);

/// Letters of ASCII in lower case; others as they are.
char lowerCase(char letter);
std::string lowerCase(std::string_view text);

}  // namespace chartflood
