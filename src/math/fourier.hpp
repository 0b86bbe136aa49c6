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

/// Forward and backward transforms of one length, not normalized: together they multiply by the
/// length. Results are the same in every run.
class RealTransform {
 public:
  /// @param min_length  minimum length; the actual length is the next product of small primes
  explicit RealTransform(std::size_t min_length);
  ~RealTransform();
  RealTransform(RealTransform&&) noexcept;

  std::size_t size() const { return size_; }
  std::size_t modes() const { return size_ / 2 + 1; }

  /// modes[k] = Σ series[j] exp(−2πi jk/size). May be called from any thread on its own columns.
  void forward(Column<double>& series, Column<std::complex<double>>& modes) const;
  /// The inverse transform; `modes` is overwritten.
  void backward(Column<std::complex<double>>& modes, Column<double>& series) const;

 private:
  struct Plans;
  std::size_t size_;
  std::unique_ptr<Plans> plans_;
};

/// ∫₀^T C(t) cos(2πνt) dt by the trapezoidal rule, for ν = k/(2T) and C at intervals of `interval`.
std::vector<double> cosine_transform(std::span<const double> values, double interval);

}  // namespace polhode
