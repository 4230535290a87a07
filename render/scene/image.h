#pragma once
/// Pictures in memory and as PNG files.

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/base/file_bytes.h"

namespace chartflood {

/// Red, green, blue, alpha of 8 bits each; sRGB, straight alpha.
using Rgba8 = std::array<std::uint8_t, 4>;

/// Rows from top to bottom, without gaps.
class Image {
 public:
  Image() = default;
  Image(int width, int height, Rgba8 fill = {0, 0, 0, 0})
      : width_(width), height_(height),
        pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), fill) {}

  int width() const { return width_; }
  int height() const { return height_; }
  /// Pixel in column x from the left and row y from the top.
  Rgba8& at(int x, int y) { return pixels_[index(x, y)]; }
  const Rgba8& at(int x, int y) const { return pixels_[index(x, y)]; }
  std::span<Rgba8> pixels() { return pixels_; }
  std::span<const Rgba8> pixels() const { return pixels_; }
  bool operator==(const Image&) const = default;

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(x);
  }
  int width_ = 0, height_ = 0;
  std::vector<Rgba8> pixels_;
};

/// Key and value that a PNG file carries beside the pixels (Latin-1 keys, UTF-8 values).
using ImageTexts = std::vector<std::pair<std::string, std::string>>;

/// The bytes of a PNG file; equal pictures and texts give equal bytes. \throws Interrupted
std::vector<std::uint8_t> encodePng(const Image& image, const ImageTexts& texts = {});
/// Pictures with more pixels are not read: as many as the largest that the program writes.
inline constexpr std::size_t kMostPixels = std::size_t{16384} * 16384;
/// The largest file that is opened as a picture.
inline constexpr FileLimit kPictureFile{std::size_t{256'000'000}, "a picture"};
/// Holds the size that a picture claims against kMostPixels and against what its bytes can hold.
/// \throws ReadError naming `file`.
void requireSanePicture(std::size_t width, std::size_t height, std::size_t mostPixelsOfBytes,
                        const std::string& file);

/// Reads what encodePng (or any other program) wrote; texts go to `texts` when given.
/// \throws ReadError naming `file`.
Image decodePng(std::span<const std::uint8_t> bytes, const std::string& file,
                ImageTexts* texts = nullptr);

/// Writes the picture beside its target and renames it, so that a failure leaves the old file.
/// \throws WriteError
void writePng(const Image& image, const std::filesystem::path& file, const ImageTexts& texts = {});
/// \throws ReadError
Image readPng(const std::filesystem::path& file, ImageTexts* texts = nullptr);
/// The texts that stand before the pixels, which are not looked at. \throws ReadError
ImageTexts readPngTexts(const std::filesystem::path& file);

/// How much two pictures of one size differ.
struct ImageDifference {
  std::size_t differentPixels = 0;  ///< more than `tolerance` apart in any channel
  int largest = 0;                  ///< largest difference of a channel, 0-255
  double mean = 0;                  ///< mean difference over all channels, 0-255
};
/// \throws Error when the sizes differ.
ImageDifference compareImages(const Image& a, const Image& b, int tolerance = 0);

/// Mean of each `factor` x `factor` block, alpha-weighted. Both sizes must be multiples of it.
Image shrinkImage(const Image& image, int factor);

}  // namespace chartflood
