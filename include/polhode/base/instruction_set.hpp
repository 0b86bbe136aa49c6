// SPDX-License-Identifier: MIT
// Instruction sets: loops over packs are compiled once for each, and one is chosen at start-up.
#pragma once

#include <string_view>
#include <vector>

namespace polhode {

enum class InstructionSet { scalar, sse4, avx2, avx512 };

const char* name(InstructionSet instruction_set);

/// The instruction sets that were compiled in and that this processor supports, slowest first.
std::vector<InstructionSet> available_instruction_sets();

/// The instruction set in use: the fastest available one, unless the environment variable
/// POLHODE_INSTRUCTION_SET or force_instruction_set() selects another.
/// @throws Error  if POLHODE_INSTRUCTION_SET names one that does not exist or that this processor
/// lacks
InstructionSet current_instruction_set();

/// Selects an instruction set, for tests and benchmarks; not while other threads compute.
void force_instruction_set(InstructionSet instruction_set);

// A file in a `kernels` folder defines its functions in namespace polhode::POLHODE_LOOPS, which the
// build defines as loops_scalar, loops_sse4 and so on. POLHODE_DECLARE_LOOPS declares them for all
// instruction sets, POLHODE_CURRENT_LOOPS selects the current one, and POLHODE_CURRENT_OVERLOAD
// does so for overloaded functions, given the type of a function pointer.
// A set that was not compiled in is an alias of the scalar one, and never available.
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
#define POLHODE_CURRENT_LOOPS(function)                                           \
  (::polhode::pick(::polhode::current_instruction_set(), &loops_scalar::function, \
                   &loops_sse4::function, &loops_avx2::function, &loops_avx512::function))
#define POLHODE_CURRENT_OVERLOAD(function, ...)                                                \
  (::polhode::pick<__VA_ARGS__>(::polhode::current_instruction_set(), &loops_scalar::function, \
                                &loops_sse4::function, &loops_avx2::function,                  \
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
constexpr Function pick(InstructionSet instruction_set, Function scalar, Function sse4,
                        Function avx2, Function avx512) {
  switch (instruction_set) {
    case InstructionSet::sse4:
      return sse4;
    case InstructionSet::avx2:
      return avx2;
    case InstructionSet::avx512:
      return avx512;
    case InstructionSet::scalar:
      break;
  }
  return scalar;
}

}  // namespace polhode
