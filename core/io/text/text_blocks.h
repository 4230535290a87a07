#pragma once
/// Text and binary rows written in fixed blocks on all threads, straight into flat memory.

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/parallel.h"

namespace chartflood {

/// Room that writeReal() and writeWhole() may take.
inline constexpr std::size_t kLongestReal = 24;
inline constexpr std::size_t kLongestWhole = 20;

/// The shortest decimal that reads as the same double. \returns the end
inline char* writeReal(char* out, double value) {
  // A sign of what is not a number would be lost on reading anyway.
  if (std::isnan(value)) value = std::fabs(value);
  return std::to_chars(out, out + kLongestReal, value).ptr;
}

template <class T>
char* writeWhole(char* out, T value) {
  return std::to_chars(out, out + kLongestWhole, value).ptr;
}

inline char* writeText(char* out, std::string_view text) {
  std::memcpy(out, text.data(), text.size());
  return out + text.size();
}

/// The bytes of a value as this machine keeps them.
template <class T>
char* writeRaw(char* out, T value) {
  std::memcpy(out, &value, sizeof value);
  return out + sizeof value;
}

/// Appends rows 0 to count - 1. `bound(begin, end)` says how many bytes these rows take at most,
/// `write(begin, end, out)` writes them and returns the end of what it wrote. The rows come in
/// order whatever the number of threads.
template <class Bound, class Write>
void appendBlocks(std::string& text, std::size_t count, const Bound& bound, const Write& write) {
  constexpr std::size_t kRows = 1 << 12, kBlocksAtOnce = 32;
  struct Part {
    std::string bytes;
    std::size_t used = 0;
  };
  // Fresh memory is what costs most, so the parts are used over and over.
  std::vector<Part> parts(kBlocksAtOnce);
  for (std::size_t first = 0; first < count; first += kRows * kBlocksAtOnce) {
    const std::size_t last = std::min(first + kRows * kBlocksAtOnce, count);
    parallelBlocks(last - first, kRows, [&](std::size_t begin, std::size_t end) {
      Part& part = parts[begin / kRows];
      const std::size_t most = bound(first + begin, first + end);
      if (part.bytes.size() < most) part.bytes.resize(most);
      char* const start = part.bytes.data();
      part.used = static_cast<std::size_t>(write(first + begin, first + end, start) - start);
    });
    for (Part& part : parts) {
      text.append(part.bytes, 0, part.used);
      part.used = 0;
    }
  }
}

/// Digits of the largest number below `count`, for estimates.
inline std::size_t digitsOf(std::size_t count) {
  std::size_t digits = 1;
  for (; count > 10; count /= 10) ++digits;
  return digits;
}

}  // namespace chartflood
