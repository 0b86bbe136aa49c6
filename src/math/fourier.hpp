// SPDX-License-Identifier: MIT
// Fourier transforms of real series.
#pragma once

#include <complex>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "polhode/base/column.hpp"

namespace polhode {

/// Forward and backward Fourier transforms of real series of one length. The transforms are not
/// normalized: a forward and a backward transform multiply a series by its length. Results are
/// bitwise identical in every run.
class RealTransform {
 public:
  /// @param min_length  minimum length; the actual length is the next product of small primes
  explicit RealTransform(std::size_t min_length);
  ~RealTransform();
  RealTransform(RealTransform&&) noexcept;

  std::size_t size() const { return size_; }
  std::size_t modes() const { return size_ / 2 + 1; }

  /// The forward transform, modes[k] = Σ series[j] exp(−2πi jk/size). Several threads may call
  /// forward() at the same time if each thread has its own columns.
  void forward(Column<double>& series, Column<std::complex<double>>& modes) const;
  /// The backward transform, which overwrites `modes`.
  void backward(Column<std::complex<double>>& modes, Column<double>& series) const;

 private:
  struct Plans;
  std::size_t size_;
  std::unique_ptr<Plans> plans_;
};

/// The cosine transform ∫₀^T C(t) cos(2πνt) dt by the trapezoidal rule, for ν = k/(2T). C is given
/// at times 0, `interval`, 2 `interval` and so on.
std::vector<double> cosine_transform(std::span<const double> values, double interval);

}  // namespace polhode
