#pragma once
/// What the refinement of borders did, step by step, so that it can be played.

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/index.h"

namespace chartflood {

/// One new seam between two charts: faces that went from a to b, and from b to a.
struct SeamStep {
  Index a = kNone, b = kNone;
  std::size_t toB = 0;  ///< faces [toB, toA) of the record went from a to b
  std::size_t toA = 0;  ///< faces [toA, end) went from b to a
  std::size_t end = 0;
};

/// Immutable once published. Steps in order; played on `start` they give the final labels.
struct SeamRecord {
  std::vector<Index> start;  ///< chart of each face before the first step
  std::vector<SeamStep> steps;
  std::vector<Index> faces;  ///< of all steps

  /// Carries out step i, or takes it back, on labels that stand just before (after) it.
  void play(std::size_t i, std::span<Index> label) const {
    const SeamStep& step = steps[i];
    for (std::size_t k = step.toB; k < step.end; ++k) {
      label[faces[k]] = k < step.toA ? step.b : step.a;
    }
  }
  void takeBack(std::size_t i, std::span<Index> label) const {
    const SeamStep& step = steps[i];
    for (std::size_t k = step.toB; k < step.end; ++k) {
      label[faces[k]] = k < step.toA ? step.a : step.b;
    }
  }
};

}  // namespace chartflood
