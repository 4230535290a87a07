#pragma once
/// Vectors for large arrays that are filled by many threads.

#include <memory>
#include <utility>
#include <vector>

namespace chartflood {

/// Leaves elements that are made without a value as they are in memory.
template <class T>
struct RawAllocator : std::allocator<T> {
  template <class U>
  struct rebind {
    using other = RawAllocator<U>;
  };
  RawAllocator() = default;
  template <class U>
  RawAllocator(const RawAllocator<U>&) {}

  template <class U>
  void construct(U* place) {
    ::new (static_cast<void*>(place)) U;
  }
  template <class U, class... Arguments>
  void construct(U* place, Arguments&&... arguments) {
    ::new (static_cast<void*>(place)) U(std::forward<Arguments>(arguments)...);
  }
};

/// After resize() new elements have no value until they are given one. Zeroing them first would be
/// a pass of one thread over memory that the system hands out page by page as it is touched.
template <class T>
using RawVector = std::vector<T, RawAllocator<T>>;

}  // namespace chartflood
