// SPDX-License-Identifier: MIT
// The settings of a run file, with forces that are Python functions.
#pragma once

#include <nanobind/nanobind.h>

#include <string>

#include "polhode/io/settings/config.hpp"

namespace polhode::python {

/// Makes external forces from a Python function. The function is called with copies of the
/// positions (n, 3) [nm], orientations (n, 4) and box (3) [nm]. The function returns forces (n, 3),
/// torques (n, 3), an energy, and a virial (3, 3) or None, as checked arrays of doubles. The
/// reference to the function is weak, so the caller must keep the function alive.
/// @param name  name as in ExternalForces
std::shared_ptr<const ExternalForces> external_forces(const nanobind::callable& function,
                                                      const std::string& name, bool has_virial);

}  // namespace polhode::python
