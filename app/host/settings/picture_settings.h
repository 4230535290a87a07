#pragma once
/// What pictures of the window are like: view, size, ground and what is kept of the helpers. Every
/// setting has a key and a text, which actions set and preferences hold.

#include <span>
#include <string>
#include <string_view>

#include "app/host/settings/setting.h"
#include "render/scene/render_settings.h"

namespace chartflood {

struct PictureSettings {
  std::string view = "3d";          ///< 3d, uv, both, ab, window
  std::string size = "window";      ///< an id of pictureSizes()
  int width = 1920, height = 1080;  ///< of the size "own", pixels
  bool lockRatio = true;            ///< a change of one side of "own" takes the other along
  int smooth = 2;                   ///< samples a pixel in each direction: 1, 2 or 4
  std::string ground = "theme";     ///< theme, white, black, transparent
  bool legend = true, seeds = true, seams = true, numbers = true;  ///< kept where they are shown
  int frames = 72;                                                 ///< of a turntable or a film
  std::string name = "{model}_{mode}_{n:3}.png";                   ///< "": this one
  std::string folder;  ///< "": the user's folder of pictures

  static constexpr int kLargestSide = 16384;
  static constexpr int kFewestFrames = 2, kMostFrames = 10'000;

  bool operator==(const PictureSettings&) const = default;
};

/// A choice of size: "window-2", "Window x 2".
struct PictureSizeChoice {
  const char* id;
  const char* label;
};
std::span<const PictureSizeChoice> pictureSizes();

/// Width and height in pixels, and how much larger than in the view lines and letters are.
struct PictureExtent {
  int width = 1, height = 1;
  float scale = 1;
};
/// For a view of so many pixels. Sides beyond kLargestSide are shortened, the ratio kept.
PictureExtent pictureExtent(const PictureSettings& settings, int viewWidth, int viewHeight);

const SettingTable<PictureSettings>& pictureSettingTable();
/// \throws UsageError for an unknown key, here and below
std::string pictureValue(const PictureSettings& settings, std::string_view key);
/// \throws UsageError that says what is allowed
void setPictureValue(PictureSettings& settings, std::string_view key, std::string_view text);

/// Ground and helpers as the settings ask.
void applyPicture(const PictureSettings& settings, RenderSettings& render);

}  // namespace chartflood
