#include "render/gl/debug.h"

#include <string>

#include <epoxy/gl.h>

#include "core/base/log.h"

namespace chartflood::gl {

namespace {
void report(GLenum source, GLenum type, GLuint, GLenum, GLsizei, const GLchar* message,
            const void*) {
  // Shaders that do not compile are thrown as errors with their file and line.
  if (type != GL_DEBUG_TYPE_ERROR || source == GL_DEBUG_SOURCE_SHADER_COMPILER) return;
  logMessage(LogLevel::Warning, std::string("OpenGL: ") + message);
}
}  // namespace

bool logDriverErrors() {
  if (!epoxy_has_gl_extension("GL_KHR_debug")) return false;
  glEnable(GL_DEBUG_OUTPUT);
  glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  glDebugMessageCallback(report, nullptr);
  return true;
}

}  // namespace chartflood::gl
