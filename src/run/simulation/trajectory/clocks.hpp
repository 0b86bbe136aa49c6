// SPDX-License-Identifier: MIT
// The computing time of the parts of a trajectory.
#pragma once

#include <algorithm>

#include "base/stopwatch.hpp"
#include "forces/timed_forces.hpp"
#include "polhode/run/simulation/trajectory/trajectory.hpp"

namespace polhode {

/// Measures the computing time of each part of the program; for a resumed run, the time before the
/// interruption is added.
class Clocks {
 public:
  /// @param near  near forces of an optional inner scheme
  Clocks(const TimedForces& whole, const TimedForces* near, const Timings& earlier)
      : whole_(whole),
        near_(near),
        earlier_(earlier),
        list_before_(in_list(&whole)),
        near_list_before_(in_list(near)) {}
  double in_forces() const { return whole_.seconds + (near_ ? near_->seconds : 0); }
  /// Adds the time since the last call of this function or skip_pause() to drifts, kicks and
  /// forces.
  void add_motion() { motion_ += part_.lap(); }
  void skip() { part_.lap(); }
  void forces_of_sample(double seconds) { forces_of_samples_ += seconds; }
  /// Discards the time since the last call, because it is not part of the trajectory.
  void skip_pause() {
    run_.lap();
    skip();
  }
  Timings timings() {
    all_ += run_.lap();
    const double list = in_list(&whole_) - list_before_;
    const double near_list = in_list(near_) - near_list_before_;
    const double motion = motion_ - (in_forces() - forces_of_samples_);
    return {earlier_.forces + whole_.seconds - list, earlier_.list + list + near_list,
            earlier_.motion + motion,
            earlier_.measurement + std::max(0.0, all_ - in_forces() - motion),
            earlier_.near + (near_ ? near_->seconds : 0) - near_list};
  }

 private:
  static double in_list(const TimedForces* timed) { return timed ? timed->in_list() : 0; }

  const TimedForces& whole_;
  const TimedForces* near_;
  Timings earlier_;
  double list_before_, near_list_before_;
  double all_ = 0, motion_ = 0;
  double forces_of_samples_ = 0;  // schemes that end with a drift need forces for the energy
  Stopwatch run_, part_;
};

}  // namespace polhode
