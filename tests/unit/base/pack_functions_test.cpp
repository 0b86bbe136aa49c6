// SPDX-License-Identifier: MIT
// Elementary functions of packs on every instruction set, against long double.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "../pack_loops.hpp"
#include "instruction_sets.hpp"
#include "polhode/base/column.hpp"

using namespace polhode;

namespace {

// The largest errors in units of the last place of the exact result.
struct Errors {
  double exp = 0, log = 0;
};

template <class T>
double ulps(T found, long double exact) {
  const T rounded = static_cast<T>(exact);
  const T unit =
      std::nextafter(std::abs(rounded), std::numeric_limits<T>::infinity()) - std::abs(rounded);
  return double(std::abs(found - exact) / unit);
}

template <class T>
Errors largest_errors(double low, double high) {
  const auto functions = POLHODE_CURRENT_OVERLOAD(elementary, void (*)(const T*, T*, T*));
  const std::size_t n = POLHODE_CURRENT_OVERLOAD(lanes_of, std::size_t(*)(const T*))(nullptr);
  Column<T> x(n), exponential(n), logarithm(n);
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> wide(low, high), narrow(-1, 1);
  Errors worst;
  for (int k = 0; k < 20'000; ++k) {
    for (std::size_t i = 0; i < n; ++i) x[i] = T(k % 2 ? wide(random) : narrow(random));
    functions(x.data(), exponential.data(), logarithm.data());  // eˣ and ln eˣ, rounded
    for (std::size_t i = 0; i < n; ++i) {
      worst.exp =
          std::max(worst.exp, ulps(exponential[i], std::exp(static_cast<long double>(x[i]))));
      const long double exact = std::log(static_cast<long double>(exponential[i]));
      if (exact != 0) worst.log = std::max(worst.log, ulps(logarithm[i], exact));
    }
  }
  return worst;
}

}  // namespace

// exp: the product by r and the last sum of the series round by half a unit each, the terms before
// by 0.35 of that and less, and r errs by 2⁻⁵⁵: below 1.5 units. log: s errs by a quotient and a
// sum, one unit, and the sum of two terms rounds; next to k ln 2 less. Never exact: an error of 0
// would say that nothing was tested.
TEST_CASE("exponentials and logarithms of packs err by less than 1.5 and 2.5 units") {
  for_each_instruction_set([] {
    for (const Errors& worst :
         {largest_errors<double>(-708, 709), largest_errors<float>(-87, 88)}) {
      CHECK(worst.exp < 1.5);
      CHECK(worst.exp > 0.4);
      CHECK(worst.log < 2.5);
      CHECK(worst.log > 0.4);
    }
  });
}

TEST_CASE("beyond their range exponentials of packs keep the value at its end") {
  for_each_instruction_set([] {
    const std::size_t n =
        POLHODE_CURRENT_OVERLOAD(lanes_of, std::size_t(*)(const double*))(nullptr);
    Column<double> x(n), e(n), l(n);
    for (const double beyond : {-1e4, 1e4}) {
      for (std::size_t i = 0; i < n; ++i) x[i] = beyond;
      POLHODE_CURRENT_OVERLOAD(elementary, void (*)(const double*, double*, double*))
      (x.data(), e.data(), l.data());
      CHECK(e[0] == doctest::Approx(std::exp(beyond < 0 ? -708.0 : 709.0)).epsilon(1e-15));
    }
  });
}

TEST_CASE("each lane reads its own entry of a table") {
  for_each_instruction_set([] {
    const std::size_t n = POLHODE_CURRENT_OVERLOAD(lanes_of, std::size_t(*)(const float*))(nullptr);
    Column<float> table(64), index(n), found(n);
    for (std::size_t k = 0; k < 64; ++k) table[k] = float(100 + k * k);
    for (std::size_t i = 0; i < n; ++i) index[i] = float(7 * i % 64);
    POLHODE_CURRENT_OVERLOAD(table_entries, void (*)(const float*, const float*, float*))
    (table.data(), index.data(), found.data());
    for (std::size_t i = 0; i < n; ++i) CHECK(found[i] == table[7 * i % 64]);
  });
}
