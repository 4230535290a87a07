#include "app/gui/widgets/frame_damage.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <utility>

namespace chartflood {

namespace {

constexpr int kTile = 32;              // pixels
constexpr std::size_t kMostParts = 8;  // each costs a look at every triangle

/// Frames differ by accident, not by malice: a multiplication spreads well enough.
std::uint64_t mixed(std::uint64_t digest, std::uint64_t value) {
  digest = (digest ^ value) * 0x9E3779B97F4A7C15U;
  return digest ^ digest >> 29;
}

std::uint64_t digestOf(const ImDrawVert& vertex) {
  std::uint64_t words[3] = {};
  static_assert(sizeof vertex <= sizeof words);
  std::memcpy(words, &vertex, sizeof vertex);
  return mixed(mixed(mixed(0, words[0]), words[1]), words[2]);
}

/// Of what the triangles of a command have in common.
std::uint64_t digestOf(const ImDrawCmd& command) {
  std::uint64_t words[2];
  static_assert(sizeof command.ClipRect == sizeof words);
  std::memcpy(words, &command.ClipRect, sizeof words);
  const auto texture = reinterpret_cast<std::uintptr_t>(command.GetTexID());
  return mixed(mixed(mixed(1, texture), words[0]), words[1]);
}

int tilesIn(int pixels) { return (pixels + kTile - 1) / kTile; }

}  // namespace

std::vector<PixelRectangle> FrameDamage::changed(const ImDrawData& data) {
  const int width = static_cast<int>(data.DisplaySize.x * data.FramebufferScale.x);
  const int height = static_cast<int>(data.DisplaySize.y * data.FramebufferScale.y);
  if (width <= 0 || height <= 0) return {};
  const bool sameSize = width == width_ && height == height_;
  width_ = width;
  height_ = height;
  columns_ = tilesIn(width);
  rows_ = tilesIn(height);
  digests_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0);
  for (int i = 0; i < data.CmdListsCount; ++i) add(*data.CmdLists[i], data);
  std::vector<PixelRectangle> parts{{0, 0, width, height}};
  if (sameSize && before_.size() == digests_.size()) {
    parts = rectangles(1);
    for (int coarser = 2; parts.size() > kMostParts; coarser *= 2) parts = rectangles(coarser);
  }
  std::swap(digests_, before_);
  return parts;
}

void FrameDamage::add(const ImDrawList& list, const ImDrawData& data) {
  vertices_.clear();
  for (const ImDrawVert& vertex : list.VtxBuffer) vertices_.push_back(digestOf(vertex));
  for (const ImDrawCmd& command : list.CmdBuffer) {
    const std::uint64_t common = digestOf(command);
    const ImDrawIdx* index = list.IdxBuffer.Data + command.IdxOffset;
    for (const ImDrawIdx* end = index + command.ElemCount; index < end; index += 3) {
      std::uint64_t digest = common;
      const ImDrawVert* corners[3];
      for (int i = 0; i < 3; ++i) {
        const std::size_t vertex = std::size_t{command.VtxOffset} + index[i];
        digest = mixed(digest, vertices_[vertex]);
        corners[i] = &list.VtxBuffer.Data[vertex];
      }
      addTriangle(corners, digest, command, data);
    }
  }
}

void FrameDamage::addTriangle(const ImDrawVert* const (&corners)[3], std::uint64_t digest,
                              const ImDrawCmd& command, const ImDrawData& data) {
  const auto [left, right] = std::minmax({corners[0]->pos.x, corners[1]->pos.x, corners[2]->pos.x});
  const auto [top, bottom] = std::minmax({corners[0]->pos.y, corners[1]->pos.y, corners[2]->pos.y});
  const ImVec2 origin = data.DisplayPos, scale = data.FramebufferScale;
  const auto tile = [](float place, float from, float pixels, int last) {
    const float at = std::floor((place - from) * pixels / kTile);
    return static_cast<int>(std::clamp(at, -1.0f, static_cast<float>(last)));
  };
  const int firstColumn =
      std::max(0, tile(std::max(left, command.ClipRect.x), origin.x, scale.x, columns_));
  const int lastColumn = tile(std::min(right, command.ClipRect.z), origin.x, scale.x, columns_ - 1);
  const int firstRow =
      std::max(0, tile(std::max(top, command.ClipRect.y), origin.y, scale.y, rows_));
  const int lastRow = tile(std::min(bottom, command.ClipRect.w), origin.y, scale.y, rows_ - 1);
  for (int row = firstRow; row <= lastRow; ++row) {
    std::uint64_t* tiles = digests_.data() + static_cast<std::ptrdiff_t>(row) * columns_;
    for (int column = firstColumn; column <= lastColumn; ++column) {
      tiles[column] = mixed(tiles[column], digest);
    }
  }
}

/// The changed tiles, `coarseness` of them at a time in each direction, as rectangles: runs along
/// the rows, joined with the same run in the row before.
std::vector<PixelRectangle> FrameDamage::rectangles(int coarseness) const {
  const int size = kTile * coarseness;
  const auto differs = [&](int left, int top) {
    const int right = std::min(left + coarseness, columns_);
    const int bottom = std::min(top + coarseness, rows_);
    for (int row = top; row < bottom; ++row) {
      for (int column = left; column < right; ++column) {
        const auto tile = static_cast<std::size_t>(row * columns_ + column);
        if (digests_[tile] != before_[tile]) return true;
      }
    }
    return false;
  };
  std::vector<PixelRectangle> parts;
  for (int row = 0; row < rows_; row += coarseness) {
    const int top = row * kTile, bottom = std::min(top + size, height_);
    for (int column = 0; column < columns_; column += coarseness) {
      if (!differs(column, row)) continue;
      const int left = column * kTile;
      while (column < columns_ && differs(column, row)) column += coarseness;
      const int right = std::min(column * kTile, width_);
      const auto above = std::find_if(parts.begin(), parts.end(), [&](const PixelRectangle& part) {
        return part.left == left && part.right == right && part.bottom == top;
      });
      if (above != parts.end()) {
        above->bottom = bottom;
      } else {
        parts.push_back({left, top, right, bottom});
      }
    }
  }
  return parts;
}

}  // namespace chartflood
