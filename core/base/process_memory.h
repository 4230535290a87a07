#pragma once
/// The memory of this process: how much it held, and what goes back to the system.

#include <cstddef>

namespace chartflood {

/// The most memory that the program held so far, bytes.
std::size_t peakMemoryBytes();

/// Lets every large block go back to the system when it is freed. A run makes each of its arrays
/// once, so that what the C library would keep for more of them only adds to the peak: a third of
/// it with a million triangles.
void returnLargeBlocks();

}  // namespace chartflood
