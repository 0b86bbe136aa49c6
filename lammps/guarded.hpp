// SPDX-License-Identifier: MIT
// Converts errors of the library to errors of LAMMPS.
#pragma once

#include <string>

#include "error.h"
#include "polhode/base/error.hpp"

namespace polhode::lammps {

/// Runs work and converts exceptions to LAMMPS errors. An Error occurs on all processes together,
/// but a RunError may occur on only one process.
/// @param style  name of the style for messages, such as "fix polhode"
template <class Work>
void guarded(LAMMPS_NS::Error* error, const char* style, const Work& work) {
  try {
    work();
  } catch (const Error& e) {
    const std::string place = e.where().empty() ? "" : ' ' + e.where() + ':';
    error->all(FLERR, std::string(style) + ':' + place + ' ' + e.what());
  } catch (const RunError& e) {
    error->one(FLERR, std::string(style) + ": " + e.what());
  }
}

}  // namespace polhode::lammps
