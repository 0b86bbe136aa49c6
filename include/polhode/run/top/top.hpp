// SPDX-License-Identifier: MIT
// A free top: the exact rotation, and the trajectories of two integrators for comparison.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "polhode/rotor/free_rotation.hpp"
#include "polhode/run/quantities.hpp"

namespace polhode {

/// Checks that principal moments belong to a rigid body, and that this body can have the angular
/// momentum.
/// @param name_J  name of the moments in the input, such as "I" for I1, I2, I3
/// @param where   place of the input, for errors
/// @throws Error  with the name and the value
void check_top(const Vec3<double>& J, const Vec3<double>& L, double t, const std::string& name_J,
               const std::string& where);

/// The state of an integrator along a top trajectory, with its errors.
struct TopTrack {
  Quaternion<double> orientation;
  Vec3<double> L;                               ///< angular momentum in the body frame
  double energy_error = 0, momentum_error = 0;  ///< relative errors of energy and angular momentum
  double angle = 0;  ///< angle between the orientation and the exact orientation (closed form)
                     ///< [rad]
};

struct TopSample {
  double t = 0;
  FreeRotation exact;  ///< rotation by the closed form
  TopTrack series, no_squish;
};

struct TopTrajectory {
  double step = 0;                 ///< time step in the units of J and L
  double angle = 0;                ///< angle by which the top initially turns in a step [rad]
  std::vector<TopSample> samples;  ///< samples at the start and at about 20 later times
  bool interrupted = false;        ///< true if interrupted; the samples end at the interruption
};

/// Integrates a free top by the series and by NO_SQUISH.
/// @param step    time step; if 0, the time in which the top initially turns by 0.2 rad
/// @param length  length of the trajectory; 0 for 200 steps
/// @param stop    called at intervals; the integration ends when `stop` returns true
/// @throws Error  under the same conditions as check_top(), or if there are not 1 to 10⁸ steps
TopTrajectory integrate_top(const Vec3<double>& J, const Vec3<double>& L, double step = 0,
                            double length = 0, const std::function<bool()>& stop = {});

/// The samples of a top trajectory as a table.
Quantities quantities(const TopTrajectory& trajectory);

/// Rotates the tops of a CSV file with columns I1, I2, I3, L1, L2, L3, t. All rows are checked and
/// computed before the text is returned.
/// @return  CSV with 17 digits: rotation matrix, equivalent quaternion, and L in the body frame
/// @throws Error  with file and line
std::string rotate_table(const std::string& file, RotorMethod method);

}  // namespace polhode
