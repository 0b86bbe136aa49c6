// SPDX-License-Identifier: MIT
// The shapes (numbers of sites) of molecules for which the pair loops of an instruction set are
// unrolled. An instruction set for old processors has only the general shape if a better set is
// also compiled, because this shortens the compile time of the loops.
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
