#include "app/gui/imgui_gl.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace chartflood {

namespace {

const void* at(std::size_t offset) { return reinterpret_cast<const void*>(offset); }

GLuint textureName(ImTextureID id) {
  return static_cast<GLuint>(reinterpret_cast<std::uintptr_t>(id));
}

}  // namespace

ImguiGl::ImguiGl()
    : program_("ui.vert", "ui.frag"), vertexArray_(gl::VertexArray::create()),
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
  atlas->SetTexID(textureId(fonts_.id()));
  atlas->ClearTexData();
}

void ImguiGl::setState(const ImDrawData& data) {
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
  program_.use();
  program_.set("uTexture", 0);
  program_.set("uVision", visionMatrix(vision_));
  program_.set("uOrigin", glm::vec2(data.DisplayPos.x, data.DisplayPos.y));
  program_.set("uSize", glm::vec2(data.DisplaySize.x, data.DisplaySize.y));
  glActiveTexture(GL_TEXTURE0);
  glBindSampler(0, 0);
  glBindVertexArray(vertexArray_.id());
}

void ImguiGl::draw(const ImDrawData& data, bool (*leaveOut)(const ImDrawList&)) {
  if (data.DisplaySize.x <= 0 || data.DisplaySize.y <= 0) return;
  setState(data);
  for (int i = 0; i < data.CmdListsCount; ++i) {
    if (leaveOut == nullptr || !leaveOut(*data.CmdLists[i])) drawList(*data.CmdLists[i], data);
  }
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_BLEND);
  glBindVertexArray(0);
}

void ImguiGl::drawList(const ImDrawList& list, const ImDrawData& data) {
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
    if (command.UserCallback == ImDrawCallback_ResetRenderState) {
      setState(data);
      continue;
    }
    if (command.UserCallback != nullptr) {
      command.UserCallback(&list, &command);
      continue;
    }
    const auto left = static_cast<GLint>((command.ClipRect.x - origin.x) * scale.x);
    const auto top = static_cast<GLint>((command.ClipRect.y - origin.y) * scale.y);
    const auto right = static_cast<GLint>((command.ClipRect.z - origin.x) * scale.x);
    const auto bottom = static_cast<GLint>((command.ClipRect.w - origin.y) * scale.y);
    if (right <= left || bottom <= top) continue;
    glScissor(left, pixelsHigh - bottom, right - left, bottom - top);
    const GLuint texture = textureName(command.GetTexID());
    const bool picture = texture != fonts_.id();
    program_.set("uSimulate", picture && vision_ != ColorVision::Full ? 1 : 0);
    glBindTexture(GL_TEXTURE_2D, texture);
    glDrawElementsBaseVertex(GL_TRIANGLES, static_cast<GLsizei>(command.ElemCount), kIndexType,
                             at(command.IdxOffset * sizeof(ImDrawIdx)),
                             static_cast<GLint>(command.VtxOffset));
  }
}

}  // namespace chartflood
