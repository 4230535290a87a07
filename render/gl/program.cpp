#include "render/gl/program.h"

#include <sstream>
#include <string>

#include <glm/gtc/type_ptr.hpp>

#include "core/base/error.h"
#include "render/gl/shader_source.h"

namespace chartflood::gl {

namespace {

struct VertexShaderKind {
  static GLuint create() { return glCreateShader(GL_VERTEX_SHADER); }
  static void destroy(GLuint id) { glDeleteShader(id); }
};
struct FragmentShaderKind {
  static GLuint create() { return glCreateShader(GL_FRAGMENT_SHADER); }
  static void destroy(GLuint id) { glDeleteShader(id); }
};

/// Puts file names in the place of the source numbers in a driver's message ("2:14(3): error").
std::string nameFiles(const std::string& message, const ShaderSource& source) {
  std::istringstream lines(message);
  std::string named, line;
  while (std::getline(lines, line)) {
    const std::size_t end = line.find_first_not_of("0123456789");
    const bool numbered =
        end != std::string::npos && end > 0 && end < 4 && (line[end] == ':' || line[end] == '(');
    const std::size_t number = numbered ? std::stoul(line.substr(0, end)) : source.files.size();
    if (number < source.files.size()) line.replace(0, end, source.files[number]);
    named += line + "\n";
  }
  return named;
}

template <typename Kind>
Handle<Kind> compile(std::string_view name, std::span<const std::string> defines) {
  const ShaderSource source = loadShader(name, defines);
  Handle<Kind> shader = Handle<Kind>::create();
  const char* text = source.text.c_str();
  glShaderSource(shader.id(), 1, &text, nullptr);
  glCompileShader(shader.id());
  GLint compiled = GL_FALSE;
  glGetShaderiv(shader.id(), GL_COMPILE_STATUS, &compiled);
  if (compiled == GL_TRUE) return shader;
  GLint length = 0;
  glGetShaderiv(shader.id(), GL_INFO_LOG_LENGTH, &length);
  std::string message(static_cast<std::size_t>(length), '\0');
  glGetShaderInfoLog(shader.id(), length, nullptr, message.data());
  throw Error("The shader " + std::string(name) +
              " does not compile here: " + nameFiles(message.c_str(), source));
}

}  // namespace

Program::Program(std::string_view vertexShader, std::string_view fragmentShader,
                 std::span<const std::string> defines)
    : program_(Handle<ProgramKind>::create()) {
  const auto vertex = compile<VertexShaderKind>(vertexShader, defines);
  const auto fragment = compile<FragmentShaderKind>(fragmentShader, defines);
  glAttachShader(program_.id(), vertex.id());
  glAttachShader(program_.id(), fragment.id());
  glLinkProgram(program_.id());
  glDetachShader(program_.id(), vertex.id());
  glDetachShader(program_.id(), fragment.id());
  GLint linked = GL_FALSE;
  glGetProgramiv(program_.id(), GL_LINK_STATUS, &linked);
  if (linked == GL_TRUE) return;
  GLint length = 0;
  glGetProgramiv(program_.id(), GL_INFO_LOG_LENGTH, &length);
  std::string message(static_cast<std::size_t>(length), '\0');
  glGetProgramInfoLog(program_.id(), length, nullptr, message.data());
  throw Error("The shaders " + std::string(vertexShader) + " and " + std::string(fragmentShader) +
              " do not link here: " + message.c_str());
}

GLint Program::location(std::string_view name) {
  const auto found = locations_.find(name);
  if (found != locations_.end()) return found->second;
  const std::string key(name);
  const GLint location = glGetUniformLocation(program_.id(), key.c_str());
  locations_.emplace(key, location);
  return location;
}

void Program::set(std::string_view name, int value) { glUniform1i(location(name), value); }
void Program::set(std::string_view name, unsigned value) { glUniform1ui(location(name), value); }
void Program::set(std::string_view name, float value) { glUniform1f(location(name), value); }
void Program::set(std::string_view name, const glm::vec2& value) {
  glUniform2fv(location(name), 1, glm::value_ptr(value));
}
void Program::set(std::string_view name, const glm::vec3& value) {
  glUniform3fv(location(name), 1, glm::value_ptr(value));
}
void Program::set(std::string_view name, const glm::vec4& value) {
  glUniform4fv(location(name), 1, glm::value_ptr(value));
}
void Program::set(std::string_view name, const glm::mat3& value) {
  glUniformMatrix3fv(location(name), 1, GL_FALSE, glm::value_ptr(value));
}
void Program::set(std::string_view name, const glm::mat4& value) {
  glUniformMatrix4fv(location(name), 1, GL_FALSE, glm::value_ptr(value));
}

}  // namespace chartflood::gl
