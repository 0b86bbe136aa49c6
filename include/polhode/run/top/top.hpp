// SPDX-License-Identifier: MIT
// One free top: its exact rotation, and both integrators step by step.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "polhode/rotor/free_rotation.hpp"
#include "polhode/run/quantities.hpp"

namespace polhode {

/// Rejects moments of no rigid body, and an angular momentum that is not possible for it.
/// @param name_J  name of the moments in the input: "I" for I1, I2, I3
/// @param where   place of the input, for errors
/// @throws Error  with the name and the value
void check_top(const Vec3<double>& J, const Vec3<double>& L, double t, const std::string& name_J,
               const std::string& where);

/// State of an integrator during a trajectory, with its errors.
struct TopTrack {
  Quaternion<double> orientation;
  Vec3<double> L;                               ///< body frame
  double energy_error = 0, momentum_error = 0;  ///< relative
  double angle = 0;  ///< between its orientation and the closed form [rad]
};

struct TopSample {
  double t = 0;
  FreeRotation exact;  ///< closed form
  TopTrack series, no_squish;
};

struct TopTrajectory {
  double step = 0;                 ///< time step in the units of J and L
  double angle = 0;                ///< angle by which the top initially turns in a step [rad]
  std::vector<TopSample> samples;  ///< the start, and about 20 more
  bool interrupted = false;        ///< interrupted before the end; the samples are up to there
};

/// Integrates a top by the series and by NO_SQUISH.
/// @param step    0: the top initially turns by 0.2 in a step
/// @param length  0: 200 steps
/// @param stop    asked now and then, true ends the integration
/// @throws Error  as check_top(), or if there are not 1 to 10⁸ steps
TopTrajectory integrate_top(const Vec3<double>& J, const Vec3<double>& L, double step = 0,
                            double length = 0, const std::function<bool()>& stop = {});

/// The samples as a table.
Quantities quantities(const TopTrajectory& trajectory);

/// Rotates the tops of a CSV file with columns I1, I2, I3, L1, L2, L3, t. All rows are checked and
/// computed before the text is returned.
/// @return  CSV with 17 digits: rotation matrix, the same as a quaternion, and L in the body frame
/// @throws Error  with file and line
std::string rotate_table(const std::string& file, RotorMethod method);

}  // namespace polhode
