#pragma once
/// Work shared out over a pool of threads in fixed blocks, so that results never depend on the
/// number of threads.

#include <cstddef>
#include <functional>

namespace chartflood {

/// Sets how many threads `parallelFor` may use, the caller's included; 0 means one per core.
/// Call it while no parallel work runs.
void setThreadCount(unsigned count);

/// Number of threads in use, at least 1.
unsigned threadCount();

/// Calls `task(i)` once for each i in [0, count), on any thread, in any order, and returns when all
/// are done. Tasks must not touch each other's results. A call from inside a task, or while
/// another thread's call runs, does its tasks on the calling thread alone. The first exception
/// thrown by a task is thrown again here after all tasks ended.
void parallelFor(std::size_t count, const std::function<void(std::size_t)>& task);

/// Splits [0, count) into blocks of `blockSize` (the last may be shorter) and calls
/// `task(begin, end)` for each. The blocks are the same for any number of threads.
void parallelBlocks(std::size_t count, std::size_t blockSize,
                    const std::function<void(std::size_t, std::size_t)>& task);

}  // namespace chartflood
