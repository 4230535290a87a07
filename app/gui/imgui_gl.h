#pragma once
/// Draws what Dear ImGui has to draw, with our own GL objects: the same pixels in a window and
/// offscreen.

#include <imgui.h>

#include "render/color_vision.h"
#include "render/gl/objects.h"
#include "render/gl/program.h"

namespace chartflood {

class ImguiGl {
 public:
  /// Needs a current GL context and Dear ImGui context.
  ImguiGl();

  /// Uploads the font atlas; again after every change of it.
  void uploadFonts();
  /// From now on pictures, unlike letters and controls, are shown as seen with this vision.
  void setVision(ColorVision vision) { vision_ = vision; }
  /// Draws into the framebuffer that is bound, without the lists that `leaveOut` says yes to.
  void draw(const ImDrawData& data, bool (*leaveOut)(const ImDrawList&) = nullptr);

 private:
  void setState(const ImDrawData& data);
  void drawList(const ImDrawList& list, const ImDrawData& data);

  gl::Program program_;
  gl::VertexArray vertexArray_;
  gl::Buffer vertices_, indices_;
  gl::Texture fonts_;
  ColorVision vision_ = ColorVision::Full;
};

/// The identity that Dear ImGui knows a GL texture by.
inline ImTextureID textureId(GLuint texture) {
  return reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture));
}

}  // namespace chartflood
