// SPDX-License-Identifier: MIT
// The interface between LAMMPS and a plugin, as in the LAMMPS documentation.
#pragma once

namespace LAMMPS_NS {
class Fix;
class LAMMPS;
class Pair;
}  // namespace LAMMPS_NS

extern "C" {

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
