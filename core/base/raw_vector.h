#pragma once
/// Vectors for large arrays that are filled by many threads.

#include <cstddef>
#include <memory>
#include <new>
#include <utility>
#include <vector>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace chartflood {

/// Leaves elements that are made without a value as they are in memory, and asks the system for
/// large pages where there are many: steps that jump about in an array, as floods do, then spend
/// less on finding where in memory a page is.
template <class T>
struct RawAllocator : std::allocator<T> {
  template <class U>
  struct rebind {
    using other = RawAllocator<U>;
  };
  RawAllocator() = default;
  template <class U>
  RawAllocator(const RawAllocator<U>&) {}

  T* allocate(std::size_t count) {
    if (!large(count)) return std::allocator<T>::allocate(count);
    const std::size_t bytes = count * sizeof(T);
    void* const block = ::operator new(bytes, kLargePage);
#ifdef __linux__
    // A wish: where it is not granted nothing changes. The last page in part stays small.
    const std::size_t page = static_cast<std::size_t>(kLargePage);
    madvise(block, bytes / page * page, MADV_HUGEPAGE);
#endif
    return static_cast<T*>(block);
  }
  void deallocate(T* block, std::size_t count) {
    if (!large(count)) return std::allocator<T>::deallocate(block, count);
    ::operator delete(static_cast<void*>(block), kLargePage);
  }

  template <class U>
  void construct(U* place) {
    ::new (static_cast<void*>(place)) U;
  }
  template <class U, class... Arguments>
  void construct(U* place, Arguments&&... arguments) {
    ::new (static_cast<void*>(place)) U(std::forward<Arguments>(arguments)...);
  }

 private:
  static constexpr std::align_val_t kLargePage{std::size_t{1} << 21};
  static constexpr bool large(std::size_t count) {
    return count >= (2 * static_cast<std::size_t>(kLargePage)) / sizeof(T);
  }
};

/// After resize() new elements have no value until they are given one. Zeroing them first would be
/// a pass of one thread over memory that the system hands out page by page as it is touched.
template <class T>
using RawVector = std::vector<T, RawAllocator<T>>;

}  // namespace chartflood
