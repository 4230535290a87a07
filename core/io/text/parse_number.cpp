#include "core/io/text/parse_number.h"

namespace chartflood {

namespace {

/// Whether the number that std::from_chars called out of range is too large rather than too small:
/// the power of ten of its first digit that is not 0 tells.
bool tooLarge(const char* p, const char* end) {
  std::int64_t power = 0;
  bool point = false, found = false;
  for (; p < end && *p != 'e' && *p != 'E'; ++p) {
    if (*p == '.') {
      point = true;
    } else if (*p >= '0' && *p <= '9') {
      if (found && !point) ++power;
      if (!found && point) --power;
      found = found || *p != '0';
    }
  }
  if (p < end) {
    const IntegerResult exponent = parseInteger(p + 1, end);
    if (exponent.status == NumberStatus::TooLarge) return p[1] != '-';
    power += exponent.value;
  }
  return power > 0;
}

}  // namespace

RealResult parseRealExactly(const char* begin, const char* end) {
  const char* p = begin;
  if (p < end && *p == '+') {
    ++p;
    if (p < end && *p == '-') return {0, begin, NumberStatus::NotANumber};
  }
  double value = 0;
  const std::from_chars_result result = std::from_chars(p, end, value);
  if (result.ec == std::errc::invalid_argument) return {0, begin, NumberStatus::NotANumber};
  const bool negative = p < end && *p == '-';
  const char* const first = negative ? p + 1 : p;
  const bool digits = first < end && (*first == '.' || (*first >= '0' && *first <= '9'));
  if (result.ec == std::errc::result_out_of_range) {
    if (tooLarge(first, result.ptr)) return {0, result.ptr, NumberStatus::TooLarge};
    return {negative ? -0.0 : 0.0, result.ptr, NumberStatus::Ok};
  }
  if (digits && std::isinf(value)) return {0, result.ptr, NumberStatus::TooLarge};
  return {value, result.ptr, NumberStatus::Ok};
}

}  // namespace chartflood
