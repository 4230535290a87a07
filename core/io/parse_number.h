#pragma once
/// Numbers in text files: exact, independent of the locale, and fast.

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>

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
    while (p < end && static_cast<unsigned char>(*p - '0') < 10) {
      digits = digits * 10 + static_cast<unsigned char>(*p++ - '0');
    }
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
