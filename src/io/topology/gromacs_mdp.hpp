// SPDX-License-Identifier: MIT
// Run parameters of GROMACS (.mdp files) as a run file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace polhode {

/// A parameter of an .mdp file without the same meaning in a run file.
struct MdpDifference {
  std::string parameter;  ///< as written: "vdw-modifier = Potential-shift"
  std::string reason;     ///< why, and what the run file has instead
};

struct MdpImport {
  std::string run_file;  ///< its text, with the differences as comments
  std::vector<MdpDifference> differences;
};

/// The files that the run file names.
struct MdpFiles {
  std::string topology = "topol.top", coordinates = "conf.gro";
  std::string prefix = "gromacs";  ///< of the outputs
};

/// Translates the parameters that have the same meaning, and lists all others. Names are compared
/// as GROMACS does, by letters and digits; parameters that are absent have the defaults of GROMACS.
/// @param file     its name in errors
/// @throws Error   with file and line: what was found, and what was expected
MdpImport import_mdp(std::string_view text, const std::string& file, const MdpFiles& files = {});

/// The same for a file.
MdpImport read_mdp(const std::string& path, const MdpFiles& files = {});

}  // namespace polhode
