// SPDX-License-Identifier: MIT
// What LAMMPS expects of a plugin, as its documentation describes it.
#pragma once

namespace LAMMPS_NS {
class Fix;
class LAMMPS;
}  // namespace LAMMPS_NS

extern "C" {

/// A fix style of a plugin.
struct LammpsPlugin {
  const char *version, *style, *name, *info, *author;
  LAMMPS_NS::Fix* (*create)(LAMMPS_NS::LAMMPS* lammps, int count, char** arguments);
  void* handle;
};

using RegisterLammpsPlugin = void (*)(LammpsPlugin* plugin, void* lammps);

/// Called by LAMMPS when it loads the plugin.
/// @param handle  of the shared object, for LammpsPlugin::handle
/// @param add     a RegisterLammpsPlugin
[[gnu::visibility("default")]] void lammpsplugin_init(void* lammps, void* handle, void* add);
}
