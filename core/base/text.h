#pragma once
/// Small things about words: on and off, letters of either case, lists in a sentence.

#include <optional>
#include <span>
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

/// "a, b or c" with the word `last` before the last one.
std::string listed(std::span<const std::string> words, std::string_view last);

}  // namespace chartflood
