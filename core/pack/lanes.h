#pragma once
/// Several numbers at once. Each lane is rounded as a single number is, so that every machine gives
/// the same results; all that Debian runs on have registers of this size.

#include <cstddef>
#include <cstring>

namespace chartflood {

constexpr std::size_t kFloatLanes = 4, kShortLanes = 8;
using FloatLanes = float __attribute__((vector_size(kFloatLanes * sizeof(float))));
using ShortLanes = short __attribute__((vector_size(kShortLanes * sizeof(short))));

/// Reads as many values as there are lanes, from anywhere.
template <class Lanes, class Value>
Lanes loadLanes(const Value* values) {
  Lanes lanes;
  std::memcpy(&lanes, values, sizeof lanes);
  return lanes;
}

template <class Lanes>
Lanes smaller(Lanes a, Lanes b) {
  return a < b ? a : b;
}
template <class Lanes>
Lanes larger(Lanes a, Lanes b) {
  return a > b ? a : b;
}
template <class Lanes>
Lanes magnitude(Lanes a) {
  return larger(a, -a);
}

/// The lanes in a fixed order.
inline float sumOf(FloatLanes a) { return (a[0] + a[1]) + (a[2] + a[3]); }
inline float largestOf(FloatLanes a) {
  const float low = a[0] > a[1] ? a[0] : a[1], high = a[2] > a[3] ? a[2] : a[3];
  return low > high ? low : high;
}

/// Whether any lane of a comparison holds.
inline bool anyOf(ShortLanes mask) {
  long long halves[2];
  std::memcpy(halves, &mask, sizeof halves);
  return (halves[0] | halves[1]) != 0;
}

}  // namespace chartflood
