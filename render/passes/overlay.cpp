#include "render/passes/overlay.h"

#include <cmath>
#include <cstddef>
#include <span>

#include "render/passes/texture_units.h"

namespace chartflood {

namespace {
constexpr float kPlain = 0, kLetter = 1, kBar = 2;
}  // namespace

Overlay::Overlay() : program_("overlay.vert", "overlay.frag") {
  vertexArray_ = gl::VertexArray::create();
  buffer_ = gl::Buffer::create();
  glBindVertexArray(vertexArray_.id());
  glBindBuffer(GL_ARRAY_BUFFER, buffer_.id());
  const auto attribute = [](GLuint index, GLint count, std::size_t offset) {
    glEnableVertexAttribArray(index);
    glVertexAttribPointer(index, count, GL_FLOAT, GL_FALSE, sizeof(Vertex),
                          reinterpret_cast<const void*>(offset));
  };
  attribute(0, 2, offsetof(Vertex, place));
  attribute(1, 2, offsetof(Vertex, texture));
  attribute(2, 4, offsetof(Vertex, color));
  attribute(3, 4, offsetof(Vertex, halo));
  attribute(4, 1, offsetof(Vertex, kind));
  glBindVertexArray(0);
}

void Overlay::quad(const glm::vec2& topLeft, const glm::vec2& size, const glm::vec4& uv,
                   Vertex look) {
  for (const int corner : {0, 1, 2, 2, 1, 3}) {
    const glm::vec2 share(corner & 1, corner >> 1);
    look.place = topLeft + share * size;
    look.texture = glm::vec2(uv) + share * (glm::vec2(uv.z, uv.w) - glm::vec2(uv));
    vertices_.push_back(look);
  }
}

void Overlay::rectangle(const glm::vec2& topLeft, const glm::vec2& size, const glm::vec4& color) {
  quad(topLeft, size, glm::vec4(0), {{}, {}, color, {}, kPlain});
}

void Overlay::triangle(const glm::vec2& a, const glm::vec2& b, const glm::vec2& c,
                       const glm::vec4& color) {
  for (const glm::vec2& place : {a, b, c}) vertices_.push_back({place, {}, color, {}, kPlain});
}

void Overlay::colorBar(const glm::vec2& topLeft, const glm::vec2& size) {
  quad(topLeft, size, glm::vec4(0, 1, 1, 0), {{}, {}, {}, {}, kBar});
}

void Overlay::text(const glm::vec2& place, std::string_view line, const TextStyle& style,
                   TextAlign align) {
  const float width = textWidth(line, style.size);
  const float shift = align == TextAlign::Left ? 0 : align == TextAlign::Center ? width / 2 : width;
  const glm::vec2 start(std::round(place.x - shift),
                        std::round(place.y + 0.5f * atlas_.capHeight() * style.size));
  // All halos lie under all letters, or each letter's halo would nibble at the one before.
  const glm::vec4 none(0);
  letters(start, line, style.size, {{}, {}, none, style.halo, kLetter});
  letters(start, line, style.size, {{}, {}, style.color, none, kLetter});
}

void Overlay::letters(glm::vec2 pen, std::string_view line, float size, const Vertex& look) {
  for (const char32_t letter : decodeUtf8(line)) {
    const Glyph& glyph = atlas_.glyph(letter);
    if (glyph.width > 0) {
      quad(pen + size * glm::vec2(glyph.left, glyph.top),
           size * glm::vec2(glyph.width, glyph.height), {glyph.u0, glyph.v0, glyph.u1, glyph.v1},
           look);
    }
    pen.x += glyph.advance * size;
  }
}

std::vector<glm::vec4> Overlay::checkerGlyphs() {
  std::vector<glm::vec4> entries;
  for (const char letter : std::string_view("ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789")) {
    const Glyph& glyph = atlas_.glyph(static_cast<char32_t>(letter));
    entries.emplace_back(glyph.u0, glyph.v0, glyph.u1, glyph.v1);
    entries.emplace_back(glyph.width, glyph.height, glyph.top, 0.0f);
  }
  return entries;
}

void Overlay::draw(const glm::vec2& viewport, const glm::vec4& tile, GLuint mapUnit,
                   int colorSteps) {
  if (vertices_.empty()) return;
  atlas_.bind(units::kGlyphs);
  glBindVertexArray(vertexArray_.id());
  gl::uploadBuffer<Vertex>(buffer_, GL_ARRAY_BUFFER, vertices_, GL_STREAM_DRAW);
  program_.use();
  program_.set("uViewport", viewport);
  program_.set("uTile", tile);
  program_.set("uGlyphs", static_cast<int>(units::kGlyphs));
  program_.set("uColorMap", static_cast<int>(mapUnit));
  program_.set("uDistanceUnit", GlyphAtlas::distanceUnit());
  program_.set("uSteps", colorSteps);
  glDisable(GL_DEPTH_TEST);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertices_.size()));
  glBindVertexArray(0);
}

}  // namespace chartflood
