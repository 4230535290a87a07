#include "core/base/error.h"

namespace chartflood {

namespace {
std::string sentence(std::string_view verb, std::string_view file, std::string_view cause) {
  std::string text = "Could not ";
  text.append(verb).append(" ").append(file).append(": ").append(cause);
  if (text.back() != '.') text.push_back('.');
  return text;
}
}  // namespace

ReadError::ReadError(std::string_view file, std::string_view cause)
    : Error(sentence("read", file, cause)), cause_(cause) {}

WriteError::WriteError(std::string_view file, std::string_view cause)
    : Error(sentence("write", file, cause)) {}

}  // namespace chartflood
