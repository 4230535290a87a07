#pragma once
/// Which parts of the window a frame of the interface changes, so that only they are drawn.

#include <cstdint>
#include <vector>

#include <imgui.h>

namespace chartflood {

/// Pixels [left, right) x [top, bottom), from the top left.
struct PixelRectangle {
  int left = 0, top = 0, right = 0, bottom = 0;

  bool operator==(const PixelRectangle&) const = default;
};

/// Compares each frame with the one before, tile by tile. Textures are taken to be the same while
/// their identities are: these change with what a texture shows (textureId()).
class FrameDamage {
 public:
  /// Parts that do not overlap and hold every pixel that may differ from the last frame: none where
  /// it is drawn alike, the whole at first and at another size. \pre Dear ImGui has rendered
  std::vector<PixelRectangle> changed(const ImDrawData& data);
  /// The next frame is as the first one: what is shown may be lost.
  void forget() { before_.clear(); }

 private:
  void add(const ImDrawList& list, const ImDrawData& data);
  void addTriangle(const ImDrawVert* const (&corners)[3], std::uint64_t digest,
                   const ImDrawCmd& command, const ImDrawData& data);
  std::vector<PixelRectangle> rectangles(int coarseness) const;

  int width_ = 0, height_ = 0;  ///< pixels
  int columns_ = 0, rows_ = 0;  ///< tiles
  /// Of all that is drawn on each tile, in order.
  std::vector<std::uint64_t> digests_, before_;
  std::vector<std::uint64_t> vertices_;  ///< of the list that is being added
};

}  // namespace chartflood
