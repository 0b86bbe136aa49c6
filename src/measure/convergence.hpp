// SPDX-License-Identifier: MIT
// Whether a run is long enough for a result, so that a number that it cannot determine is not
// taken for one.
#pragma once

#include "polhode/measure/correlated_series.hpp"

namespace polhode {

/// Why a number is no result.
enum class Obstacle {
  none,
  length,            ///< the run is shorter than needed
  no_error,          ///< its error is not known
  still_moving,      ///< it still changes along the run
  slope_changes,     ///< of the line from which it is computed: between the halves of the line
  integral_changes,  ///< between half of the largest lag and all of it
  interval           ///< the integrand is sampled too rarely
};

/// Length of a run, and the length that a result needs.
struct Convergence {
  double length = 0;      ///< of the run [ps]
  double relaxation = 0;  ///< relaxation time of the quantity, or the largest lag from which it is
                          ///< computed [ps]
  double needed = 0;      ///< a multiple of it; twice the length where that does not suffice [ps]
  const char* unit = "ps";  ///< "frames" for all three if the frames have no times
  Obstacle obstacle = Obstacle::none;
  double interval = 0;  ///< that would do, if the obstacle is the interval between frames [ps]

  bool converged() const { return obstacle == Obstacle::none; }
};

/// @param multiple  of the relaxation time that is needed
/// @param other     what else is an obstacle, if the run is long enough
Convergence convergence(double length, double relaxation, double multiple,
                        Obstacle other = Obstacle::none);

/// Needed lengths, in relaxation times.
/// ε: its relative error then is √(2/3 · 1/30) = 15 %, and the mean of M, which ought to vanish,
/// lowers it by 2/30.
inline constexpr double relaxations_of_dipole = 30;
/// Of functions of a lag: the minimum number of windows for calibrated errors.
inline constexpr double windows_of_lags = 8;

/// The relaxation time of a vector whose true mean is zero, ∫₀^∞ ⟨M(0)·M(t)⟩ dt/⟨M²⟩, in units of
/// the length of the run: half of |M̄|²/⟨M²⟩, with M̄ the mean over a part of the run, times the
/// fraction that the part is; averaged over the whole run, its halves and quarters. It is 0.29 for
/// a vector that hardly changes in the run, and for long runs τ/T with a scatter of about half of
/// that.
/// @param x       the first of its three components among the sums of the blocks
/// @param square  M²
double relaxation_share(const BlockMeans& blocks, std::size_t x, std::size_t square);

/// Whether a statistic still changes along the run: over its first half it differs from that over
/// the whole run by more than three_sigma(); its standard error is also the standard deviation of
/// this difference. False if the error is not known.
bool still_moving(const BlockMeans& blocks, const SeriesEstimate& whole,
                  const std::function<double(std::span<const double>)>& statistic);

/// Whether a difference that ought to vanish, such as that of two values of D from different lags,
/// does not: it exceeds three_sigma(), and a tenth of the value.
bool differs(const SeriesEstimate& difference, double value);

/// Whether a systematic error of a result matters: it exceeds three_sigma(), and the standard error
/// of the result.
bool matters(const SeriesEstimate& systematic, const SeriesEstimate& result);

}  // namespace polhode
