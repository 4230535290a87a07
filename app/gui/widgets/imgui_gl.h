#pragma once
/// Draws what Dear ImGui has to draw, with our own GL objects: the same pixels in a window and
/// offscreen.

#include <cstdint>
#include <optional>
#include <span>

#include <imgui.h>

#include "app/gui/widgets/frame_damage.h"
#include "render/gl/framebuffer.h"
#include "render/gl/objects.h"
#include "render/gl/program.h"
#include "render/scene/color_vision.h"

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
  /// The same, but nothing outside these parts, which do not overlap.
  void draw(const ImDrawData& data, std::span<const PixelRectangle> parts);

 private:
  void begin(const ImDrawData& data);
  static void end();
  void setProgram(gl::Program& program, const ImDrawData& data);
  void drawList(const ImDrawList& list, const ImDrawData& data,
                std::span<const PixelRectangle> parts);
  bool simulates() const { return vision_ != ColorVision::Full; }

  gl::Program plain_;
  std::optional<gl::Program> simulating_;  ///< for pictures; made when it is first wanted
  gl::VertexArray vertexArray_;
  gl::Buffer vertices_, indices_;
  gl::Texture fonts_;
  std::uint32_t fontUploads_ = 0;
  ColorVision vision_ = ColorVision::Full;
};

/// The identity that Dear ImGui knows a GL texture by; another `content`, another identity.
inline ImTextureID textureId(GLuint texture, std::uint32_t content) {
  static_assert(sizeof(ImTextureID) == sizeof(std::uint64_t));
  return reinterpret_cast<ImTextureID>(std::uint64_t{content} << 32 | texture);
}
/// The same for what was last drawn into a framebuffer.
inline ImTextureID textureId(const gl::Framebuffer& picture) {
  return textureId(picture.texture(), picture.drawing());
}

}  // namespace chartflood
