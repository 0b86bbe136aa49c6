// SPDX-License-Identifier: MIT
// Packs on every instruction set: conversion to and from records, integers, inverse powers.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <random>

#include "../pack_loops.hpp"
#include "instruction_sets.hpp"
#include "polhode/base/column.hpp"

using namespace polhode;

namespace {

constexpr std::size_t max_width = 16;  // numbers in the widest pack

template <class T>
std::size_t width() {
  return POLHODE_CURRENT_OVERLOAD(lanes_of, std::size_t(*)(const T*))(nullptr);
}

template <class T>
void check_transpose() {
  const std::size_t n = width<T>();
  Column<T> row(n * n), column(n * n);
  for (std::size_t k = 0; k < n * n; ++k) row[k] = T(k);
  POLHODE_CURRENT_OVERLOAD(transposed, void (*)(const T*, T*))(row.data(), column.data());
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < n; ++k) CHECK(column[k * n + i] == row[i * n + k]);
}

// Whole numbers are added, so that the order of a sum does not matter.
template <class T>
void check_records() {
  const std::size_t n = width<T>();
  Column<T> value(6 * n);
  for (std::size_t k = 0; k < 6; ++k)
    for (std::size_t lane = 0; lane < n; ++lane) value[k * n + lane] = T(100 * k + 3 * lane + 1);
  std::array<std::uint32_t, max_width> index{};
  for (std::size_t lane = 0; lane < n; ++lane) index[lane] = std::uint32_t(7 * lane % 5);  // shared
  if (n > 1) index[1] = index[0];
  Column<T> records(8 * 8);
  for (std::size_t k = 0; k < 64; ++k) records[k] = T(k);
  Column<T> expected = records, record = records, sums = records;
  for (std::size_t lane = 0; lane < n; ++lane)
    for (std::size_t k = 0; k < 6; ++k) {
      expected[8 * index[lane] + k] += value[k * n + lane];
      record[k] += value[k * n + lane];
    }
  POLHODE_CURRENT_OVERLOAD(added_to_records, void (*)(const T*, const std::uint32_t*, T*))
  (value.data(), index.data(), records.data());
  POLHODE_CURRENT_OVERLOAD(added_sums, void (*)(const T*, T*))(value.data(), sums.data());
  for (std::size_t k = 0; k < 64; ++k) {
    CAPTURE(k);
    CHECK(records[k] == expected[k]);
    CHECK(sums[k] == record[k]);
  }
}

// Relative errors of 1/r, 1/r², 1/r³ in units of half an ulp at most.
template <class T>
std::array<double, 3> worst_inverse_powers() {
  constexpr double half_ulp = sizeof(T) == 8 ? 0x1p-53 : 0x1p-24;
  const std::size_t n = width<T>();
  const auto powers = POLHODE_CURRENT_OVERLOAD(inverse_powers, void (*)(const T*, T*, T*, T*));
  Column<T> r2(n), first(n), second(n), third(n);
  std::array<double, 3> worst{};
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> uniform(-10, 10);
  constexpr std::size_t dense = 1 << 15;  // of the two binades that any estimate repeats
  for (std::size_t k = 0; k < dense + 4096; k += n) {
    for (std::size_t i = 0; i < n; ++i)
      r2[i] = k < dense ? T(1 + 3 * double(k + i) / dense) : T(std::exp2(uniform(random)));
    powers(r2.data(), first.data(), second.data(), third.data());
    for (std::size_t i = 0; i < n; ++i) {
      const long double a = r2[i], r = std::sqrt(a);
      const auto error = [&](T x, long double exact) {
        return double(std::abs(x / exact - 1)) / half_ulp;
      };
      worst[0] = std::max(worst[0], error(first[i], 1 / r));
      worst[1] = std::max(worst[1], error(second[i], 1 / a));
      worst[2] = std::max(worst[2], error(third[i], 1 / (a * r)));
    }
  }
  return worst;
}

}  // namespace

TEST_CASE("a square of numbers is transposed") {
  for_each_instruction_set([] {
    check_transpose<double>();
    check_transpose<float>();
  });
}

TEST_CASE("columns are added to records, also to one record from several lanes") {
  for_each_instruction_set([] {
    check_records<double>();
    check_records<float>();
  });
}

// In halves of an ulp, u. e = 1 − a y² errs by 2 u, of y² and of the product, and enters 1/rⁿ with
// n/2; the terms left out are below half of one u (docs of InversePowers) or 1 u for n = 3; sums
// and products round by 1 u each. First: 1 + 2/2 + 1/2. Second: 2 + 1 + 1 + 1/2, one more for y y.
// Third: 3 + 1 + 1 + 1 + 1. Without an estimate, in the scalar packs: y errs by 2, powers by 2 n,
// and by 1 for each product. Not exact: an error of 0 would mean that nothing was tested.
TEST_CASE("inverse powers err by a few roundings") {
  for_each_instruction_set([] {
    const bool scalar = current_instruction_set() == InstructionSet::scalar;
    const std::array<double, 3> bound =
        scalar ? std::array{2.0, 5.0, 8.0} : std::array{2.5, 5.5, 7.0};
    const auto check = [&](const std::array<double, 3>& worst) {
      for (std::size_t k = 0; k < 3; ++k) {
        CAPTURE(k);
        CHECK(worst[k] <= bound[k]);
        CHECK(worst[k] > 0.5);
      }
    };
    check(worst_inverse_powers<double>());
    check(worst_inverse_powers<float>());
  });
}

// Differences overflow from end to end: the shorter way around 2³² units.
TEST_CASE("fixed-point differences are exact before rounding, and wrap") {
  for_each_instruction_set([] {
    const std::size_t n = width<float>();
    constexpr std::int32_t end = 0x7fffffff;
    const std::array<std::int32_t, 8> numbers{0,        1,   -1,        1 << 30,
                                              -end - 1, end, 123456789, -(1 << 30) + 3};
    Column<std::int32_t> p(n), q(n), sum(n);
    Column<float> read(n), in_pack(n);
    for (std::size_t shift = 0; shift < numbers.size(); ++shift) {
      for (std::size_t i = 0; i < n; ++i) {
        p[i] = numbers[(i + shift) % numbers.size()];
        q[i] = numbers[(3 * i + shift) % numbers.size()];
      }
      for (const std::int32_t from : numbers) {
        POLHODE_CURRENT_LOOPS(fixed_differences)(p.data(), from, read.data(), in_pack.data());
        for (std::size_t i = 0; i < n; ++i) {
          const auto bits = std::uint32_t(p[i]) - std::uint32_t(from);
          CHECK(read[i] == float(std::int32_t(bits)));
          CHECK(in_pack[i] == read[i]);
        }
      }
      POLHODE_CURRENT_LOOPS(fixed_sums)(p.data(), q.data(), sum.data());
      for (std::size_t i = 0; i < n; ++i)
        CHECK(std::uint32_t(sum[i]) == std::uint32_t(p[i]) + std::uint32_t(q[i]));
    }
  });
}

TEST_CASE("doubles are converted to the nearest floats and integers, in order") {
  for_each_instruction_set([] {
    const std::size_t n = width<float>();
    Column<double> x(n);
    Column<float> rounded(n);
    Column<std::int32_t> fixed(n);
    for (std::size_t i = 0; i < n; ++i) x[i] = (i % 2 ? -1 : 1) * (1e8 / 3 * double(i) + 0.7);
    POLHODE_CURRENT_LOOPS(all_narrowed)(x.data(), rounded.data(), fixed.data());
    for (std::size_t i = 0; i < n; ++i) {
      CHECK(rounded[i] == float(x[i]));
      CHECK(fixed[i] == std::lround(x[i]));
    }
  });
}

TEST_CASE("numbers are gathered by their indices") {
  for_each_instruction_set([] {
    const std::size_t n = width<double>();
    Column<double> from(100), to(n);
    std::array<std::uint32_t, max_width> index{};
    for (std::size_t k = 0; k < 100; ++k) from[k] = double(k) + 0.5;
    for (std::size_t i = 0; i < n; ++i) index[i] = std::uint32_t((37 * i + 11) % 100);
    POLHODE_CURRENT_LOOPS(all_gathered)(from.data(), index.data(), to.data());
    for (std::size_t i = 0; i < n; ++i) CHECK(to[i] == from[index[i]]);
  });
}

TEST_CASE_TEMPLATE("packs keep numbers within bounds", T, float, double) {
  for_each_instruction_set([] {
    Column<T> x(width<T>()), to(width<T>());
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = T(i) / 2 - 1;
    POLHODE_CURRENT_OVERLOAD(within_bounds, void (*)(const T*, T, T, T*))
    (x.data(), T(-0.25), T(0.25), to.data());
    for (std::size_t i = 0; i < x.size(); ++i) CHECK(to[i] == std::clamp(x[i], T(-0.25), T(0.25)));
  });
}

TEST_CASE("the lanes of a mask are counted and stored in their order") {
  for_each_instruction_set([] {
    const std::size_t n = width<float>();
    Column<float> x(n);
    POLHODE_CURRENT_LOOPS(lanes_in_order)(x.data());
    for (std::size_t i = 0; i < n; ++i) CHECK(x[i] == float(i));
    std::mt19937_64 random(2);
    for (std::uint32_t k = 0; k < 600; ++k) {  // includes each mask of eight lanes
      const std::uint64_t mask = k < 256 ? k : k == 256 ? ~std::uint64_t{0} : random();
      for (std::size_t i = 0; i < n; ++i) x[i] = float(i + 1) * (mask >> i & 1 ? -1.0F : 1.0F);
      std::array<std::uint32_t, 2 * max_width> numbers;
      std::array<float, 2 * max_width> values;
      numbers.fill(99);
      values.fill(99);
      const std::size_t count = POLHODE_CURRENT_LOOPS(negative_lanes)(
          x.data(), 4000000000, 1 + k % 3, values.data(), numbers.data());
      std::size_t expected = 0;
      for (std::uint32_t i = 0; i < n; ++i)
        if (mask >> i & 1) {
          CHECK(values[expected] == -float(i + 1));
          CHECK(numbers[expected++] == 4000000000 + i * (1 + k % 3));
        }
      CHECK(count == expected);
      CHECK(numbers[n] == 99);  // a pack is written at most
      CHECK(values[n] == 99);
    }
  });
}
