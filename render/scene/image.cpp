#include "render/scene/image.h"

#include <algorithm>
#include <csetjmp>
#include <cstdlib>
#include <cstring>
#include <fstream>

#include <png.h>
#include <unistd.h>

#include "core/base/error.h"
#include "core/base/interruption.h"
#include "core/base/parallel.h"

namespace chartflood {

namespace {

struct PngFailure {
  std::string message;
};

// libpng's own error handling is longjmp; exceptions pass through its C frames safely because
// Debian builds it with unwind tables.
[[noreturn]] void throwFailure(png_structp, png_const_charp message) { throw PngFailure{message}; }
void ignoreWarning(png_structp, png_const_charp) {}

void appendBytes(png_structp png, png_bytep data, png_size_t length) {
  auto& bytes = *static_cast<std::vector<std::uint8_t>*>(png_get_io_ptr(png));
  bytes.insert(bytes.end(), data, data + length);
}
void flushNothing(png_structp) {}

struct ByteReader {
  std::span<const std::uint8_t> rest;
};
void takeBytes(png_structp png, png_bytep data, png_size_t length) {
  auto& reader = *static_cast<ByteReader*>(png_get_io_ptr(png));
  if (reader.rest.size() < length) throw PngFailure{"the file ends too early"};
  std::memcpy(data, reader.rest.data(), length);
  reader.rest = reader.rest.subspan(length);
}

struct Writer {
  png_structp png =
      png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, throwFailure, ignoreWarning);
  png_infop info = png_create_info_struct(png);
  ~Writer() { png_destroy_write_struct(&png, &info); }
};
struct Reader {
  png_structp png =
      png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, throwFailure, ignoreWarning);
  png_infop info = png_create_info_struct(png);
  ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
};

/// Texts that go into Latin-1 chunks must be plain ASCII; others become UTF-8 chunks.
bool isAscii(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [](unsigned char c) { return c < 0x80; });
}

void setTexts(Writer& writer, const ImageTexts& texts) {
  std::vector<png_text> chunks;
  for (const auto& [key, value] : texts) {
    png_text chunk{};
    chunk.compression = isAscii(value) ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
    chunk.key = const_cast<char*>(key.c_str());
    chunk.text = const_cast<char*>(value.c_str());
    chunk.text_length = isAscii(value) ? value.size() : 0;
    chunk.itxt_length = isAscii(value) ? 0 : value.size();
    chunk.lang = const_cast<char*>("");
    chunk.lang_key = const_cast<char*>("");
    chunks.push_back(chunk);
  }
  if (!chunks.empty()) {
    png_set_text(writer.png, writer.info, chunks.data(), static_cast<int>(chunks.size()));
  }
}

bool isOpaque(const Image& image) {
  return std::all_of(image.pixels().begin(), image.pixels().end(),
                     [](const Rgba8& p) { return p[3] == 255; });
}

void takeTexts(Reader& reader, ImageTexts& texts) {
  png_textp chunks = nullptr;
  int count = 0;
  png_get_text(reader.png, reader.info, &chunks, &count);
  for (int i = 0; i < count; ++i) texts.emplace_back(chunks[i].key, chunks[i].text);
}

/// Reads as far as the pixels, and refuses more of them than can be.
void beginReading(Reader& reader, ByteReader& source, const std::string& file) {
  const std::size_t size = source.rest.size();
  if (size < 8 || png_sig_cmp(source.rest.data(), 0, 8) != 0) {
    throw PngFailure{"it is no PNG picture"};
  }
  png_set_read_fn(reader.png, &source, takeBytes);
  // Its own limits have words of their own.
  png_set_user_limits(reader.png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
  png_read_info(reader.png, reader.info);
  // Deflate makes 1032 bytes of one at the most.
  constexpr std::size_t kBitsOfByte = 8 * 1040;
  const auto bits = std::size_t{png_get_channels(reader.png, reader.info)} *
                    png_get_bit_depth(reader.png, reader.info);
  requireSanePicture(png_get_image_width(reader.png, reader.info),
                     png_get_image_height(reader.png, reader.info),
                     size * kBitsOfByte / std::max<std::size_t>(bits, 1), file);
}

}  // namespace

void requireSanePicture(std::size_t width, std::size_t height, std::size_t mostPixelsOfBytes,
                        const std::string& file) {
  const std::string claim =
      "it says that it has " + std::to_string(width) + " x " + std::to_string(height) + " pixels";
  const auto isAbove = [&](std::size_t most) { return width != 0 && height > most / width; };
  if (isAbove(kMostPixels)) {
    throw ReadError(file, claim + ", and 16384 x 16384 are the most; save it smaller");
  }
  if (isAbove(mostPixelsOfBytes)) {
    throw ReadError(file, claim + ", more than so short a file can hold; save it anew");
  }
}

std::vector<std::uint8_t> encodePng(const Image& image, const ImageTexts& texts) {
  std::vector<std::uint8_t> bytes;
  try {
    Writer writer;
    const bool opaque = isOpaque(image);
    png_set_write_fn(writer.png, &bytes, appendBytes, flushNothing);
    png_set_IHDR(writer.png, writer.info, static_cast<png_uint_32>(image.width()),
                 static_cast<png_uint_32>(image.height()), 8,
                 opaque ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGBA, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB(writer.png, writer.info, PNG_sRGB_INTENT_PERCEPTUAL);
    // Trying all filters takes longer and saves nothing on pictures of models.
    png_set_filter(writer.png, 0, PNG_FILTER_PAETH);
    setTexts(writer, texts);
    png_write_info(writer.png, writer.info);
    if (opaque) png_set_filler(writer.png, 0, PNG_FILLER_AFTER);
    for (int y = 0; y < image.height(); ++y) {
      throwIfInterrupted();
      png_write_row(writer.png, image.at(0, y).data());
    }
    png_write_end(writer.png, writer.info);
  } catch (const PngFailure& failure) {
    throw Error("The picture could not be encoded as PNG: " + failure.message + ".");
  }
  return bytes;
}

Image decodePng(std::span<const std::uint8_t> bytes, const std::string& file, ImageTexts* texts) {
  ByteReader source{bytes};
  try {
    Reader reader;
    beginReading(reader, source, file);
    png_set_expand(reader.png);
    png_set_strip_16(reader.png);
    png_set_gray_to_rgb(reader.png);
    png_set_add_alpha(reader.png, 255, PNG_FILLER_AFTER);
    const int passes = png_set_interlace_handling(reader.png);
    Image image(static_cast<int>(png_get_image_width(reader.png, reader.info)),
                static_cast<int>(png_get_image_height(reader.png, reader.info)));
    for (int pass = 0; pass < passes; ++pass) {
      for (int y = 0; y < image.height(); ++y) {
        png_read_row(reader.png, image.at(0, y).data(), nullptr);
      }
    }
    png_read_end(reader.png, reader.info);
    if (texts != nullptr) takeTexts(reader, *texts);
    return image;
  } catch (const PngFailure& failure) {
    throw ReadError(file, failure.message);
  }
}

void writePng(const Image& image, const std::filesystem::path& file, const ImageTexts& texts) {
  const std::vector<std::uint8_t> bytes = encodePng(image, texts);
  std::filesystem::path beside = file;
  beside += ".part" + std::to_string(getpid());
  std::error_code ignored;
  {
    std::ofstream out(beside, std::ios::binary);
    out.write(reinterpret_cast<const char*>(bytes.data()),
              static_cast<std::streamsize>(bytes.size()));
    out.close();
    if (!out) {
      std::filesystem::remove(beside, ignored);
      throw WriteError(file.string(), "the folder does not take it; choose another one");
    }
  }
  std::error_code failed;
  std::filesystem::rename(beside, file, failed);
  if (!failed) return;
  std::filesystem::remove(beside, ignored);
  throw WriteError(file.string(), failed.message());
}

Image readPng(const std::filesystem::path& file, ImageTexts* texts) {
  return decodePng(FileBytes(file, kPictureFile).bytes(), file.string(), texts);
}

ImageTexts readPngTexts(const std::filesystem::path& file) {
  const FileBytes content(file, kPictureFile);
  ByteReader source{content.bytes()};
  try {
    Reader reader;
    beginReading(reader, source, file.string());
    ImageTexts texts;
    takeTexts(reader, texts);
    return texts;
  } catch (const PngFailure& failure) {
    throw ReadError(file.string(), failure.message);
  }
}

ImageDifference compareImages(const Image& a, const Image& b, int tolerance) {
  if (a.width() != b.width() || a.height() != b.height()) {
    throw Error("Two pictures of different size cannot be compared.");
  }
  ImageDifference difference;
  double sum = 0;
  for (std::size_t i = 0; i < a.pixels().size(); ++i) {
    int pixel = 0;
    for (std::size_t c = 0; c < 4; ++c) {
      const int d = std::abs(int{a.pixels()[i][c]} - int{b.pixels()[i][c]});
      pixel = std::max(pixel, d);
      sum += d;
    }
    difference.largest = std::max(difference.largest, pixel);
    if (pixel > tolerance) ++difference.differentPixels;
  }
  if (!a.pixels().empty()) difference.mean = sum / (4.0 * static_cast<double>(a.pixels().size()));
  return difference;
}

namespace {

/// Mean colour of a block, each pixel weighted by its alpha.
Rgba8 blockMean(const Image& image, int left, int top, int factor) {
  std::uint32_t sum[3] = {0, 0, 0}, alpha = 0;
  for (int y = top; y < top + factor; ++y) {
    for (int x = left; x < left + factor; ++x) {
      const Rgba8& p = image.at(x, y);
      for (std::size_t c = 0; c < 3; ++c) sum[c] += std::uint32_t{p[c]} * p[3];
      alpha += p[3];
    }
  }
  if (alpha == 0) return {0, 0, 0, 0};
  Rgba8 mean{};
  for (std::size_t c = 0; c < 3; ++c) {
    mean[c] = static_cast<std::uint8_t>((sum[c] + alpha / 2) / alpha);
  }
  const auto count = static_cast<std::uint32_t>(factor * factor);
  mean[3] = static_cast<std::uint8_t>((alpha + count / 2) / count);
  return mean;
}

}  // namespace

Image shrinkImage(const Image& image, int factor) {
  if (factor == 1) return image;
  Image small(image.width() / factor, image.height() / factor);
  parallelBlocks(static_cast<std::size_t>(small.height()), 32,
                 [&](std::size_t begin, std::size_t end) {
                   for (int y = static_cast<int>(begin); y < static_cast<int>(end); ++y) {
                     for (int x = 0; x < small.width(); ++x) {
                       small.at(x, y) = blockMean(image, x * factor, y * factor, factor);
                     }
                   }
                 });
  return small;
}

}  // namespace chartflood
