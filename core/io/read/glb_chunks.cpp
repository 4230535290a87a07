#include "core/io/read/glb_chunks.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <string>

namespace chartflood {

namespace {

constexpr std::size_t kHead = 12, kChunkHead = 8;  // bytes
constexpr std::uint32_t kJson = 0x4E4F534A, kBinary = 0x004E4942;

std::uint32_t wordAt(std::string_view bytes, std::size_t at) {
  std::uint32_t word = 0;
  std::memcpy(&word, bytes.data() + at, sizeof word);
  return word;
}

}  // namespace

bool isGlb(std::string_view bytes) { return bytes.starts_with("glTF"); }

GlbChunks readGlbChunks(const Source& source) {
  if (source.bytes.size() > std::numeric_limits<std::uint32_t>::max()) {
    source.fail("it is larger than 4 GB, which glTF cannot be");
  }
  if (source.bytes.size() < kHead + kChunkHead) source.fail("it ends within its head");
  GlbChunks chunks;
  chunks.version = wordAt(source.bytes, 4);
  if (chunks.version != 2) return chunks;
  const std::size_t length = wordAt(source.bytes, 8);
  if (length > source.bytes.size()) {
    source.fail("it ends after " + std::to_string(source.bytes.size()) + " bytes but says it has " +
                std::to_string(length));
  }
  const std::string_view bytes = source.bytes.substr(0, length);
  bool first = true;
  for (std::size_t at = kHead; at + kChunkHead <= bytes.size(); first = false) {
    const std::size_t size = wordAt(bytes, at);
    const std::uint32_t kind = wordAt(bytes, at + 4);
    at += kChunkHead;
    if (size > bytes.size() - at) {
      source.failAtByte(bytes.data() + at, "a part of the file is longer than the file");
    }
    if (first && kind != kJson) source.fail("it is not valid glTF: its first part is no JSON");
    if (first) chunks.json = bytes.substr(at, size);
    // Parts of other kinds are to be passed over.
    if (kind == kBinary && chunks.binary.empty()) chunks.binary = bytes.substr(at, size);
    at += std::min((size + 3) / 4 * 4, bytes.size() - at);
  }
  if (chunks.json.empty()) source.fail("it is not valid glTF: it has no JSON");
  return chunks;
}

}  // namespace chartflood
