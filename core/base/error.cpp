#include "core/base/error.h"

#include <algorithm>

namespace chartflood {

namespace {

/// A name with its folders may be thousands of letters long: its end is what tells it.
std::string_view endOf(std::string_view file, std::size_t longest) {
  std::string_view end = file.substr(file.size() - std::min(file.size(), longest));
  while (!end.empty() && (static_cast<unsigned char>(end.front()) & 0xC0) == 0x80) {
    end.remove_prefix(1);
  }
  return end;
}

/// Causes may quote what stands in a file, which may be of any length.
std::string shortened(std::string_view cause) {
  constexpr std::size_t kLongest = 300;
  if (cause.size() <= kLongest) return std::string(cause);
  std::string text(cause.substr(0, kLongest - 2));
  // Not in the middle of a letter of several bytes.
  while ((static_cast<unsigned char>(text.back()) & 0xC0) == 0x80) text.pop_back();
  if (static_cast<unsigned char>(text.back()) >= 0xC0) text.pop_back();
  return text + "..";
}

std::string sentence(std::string_view verb, std::string_view file, std::string_view cause) {
  std::string text = "Could not ";
  constexpr std::size_t kLongestName = 300;
  text.append(verb).append(file.size() > kLongestName ? " .." : " ");
  text.append(endOf(file, kLongestName)).append(": ").append(cause);
  if (text.back() != '.') text.push_back('.');
  return text;
}
}  // namespace

ReadError::ReadError(std::string_view file, std::string_view cause)
    : Error(sentence("read", file, shortened(cause))), cause_(shortened(cause)) {}

WriteError::WriteError(std::string_view file, std::string_view cause)
    : Error(sentence("write", file, shortened(cause))) {}

}  // namespace chartflood
