#pragma once
/// Numbers in text files: exact, independent of the locale, and fast.

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace chartflood {

enum class NumberStatus { Ok, NotANumber, TooLarge };

/// What parseReal() found: `end` is behind the number when the status is Ok.
struct RealResult {
  double value = 0;
  const char* end = nullptr;
  NumberStatus status = NumberStatus::Ok;
};

/// The numbers that the quick way leaves over: many digits, large exponents, "nan", "inf".
RealResult parseRealExactly(const char* begin, const char* end);

/// Appends the digits at `p` to `value`, wrapping around like it; returns the first character
/// behind them. Eight at a time: how many there are is anyone's guess, and a branch on each
/// mispredicted.
inline const char* parseDigits(const char* p, const char* end, std::uint64_t& value) {
  static constexpr std::array<std::uint64_t, 9> kShift = {
      1, 10, 100, 1000, 10000, 100000, 1000000, 10000000, 100000000};
  while (std::endian::native == std::endian::little && end - p >= 8) {
    std::uint64_t bytes = 0;
    std::memcpy(&bytes, p, 8);
    bytes ^= 0x3030303030303030u;  // digits become 0 to 9
    // The lowest marked byte is no digit. Carries only reach those above it.
    const std::uint64_t others = ((bytes + 0x7676767676767676u) | bytes) & 0x8080808080808080u;
    const int count = others == 0 ? 8 : std::countr_zero(others) / 8;
    // As if zeros came before the digits; in two steps, as all 64 bits may have to go.
    bytes = bytes << (32 - 4 * count) << (32 - 4 * count);
    bytes = 10 * bytes + (bytes >> 8);  // pairs, then fours, then all eight
    bytes = ((bytes & 0x000000ff000000ffu) * (100 + (1000000ull << 32)) +
             ((bytes >> 16) & 0x000000ff000000ffu) * (1 + (10000ull << 32))) >>
            32;
    value = value * kShift[static_cast<std::size_t>(count)] + bytes;
    p += count;
    if (count < 8) return p;
  }
  while (p < end && static_cast<unsigned char>(*p - '0') < 10) {
    value = value * 10 + static_cast<unsigned char>(*p++ - '0');
  }
  return p;
}

/// Reads "-1", "+.5", "1e-3", "nan" at `begin`; values below the smallest double become 0.
/// Up to 19 digits whose value and power of ten are exact doubles need one rounding only (Clinger's
/// quick case), so the result is the nearest double; the rest goes to std::from_chars.
inline RealResult parseReal(const char* begin, const char* end) {
  static constexpr std::array<double, 23> kPowers = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                     1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                                     1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
  const char* p = begin;
  const bool negative = p < end && *p == '-';
  if (p < end && (*p == '-' || *p == '+')) ++p;
  std::uint64_t digits = 0;
  const char* const first = p;
  while (p < end && static_cast<unsigned char>(*p - '0') < 10) {
    digits = digits * 10 + static_cast<unsigned char>(*p++ - '0');
  }
  std::ptrdiff_t length = p - first;
  int exponent = 0;
  if (p < end && *p == '.') {
    const char* const fraction = ++p;
    p = parseDigits(p, end, digits);
    exponent = -static_cast<int>(p - fraction < 100 ? p - fraction : 100);
    length += p - fraction;
  }
  if (length == 0 || length > 19) return parseRealExactly(begin, end);
  if (p < end && (*p == 'e' || *p == 'E')) {
    const char* q = p + 1;
    if (q < end && *q == '+') ++q;
    int written = 0;
    const std::from_chars_result result = std::from_chars(q, end, written);
    if (result.ec != std::errc() || written < -1000 || written > 1000 || q[0] == '+') {
      return parseRealExactly(begin, end);
    }
    exponent += written;
    p = result.ptr;
  }
  if (digits >> 53 != 0 || exponent < -22 || exponent > 22) return parseRealExactly(begin, end);
  double value = static_cast<double>(digits);
  value = exponent < 0 ? value / kPowers[static_cast<std::size_t>(-exponent)]
                       : value * kPowers[static_cast<std::size_t>(exponent)];
  return {negative ? -value : value, p, NumberStatus::Ok};
}

/// The text of a number without the plus before it, which std::from_chars does not take.
inline std::string_view withoutPlus(std::string_view text) {
  const bool plus = text.size() > 1 && text[0] == '+' &&
                    (text[1] == '.' || static_cast<unsigned char>(text[1] - '0') < 10);
  return plus ? text.substr(1) : text;
}

/// Reads a whole number with optional sign. Numbers beyond 64 bits are TooLarge.
struct IntegerResult {
  std::int64_t value = 0;
  const char* end = nullptr;
  NumberStatus status = NumberStatus::Ok;
};
inline IntegerResult parseInteger(const char* begin, const char* end) {
  const char* p = begin;
  const bool negative = p < end && *p == '-';
  if (p < end && (*p == '-' || *p == '+')) ++p;
  std::int64_t value = 0;
  const char* const first = p;
  while (p < end && static_cast<unsigned char>(*p - '0') < 10) {
    if (p - first >= 18) return {0, p, NumberStatus::TooLarge};
    value = value * 10 + (*p++ - '0');
  }
  if (p == first) return {0, begin, NumberStatus::NotANumber};
  return {negative ? -value : value, p, NumberStatus::Ok};
}

}  // namespace chartflood
