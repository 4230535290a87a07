#pragma once
/// A linked pair of shaders with its uniforms.

#include <map>
#include <span>
#include <string>
#include <string_view>

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "render/gl/objects.h"

namespace chartflood::gl {

struct ProgramKind {
  static GLuint create() { return glCreateProgram(); }
  static void destroy(GLuint id) { glDeleteProgram(id); }
};

/// Uniforms that a shader does not use may be set without effect.
class Program {
 public:
  Program() = default;
  /// Compiles and links two files of the folder `shaders`, e.g. "surface.vert", "surface.frag";
  /// `defines` as for loadShader(). \throws Error with the driver's message, file and line.
  Program(std::string_view vertexShader, std::string_view fragmentShader,
          std::span<const std::string> defines = {});

  void use() const { glUseProgram(program_.id()); }
  GLuint id() const { return program_.id(); }
  GLint attribute(const char* name) const { return glGetAttribLocation(program_.id(), name); }

  // The program must be in use.
  void set(std::string_view name, int value);
  void set(std::string_view name, unsigned value);
  void set(std::string_view name, float value);
  void set(std::string_view name, const glm::vec2& value);
  void set(std::string_view name, const glm::vec3& value);
  void set(std::string_view name, const glm::vec4& value);
  void set(std::string_view name, const glm::mat3& value);
  void set(std::string_view name, const glm::mat4& value);

 private:
  GLint location(std::string_view name);

  Handle<ProgramKind> program_;
  std::map<std::string, GLint, std::less<>> locations_;
};

}  // namespace chartflood::gl
