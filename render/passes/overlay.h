#pragma once
/// Text and plain shapes drawn over the model, in pixels.

#include <string_view>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "render/gl/objects.h"
#include "render/gl/program.h"
#include "render/text/glyph_atlas.h"

namespace chartflood {

/// How a line of text sits at its place.
enum class TextAlign { Left, Center, Right };

/// Text colour and the halo that keeps it legible on any ground; sRGB, straight alpha.
struct TextStyle {
  float size = 13;  ///< height of an em, pixels
  glm::vec4 color{1};
  glm::vec4 halo{0, 0, 0, 0.8f};
};

/// Collects shapes, then draws them in that order. Places are pixels from the top left.
class Overlay {
 public:
  Overlay();

  void clear() { vertices_.clear(); }
  void rectangle(const glm::vec2& topLeft, const glm::vec2& size, const glm::vec4& color);
  void triangle(const glm::vec2& a, const glm::vec2& b, const glm::vec2& c, const glm::vec4& color);
  /// The colour map of the picture, its low end at the bottom.
  void colorBar(const glm::vec2& topLeft, const glm::vec2& size);
  /// A line of UTF-8 text whose middle of capital letters is at `place.y`.
  void text(const glm::vec2& place, std::string_view line, const TextStyle& style,
            TextAlign align = TextAlign::Left);
  float textWidth(std::string_view line, float size) { return atlas_.width(line) * size; }

  /// What the numbered checkerboard needs to know of the letters A to Z and the digits 0 to 9: two
  /// entries each, (u0, v0, u1, v1) in the glyphs' texture and (width, height, top, 0) in ems.
  std::vector<glm::vec4> checkerGlyphs();
  /// Makes the glyphs' texture readable.
  void bindGlyphs(GLuint unit) { atlas_.bind(unit); }

  /// Draws what was collected. `tile` is as in common/eye.glsl; the map's texture is at `mapUnit`.
  void draw(const glm::vec2& viewport, const glm::vec4& tile, GLuint mapUnit, int colorSteps);

 private:
  struct Vertex {
    glm::vec2 place, texture;
    glm::vec4 color, halo;
    float kind;
  };
  void quad(const glm::vec2& topLeft, const glm::vec2& size, const glm::vec4& uv, Vertex look);

  void letters(glm::vec2 pen, std::string_view line, float size, const Vertex& look);

  GlyphAtlas atlas_;
  gl::Program program_;
  gl::VertexArray vertexArray_;
  gl::Buffer buffer_;
  std::vector<Vertex> vertices_;
};

}  // namespace chartflood
