// SPDX-License-Identifier: MIT
// The plugin: `plugin load polhodeplugin.so` adds the fix and pair styles polhode to LAMMPS.
#include <string>

#include "base/version.hpp"
#include "error.h"
#include "fix_polhode.hpp"
#include "lammps.h"
#include "library.h"
#include "pair_polhode.hpp"

extern "C" {

// The interface between LAMMPS and a plugin, as in the LAMMPS documentation.

/// Functions that make an object of a style. The style kind (pair or fix) determines which function
/// is called.
union LammpsFactory {
  LAMMPS_NS::Pair* (*pair)(LAMMPS_NS::LAMMPS* lammps);
  LAMMPS_NS::Fix* (*fix)(LAMMPS_NS::LAMMPS* lammps, int count, char** arguments);
};

/// A style of a plugin: its kind ("fix" or "pair"), name and factory.
struct LammpsPlugin {
  const char *version, *style, *name, *info, *author;
  LammpsFactory create;
  void* handle;
};

using RegisterLammpsPlugin = void (*)(LammpsPlugin* plugin, void* lammps);

/// Registers the plugin; LAMMPS calls this function when it loads the plugin.
/// @param handle  handle of the shared object, for LammpsPlugin::handle
/// @param add     function of type RegisterLammpsPlugin
[[gnu::visibility("default")]] void lammpsplugin_init(void* lammps, void* handle, void* add);
}

namespace {

using LAMMPS_NS::LAMMPS;

LAMMPS_NS::Fix* create_fix(LAMMPS* lammps, int count, char** arguments) {
  return new polhode::lammps::FixPolhode(lammps, count, arguments);
}

LAMMPS_NS::Pair* create_pair(LAMMPS* lammps) { return new polhode::lammps::PairPolhode(lammps); }

// LAMMPS classes differ between versions, so a plugin built for another version would crash.
void check_version(LAMMPS* lammps) {
  if (lammps->num_ver != POLHODE_LAMMPS_VERSION)
    lammps->error->all(FLERR,
                       "the polhode plugin was built for LAMMPS version {}, but this is version {} "
                       "({}); build the plugin again with the headers of this LAMMPS",
                       POLHODE_LAMMPS_VERSION, lammps->num_ver, lammps->version);
  const int tag_size = lammps_extract_setting(lammps, "tagint");
  if (tag_size != static_cast<int>(sizeof(LAMMPS_NS::tagint)))
    lammps->error->all(
        FLERR,
        "the polhode plugin was built for atom ids of {} bytes, but atom ids of this LAMMPS have "
        "{} bytes; build the plugin again with the POLHODE_LAMMPS_SIZES of this LAMMPS",
        sizeof(LAMMPS_NS::tagint), tag_size);
}

}  // namespace

void lammpsplugin_init(void* lammps, void* handle, void* add) {
  auto* const instance = static_cast<LAMMPS*>(lammps);
  check_version(instance);
  const auto add_style = [&](const char* style, const char* info, const LammpsFactory& create) {
    LammpsPlugin plugin{instance->version, style, "polhode", info, "polhode", create, handle};
    reinterpret_cast<RegisterLammpsPlugin>(add)(&plugin, lammps);
  };
  add_style("fix", "rigid molecules: exact free rotation and optimized splitting schemes",
            {.fix = &create_fix});
  add_style("pair", "smoothly truncated forces on the molecules of fix polhode",
            {.pair = &create_pair});
}
