#include "render/text/glyph_atlas.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <stb/stb_truetype.h>

#include "core/base/check.h"
#include "core/base/error.h"
#include "render/text/distance_field.h"
#include "render/text/font_data.h"

namespace chartflood {

namespace {

constexpr int kTextureSize = 512;
constexpr int kEm = 40;      // pixels of the texture
constexpr int kPadding = 8;  // how far distances reach, pixels of the texture
constexpr int kFiner = 4;    // outlines are sampled so many times finer than the texture

/// Level of a distance in pixels of the texture: 0.5 on the outline, 0 and 1 kPadding away.
unsigned char level(float distance) {
  const float t = 0.5f + 0.5f * distance / static_cast<float>(kPadding);
  return static_cast<unsigned char>(std::lround(255 * std::clamp(t, 0.0f, 1.0f)));
}

}  // namespace

struct GlyphAtlas::Font {
  stbtt_fontinfo info{};
  float scale = 1;
};

GlyphAtlas::GlyphAtlas()
    : font_(std::make_unique<Font>()),
      pixels_(static_cast<std::size_t>(kTextureSize) * kTextureSize, 0) {
  if (!stbtt_InitFont(&font_->info, interSemiBold().data(), 0)) {
    throw Error("The built-in font cannot be read; the program was built with a broken font file.");
  }
  font_->scale = stbtt_ScaleForMappingEmToPixels(&font_->info, static_cast<float>(kEm));
  int left = 0, bottom = 0, right = 0, top = 0;
  stbtt_GetCodepointBox(&font_->info, 'H', &left, &bottom, &right, &top);
  capHeight_ = static_cast<float>(top) * font_->scale / kEm;
}

GlyphAtlas::~GlyphAtlas() = default;

float GlyphAtlas::distanceUnit() { return 2.0f * kPadding; }

float GlyphAtlas::pixelsPerEm() { return kEm; }

const Glyph& GlyphAtlas::glyph(char32_t letter) {
  const auto [place, isNew] = glyphs_.try_emplace(letter);
  if (isNew) rasterize(letter, place->second);
  return place->second;
}

void GlyphAtlas::rasterize(char32_t letter, Glyph& glyph) {
  const int code = static_cast<int>(letter);
  int advance = 0, bearing = 0;
  stbtt_GetCodepointHMetrics(&font_->info, code, &advance, &bearing);
  glyph.advance = static_cast<float>(advance) * font_->scale / kEm;
  // Not stb's own distances: they ignore the cubic curves of this font.
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  const float finer = font_->scale * kFiner;
  stbtt_GetCodepointBitmapBox(&font_->info, code, finer, finer, &x0, &y0, &x1, &y1);
  if (x0 == x1 || y0 == y1) return;  // a space
  const auto toTexture = [](int fine) {
    return static_cast<int>(std::floor(static_cast<double>(fine) / kFiner));
  };
  const int left = toTexture(x0) - kPadding, top = toTexture(y0) - kPadding;
  const int width = toTexture(x1) + 1 + kPadding - left,
            height = toTexture(y1) + 1 + kPadding - top;
  const int fineWidth = width * kFiner, fineHeight = height * kFiner;
  std::vector<unsigned char> cover(static_cast<std::size_t>(fineWidth * fineHeight), 0);
  unsigned char* const corner =
      cover.data() + (y0 - top * kFiner) * fineWidth + (x0 - left * kFiner);
  stbtt_MakeCodepointBitmap(&font_->info, corner, x1 - x0, y1 - y0, fineWidth, finer, finer, code);
  std::vector<bool> inside(cover.size());
  std::transform(cover.begin(), cover.end(), inside.begin(), [](int c) { return c >= 128; });
  place(signedDistances(inside, fineWidth, fineHeight), width, height, glyph);
  glyph.left = static_cast<float>(left) / kEm;
  glyph.top = static_cast<float>(top) / kEm;
}

void GlyphAtlas::place(const std::vector<float>& fine, int width, int height, Glyph& glyph) {
  if (penX_ + width > kTextureSize) {
    penX_ = 0;
    penY_ += rowHeight_ + 1;
    rowHeight_ = 0;
  }
  CF_CHECK(penY_ + height <= kTextureSize);  // the program's own texts fit many times over
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      // Mean of the four fine pixels around the middle of the coarse one.
      const std::size_t row = static_cast<std::size_t>(width) * kFiner;
      const std::size_t i = (static_cast<std::size_t>(y) * kFiner + kFiner / 2 - 1) * row +
                            static_cast<std::size_t>(x) * kFiner + kFiner / 2 - 1;
      const float mean = 0.25f * (fine[i] + fine[i + 1] + fine[i + row] + fine[i + row + 1]);
      const int pixel = (penY_ + y) * kTextureSize + penX_ + x;
      pixels_[static_cast<std::size_t>(pixel)] = level(mean / kFiner);
    }
  }
  glyph.width = static_cast<float>(width) / kEm;
  glyph.height = static_cast<float>(height) / kEm;
  glyph.u0 = static_cast<float>(penX_) / kTextureSize;
  glyph.v0 = static_cast<float>(penY_) / kTextureSize;
  glyph.u1 = static_cast<float>(penX_ + width) / kTextureSize;
  glyph.v1 = static_cast<float>(penY_ + height) / kTextureSize;
  penX_ += width + 1;
  rowHeight_ = std::max(rowHeight_, height);
  changed_ = true;
}

float GlyphAtlas::width(std::string_view text) {
  float sum = 0;
  for (const char32_t letter : decodeUtf8(text)) sum += glyph(letter).advance;
  return sum;
}

void GlyphAtlas::bind(GLuint unit) {
  if (!texture_) texture_ = gl::Texture::create();
  glActiveTexture(GL_TEXTURE0 + unit);
  glBindTexture(GL_TEXTURE_2D, texture_.id());
  if (!changed_) return;
  changed_ = false;
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, kTextureSize, kTextureSize, 0, GL_RED, GL_UNSIGNED_BYTE,
               pixels_.data());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

std::vector<char32_t> decodeUtf8(std::string_view text) {
  constexpr char32_t kWrong = 0xFFFD;
  std::vector<char32_t> letters;
  for (std::size_t i = 0; i < text.size();) {
    const auto lead = static_cast<unsigned char>(text[i++]);
    const int more = lead < 0x80 ? 0 : lead >= 0xF0 ? 3 : lead >= 0xE0 ? 2 : lead >= 0xC0 ? 1 : -1;
    char32_t letter = more < 0 ? kWrong : more == 0 ? lead : lead & (0x3Fu >> more);
    for (int k = 0; k < more; ++k) {
      const auto next = i < text.size() ? static_cast<unsigned char>(text[i]) : 0u;
      if ((next & 0xC0u) != 0x80u) {
        letter = kWrong;
        break;
      }
      letter = letter << 6 | (next & 0x3Fu);
      ++i;
    }
    letters.push_back(letter);
  }
  return letters;
}

}  // namespace chartflood
