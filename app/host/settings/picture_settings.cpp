#include "app/host/settings/picture_settings.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <functional>

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/io/text/parse_number.h"

namespace chartflood {

namespace {

constexpr std::array<PictureSizeChoice, 7> kSizes = {{{"window", "As in the window"},
                                                      {"window-2", "Window, twice"},
                                                      {"window-4", "Window, four times"},
                                                      {"1080p", "1920 x 1080"},
                                                      {"4k", "3840 x 2160"},
                                                      {"square", "2048 x 2048"},
                                                      {"own", "Own"}}};

[[noreturn]] void refuse(std::string_view key, std::string_view text, const std::string& allowed) {
  throw UsageError("The picture's " + std::string(key) + " cannot be '" + std::string(text) +
                   "': " + allowed + ".");
}

struct Row {
  const char* key;
  std::function<std::string(const PictureSettings&)> get;
  std::function<void(PictureSettings&, std::string_view)> set;
};

Row switchRow(const char* key, bool PictureSettings::*member) {
  return {key, [=](const PictureSettings& s) { return std::string(switchWord(s.*member)); },
          [=](PictureSettings& s, std::string_view text) {
            const std::optional<bool> on = switchValue(text);
            if (!on) refuse(key, text, "give on or off");
            s.*member = *on;
          }};
}

Row choiceRow(const char* key, std::string PictureSettings::*member,
              const std::vector<std::string>& choices) {
  return {key, [=](const PictureSettings& s) { return s.*member; },
          [=](PictureSettings& s, std::string_view text) {
            if (std::find(choices.begin(), choices.end(), text) == choices.end()) {
              std::string all;
              for (const std::string& each : choices) all += (all.empty() ? "" : ", ") + each;
              refuse(key, text, "choose of " + all);
            }
            s.*member = text;
          }};
}

int readInteger(std::string_view key, std::string_view text, int least, int most) {
  int value = 0;
  const std::string_view digits = withoutPlus(text);
  const char* const last = digits.data() + digits.size();
  const auto [end, error] = std::from_chars(digits.data(), last, value);
  if (error != std::errc() || end != last || value < least || value > most) {
    refuse(key, text,
           "give a whole number from " + std::to_string(least) + " to " + std::to_string(most));
  }
  return value;
}

/// One side of the own size; the other follows where the ratio is locked.
Row sideRow(const char* key, int PictureSettings::*member, int PictureSettings::*other) {
  return {key, [=](const PictureSettings& s) { return std::to_string(s.*member); },
          [=](PictureSettings& s, std::string_view text) {
            const int value = readInteger(key, text, 1, PictureSettings::kLargestSide);
            if (s.lockRatio) {
              const double ratio = static_cast<double>(s.*other) / (s.*member);
              s.*other = static_cast<int>(
                  std::clamp(std::round(value * ratio), 1.0, 1.0 * PictureSettings::kLargestSide));
            }
            s.*member = value;
          }};
}

Row textRow(const char* key, std::string PictureSettings::*member) {
  return {key, [=](const PictureSettings& s) { return s.*member; },
          [=](PictureSettings& s, std::string_view text) { s.*member = text; }};
}

std::vector<Row> makeRows() {
  std::vector<std::string> sizes;
  sizes.reserve(std::size(kSizes));
  for (const PictureSizeChoice& each : kSizes) sizes.push_back(each.id);
  using S = PictureSettings;
  return {choiceRow("view", &S::view, {"3d", "uv", "both", "ab", "window"}),
          choiceRow("size", &S::size, sizes),
          switchRow("lock-ratio", &S::lockRatio),
          sideRow("width", &S::width, &S::height),
          sideRow("height", &S::height, &S::width),
          {"smooth", [](const S& s) { return std::to_string(s.smooth); },
           [](S& s, std::string_view text) {
             if (text != "1" && text != "2" && text != "4")
               refuse("smooth", text, "give 1, 2 or 4");
             s.smooth = text[0] - '0';
           }},
          choiceRow("ground", &S::ground, {"theme", "white", "black", "transparent"}),
          switchRow("legend", &S::legend),
          switchRow("seeds", &S::seeds),
          switchRow("seams", &S::seams),
          switchRow("numbers", &S::numbers),
          {"frames", [](const S& s) { return std::to_string(s.frames); },
           [](S& s, std::string_view text) {
             s.frames = readInteger("frames", text, S::kFewestFrames, S::kMostFrames);
           }},
          textRow("name", &S::name),
          textRow("folder", &S::folder)};
}

const std::vector<Row>& rows() {
  static const std::vector<Row> all = makeRows();
  return all;
}

const Row& rowOf(std::string_view key) {
  for (const Row& row : rows()) {
    if (key == row.key) return row;
  }
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

std::vector<std::string> pictureKeys() {
  std::vector<std::string> keys;
  for (const Row& row : rows()) keys.emplace_back(row.key);
  return keys;
}

std::string pictureValue(const PictureSettings& settings, std::string_view key) {
  return rowOf(key).get(settings);
}

void setPictureValue(PictureSettings& settings, std::string_view key, std::string_view text) {
  rowOf(key).set(settings, text);
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
