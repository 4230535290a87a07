#pragma once
/// How deeply JSON is nested, told before a parser or a tree that calls itself could run out of
/// stack.

#include <string_view>

namespace chartflood {

/// The bracket with which JSON becomes nested more than `deepest` deep; null when it never is.
const char* tooDeepInJson(std::string_view json, int deepest);

}  // namespace chartflood
