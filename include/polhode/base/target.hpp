// SPDX-License-Identifier: MIT
// Instruction sets: loops over packs are compiled once for each, and one is chosen at start-up.
#pragma once

#include <string_view>
#include <vector>

namespace polhode {

enum class Target { scalar, sse4, avx2, avx512 };

const char* name(Target target);

/// The instruction sets that were compiled in and that this processor supports, slowest first.
std::vector<Target> available_targets();

/// The instruction set in use: the fastest available one, unless the environment variable
/// POLHODE_TARGET or force_target() selects another.
/// @throws Error  if POLHODE_TARGET names one that does not exist or that this processor lacks
Target current_target();

/// Use this instruction set from now on; for tests and benchmarks. Not while other threads compute.
void force_target(Target target);

// A file in a `targets` folder defines its functions in namespace polhode::POLHODE_LOOPS, which the
// build defines as loops_scalar, loops_sse4 and so on. POLHODE_DECLARE_LOOPS declares them for all
// instruction sets, POLHODE_CURRENT_LOOPS selects the current one, and POLHODE_CURRENT_OVERLOAD
// does so for overloaded functions, given the type of a function pointer.
// A set that was not compiled in is another name for the scalar one, and never available.
#if defined(__x86_64__)
#if defined(POLHODE_WITHOUT_SSE4)
#define POLHODE_DECLARE_SSE4(...) namespace loops_sse4 = loops_scalar;
#else
#define POLHODE_DECLARE_SSE4(...) \
  namespace loops_sse4 {          \
  __VA_ARGS__                     \
  }
#endif
#if defined(POLHODE_WITHOUT_AVX2)
#define POLHODE_DECLARE_AVX2(...) namespace loops_avx2 = loops_scalar;
#else
#define POLHODE_DECLARE_AVX2(...) \
  namespace loops_avx2 {          \
  __VA_ARGS__                     \
  }
#endif
#if defined(POLHODE_WITHOUT_AVX512)
#define POLHODE_DECLARE_AVX512(...) namespace loops_avx512 = loops_scalar;
#else
#define POLHODE_DECLARE_AVX512(...) \
  namespace loops_avx512 {          \
  __VA_ARGS__                       \
  }
#endif
#define POLHODE_DECLARE_LOOPS(...)  \
  namespace loops_scalar {          \
  __VA_ARGS__                       \
  }                                 \
  POLHODE_DECLARE_SSE4(__VA_ARGS__) \
  POLHODE_DECLARE_AVX2(__VA_ARGS__) \
  POLHODE_DECLARE_AVX512(__VA_ARGS__)
#define POLHODE_CURRENT_LOOPS(function)                                                         \
  (::polhode::pick(::polhode::current_target(), &loops_scalar::function, &loops_sse4::function, \
                   &loops_avx2::function, &loops_avx512::function))
#define POLHODE_CURRENT_OVERLOAD(function, ...)                                       \
  (::polhode::pick<__VA_ARGS__>(::polhode::current_target(), &loops_scalar::function, \
                                &loops_sse4::function, &loops_avx2::function,         \
                                &loops_avx512::function))
#else
#define POLHODE_DECLARE_LOOPS(...) \
  namespace loops_scalar {         \
  __VA_ARGS__                      \
  }
#define POLHODE_CURRENT_LOOPS(function) (&loops_scalar::function)
#define POLHODE_CURRENT_OVERLOAD(function, ...) (static_cast<__VA_ARGS__>(&loops_scalar::function))
#endif

/// One of four functions, by instruction set.
template <class Function>
constexpr Function pick(Target target, Function scalar, Function sse4, Function avx2,
                        Function avx512) {
  switch (target) {
    case Target::sse4:
      return sse4;
    case Target::avx2:
      return avx2;
    case Target::avx512:
      return avx512;
    case Target::scalar:
      break;
  }
  return scalar;
}

}  // namespace polhode
