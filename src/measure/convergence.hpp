// SPDX-License-Identifier: MIT
// Decides whether a run is long enough for a result, so that unconverged numbers are not reported
// as results.
#pragma once

#include "polhode/measure/correlated_series.hpp"

namespace polhode {

/// The reasons why a number is not converged.
enum class Obstacle {
  none,
  length,            ///< the run is too short
  no_error,          ///< the error is not known
  still_moving,      ///< the quantity still changes along the run
  slope_changes,     ///< the slopes in the two halves of the fit window differ
  integral_changes,  ///< the integral up to half of the largest lag differs from the whole integral
  interval           ///< the integrand is sampled too rarely
};

/// The length of a run, the length that a result needs, and the obstacle if the result is not
/// converged.
struct Convergence {
  double length = 0;  ///< actual length of the run [ps]
  double relaxation =
      0;  ///< relaxation time of the quantity, or the largest lag that contributes to it [ps]
  double needed = 0;        ///< needed length [ps]: a multiple of the relaxation time, or twice the
                            ///< actual length if that multiple does not suffice
  const char* unit = "ps";  ///< unit of the length and times; "frames" if the frames have no times
  Obstacle obstacle = Obstacle::none;
  double interval = 0;    ///< sufficient interval between frames [ps], if it is the obstacle
  double min_window = 0;  ///< shortest window of lags from which the result follows: two intervals
                          ///< between frames [ps]

  bool converged() const { return obstacle == Obstacle::none; }
};

/// Makes a Convergence.
/// @param multiple  needed length in units of the relaxation time
/// @param other     other obstacle, which applies if the run is long enough
Convergence convergence(double length, double relaxation, double multiple,
                        Obstacle other = Obstacle::none);

/// The needed length for the dielectric constant, in relaxation times. For a run of this length,
/// the relative error of the dielectric constant is √(2/3 · 1/30) = 15 %. Subtracting the mean of
/// the dipole moment M, which should vanish, reduces ε by 2/30.
inline constexpr double relaxations_of_dipole = 30;
/// The needed run length for functions of the time lag, in units of the longest lag. Shorter runs
/// do not give reliable errors.
inline constexpr double windows_of_lags = 8;

/// The relaxation time ∫₀^∞ ⟨M(0)·M(t)⟩ dt/⟨M²⟩ of a vector whose true mean is zero, in units of
/// the run length. A part of the run with mean M̄ gives the estimate ½ f |M̄|²/⟨M²⟩, where f is the
/// part's fraction of the run. The estimates from the whole run, its halves and its quarters are
/// averaged. The result is 0.29 for a vector that hardly changes during the run. For long runs the
/// result is τ/T, with a scatter of about half of τ/T.
/// @param x       column of the first of three vector components in the block sums
/// @param square  index of M²
double relaxation_share(const BlockMeans& blocks, std::size_t x, std::size_t square);

/// Whether a statistic still changes along the run. A statistic changes if its values for the first
/// half and for the whole run differ by more than three_sigma(). The standard error of the
/// statistic is also the standard deviation of the difference between the values for the first half
/// and for the whole run. The result is false if the standard error is not known.
bool still_moving(const BlockMeans& blocks, const SeriesEstimate& whole,
                  const std::function<double(std::span<const double>)>& statistic);

/// Whether a difference that should be zero, such as the difference of two values of D from
/// different lags, is significant. A significant difference must exceed both three_sigma() and 10 %
/// of the value.
bool differs(const SeriesEstimate& difference, double value);

/// Whether a systematic error of a result matters. A systematic error matters if it exceeds both
/// three_sigma() and the standard error of the result.
bool matters(const SeriesEstimate& systematic, const SeriesEstimate& result);

}  // namespace polhode
