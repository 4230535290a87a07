#include "core/param/dense_front.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace chartflood {

namespace {

/// Columns whose shares are taken off others in one go.
constexpr std::size_t kTogether = 4;
/// Columns that are eliminated before those behind them take notice: as many as stay in the cache.
constexpr std::size_t kPanel = 32;

using Lanes = double __attribute__((vector_size(32)));
constexpr std::size_t kLanes = 4;

#define CF_INLINE [[gnu::always_inline]] inline

CF_INLINE void load(Lanes& lanes, const double* from) { std::memcpy(&lanes, from, sizeof(lanes)); }
CF_INLINE void store(double* to, const Lanes& lanes) { std::memcpy(to, &lanes, sizeof(lanes)); }

/// What column q of a front was divided by.
CF_INLINE double pivotOf(const DenseFront& f, std::size_t q) { return f.real[q * f.stride + q]; }

/// Rows [begin, end) of column j less those of four columns times a factor each.
CF_INLINE void subtract(double* column, const double* const (&from)[kTogether],
                        const double (&factor)[kTogether], std::size_t begin, std::size_t end) {
  std::size_t i = begin;
  for (; i + kLanes <= end; i += kLanes) {
    Lanes sum, l;
    load(sum, column + i);
    for (std::size_t q = 0; q < kTogether; ++q) {
      load(l, from[q] + i);
      sum -= l * factor[q];
    }
    store(column + i, sum);
  }
  for (; i < end; ++i) {
    double sum = column[i];
    for (std::size_t q = 0; q < kTogether; ++q) sum -= from[q][i] * factor[q];
    column[i] = sum;
  }
}

/// The same of two columns at once, from the same four.
CF_INLINE void subtract(double* first, double* second, const double* const (&from)[kTogether],
                        const double (&ofFirst)[kTogether], const double (&ofSecond)[kTogether],
                        std::size_t begin, std::size_t end) {
  std::size_t i = begin;
  for (; i + kLanes <= end; i += kLanes) {
    Lanes a, b, l;
    load(a, first + i);
    load(b, second + i);
    for (std::size_t q = 0; q < kTogether; ++q) {
      load(l, from[q] + i);
      a -= l * ofFirst[q];
      b -= l * ofSecond[q];
    }
    store(first + i, a);
    store(second + i, b);
  }
  for (; i < end; ++i) {
    for (std::size_t q = 0; q < kTogether; ++q) {
      first[i] -= from[q][i] * ofFirst[q];
      second[i] -= from[q][i] * ofSecond[q];
    }
  }
}

/// Columns [begin, end) less what the columns [first, last) leave to them.
struct Update {
  std::size_t first, last, begin, end;
};

CF_INLINE void updateReal(const DenseFront& f, const Update& u) {
  std::size_t j = u.begin;
  for (; j < u.end; j += 2) {
    const bool two = j + 1 < u.end;
    double* const column = f.real + j * f.stride;
    for (std::size_t block = u.first; block < u.last; block += kTogether) {
      const double* from[kTogether];
      double a[kTogether], b[kTogether];
      for (std::size_t q = 0; q < kTogether; ++q) {
        const std::size_t k = std::min(block + q, u.last - 1);
        const double pivot = block + q < u.last ? pivotOf(f, k) : 0;
        from[q] = f.real + k * f.stride;
        a[q] = from[q][j] * pivot;
        b[q] = two ? from[q][j + 1] * pivot : 0;
      }
      if (two) {
        for (std::size_t q = 0; q < kTogether; ++q) column[j] -= from[q][j] * a[q];
        subtract(column, column + f.stride, from, a, b, j + 1, f.size);
      } else {
        subtract(column, from, a, j, f.size);
      }
    }
  }
}

CF_INLINE void updateComplex(const DenseFront& f, const Update& u) {
  for (std::size_t j = u.begin; j < u.end; ++j) {
    double *const real = f.real + j * f.stride, *const imaginary = f.imaginary + j * f.stride;
    for (std::size_t block = u.first; block < u.last; block += kTogether) {
      const double *re[kTogether], *im[kTogether];
      double a[kTogether], b[kTogether], minusB[kTogether];  // of the conjugate in row j
      for (std::size_t q = 0; q < kTogether; ++q) {
        const std::size_t k = std::min(block + q, u.last - 1);
        const double pivot = block + q < u.last ? pivotOf(f, k) : 0;
        re[q] = f.real + k * f.stride;
        im[q] = f.imaginary + k * f.stride;
        a[q] = re[q][j] * pivot;
        minusB[q] = im[q][j] * pivot;
        b[q] = -minusB[q];
      }
      std::size_t i = j;
      for (; i + kLanes <= f.size; i += kLanes) {
        Lanes x, y, v, w;
        load(x, real + i);
        load(y, imaginary + i);
        for (std::size_t q = 0; q < kTogether; ++q) {
          load(v, re[q] + i);
          load(w, im[q] + i);
          x -= v * a[q];
          x -= w * minusB[q];
          y -= v * b[q];
          y -= w * a[q];
        }
        store(real + i, x);
        store(imaginary + i, y);
      }
      for (; i < f.size; ++i) {
        double x = real[i], y = imaginary[i];
        for (std::size_t q = 0; q < kTogether; ++q) {
          x -= re[q][i] * a[q];
          x -= im[q][i] * minusB[q];
          y -= re[q][i] * b[q];
          y -= im[q][i] * a[q];
        }
        real[i] = x;
        imaginary[i] = y;
      }
    }
  }
}

CF_INLINE void updateAny(const DenseFront& f, const Update& u) {
  if (f.imaginary == nullptr) {
    updateReal(f, u);
  } else {
    updateComplex(f, u);
  }
}

void updatePlain(const DenseFront& f, const Update& u) { updateAny(f, u); }

// Wider registers give the same sums: products are not fused with them.
#ifdef __x86_64__
[[gnu::target("avx2")]] void updateWide(const DenseFront& f, const Update& u) { updateAny(f, u); }
const auto kUpdate = __builtin_cpu_supports("avx2") != 0 ? updateWide : updatePlain;
#else
const auto kUpdate = updatePlain;
#endif

#undef CF_INLINE

/// Column j less what the columns from `block` on leave to it, then divided by its pivot.
bool eliminateColumn(const DenseFront& f, std::size_t block, std::size_t j, double* inverse) {
  double* const real = f.real + j * f.stride;
  double* const imaginary = f.imaginary == nullptr ? nullptr : f.imaginary + j * f.stride;
  for (std::size_t q = block; q < j; ++q) {
    const double* const re = f.real + q * f.stride;
    const double pivot = pivotOf(f, q);
    const double a = re[j] * pivot;
    if (imaginary == nullptr) {
      for (std::size_t i = j; i < f.size; ++i) real[i] -= re[i] * a;
      continue;
    }
    const double* const im = f.imaginary + q * f.stride;
    const double b = -im[j] * pivot;
    for (std::size_t i = j; i < f.size; ++i) {
      real[i] -= re[i] * a - im[i] * b;
      imaginary[i] -= re[i] * b + im[i] * a;
    }
  }
  inverse[j] = 1 / real[j];
  if (!(real[j] > 0) || !std::isfinite(inverse[j])) return false;
  for (std::size_t i = j + 1; i < f.size; ++i) real[i] *= inverse[j];
  if (imaginary == nullptr) return true;
  for (std::size_t i = j + 1; i < f.size; ++i) imaginary[i] *= inverse[j];
  return true;
}

}  // namespace

bool eliminate(const DenseFront& front, std::size_t columns, double* inverse) {
  for (std::size_t panel = 0; panel < columns; panel += kPanel) {
    const std::size_t panelEnd = std::min(panel + kPanel, columns);
    for (std::size_t block = panel; block < panelEnd; block += kTogether) {
      const std::size_t end = std::min(block + kTogether, panelEnd);
      for (std::size_t j = block; j < end; ++j) {
        if (!eliminateColumn(front, block, j, inverse)) return false;
      }
      kUpdate(front, {block, end, end, panelEnd});
    }
    kUpdate(front, {panel, panelEnd, panelEnd, front.size});
  }
  return true;
}

}  // namespace chartflood
