#pragma once
/// Searches for the densest layout of shapes in a square.

#include <span>

#include "core/base/progress.h"
#include "core/pack/pack_shape.h"
#include "core/pack/squeeze.h"

namespace chartflood {

struct SearchOptions {
  int starts = 8;
  int rounds = 16;
  int changes = 2;
  std::uint32_t seed = 1;
};

/// The best layout found; its shapes may still be pressed into each other by a small part of the
/// points' spacing. Fixed work, shared out over the threads by independent starts.
PackLayout searchLayout(std::span<const PackShape> shapes, const PackGaps& gaps,
                        const SearchOptions& options, Progress& progress);

}  // namespace chartflood
