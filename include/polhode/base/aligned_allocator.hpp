// SPDX-License-Identifier: MIT
// Memory for packs. Large memory blocks are placed on large pages, because the processor's address
// tables hold only a limited number of pages.
#pragma once

#include <cstddef>
#include <new>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace polhode {

/// Size of the widest SIMD pack in bytes; the memory of a column starts and ends at multiples of
/// this size.
inline constexpr std::size_t pack_bytes = 64;

/// Size of a large page on common processors, in bytes. A block of memory of at least two large
/// pages starts at a large-page boundary.
inline constexpr std::size_t large_page_bytes = std::size_t{1} << 21;

template <class T>
struct AlignedAllocator {
  using value_type = T;
  AlignedAllocator() = default;
  template <class U>
  AlignedAllocator(const AlignedAllocator<U>&) {}
  T* allocate(std::size_t n) {
    void* const memory = ::operator new(n * sizeof(T), alignment(n));
#ifdef __linux__
    if (is_large(n)) madvise(memory, n * sizeof(T), MADV_HUGEPAGE);  // may be ignored
#endif
    return static_cast<T*>(memory);
  }
  void deallocate(T* p, std::size_t n) { ::operator delete(p, alignment(n)); }
  friend bool operator==(const AlignedAllocator&, const AlignedAllocator&) { return true; }

 private:
  static bool is_large(std::size_t n) { return n * sizeof(T) >= 2 * large_page_bytes; }
  static std::align_val_t alignment(std::size_t n) {
    return std::align_val_t{is_large(n) ? large_page_bytes : pack_bytes};
  }
};

}  // namespace polhode
