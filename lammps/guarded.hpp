// SPDX-License-Identifier: MIT
// Errors of the library become errors of LAMMPS.
#pragma once

#include <string>

#include "error.h"
#include "polhode/base/error.hpp"

namespace polhode::lammps {

/// Runs work. All processes meet an Error together; a RunError may be that of one.
/// @param style  "fix polhode"
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
