// SPDX-License-Identifier: MIT
// Adds sums of a chunk to sums in double precision.
#include "base/pack_transpose.hpp"
#include "forces/pairs/pair_loops.hpp"

namespace polhode::POLHODE_LOOPS {
namespace {

template <class T>
void add(const T* from, std::size_t n, double* total) {
  constexpr std::size_t width = Pack<T>::width;
  std::size_t k = 0;
  for (; k + width <= n; k += width)
    for (const Pack<double>& part :
         promote(Pack<T>(hn::LoadU(typename Pack<T>::Tag(), from + k)))) {
      (Pack<double>::load(total) + part).store(total);
      total += Pack<double>::width;
    }
  for (; k < n; ++k) *total++ += from[k];
}

}  // namespace

void add_sums(const double* from, std::size_t n, double* total) { add(from, n, total); }
void add_sums(const float* from, std::size_t n, double* total) { add(from, n, total); }

}  // namespace polhode::POLHODE_LOOPS
