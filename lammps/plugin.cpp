// SPDX-License-Identifier: MIT
// The plugin: `plugin load polhodeplugin.so` adds the fix style polhode to LAMMPS.
#include <string>

#include "abi.hpp"
#include "error.h"
#include "fix_polhode.hpp"
#include "lammps.h"
#include "library.h"
#include "polhode/base/version.hpp"

namespace {

using LAMMPS_NS::LAMMPS;

LAMMPS_NS::Fix* create_fix(LAMMPS* lammps, int count, char** arguments) {
  return new polhode::lammps::FixPolhode(lammps, count, arguments);
}

// Classes of LAMMPS differ from version to version; with other ones the plugin would crash.
void check_version(LAMMPS* lammps) {
  if (lammps->num_ver != POLHODE_LAMMPS_VERSION)
    lammps->error->all(FLERR,
                       "the plugin of polhode was built for LAMMPS version {} and this is version "
                       "{} ({}); build it again with the headers of this LAMMPS",
                       POLHODE_LAMMPS_VERSION, lammps->num_ver, lammps->version);
  const int tag_size = lammps_extract_setting(lammps, "tagint");
  if (tag_size != static_cast<int>(sizeof(LAMMPS_NS::tagint)))
    lammps->error->all(FLERR,
                       "the plugin of polhode was built for atom ids of {} bytes and those of this "
                       "LAMMPS have {}; build it again with POLHODE_LAMMPS_SIZES as LAMMPS was",
                       sizeof(LAMMPS_NS::tagint), tag_size);
}

}  // namespace

void lammpsplugin_init(void* lammps, void* handle, void* add) {
  auto* const instance = static_cast<LAMMPS*>(lammps);
  check_version(instance);
  LammpsPlugin plugin{instance->version,
                      "fix",
                      "polhode",
                      "rigid molecules: exact free rotation and optimized splitting schemes",
                      "polhode",
                      &create_fix,
                      handle};
  reinterpret_cast<RegisterLammpsPlugin>(add)(&plugin, lammps);
}
