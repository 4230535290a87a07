#include "render/scene/read_picture.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>

#include <stb/stb_image.h>

#include "core/base/error.h"

namespace chartflood {

namespace {

Image decodeJpeg(std::span<const std::uint8_t> bytes, const std::string& file) {
  const int size = static_cast<int>(bytes.size());
  int width = 0, height = 0, channels = 0;
  if (stbi_info_from_memory(bytes.data(), size, &width, &height, &channels) == 0 || width < 1 ||
      height < 1) {
    throw ReadError(file, "it is no JPEG picture that can be read");
  }
  // A block of 8 x 8 pixels takes a bit at least.
  constexpr std::size_t kPixelsOfByte = 8 * 64;
  requireSanePicture(static_cast<std::size_t>(width), static_cast<std::size_t>(height),
                     kPixelsOfByte * bytes.size(), file);
  const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
      stbi_load_from_memory(bytes.data(), size, &width, &height, &channels, 4), stbi_image_free);
  if (!pixels) throw ReadError(file, "it is no whole JPEG picture");
  Image image(width, height);
  for (std::size_t i = 0; i < image.pixels().size(); ++i) {
    std::copy_n(pixels.get() + 4 * i, 4, image.pixels()[i].begin());
  }
  return image;
}

/// Half as large; a last odd row or column is left out.
Image halved(const Image& image) {
  const int width = std::max(1, image.width() / 2), height = std::max(1, image.height() / 2);
  Image even(2 * width, 2 * height);
  for (int y = 0; y < even.height(); ++y) {
    for (int x = 0; x < even.width(); ++x) {
      even.at(x, y) = image.at(std::min(x, image.width() - 1), std::min(y, image.height() - 1));
    }
  }
  return shrinkImage(even, 2);
}

}  // namespace

Image readPicture(const std::filesystem::path& file) {
  const FileBytes content(file, kPictureFile);
  const std::span<const std::uint8_t> bytes = content.bytes();
  const bool jpeg = bytes.size() > 2 && bytes[0] == 0xFF && bytes[1] == 0xD8;
  Image image = jpeg ? decodeJpeg(bytes, file.string()) : decodePng(bytes, file.string());
  while (std::max(image.width(), image.height()) > kLargestPicture) image = halved(image);
  return image;
}

}  // namespace chartflood
