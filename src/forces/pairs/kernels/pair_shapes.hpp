// SPDX-License-Identifier: MIT
// Which shapes of molecules the pair loops of an instruction set are unrolled for. If a better set
// is also compiled, an instruction set that serves only old processors has only the general shape.
// This saves most of the compile time of its loops.
#pragma once

#include "pair_rows.hpp"

namespace polhode::POLHODE_LOOPS {
namespace {

#ifdef POLHODE_FALLBACK
inline constexpr bool unrolled = false;
#else
inline constexpr bool unrolled = true;
#endif

template <class T>
void forces_of_shapes(const PairJob<T>& job) {
  if constexpr (unrolled)
    pair_forces_of(job);
  else
    run_fitting<Pack<T>>(job);
}

template <class T>
void derivative_of_shapes(const PairJob<T>& job) {
  if constexpr (unrolled)
    pair_derivative_of(job);
  else
    run_fitting<Dual<Pack<T>>>(job);
}

}  // namespace
}  // namespace polhode::POLHODE_LOOPS
