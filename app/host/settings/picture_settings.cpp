#include "app/host/settings/picture_settings.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/error.h"

namespace chartflood {

namespace {

constexpr std::array<PictureSizeChoice, 7> kSizes = {{{"window", "As in the window"},
                                                      {"window-2", "Window, twice"},
                                                      {"window-4", "Window, four times"},
                                                      {"1080p", "1920 x 1080"},
                                                      {"4k", "3840 x 2160"},
                                                      {"square", "2048 x 2048"},
                                                      {"own", "Own"}}};

/// One side of the own size; the other follows where the ratio is locked.
SettingSource<PictureSettings> side(int PictureSettings::*member, int PictureSettings::*other) {
  SettingSource<PictureSettings> source = numberFrom(member, 1, PictureSettings::kLargestSide);
  source.set = [=, plain = source.set](PictureSettings& s, const SettingValue& value) {
    const double ratio = static_cast<double>(s.*other) / (s.*member);
    std::string reason = plain(s, value);
    if (reason.empty() && s.lockRatio) {
      s.*other = static_cast<int>(
          std::clamp(std::round((s.*member) * ratio), 1.0, 1.0 * PictureSettings::kLargestSide));
    }
    return reason;
  };
  return source;
}

/// Samples a pixel in each direction.
SettingSource<PictureSettings> samples() {
  return checkedSource<PictureSettings, std::string>(
      {.type = SettingType::Choice, .choices = {{"1", "1x"}, {"2", "2x"}, {"4", "4x"}}},
      [](const PictureSettings& s) { return std::to_string(s.smooth); },
      [](PictureSettings& s, const std::string& text) { s.smooth = text[0] - '0'; });
}

SettingTable<PictureSettings> makePictureRows() {
  using S = PictureSettings;
  std::vector<SettingChoice> sizes;
  for (const PictureSizeChoice& each : kSizes) sizes.push_back({each.id, each.label});
  return {{"view", "View", "What a picture shows.",
           oneOf(&S::view, {{"3d", "Model"},
                            {"uv", "Texture"},
                            {"both", "Both"},
                            {"ab", "A | B"},
                            {"window", "Window"}})},
          {"size", "Size", "How large a picture is.", oneOf(&S::size, sizes)},
          {"lock-ratio", "Lock ratio", "A change of one side takes the other along.",
           onOff(&S::lockRatio)},
          {"width", "Width", "Pixels of the own size.", side(&S::width, &S::height)},
          {"height", "Height", "Pixels of the own size.", side(&S::height, &S::width)},
          {.id = "supersampling",
           .title = "Smoothing",
           .help = "Samples a pixel in each direction, for smooth lines.",
           .value = samples(),
           .former = "smooth"},
          {.id = "background",
           .title = "Ground",
           .help = "What stands behind the model.",
           .value = oneOf(&S::ground, {{"theme", "As shown"},
                                       {"white", "White"},
                                       {"black", "Black"},
                                       {"transparent", "Transparent"}}),
           .former = "ground"},
          {.id = "scalar-bar",
           .title = "Colour bar",
           .help = "Kept where it is shown.",
           .value = onOff(&S::legend),
           .former = "legend"},
          {.id = "seed-marks",
           .title = "Seeds",
           .help = "Kept where they are shown.",
           .value = onOff(&S::seeds),
           .former = "seeds"},
          {"seams", "Seams", "Kept where they are shown.", onOff(&S::seams)},
          {"numbers", "Numbers", "Kept where they are shown.", onOff(&S::numbers)},
          {"frames", "Pictures", "Of a turntable or a film.",
           numberFrom(&S::frames, S::kFewestFrames, S::kMostFrames)},
          {"name", "Name", "Of new pictures.", freeText(&S::name)},
          {"folder", "Folder", "Of new pictures.", freeText(&S::folder)}};
}

const Setting<PictureSettings>& rowOf(std::string_view key) {
  if (const auto* row = findSetting(pictureSettingTable(), key)) return *row;
  throw UsageError("A picture has no setting '" + std::string(key) + "'.");
}

}  // namespace

std::span<const PictureSizeChoice> pictureSizes() { return kSizes; }

PictureExtent pictureExtent(const PictureSettings& settings, int viewWidth, int viewHeight) {
  const int width = std::max(1, viewWidth), height = std::max(1, viewHeight);
  PictureExtent extent{width, height, 1};
  if (settings.size == "1080p") {
    extent = {1920, 1080};
  } else if (settings.size == "4k") {
    extent = {3840, 2160};
  } else if (settings.size == "square") {
    extent = {2048, 2048};
  } else if (settings.size == "own") {
    extent = {settings.width, settings.height};
  } else {
    const int times = settings.size == "window-4" ? 4 : settings.size == "window-2" ? 2 : 1;
    extent = {width * times, height * times};
  }
  const int longest = std::max(extent.width, extent.height);
  if (longest > PictureSettings::kLargestSide) {
    const double shrink = static_cast<double>(PictureSettings::kLargestSide) / longest;
    extent.width = std::max(1, static_cast<int>(extent.width * shrink));
    extent.height = std::max(1, static_cast<int>(extent.height * shrink));
  }
  extent.scale = static_cast<float>(std::min(static_cast<double>(extent.width) / width,
                                             static_cast<double>(extent.height) / height));
  return extent;
}

const SettingTable<PictureSettings>& pictureSettingTable() {
  static const SettingTable<PictureSettings> rows = makePictureRows();
  return rows;
}

std::string pictureValue(const PictureSettings& settings, std::string_view key) {
  return rowOf(key).text(settings);
}

void setPictureValue(PictureSettings& settings, std::string_view key, std::string_view text) {
  const Setting<PictureSettings>& row = rowOf(key);
  const std::string reason = row.setText(settings, text);
  if (reason.empty()) return;
  throw UsageError("The picture's " + refusalText(row.id, text, reason, row.value.domain));
}

void applyPicture(const PictureSettings& settings, RenderSettings& render) {
  if (settings.ground == "transparent") {
    render.background.transparent = true;
  } else if (settings.ground != "theme") {
    render.background = backgroundFromText(settings.ground);
  }
  render.scalarBar = render.scalarBar && settings.legend;
  render.seedMarks = render.seedMarks && settings.seeds;
  render.seams = render.seams && settings.seams;
  render.numbers = render.numbers && settings.numbers;
}

}  // namespace chartflood
