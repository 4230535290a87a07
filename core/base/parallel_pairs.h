#pragma once
/// Work on pairs of things, side by side where pairs share nothing, with the result of doing them
/// in order.

#include <cstddef>
#include <functional>
#include <span>
#include <utility>

#include "core/base/index.h"

namespace chartflood {

/// Calls `task(i, worker)` once for each pair i, on all threads. Two pairs with a thing in common
/// run one after the other, the earlier first, so that what a task finds of its own two things does
/// not depend on the number of threads.
/// \param pairs two different numbers below `things` each
/// \param task gets the pair and a number below threadCount() that no other task has meanwhile, for
///   scratch memory; once it returns false, no further task is begun
/// An exception thrown by a task is thrown again here, after the tasks that ran have ended.
void parallelPairs(std::span<const std::pair<Index, Index>> pairs, std::size_t things,
                   const std::function<bool(std::size_t, std::size_t)>& task);

}  // namespace chartflood
