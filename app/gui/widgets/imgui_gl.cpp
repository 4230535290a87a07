#include "app/gui/widgets/imgui_gl.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace chartflood {

namespace {

const void* at(std::size_t offset) { return reinterpret_cast<const void*>(offset); }

GLuint textureName(ImTextureID id) {
  return static_cast<GLuint>(reinterpret_cast<std::uintptr_t>(id) & 0xFFFFFFFFU);
}

PixelRectangle wholeOf(const ImDrawData& data) {
  return {0, 0, static_cast<int>(data.DisplaySize.x * data.FramebufferScale.x),
          static_cast<int>(data.DisplaySize.y * data.FramebufferScale.y)};
}

}  // namespace

ImguiGl::ImguiGl()
    : plain_("ui.vert", "ui.frag"), vertexArray_(gl::VertexArray::create()),
      vertices_(gl::Buffer::create()), indices_(gl::Buffer::create()) {
  ImGuiIO& io = ImGui::GetIO();
  io.BackendRendererName = "chartflood";
  ImGui::GetStyle().AntiAliasedLinesUseTex = false;  // that texture would need smoothing
  io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
  glBindVertexArray(vertexArray_.id());
  glBindBuffer(GL_ARRAY_BUFFER, vertices_.id());
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());
  for (GLuint attribute = 0; attribute < 3; ++attribute) glEnableVertexAttribArray(attribute);
  constexpr GLsizei kStride = sizeof(ImDrawVert);
  glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, kStride, at(offsetof(ImDrawVert, pos)));
  glVertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, kStride, at(offsetof(ImDrawVert, uv)));
  glVertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, kStride, at(offsetof(ImDrawVert, col)));
  glBindVertexArray(0);
}

void ImguiGl::uploadFonts() {
  ImFontAtlas* atlas = ImGui::GetIO().Fonts;
  unsigned char* pixels = nullptr;
  int width = 0, height = 0;
  atlas->GetTexDataAsRGBA32(&pixels, &width, &height);
  if (!fonts_) fonts_ = gl::Texture::create();
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, fonts_.id());
  // Letters stand on whole pixels at the size they were made for; looking up four texels for each
  // pixel of the window would cost a third of its time where graphics are drawn in software.
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
  atlas->SetTexID(textureId(fonts_.id(), ++fontUploads_));
  atlas->ClearTexData();
}

void ImguiGl::begin(const ImDrawData& data) {
  glViewport(0, 0, static_cast<GLsizei>(data.DisplaySize.x * data.FramebufferScale.x),
             static_cast<GLsizei>(data.DisplaySize.y * data.FramebufferScale.y));
  glEnable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glDisable(GL_CULL_FACE);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_STENCIL_TEST);
  glEnable(GL_SCISSOR_TEST);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  if (simulates()) {
    if (!simulating_) {
      const std::string define = "SIMULATE";
      simulating_.emplace("ui.vert", "ui.frag", std::span(&define, 1));
    }
    setProgram(*simulating_, data);
    simulating_->set("uVision", visionMatrix(vision_));
  }
  setProgram(plain_, data);
  glActiveTexture(GL_TEXTURE0);
  glBindSampler(0, 0);
  glBindVertexArray(vertexArray_.id());
}

void ImguiGl::setProgram(gl::Program& program, const ImDrawData& data) {
  program.use();
  program.set("uTexture", 0);
  program.set("uOrigin", glm::vec2(data.DisplayPos.x, data.DisplayPos.y));
  program.set("uSize", glm::vec2(data.DisplaySize.x, data.DisplaySize.y));
}

void ImguiGl::draw(const ImDrawData& data, bool (*leaveOut)(const ImDrawList&)) {
  const PixelRectangle whole = wholeOf(data);
  begin(data);
  for (int i = 0; i < data.CmdListsCount; ++i) {
    const ImDrawList& list = *data.CmdLists[i];
    if (leaveOut == nullptr || !leaveOut(list)) drawList(list, data, std::span(&whole, 1));
  }
  end();
}

void ImguiGl::draw(const ImDrawData& data, std::span<const PixelRectangle> parts) {
  begin(data);
  for (int i = 0; i < data.CmdListsCount; ++i) drawList(*data.CmdLists[i], data, parts);
  end();
}

void ImguiGl::end() {
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_BLEND);
  glBindVertexArray(0);
}

void ImguiGl::drawList(const ImDrawList& list, const ImDrawData& data,
                       std::span<const PixelRectangle> parts) {
  using std::span;
  gl::uploadBuffer(
      vertices_, GL_ARRAY_BUFFER,
      span<const ImDrawVert>(list.VtxBuffer.Data, static_cast<std::size_t>(list.VtxBuffer.Size)),
      GL_STREAM_DRAW);
  gl::uploadBuffer(
      indices_, GL_ELEMENT_ARRAY_BUFFER,
      span<const ImDrawIdx>(list.IdxBuffer.Data, static_cast<std::size_t>(list.IdxBuffer.Size)),
      GL_STREAM_DRAW);
  constexpr GLenum kIndexType = sizeof(ImDrawIdx) == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT;
  const ImVec2 origin = data.DisplayPos, scale = data.FramebufferScale;
  const auto pixelsHigh = static_cast<GLint>(data.DisplaySize.y * scale.y);
  for (const ImDrawCmd& command : list.CmdBuffer) {
    const PixelRectangle clip{static_cast<int>((command.ClipRect.x - origin.x) * scale.x),
                              static_cast<int>((command.ClipRect.y - origin.y) * scale.y),
                              static_cast<int>((command.ClipRect.z - origin.x) * scale.x),
                              static_cast<int>((command.ClipRect.w - origin.y) * scale.y)};
    const GLuint texture = textureName(command.GetTexID());
    const bool picture = texture != fonts_.id();
    (picture && simulates() ? *simulating_ : plain_).use();
    glBindTexture(GL_TEXTURE_2D, texture);
    for (const PixelRectangle& part : parts) {
      const int left = std::max(part.left, clip.left), right = std::min(part.right, clip.right);
      const int top = std::max(part.top, clip.top), bottom = std::min(part.bottom, clip.bottom);
      if (right <= left || bottom <= top) continue;
      glScissor(left, pixelsHigh - bottom, right - left, bottom - top);
      glDrawElementsBaseVertex(GL_TRIANGLES, static_cast<GLsizei>(command.ElemCount), kIndexType,
                               at(command.IdxOffset * sizeof(ImDrawIdx)),
                               static_cast<GLint>(command.VtxOffset));
    }
  }
}

}  // namespace chartflood
