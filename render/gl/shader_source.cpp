#include "render/gl/shader_source.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>

#include "core/base/error.h"

namespace chartflood::gl {

namespace {

std::filesystem::path& shaderFolder() {
  static std::filesystem::path folder;
  return folder;
}

std::string readText(const std::string& name) {
  if (!shaderFolder().empty()) {
    std::ifstream file(shaderFolder() / name, std::ios::binary);
    if (!file) throw ReadError((shaderFolder() / name).string(), "there is no such shader");
    return {std::istreambuf_iterator<char>(file), {}};
  }
  for (const EmbeddedShader& shader : embeddedShaders()) {
    if (shader.name == name) return std::string(shader.text);
  }
  throw Error("The program holds no shader \"" + name + "\".");
}

/// The name between the quotes of an include line, or "" for any other line.
std::string includedName(const std::string& line) {
  constexpr std::string_view kDirective = "#include \"";
  if (!line.starts_with(kDirective)) return "";
  const std::size_t end = line.find('"', kDirective.size());
  if (end == std::string::npos) throw Error("A shader has an unfinished line: " + line);
  return line.substr(kDirective.size(), end - kDirective.size());
}

void append(ShaderSource& source, const std::string& name) {
  const std::size_t number = source.files.size();
  source.files.push_back(name);
  std::istringstream text(readText(name));
  std::string line;
  for (int lineNumber = 1; std::getline(text, line); ++lineNumber) {
    const std::string included = includedName(line);
    if (included.empty()) {
      source.text.append(line).append("\n");
      continue;
    }
    const bool seen =
        std::find(source.files.begin(), source.files.end(), included) != source.files.end();
    if (!seen) {
      source.text += "#line 1 " + std::to_string(source.files.size()) + "\n";
      append(source, included);
    }
    source.text += "#line " + std::to_string(lineNumber + 1) + " " + std::to_string(number) + "\n";
  }
}

}  // namespace

void setShaderFolder(const std::filesystem::path& folder) { shaderFolder() = folder; }

ShaderSource loadShader(std::string_view name, std::span<const std::string> defines) {
  ShaderSource source;
  append(source, std::string(name));
  if (defines.empty()) return source;
  std::string lines;
  for (const std::string& define : defines) lines += "#define " + define + "\n";
  // After the line of #version, which must stay the first.
  source.text.insert(source.text.find('\n') + 1, lines + "#line 2 0\n");
  return source;
}

}  // namespace chartflood::gl
