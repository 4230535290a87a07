#include "render/scene/image.h"
#include "render/scene/read_picture.h"

#include <array>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <stb/stb_image_write.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include "core/base/error.h"
#include "tests/support/temporary_folder.h"

namespace chartflood {
namespace {

Image gradient(bool transparent) {
  Image image(13, 7);
  for (int y = 0; y < 7; ++y) {
    for (int x = 0; x < 13; ++x) {
      const auto alpha = static_cast<std::uint8_t>(transparent ? 20 * x : 255);
      image.at(x, y) = {static_cast<std::uint8_t>(x * 19), static_cast<std::uint8_t>(y * 36),
                        static_cast<std::uint8_t>(x * y), alpha};
    }
  }
  return image;
}

TEST(Png, RoundTripKeepsPixelsAndTexts) {
  const ImageTexts texts{{"Software", "chartflood"}, {"Parameters", "charts=20 K \u2265 3"}};
  for (const bool transparent : {false, true}) {
    const Image image = gradient(transparent);
    ImageTexts back;
    EXPECT_EQ(decodePng(encodePng(image, texts), "test", &back), image);
    EXPECT_EQ(back, texts);
  }
}

TEST(Png, EqualPicturesGiveEqualBytes) {
  const ImageTexts texts{{"Software", "chartflood"}};
  EXPECT_EQ(encodePng(gradient(true), texts), encodePng(gradient(true), texts));
}

TEST(Png, BrokenBytesAreRefused) {
  const auto bytes = encodePng(gradient(true));
  for (std::size_t length = 0; length < bytes.size(); length += 3) {
    const std::span<const std::uint8_t> part(bytes.data(), length);
    EXPECT_THROW(decodePng(part, "cut.png"), ReadError) << length;
  }
}

TEST(Png, AFailedWriteLeavesTheOldFileAndNothingElse) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "taken.png" / "inside");
  EXPECT_THROW(writePng(gradient(false), folder / "taken.png"), WriteError);
  EXPECT_THROW(writePng(gradient(false), folder / "missing" / "a.png"), WriteError);
  writePng(gradient(false), folder / "good.png");
  EXPECT_EQ(readPng(folder / "good.png"), gradient(false));
  std::size_t entries = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    (void)entry;
    ++entries;
  }
  EXPECT_EQ(entries, 2u);
}

TEST(ImageDifference, CountsPixelsBeyondTheTolerance) {
  const Image a(4, 4, {10, 20, 30, 255});
  Image b = a;
  b.at(1, 2) = {10, 23, 30, 255};
  b.at(3, 3) = {60, 20, 30, 255};
  EXPECT_EQ(compareImages(a, a).differentPixels, 0u);
  EXPECT_EQ(compareImages(a, b).differentPixels, 2u);
  EXPECT_EQ(compareImages(a, b, 3).differentPixels, 1u);
  EXPECT_EQ(compareImages(a, b).largest, 50);
  EXPECT_NEAR(compareImages(a, b).mean, 53.0 / 64, 1e-12);
  EXPECT_THROW(compareImages(a, Image(4, 5)), Error);
}

TEST(ShrinkImage, AveragesColourByAlpha) {
  Image image(2, 2, {0, 0, 0, 0});
  image.at(0, 0) = {200, 100, 50, 255};
  const Image small = shrinkImage(image, 2);
  // The three empty pixels take away alpha, not colour: no dark rim.
  EXPECT_EQ(small.at(0, 0), (Rgba8{200, 100, 50, 64}));
  EXPECT_EQ(shrinkImage(image, 1), image);
}

class PictureFiles : public ::testing::Test {
 protected:
  std::filesystem::path file(const char* name, const std::vector<std::uint8_t>& bytes) {
    std::ofstream stream(folder / name, std::ios::binary);
    stream.write(reinterpret_cast<const char*>(bytes.data()),
                 static_cast<std::streamsize>(bytes.size()));
    return folder / name;
  }
  const TemporaryFolder folder;
};

std::vector<std::uint8_t> encodeJpeg(const Image& image) {
  std::vector<std::uint8_t> bytes;
  const auto append = [](void* out, void* data, int size) {
    const auto* first = static_cast<const std::uint8_t*>(data);
    auto& list = *static_cast<std::vector<std::uint8_t>*>(out);
    list.insert(list.end(), first, first + size);
  };
  stbi_write_jpg_to_func(append, &bytes, image.width(), image.height(), 4, image.pixels().data(),
                         95);
  return bytes;
}

TEST_F(PictureFiles, JpegAndPngAreReadAlike) {
  Image image(48, 32, {30, 120, 210, 255});
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 48; ++x) image.at(x, y) = {200, 160, 40, 255};
  }
  EXPECT_EQ(readPicture(file("a.png", encodePng(image))), image);
  const Image jpeg = readPicture(file("a.jpg", encodeJpeg(image)));
  EXPECT_LT(compareImages(jpeg, image).mean, 6);
}

TEST_F(PictureFiles, WhatIsNoPictureIsNamed) {
  const std::vector<std::uint8_t> whole = encodeJpeg(Image(40, 40, {9, 9, 9, 255}));
  const std::vector<std::uint8_t> head(whole.begin(), whole.begin() + 20);
  EXPECT_THROW(readPicture(file("cut.jpg", head)), ReadError);
  EXPECT_THROW(readPicture(file("empty.png", {})), ReadError);
  EXPECT_THROW(readPicture(file("text.png", std::vector<std::uint8_t>(40, 'x'))), ReadError);
  EXPECT_THROW(readPicture(folder / "none.png"), ReadError);
  // A small file that claims a huge picture.
  std::vector<std::uint8_t> bomb = encodePng(Image(4, 4, {1, 2, 3, 255}));
  bomb[16] = bomb[20] = 0x7F;
  EXPECT_THROW(readPicture(file("bomb.png", bomb)), ReadError);
}

TEST_F(PictureFiles, LargeOnesAreHalvedUntilTheyFit) {
  const Image read = readPicture(file("wide.png", encodePng(Image(9001, 3, {50, 60, 70, 255}))));
  EXPECT_EQ(read.width(), 2250);
  EXPECT_EQ(read.height(), 1);
  EXPECT_EQ(read.at(1000, 0), (Rgba8{50, 60, 70, 255}));
}

/// The most memory that this program has had so far, in MB.
long peakMegabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss / 1024;
}

TEST_F(PictureFiles, WhatClaimsMoreThanItCanHoldIsRefusedBeforeMemoryIsAskedFor) {
  const auto causes = [](const std::filesystem::path& picture) {
    std::vector<std::string> all;
    try {
      readPicture(picture);
    } catch (const ReadError& error) {
      all.push_back(error.cause());
    }
    try {
      readPngTexts(picture);
    } catch (const ReadError& error) {
      all.push_back(error.cause());
    }
    return all;
  };
  const long before = peakMegabytes();
  const std::filesystem::path cases = CHARTFLOOD_CASES;
  const std::string most = " pixels, and 16384 x 16384 are the most; save it smaller";
  EXPECT_EQ(causes(cases / "bomb-huge.png"),
            std::vector<std::string>(2, "it says that it has 900000 x 900000" + most));
  EXPECT_EQ(causes(cases / "bomb-size.png"),
            std::vector<std::string>(2, "it says that it has 25000 x 25000" + most));
  // 16128 x 16128 would be allowed, but not in so few bytes.
  std::vector<std::uint8_t> claim = encodePng(Image(4, 4, {1, 2, 3, 255}));
  claim[18] = claim[22] = 63;
  claim[19] = claim[23] = 0;
  // The checksum of the changed head: 8 bits, red, green, blue.
  constexpr std::array<std::uint8_t, 4> kChecksum = {0x51, 0x50, 0x81, 0x24};
  for (std::size_t i = 0; i < 4; ++i) claim[29 + i] = kChecksum[i];
  EXPECT_EQ(causes(file("claim.png", claim)),
            std::vector<std::string>(2, "it says that it has 16128 x 16128 pixels, more than so "
                                        "short a file can hold; save it anew"));
  EXPECT_LT(peakMegabytes() - before, 64);
}

TEST_F(PictureFiles, OnlyRegularFilesAreOpened) {
  ASSERT_EQ(::mkfifo((folder / "pipe.png").c_str(), 0600), 0);
  for (const std::filesystem::path& no :
       {folder / "pipe.png", std::filesystem::path("/dev/zero"), folder.path()}) {
    EXPECT_THROW(readPicture(no), ReadError) << no;
    EXPECT_THROW(readPng(no), ReadError) << no;
    EXPECT_THROW(readPngTexts(no), ReadError) << no;
  }
}

TEST_F(PictureFiles, TextsAreReadWithoutThePixels) {
  std::vector<std::uint8_t> bytes = encodePng(Image(40, 40, {9, 9, 9, 255}), {{"Key", "value"}});
  bytes.resize(bytes.size() - 30);
  const ImageTexts texts = readPngTexts(file("cut.png", bytes));
  EXPECT_EQ(texts, (ImageTexts{{"Key", "value"}}));
}

}  // namespace
}  // namespace chartflood
