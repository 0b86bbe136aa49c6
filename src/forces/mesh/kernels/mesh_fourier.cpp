// SPDX-License-Identifier: MIT
// pocketfft's algorithm on packs. The algorithm is a template on the number type. With packs as
// numbers, the algorithm transforms one series per lane at once.
#include "base/pack_grid.hpp"
#include "forces/mesh/fourier_loops.hpp"
#include "pack_series.hpp"

namespace polhode::POLHODE_LOOPS {
namespace {

using pocketfft::detail::arr;
using pocketfft::detail::cmplx;

// Real and imaginary parts of the coefficients of a stack, one pack each, for k_z from 0 up to
// whole tiles. pocketfft stores the coefficients of a real series as r0, r1, i1, r2, i2, ... The
// order here is the same, except for a first imaginary part i0 = 0, which pocketfft omits. For an
// even length, pocketfft also omits the last imaginary part.
template <class T>
class StackSeries {
 public:
  using Real = Pack<T>;
  static std::size_t packs(const MeshModes<T>& modes) {
    return 2 * Tile<T>::columns * modes.columns_z();
  }

  StackSeries(Real* mode, const FourierRowJob<T>& job) : mode_(mode), job_(job) {}

  void transform(const T* stack) {
    const std::size_t n = job_.grid.points[2];
    Real* const series = mode_ + 1;
    for (std::size_t z = 0; z < n; ++z) series[z] = Real::load(stack + z * Real::width);
    for (std::size_t z = 0; z < job_.grid.overhang; ++z)
      series[z] += Real::load(stack + (n + z) * Real::width);
    job_.along_z.exec(series, T(1), true);
    mode_[0] = series[0];
    mode_[1] = Real();
    std::fill(mode_ + n + 1, mode_ + packs(job_.modes), Real());
  }
  void transform_back(T* stack) {
    const std::size_t n = job_.grid.points[2];
    Real* const series = mode_ + 1;
    series[0] = mode_[0];
    job_.along_z.exec(series, T(1), false);
    for (std::size_t z = 0; z < n; ++z) series[z].store(stack + z * Real::width);
    for (std::size_t z = 0; z < job_.grid.overhang; ++z)
      series[z].store(stack + (n + z) * Real::width);
  }

 private:
  Real* mode_;
  const FourierRowJob<T>& job_;
};

// The coefficients of a row of stacks between the transforms along z and along x.
template <class T>
class RowModes {
 public:
  using Real = Pack<T>;
  static constexpr std::size_t columns = Tile<T>::columns, rows = Tile<T>::rows;

  explicit RowModes(const FourierRowJob<T>& job)
      : job_(job),
        stride_(StackSeries<T>::packs(job.modes)),
        space_(stride_ * job.grid.stacks()),
        series_(job.grid.points[0]) {}

  StackSeries<T> stack(std::size_t n) { return {space_.data() + n * stride_, job_}; }
  T* values(std::size_t stack) {
    return &job_.grid.values[job_.row * job_.grid.row + stack * job_.grid.stack];
  }

  /// Transforms group z of k_z along x.
  void transform_group(std::size_t z) {
    for (std::size_t n = 0; n < job_.grid.stacks(); ++n)
      for (std::size_t part = 0; part < 2; ++part) {
        Real tile[columns];
        for (std::size_t k = 0; k < columns; ++k) tile[k] = *mode(n, z, k, part);
        Tile<T>::transpose_columns(tile);
        for (std::size_t c = 0; c < columns; ++c) part_of(series_[n * columns + c], part) = tile[c];
      }
    job_.along_x.exec(series_.data(), T(1), true);
    each_mode(z,
              [](cmplx<Real>& mode, T* at) { mode.r.store(at), mode.i.store(at + Real::width); });
  }
  void transform_group_back(std::size_t z) {
    each_mode(z, [](cmplx<Real>& mode, T* at) {
      mode = {Real::load(at), Real::load(at + Real::width)};
    });
    job_.along_x.exec(series_.data(), T(1), false);
    for (std::size_t n = 0; n < job_.grid.stacks(); ++n)
      for (std::size_t part = 0; part < 2; ++part) {
        Real tile[columns];
        for (std::size_t c = 0; c < columns; ++c) tile[c] = part_of(series_[n * columns + c], part);
        Tile<T>::transpose_columns(tile);
        for (std::size_t k = 0; k < columns; ++k) *mode(n, z, k, part) = tile[k];
      }
  }

 private:
  static Real& part_of(cmplx<Real>& mode, std::size_t part) { return part == 0 ? mode.r : mode.i; }
  Real* mode(std::size_t stack, std::size_t z, std::size_t k, std::size_t part) {
    return space_.data() + stack * stride_ + 2 * (z * columns + k) + part;
  }
  // Calls visit(mode, address) for each k_x of group z of k_z.
  template <class Visit>
  void each_mode(std::size_t z, const Visit& visit) {
    MeshModes<T>& modes = job_.modes;
    for (std::size_t x = 0; x < modes.columns_x(); ++x) {
      T* const column = &modes.values[modes.index(x, z) * modes.column];
      for (std::size_t k = 0; k < rows; ++k)
        visit(series_[x * rows + k], column + (job_.row * rows + k) * 2 * Real::width);
    }
  }

  const FourierRowJob<T>& job_;
  std::size_t stride_;
  arr<Real> space_;
  arr<cmplx<Real>> series_;
};

template <class T>
void to_modes(const FourierRowJob<T>& job) {
  RowModes<T> row(job);
  for (std::size_t n = 0; n < job.grid.stacks(); ++n) row.stack(n).transform(row.values(n));
  for (std::size_t z = 0; z < job.modes.columns_z(); ++z) row.transform_group(z);
}

template <class T>
void to_rows(const FourierRowJob<T>& job) {
  RowModes<T> row(job);
  for (std::size_t z = 0; z < job.modes.columns_z(); ++z) row.transform_group_back(z);
  for (std::size_t n = 0; n < job.grid.stacks(); ++n) row.stack(n).transform_back(row.values(n));
}

// Calls visit(modes, address) for each group of coefficients that fills a whole number of tiles.
template <class T, class Visit>
void each_tile(const ConvolveJob<T>& job, cmplx<Pack<T>>* series, const Visit& visit) {
  constexpr std::size_t rows = Tile<T>::rows;
  for (std::size_t y = 0; y < job.length; y += rows)
    visit(series + y, job.modes + y * 2 * Pack<T>::width);
}

template <class T>
void load_turned(const ConvolveJob<T>& job, cmplx<Pack<T>>* series) {
  using Real = Pack<T>;
  static constexpr std::size_t rows = Tile<T>::rows, width = Real::width;
  each_tile(job, series, [](cmplx<Real>* mode, const T* at) {
    Real real[rows], imaginary[rows];
    for (std::size_t k = 0; k < rows; ++k) {
      real[k] = Real::load(at + 2 * k * width);
      imaginary[k] = Real::load(at + (2 * k + 1) * width);
    }
    Tile<T>::transpose_rows(real), Tile<T>::transpose_rows(imaginary);
    for (std::size_t k = 0; k < rows; ++k) mode[k] = {real[k], imaginary[k]};
  });
}

template <class T>
void store_turned(const ConvolveJob<T>& job, cmplx<Pack<T>>* series) {
  using Real = Pack<T>;
  static constexpr std::size_t rows = Tile<T>::rows, width = Real::width;
  each_tile(job, series, [](const cmplx<Real>* mode, T* at) {
    Real real[rows], imaginary[rows];
    for (std::size_t k = 0; k < rows; ++k) real[k] = mode[k].r, imaginary[k] = mode[k].i;
    Tile<T>::transpose_rows(real), Tile<T>::transpose_rows(imaginary);
    for (std::size_t k = 0; k < rows; ++k) {
      real[k].store(at + 2 * k * width);
      imaginary[k].store(at + (2 * k + 1) * width);
    }
  });
}

// Sums over all k_y at one k_x and k_z per lane, in double precision.
template <class T>
class LaneSums {
 public:
  void add(const Pack<T>& what, double factor = 1) {
    const auto parts = promote(what);
    for (std::size_t h = 0; h < parts.size(); ++h)
      sum_[h] = fma(parts[h], Pack<double>(factor), sum_[h]);
  }
  void store(double* to) const {
    for (std::size_t h = 0; h < sum_.size(); ++h) sum_[h].store(to + h * Pack<double>::width);
  }

 private:
  decltype(promote(Pack<T>())) sum_{};
};

template <class T>
void sum_energies(const ConvolveJob<T>& job, const cmplx<Pack<T>>* series, ModeSums& sums) {
  using Real = Pack<T>;
  LaneSums<T> energy, slope, slope_y, slope_yy;
  for (std::size_t y = 0; y < job.length; ++y) {
    const std::size_t at = std::min(y, job.length - y) * Real::width;
    const Real square = series[y].r * series[y].r + series[y].i * series[y].i;
    const Real H = square * Real::load(job.slope + at);
    energy.add(square * Real::load(job.influence + at));
    slope.add(H);
    slope_y.add(H, job.odd_ky[y]);
    slope_yy.add(H, job.ky[y] * job.ky[y]);
  }
  energy.store(sums.energy), slope.store(sums.slope);
  slope_y.store(sums.slope_y), slope_yy.store(sums.slope_yy);
}

template <class T>
void convolve_column(const ConvolveJob<T>& job, ModeSums* sums) {
  using Real = Pack<T>;
  arr<cmplx<Real>> series(job.length);
  load_turned(job, series.data());
  job.along_y.exec(series.data(), T(1), true);
  if (sums) sum_energies(job, series.data(), *sums);
  for (std::size_t y = 0; y < job.length; ++y) {
    const Real G = Real::load(job.influence + std::min(y, job.length - y) * Real::width);
    series[y] = {G * series[y].r, G * series[y].i};
  }
  job.along_y.exec(series.data(), T(1), false);
  store_turned(job, series.data());
}

}  // namespace

void rows_to_modes(const FourierRowJob<double>& job) { to_modes(job); }
void rows_to_modes(const FourierRowJob<float>& job) { to_modes(job); }
void modes_to_rows(const FourierRowJob<double>& job) { to_rows(job); }
void modes_to_rows(const FourierRowJob<float>& job) { to_rows(job); }
void convolve(const ConvolveJob<double>& job, ModeSums* sums) { convolve_column(job, sums); }
void convolve(const ConvolveJob<float>& job, ModeSums* sums) { convolve_column(job, sums); }

}  // namespace polhode::POLHODE_LOOPS
