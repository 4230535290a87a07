#pragma once
/// Letters as a texture of distances to their outline, so that one texture serves every size and a
/// halo costs nothing.

#include <map>
#include <memory>
#include <string_view>
#include <vector>

#include "render/gl/objects.h"

namespace chartflood {

/// One letter; lengths in ems unless said otherwise.
struct Glyph {
  float left = 0, top = 0;      ///< of the picture, from the pen; y down, the baseline is 0
  float width = 0, height = 0;  ///< of the picture; 0 for a space
  float advance = 0;
  float u0 = 0, v0 = 0, u1 = 0, v1 = 0;  ///< place in the texture
};

/// Letters of the built-in font (Inter), drawn when first used.
class GlyphAtlas {
 public:
  GlyphAtlas();
  ~GlyphAtlas();
  GlyphAtlas(const GlyphAtlas&) = delete;
  GlyphAtlas& operator=(const GlyphAtlas&) = delete;

  const Glyph& glyph(char32_t letter);
  /// Width of a line of UTF-8 text, ems.
  float width(std::string_view text);
  /// Uploads new letters where there are any and makes the texture readable.
  void bind(GLuint unit);
  /// Pixels of the texture over the whole range of distances, 0 to 1.
  static float distanceUnit();
  static float pixelsPerEm();
  /// Height of capital letters, ems.
  float capHeight() const { return capHeight_; }

 private:
  struct Font;
  void rasterize(char32_t letter, Glyph& glyph);
  void place(const std::vector<float>& fine, int width, int height, Glyph& glyph);

  std::unique_ptr<Font> font_;
  std::map<char32_t, Glyph> glyphs_;
  std::vector<unsigned char> pixels_;
  int penX_ = 0, penY_ = 0, rowHeight_ = 0;
  float capHeight_ = 0.7f;
  bool changed_ = true;
  gl::Texture texture_;
};

/// The letters of UTF-8 text; wrong bytes become U+FFFD.
std::vector<char32_t> decodeUtf8(std::string_view text);

}  // namespace chartflood
