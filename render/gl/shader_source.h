#pragma once
/// Texts of the shaders: built into the program, or read from a folder while working on them.

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace chartflood::gl {

/// A file of the folder `shaders`, as built in; `name` is its path inside that folder.
struct EmbeddedShader {
  std::string_view name;
  std::string_view text;
};
std::span<const EmbeddedShader> embeddedShaders();

/// Reads shaders from this folder instead of the built-in ones; an empty path goes back to them.
void setShaderFolder(const std::filesystem::path& folder);

/// A text ready to compile. `files[n]` is the file that the compiler's messages call source n.
struct ShaderSource {
  std::string text;
  std::vector<std::string> files;
};

/// The shader with every `#include "name"` replaced by that file, once each, and `#line` directives
/// that keep line numbers true. Each of `defines` ("NAME" or "NAME value") is defined before its
/// second line. \throws Error when a file is missing.
ShaderSource loadShader(std::string_view name, std::span<const std::string> defines = {});

}  // namespace chartflood::gl
