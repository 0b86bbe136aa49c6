// SPDX-License-Identifier: MIT
// Instruction sets. Loops over packs are compiled once for each instruction set, and a set is
// chosen at start-up.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <string_view>
#include <vector>

namespace polhode {

enum class InstructionSet { scalar, sse4, avx2, avx512, neon };

const char* name(InstructionSet instruction_set);

/// The instruction sets that were compiled in and that this processor supports, slowest first.
std::vector<InstructionSet> available_instruction_sets();

/// The current instruction set: the fastest available set, unless the environment variable
/// POLHODE_INSTRUCTION_SET or force_instruction_set() selects another.
/// @throws Error  if POLHODE_INSTRUCTION_SET names an instruction set that does not exist or that
///   this processor does not support
InstructionSet current_instruction_set();

/// Selects an instruction set, for tests and benchmarks. This function must not be called while
/// other threads compute.
void force_instruction_set(InstructionSet instruction_set);

// A file in a `kernels` folder defines functions in namespace polhode::POLHODE_LOOPS. The build
// defines POLHODE_LOOPS as loops_scalar, loops_sse4 and so on. POLHODE_DECLARE_LOOPS declares these
// functions for all instruction sets. POLHODE_CURRENT_LOOPS selects the functions of the current
// instruction set. POLHODE_CURRENT_OVERLOAD selects an overloaded function, given the type of a
// function pointer. The loops of an instruction set that was not compiled in are an alias of the
// scalar loops, and are never selected.
#define POLHODE_DECLARE_IN(loops, ...) \
  namespace loops {                    \
  __VA_ARGS__                          \
  }
#if defined(POLHODE_WITHOUT_SSE4)
#define POLHODE_DECLARE_SSE4(...) namespace loops_sse4 = loops_scalar;
#else
#define POLHODE_DECLARE_SSE4(...) POLHODE_DECLARE_IN(loops_sse4, __VA_ARGS__)
#endif
#if defined(POLHODE_WITHOUT_AVX2)
#define POLHODE_DECLARE_AVX2(...) namespace loops_avx2 = loops_scalar;
#else
#define POLHODE_DECLARE_AVX2(...) POLHODE_DECLARE_IN(loops_avx2, __VA_ARGS__)
#endif
#if defined(POLHODE_WITHOUT_AVX512)
#define POLHODE_DECLARE_AVX512(...) namespace loops_avx512 = loops_scalar;
#else
#define POLHODE_DECLARE_AVX512(...) POLHODE_DECLARE_IN(loops_avx512, __VA_ARGS__)
#endif
#if defined(POLHODE_WITHOUT_NEON)
#define POLHODE_DECLARE_NEON(...) namespace loops_neon = loops_scalar;
#else
#define POLHODE_DECLARE_NEON(...) POLHODE_DECLARE_IN(loops_neon, __VA_ARGS__)
#endif
#define POLHODE_DECLARE_LOOPS(...)              \
  POLHODE_DECLARE_IN(loops_scalar, __VA_ARGS__) \
  POLHODE_DECLARE_SSE4(__VA_ARGS__)             \
  POLHODE_DECLARE_AVX2(__VA_ARGS__)             \
  POLHODE_DECLARE_AVX512(__VA_ARGS__)           \
  POLHODE_DECLARE_NEON(__VA_ARGS__)
#define POLHODE_LOOPS_OF_SETS(function)                                    \
  {                                                                        \
    &loops_scalar::function, &loops_sse4::function, &loops_avx2::function, \
        &loops_avx512::function, &loops_neon::function                     \
  }
#define POLHODE_CURRENT_LOOPS(function) \
  (::polhode::pick(::polhode::current_instruction_set(), POLHODE_LOOPS_OF_SETS(function)))
#define POLHODE_CURRENT_OVERLOAD(function, ...)                       \
  (::polhode::pick<__VA_ARGS__>(::polhode::current_instruction_set(), \
                                POLHODE_LOOPS_OF_SETS(function)))

/// Selects a function from an array in the order of InstructionSet.
template <class Function>
constexpr Function pick(InstructionSet instruction_set, std::initializer_list<Function> functions) {
  return functions.begin()[static_cast<std::size_t>(instruction_set)];
}

}  // namespace polhode
