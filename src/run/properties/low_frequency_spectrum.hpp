// SPDX-License-Identifier: MIT
// The low-frequency spectra of the pressure tensor and of the heat flux, from which the viscosity
// and the thermal conductivity follow.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "measure/zero_frequency.hpp"
#include "polhode/base/vec3.hpp"

namespace polhode {

/// The five independent components of a traceless symmetric tensor, which have equal variances in a
/// fluid [daivis1994].
inline constexpr std::size_t pressure_components = 5;
inline std::array<double, pressure_components> independent_components(const Mat3<double>& P) {
  const double xy = (P[0].y + P[1].x) / 2, yz = (P[1].z + P[2].y) / 2, zx = (P[2].x + P[0].z) / 2;
  return {(2 * P[0].x - P[1].y - P[2].z) / (2 * std::sqrt(3.0)), (P[1].y - P[2].z) / 2, yz, zx, xy};
}

/// The mean spectrum of components with equal variances, of a trajectory.
template <std::size_t components>
class LowFrequencySpectrum {
 public:
  /// @param samples   number of samples of the trajectory
  /// @param interval  time between samples [ps]
  LowFrequencySpectrum(std::size_t samples, double interval) : interval_(interval) {
    series_.fill(Column<double>(samples));
  }
  /// Adds the next sample; samples beyond the stated number are ignored.
  void add(const std::array<double, components>& now) {
    if (count_ == series_.front().size()) return;
    for (std::size_t k = 0; k < components; ++k) series_[k][count_] = now[k];
    ++count_;
  }
  /// The mean spectrum of the components in each bin [square of the unit of a component, times ps].
  std::vector<double> means(const ModeBins& bins) const {
    std::vector<double> mean(bins.size());
    for (const Column<double>& series : series_) {
      const std::vector<double> one = binned_periodogram(series.values(), interval_, bins);
      for (std::size_t b = 0; b < mean.size(); ++b) mean[b] += one[b] / components;
    }
    return mean;
  }

 private:
  double interval_;
  std::size_t count_ = 0;
  std::array<Column<double>, components> series_;
};

}  // namespace polhode
