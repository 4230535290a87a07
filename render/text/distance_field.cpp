#include "render/text/distance_field.h"

#include <cmath>
#include <cstddef>

namespace chartflood {

namespace {

constexpr double kFar = 1e12;

/// Lower envelope of parabolas: f(x) becomes min over y of (x - y)^2 + f(y), for the `count` values
/// at `first`, `first + stride`, ...
void transformLine(std::vector<double>& f, std::size_t first, std::size_t stride,
                   std::size_t count) {
  std::vector<double> old(count), bound(count + 1);
  std::vector<std::size_t> vertex(count);
  for (std::size_t i = 0; i < count; ++i) old[i] = f[first + i * stride];
  const auto square = [](std::size_t x) { return static_cast<double>(x) * static_cast<double>(x); };
  std::size_t top = 0;
  vertex[0] = 0;
  bound[0] = -kFar;
  bound[1] = kFar;
  for (std::size_t q = 1; q < count; ++q) {
    double meet = 0;
    for (;; --top) {
      const std::size_t v = vertex[top];
      meet = ((old[q] + square(q)) - (old[v] + square(v))) / (2.0 * static_cast<double>(q - v));
      if (meet > bound[top] || top == 0) break;
    }
    if (meet > bound[top]) ++top;
    vertex[top] = q;
    bound[top] = top == 0 ? -kFar : meet;
    bound[top + 1] = kFar;
  }
  std::size_t k = 0;
  for (std::size_t x = 0; x < count; ++x) {
    while (bound[k + 1] < static_cast<double>(x)) ++k;
    const double away = static_cast<double>(x) - static_cast<double>(vertex[k]);
    f[first + x * stride] = away * away + old[vertex[k]];
  }
}

/// Squared distance of each pixel to the nearest pixel whose flag is `value`.
std::vector<double> squaredDistances(const std::vector<bool>& flags, bool value, std::size_t width,
                                     std::size_t height) {
  std::vector<double> f(flags.size());
  for (std::size_t i = 0; i < flags.size(); ++i) f[i] = flags[i] == value ? 0 : kFar;
  for (std::size_t x = 0; x < width; ++x) transformLine(f, x, width, height);
  for (std::size_t y = 0; y < height; ++y) transformLine(f, y * width, 1, width);
  return f;
}

}  // namespace

std::vector<float> signedDistances(const std::vector<bool>& inside, int width, int height) {
  // A rim of unset pixels stands for what lies beyond.
  const auto w = static_cast<std::size_t>(width) + 2, h = static_cast<std::size_t>(height) + 2;
  std::vector<bool> padded(w * h, false);
  for (std::size_t y = 0; y + 2 < h; ++y) {
    for (std::size_t x = 0; x + 2 < w; ++x) padded[(y + 1) * w + x + 1] = inside[y * (w - 2) + x];
  }
  const std::vector<double> toInside = squaredDistances(padded, true, w, h);
  const std::vector<double> toOutside = squaredDistances(padded, false, w, h);
  std::vector<float> distance(inside.size());
  for (std::size_t y = 0; y + 2 < h; ++y) {
    for (std::size_t x = 0; x + 2 < w; ++x) {
      const std::size_t i = (y + 1) * w + x + 1;
      const double d = padded[i] ? std::sqrt(toOutside[i]) - 0.5 : 0.5 - std::sqrt(toInside[i]);
      distance[y * (w - 2) + x] = static_cast<float>(d);
    }
  }
  return distance;
}

}  // namespace chartflood
