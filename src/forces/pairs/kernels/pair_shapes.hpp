// SPDX-License-Identifier: MIT
// The shapes (numbers of sites) of molecules for which the pair loops of an instruction set are
// unrolled. An instruction set for old processors has only one loop, for any shape and any
// short-range potential, if a better set is also compiled. This loop compiles in a third of the
// time, and is slower.
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
    run<Pack<T>, AnyShape<1>>(job, job.table.template any_law<T>());
}

template <class T>
void derivative_of_shapes(const PairJob<T>& job) {
  if constexpr (unrolled)
    pair_derivative_of(job);
  else
    run<Dual<Pack<T>>, AnyShape<1>>(job, job.table.template any_law<T>());
}

}  // namespace
}  // namespace polhode::POLHODE_LOOPS
