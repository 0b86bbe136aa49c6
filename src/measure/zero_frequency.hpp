// SPDX-License-Identifier: MIT
// The spectrum of a stationary series at zero frequency, which is the integral of its
// autocorrelation function.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace polhode {

/// Bins of neighbouring Fourier modes. Their widths grow with the mode number.
class ModeBins {
 public:
  /// @param modes  highest mode number of the last bin, approximately; mode 0 is in no bin
  explicit ModeBins(std::size_t modes);
  std::size_t size() const { return first_.size() - 1; }
  std::size_t first(std::size_t bin) const { return first_[bin]; }  ///< first mode of a bin
  std::size_t count(std::size_t bin) const { return first_[bin + 1] - first_[bin]; }
  double middle(std::size_t bin) const;  ///< mean mode number of a bin

 private:
  std::vector<std::size_t> first_;
};

/// The periodogram of a series, averaged over the modes of each bin: an estimate of the integral of
/// C(t) cos(2πνt) over all times, where C is the autocorrelation function and ν = k/T for mode k
/// and the length T. A taper at both ends removes the bias of order 1/T. The mean of the series
/// must be zero.
/// @param interval  time between samples
std::vector<double> binned_periodogram(std::span<const double> series, double interval,
                                       const ModeBins& bins);

/// Extrapolates a binned periodogram to zero frequency.
///
/// The logarithm of the spectrum is fitted by polynomials in ν² up to a cutoff frequency, with the
/// likelihood of a periodogram [toraman2025]. All degrees and cutoffs contribute with the
/// probabilities of [jay2021], in which each bin above the cutoff costs a parameter. The value of
/// each contribution is fitted up to half of its cutoff, or to as many bins as it has parameters.
/// The error from the omitted power of ν is there far below the statistical error.
class ZeroFrequency {
 public:
  /// Determines the probabilities of all degrees and cutoffs.
  /// @param mean    mean periodogram of independent series in each bin
  /// @param series  number of these series
  ZeroFrequency(std::span<const double> mean, double series, const ModeBins& bins);

  /// The spectrum at zero frequency for other means, with the same probabilities; NaN if a bin is
  /// not positive.
  double value(std::span<const double> mean) const;
  /// Mean of the highest mode numbers in the fits. If this number is small, the spectrum changes
  /// within the lowest modes, so the series are too short compared with their correlation time.
  double max_mode() const { return max_mode_; }
  /// Whether the fits reach modes that are high enough. With a fit of degree 2 up to half of its
  /// cutoff, the half must contain three modes.
  bool is_resolved() const { return max_mode_ >= 6; }

 private:
  /// A fit whose value contributes.
  struct Contribution {
    std::size_t degree, bins;
    double probability;
  };
  ModeBins bins_;
  std::vector<Contribution> contributions_;
  double max_mode_ = 0;
};

}  // namespace polhode
