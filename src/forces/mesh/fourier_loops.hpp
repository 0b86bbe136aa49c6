// SPDX-License-Identifier: MIT
// Fourier transforms of many series at once, one in each lane of a pack, by pocketfft.
#pragma once

#include <cstddef>

#include "../../math/pocketfft.hpp"
#include "polhode/base/instruction_set.hpp"

namespace polhode {

/// Rows of real numbers, transformed in place to Fourier coefficients
/// and back. A coefficient is a real and an imaginary part; a row has room for length/2 + 1 of them
/// and then for a whole number of packs.
template <class T>
struct RowsJob {
  const pocketfft::detail::rfftp<T>& plan;
  T* rows;
  std::size_t length, count, stride;  ///< numbers of a row, rows, and numbers from row to row
};

/// Columns of Fourier coefficients: the n-th of each of `length` rows, for all n. Padding up to
/// whole packs is transformed as well.
template <class T>
struct ColumnsJob {
  const pocketfft::detail::cfftp<T>& plan;
  std::size_t length;
  std::size_t numbers;  ///< of a row: whole packs
  const T* from;
  std::size_t from_stride;  ///< numbers from row to row
  T* to;
  std::size_t to_stride;
};

POLHODE_DECLARE_LOOPS(
    /// Σ_x row[x] exp(−2πi kx/length), followed by zeros up to whole packs.
    void rows_to_modes(const RowsJob<double>& job); void rows_to_modes(const RowsJob<float>& job);
    /// The inverse times the length.
    void modes_to_rows(const RowsJob<double>& job); void modes_to_rows(const RowsJob<float>& job);
    /// Transforms columns, with the sign −1 or +1 in the exponent; not normalized.
    void transform_columns(const ColumnsJob<double>& job, int sign);
    void transform_columns(const ColumnsJob<float>& job, int sign);)

}  // namespace polhode
