// SPDX-License-Identifier: MIT
// Run parameters of GROMACS (.mdp files) as a run file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace polhode {

/// A parameter of an .mdp file that has no exact equivalent in a run file.
struct MdpDifference {
  std::string parameter;  ///< parameter as written, such as "vdw-modifier = Potential-shift"
  std::string reason;     ///< reason, and the replacement in the run file
};

struct MdpImport {
  std::string run_file;  ///< text of the run file, with the differences as comments
  std::vector<MdpDifference> differences;
};

/// The files to which the run file refers.
struct MdpFiles {
  std::string topology = "topol.top", coordinates = "conf.gro";
  std::string prefix = "gromacs";  ///< prefix of the outputs
};

/// Translates the parameters that have the same meaning, and lists all others. Parameter names are
/// compared as in GROMACS: only letters and digits count. Absent parameters have the defaults of
/// GROMACS.
/// @param file     file name in error messages
/// @throws Error   with file, line, the text found and the text expected
MdpImport import_mdp(std::string_view text, const std::string& file, const MdpFiles& files = {});

/// Translates the parameters of an .mdp file.
MdpImport read_mdp(const std::string& path, const MdpFiles& files = {});

}  // namespace polhode
