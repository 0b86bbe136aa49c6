// SPDX-License-Identifier: MIT
// pocketfft's algorithm on packs. It is a template on the number type, so with packs it transforms
// one series per lane at once.
#include "../fourier_loops.hpp"
#include "pack_series.hpp"
#include "polhode/base/pack_transpose.hpp"

namespace polhode::POLHODE_LOOPS {
namespace {

using pocketfft::detail::arr;
using pocketfft::detail::cmplx;

/// Transposes `width` rows from `row` on to columns[0, numbers), rounded up to whole packs.
/// Where fewer rows are left, the last one replaces those that are missing.
template <class T>
void load_rows(const RowsJob<T>& job, std::size_t row, std::size_t numbers, Pack<T>* columns) {
  for (std::size_t x = 0; x < numbers; x += Pack<T>::width)
    transpose<T>(
        [&](std::size_t i) {
          return Pack<T>::load(job.rows + std::min(row + i, job.count - 1) * job.stride + x);
        },
        columns + x);
}

template <class T>
void store_rows(const RowsJob<T>& job, std::size_t row, std::size_t numbers,
                const Pack<T>* columns) {
  constexpr std::size_t width = Pack<T>::width;
  for (std::size_t x = 0; x < numbers; x += width) {
    Pack<T> part[width];
    transpose<T>([&](std::size_t k) { return columns[x + k]; }, part);
    for (std::size_t i = 0; i < std::min(width, job.count - row); ++i)
      part[i].store(job.rows + (row + i) * job.stride + x);
  }
}

// pocketfft stores the coefficients of a real series as r0, r1, i1, r2, i2 ... From r1 on this is
// our order; the first imaginary part is missing, and for an even length the last.
template <class T>
void each_rows(const RowsJob<T>& job, bool forward) {
  constexpr std::size_t width = Pack<T>::width;
  const std::size_t n = job.length, modes = 2 * (n / 2 + 1);
  arr<Pack<T>> space(modes + 2 * width);
  Pack<T>*const series = space.data() + width, *const mode = series - 1;
  for (std::size_t row = 0; row < job.count; row += width) {
    if (forward) {
      load_rows(job, row, n, series);
      job.plan.exec(series, T(1), true);
      mode[0] = series[0];
      mode[1] = Pack<T>();
      for (std::size_t k = n + 1; k < modes + width; ++k) mode[k] = Pack<T>();
      store_rows(job, row, modes, mode);
    } else {
      load_rows(job, row, modes, mode);
      series[0] = mode[0];
      job.plan.exec(series, T(1), false);
      store_rows(job, row, n, series);
    }
  }
}

/// Real and imaginary parts of the modes in two packs, in some order: that of join().
template <class T>
cmplx<Pack<T>> split(Pack<T> a, Pack<T> b) {
#if HWY_TARGET == HWY_SCALAR
  return {a, b};
#else
  const typename Pack<T>::Tag tag;
  const auto low = hn::InterleaveLower(tag, a.v, b.v), high = hn::InterleaveUpper(tag, a.v, b.v);
  if constexpr (sizeof(T) == 8) {
    return {low, high};
  } else {  // two modes in 16 bytes
    const hn::RepartitionToWide<typename Pack<T>::Tag> pairs;
    const auto x = hn::BitCast(pairs, low), y = hn::BitCast(pairs, high);
    return {hn::BitCast(tag, hn::InterleaveLower(pairs, x, y)),
            hn::BitCast(tag, hn::InterleaveUpper(pairs, x, y))};
  }
#endif
}

/// The inverse of split(), which is itself.
template <class T>
cmplx<Pack<T>> join(const cmplx<Pack<T>>& mode) {
  return split(mode.r, mode.i);
}

template <class T>
void each_columns(const ColumnsJob<T>& job, bool forward) {
  using Real = Pack<T>;
  arr<cmplx<Real>> series(job.length);
  for (std::size_t x = 0; x < job.numbers; x += 2 * Real::width) {
    const bool both = x + Real::width < job.numbers;
    for (std::size_t k = 0; k < job.length; ++k) {
      const T* const from = job.from + k * job.from_stride + x;
      series[k] = split(Real::load(from), both ? Real::load(from + Real::width) : Real());
    }
    job.plan.exec(series.data(), T(1), forward);
    for (std::size_t k = 0; k < job.length; ++k) {
      T* const to = job.to + k * job.to_stride + x;
      const cmplx<Real> modes = join(series[k]);
      modes.r.store(to);
      if (both) modes.i.store(to + Real::width);
    }
  }
}

}  // namespace

void rows_to_modes(const RowsJob<double>& job) { each_rows(job, true); }
void rows_to_modes(const RowsJob<float>& job) { each_rows(job, true); }
void modes_to_rows(const RowsJob<double>& job) { each_rows(job, false); }
void modes_to_rows(const RowsJob<float>& job) { each_rows(job, false); }
void transform_columns(const ColumnsJob<double>& job, int sign) { each_columns(job, sign < 0); }
void transform_columns(const ColumnsJob<float>& job, int sign) { each_columns(job, sign < 0); }

}  // namespace polhode::POLHODE_LOOPS
