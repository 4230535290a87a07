#include "render/text/glyph_atlas.h"

#include <algorithm>
#include <cstddef>

#include <stb/stb_truetype.h>

#include "core/base/check.h"
#include "core/base/error.h"
#include "render/text/font_data.h"

namespace chartflood {

namespace {
constexpr int kTextureSize = 512;
constexpr float kEm = 40;    // pixels of the texture
constexpr int kPadding = 6;  // how far distances reach, pixels of the texture
constexpr unsigned char kOnEdge = 128;
constexpr float kDistanceScale = 120.0f / kPadding;  // levels a pixel
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
  font_->scale = stbtt_ScaleForMappingEmToPixels(&font_->info, kEm);
  int left = 0, bottom = 0, right = 0, top = 0;
  stbtt_GetCodepointBox(&font_->info, 'H', &left, &bottom, &right, &top);
  capHeight_ = static_cast<float>(top) * font_->scale / kEm;
}

GlyphAtlas::~GlyphAtlas() = default;

float GlyphAtlas::distanceUnit() { return 255.0f / kDistanceScale; }

const Glyph& GlyphAtlas::glyph(char32_t letter) {
  const auto [place, isNew] = glyphs_.try_emplace(letter);
  if (isNew) rasterize(letter, place->second);
  return place->second;
}

void GlyphAtlas::rasterize(char32_t letter, Glyph& glyph) {
  int advance = 0, bearing = 0;
  stbtt_GetCodepointHMetrics(&font_->info, static_cast<int>(letter), &advance, &bearing);
  glyph.advance = static_cast<float>(advance) * font_->scale / kEm;
  int width = 0, height = 0, left = 0, top = 0;
  unsigned char* distances =
      stbtt_GetCodepointSDF(&font_->info, font_->scale, static_cast<int>(letter), kPadding, kOnEdge,
                            kDistanceScale, &width, &height, &left, &top);
  if (!distances) return;  // a space
  if (penX_ + width > kTextureSize) {
    penX_ = 0;
    penY_ += rowHeight_ + 1;
    rowHeight_ = 0;
  }
  CF_CHECK(penY_ + height <= kTextureSize);  // the program's own texts fit many times over
  for (int y = 0; y < height; ++y) {
    std::copy_n(distances + y * width, width, pixels_.begin() + (penY_ + y) * kTextureSize + penX_);
  }
  stbtt_FreeSDF(distances, nullptr);
  glyph.left = static_cast<float>(left) / kEm;
  glyph.top = static_cast<float>(top) / kEm;
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
