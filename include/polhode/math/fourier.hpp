// SPDX-License-Identifier: MIT
// Fourier transforms of series of real numbers.
#pragma once

#include <complex>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "polhode/base/column.hpp"

namespace polhode {

/// Transforms of one length, there and back without a factor: together they multiply by the length.
/// Plans are estimated, not measured, so that they do not vary from run to run.
class RealTransform {
 public:
  /// @param least  shortest length wanted; the length is the next product of small primes
  explicit RealTransform(std::size_t least);
  ~RealTransform();
  RealTransform(RealTransform&&) noexcept;

  std::size_t size() const { return size_; }
  std::size_t waves() const { return size_ / 2 + 1; }

  /// waves[k] = Σ series[j] exp(−2πi jk/size). Any thread may call it, on columns of its own.
  void forward(Column<double>& series, Column<std::complex<double>>& waves) const;
  /// The way back; `waves` is overwritten.
  void backward(Column<std::complex<double>>& waves, Column<double>& series) const;

 private:
  struct Plans;
  std::size_t size_;
  std::unique_ptr<Plans> plans_;
};

/// ∫₀^T C(t) cos(2πνt) dt by the trapezoidal rule, for ν = k/(2T) and C at steps of `interval`.
std::vector<double> cosine_transform(std::span<const double> values, double interval);

}  // namespace polhode
