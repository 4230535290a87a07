#pragma once
/// The one random generator: the same numbers with every compiler and library.

#include <cstdint>
#include <random>

namespace chartflood {

/// A 32-bit Mersenne Twister used as value mod n. The standard fixes its output; the library's
/// distributions are not used because they differ between platforms.
class Rng {
 public:
  explicit Rng(std::uint32_t seed) : engine_(seed) {}

  /// A number in [0, n), n > 0.
  std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(engine_()) % n; }

 private:
  std::mt19937 engine_;
};

}  // namespace chartflood
