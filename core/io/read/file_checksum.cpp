#include "core/io/read/file_checksum.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <vector>

#include "core/base/error.h"
#include "core/base/file_bytes.h"

namespace chartflood {

namespace {

constexpr std::size_t kChecksumBlock = std::size_t{1} << 20;  // bytes, a multiple of 8

std::uint64_t mixed(std::uint64_t hash, std::uint64_t word) {
  // Odd constants of the splitmix generator; the rotation brings high bits back to the low end.
  hash = (hash ^ word) * 0x9E3779B97F4A7C15u;
  return std::rotl(hash, 29) * 0xBF58476D1CE4E5B9u;
}

}  // namespace

std::string fileChecksum(const std::filesystem::path& file) {
  std::uint64_t hash = 0, bytes = 0;
  try {
    RegularFile opened(file);
    std::vector<char> block(kChecksumBlock);
    std::size_t count = kChecksumBlock;
    while (count == kChecksumBlock) {
      count = opened.read(block.data(), kChecksumBlock);
      bytes += count;
      for (std::size_t i = 0; i < count; i += 8) {
        std::uint64_t word = 0;
        std::memcpy(&word, block.data() + i, std::min<std::size_t>(8, count - i));
        hash = mixed(hash, word);
      }
    }
  } catch (const ReadError&) {
    return "";
  }
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(mixed(hash, bytes)));
  return text;
}

}  // namespace chartflood
