// SPDX-License-Identifier: MIT
// NumPy arrays of numbers that the library computed.
#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "polhode/base/column.hpp"

namespace polhode::python {

/// Makes an array that takes over the memory of a vector.
template <class T>
nanobind::object array_of(std::vector<T> values, std::initializer_list<std::size_t> shape) {
  auto kept = std::make_unique<std::vector<T>>(std::move(values));
  T* const data = kept->data();
  const nanobind::capsule owner(kept.release(),
                                [](void* p) noexcept { delete static_cast<std::vector<T>*>(p); });
  return nanobind::cast(nanobind::ndarray<nanobind::numpy, T>(data, shape, owner));
}

/// A new NumPy array with the rows of some columns.
template <std::size_t n>
nanobind::object rows_of(const Components<n>& columns) {
  const std::size_t size = columns.size();
  auto* const data = new double[std::max<std::size_t>(size * n, 1)];
  const nanobind::capsule owner(data, [](void* p) noexcept { delete[] static_cast<double*>(p); });
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = 0; const double x : columns.component(k)) data[n * i++ + k] = x;
  return nanobind::cast(nanobind::ndarray<nanobind::numpy, double>(data, {size, n}, owner));
}

/// Arrays of doubles that are passed to the library. The arrays are contiguous and stored by rows.
using Rows =
    nanobind::ndarray<const double, nanobind::ndim<2>, nanobind::c_contig, nanobind::device::cpu>;

/// A row of an array with three columns.
inline Vec3<double> row(const Rows& rows, std::size_t i) {
  const double* const x = rows.data() + 3 * i;
  return {x[0], x[1], x[2]};
}

}  // namespace polhode::python
