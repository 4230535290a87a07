#include "core/io/read/json_depth.h"

#include <cstddef>

namespace chartflood {

const char* tooDeepInJson(std::string_view json, int deepest) {
  int depth = 0;
  bool inString = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (inString) {
      if (c == '\\') ++i;
      inString = c != '"';
      continue;
    }
    inString = c == '"';
    if (c == '{' || c == '[') ++depth;
    if (c == '}' || c == ']') --depth;
    if (depth > deepest) return &json[i];
  }
  return nullptr;
}

}  // namespace chartflood
