#include "core/base/text.h"

#include <cctype>

namespace chartflood {

std::optional<bool> switchValue(std::string_view word) {
  for (const char* on : {"on", "true", "yes", "1"}) {
    if (word == on) return true;
  }
  for (const char* off : {"off", "false", "no", "0"}) {
    if (word == off) return false;
  }
  return std::nullopt;
}

const char* switchWord(bool on) { return on ? "on" : "off"; }

char lowerCase(char letter) {
  return static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
}

std::string lowerCase(std::string_view text) {
  std::string lower(text);
  for (char& letter : lower) letter = lowerCase(letter);
  return lower;
}

std::string listed(std::span<const std::string> words, std::string_view last) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0 && i + 1 < words.size()) text += ", ";
    if (i > 0 && i + 1 == words.size()) text.append(" ").append(last).append(" ");
    text += words[i];
  }
  return text;
}

}  // namespace chartflood
