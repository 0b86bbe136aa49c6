// SPDX-License-Identifier: MIT
// Common to all fuzz targets: errors are valid results, and memory is limited to a multiple of the
// input.
#include <atomic>
#include <cstdio>
#include <cstdlib>

#include "fuzz.hpp"
#include "polhode/base/error.hpp"

// Hooks of the sanitizers' allocator; g++ has no header for them.
extern "C" int __sanitizer_install_malloc_and_free_hooks(void (*malloc_hook)(const volatile void*,
                                                                             std::size_t),
                                                         void (*free_hook)(const volatile void*));
extern "C" std::size_t __sanitizer_get_allocated_size(const volatile void*);

namespace {

// Bytes of memory per byte of input, in addition to a constant. A line of a few characters becomes
// an atom of 56 bytes or a site of 160, twice while a vector grows.
constexpr std::size_t multiple = 256, beside = std::size_t{8} << 20;

std::atomic<std::size_t> live{0}, peak{0};

void on_malloc(const volatile void*, std::size_t size) {
  const std::size_t now = live += size;
  if (now > peak) peak = now;
}
void on_free(const volatile void* pointer) {
  if (pointer == nullptr) return;
  live -= __sanitizer_get_allocated_size(pointer);
}

[[noreturn]] void finding(const char* what, const char* detail) {
  std::fprintf(stderr, "FINDING: %s%s\n", what, detail);
  std::abort();
}

}  // namespace

extern "C" const char* __asan_default_options() {
  return "max_allocation_size_mb=512:allocator_may_return_null=0:detect_leaks=0";
}
// It exits by a signal, because with g++ it does not run the exit handler of the address sanitizer.
extern "C" const char* __ubsan_default_options() { return "print_stacktrace=1:abort_on_error=1"; }

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const bool hooked = __sanitizer_install_malloc_and_free_hooks(on_malloc, on_free) != 0;
  if (!hooked) finding("the hooks of malloc", " cannot be set");
  const std::size_t before = live;
  peak = before;
  try {
    polhode::fuzz::read({reinterpret_cast<const char*>(data), size});
  } catch (const polhode::Error& e) {
    if (e.where().empty()) finding("an error has no place:  ", e.what());
  } catch (const std::exception& e) {
    finding("a reader threw something other than Error: ", e.what());
  }
  if (peak - before > multiple * size + beside)
    finding("a reader used more memory than its input justifies", "");
  return 0;
}
