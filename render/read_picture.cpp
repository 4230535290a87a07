#include "render/read_picture.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <memory>
#include <vector>

#include <stb/stb_image.h>

#include "core/base/error.h"

namespace chartflood {

namespace {

constexpr int kLargestRead = 1 << 15;           // a side, before halving
constexpr std::uintmax_t kMostBytes = 1 << 28;  // of the file

std::vector<std::uint8_t> bytesOf(const std::filesystem::path& file) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  if (!error && size > kMostBytes) {
    throw ReadError(file.string(), "it is too large for a picture; 256 MB is the most");
  }
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw ReadError(file.string(), "the file cannot be opened");
  std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(stream), {}};
  if (stream.bad()) throw ReadError(file.string(), "the file cannot be read");
  return bytes;
}

Image decodeJpeg(const std::vector<std::uint8_t>& bytes, const std::string& file) {
  const int size = static_cast<int>(bytes.size());
  int width = 0, height = 0, channels = 0;
  if (stbi_info_from_memory(bytes.data(), size, &width, &height, &channels) == 0 || width < 1 ||
      height < 1 || width > kLargestRead || height > kLargestRead) {
    throw ReadError(file, "it is no JPEG picture that can be read");
  }
  const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
      stbi_load_from_memory(bytes.data(), size, &width, &height, &channels, 4), stbi_image_free);
  if (!pixels) throw ReadError(file, "it is no whole JPEG picture");
  Image image(width, height);
  for (std::size_t i = 0; i < image.pixels().size(); ++i) {
    std::copy_n(pixels.get() + 4 * i, 4, image.pixels()[i].begin());
  }
  return image;
}

/// A file of a few bytes may claim any size: it is refused before there is room for it.
void requireSanePng(const std::vector<std::uint8_t>& bytes, const std::string& file) {
  if (bytes.size() < 24) throw ReadError(file, "it is no PNG or JPEG picture");
  const auto number = [&](std::size_t at) {
    return (std::uint32_t{bytes[at]} << 24) | (std::uint32_t{bytes[at + 1]} << 16) |
           (std::uint32_t{bytes[at + 2]} << 8) | bytes[at + 3];
  };
  constexpr auto kMost = static_cast<std::uint32_t>(kLargestRead);
  if (number(16) > kMost || number(20) > kMost) {
    throw ReadError(file, "it is larger than 32768 pixels a side");
  }
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
  const std::vector<std::uint8_t> bytes = bytesOf(file);
  const bool jpeg = bytes.size() > 2 && bytes[0] == 0xFF && bytes[1] == 0xD8;
  if (!jpeg) requireSanePng(bytes, file.string());
  Image image = jpeg ? decodeJpeg(bytes, file.string()) : decodePng(bytes, file.string());
  while (std::max(image.width(), image.height()) > kLargestPicture) image = halved(image);
  return image;
}

}  // namespace chartflood
