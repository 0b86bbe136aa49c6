// SPDX-License-Identifier: MIT
// Converts frames of a file to another format.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>

#include "polhode/io/settings/config.hpp"
#include "polhode/model/topology.hpp"
#include "polhode/run/outputs.hpp"

namespace polhode {

struct Conversion {
  std::string from, to;  ///< paths of the files; the extensions select the formats
  std::string names;     ///< file with the names of atoms; empty if `from` has names, or `to` needs
                         ///< none
  std::optional<Topology> particles;  ///< molecules, if each particle of `from` is a molecule
  std::size_t every = 1;              ///< n, if every n-th of the selected frames is written
  double first = -std::numeric_limits<double>::infinity();  ///< first time; earlier frames are
                                                            ///< skipped [ps]
  double last =
      std::numeric_limits<double>::infinity();  ///< last time; later frames are skipped [ps]
};

struct ConversionResult {
  std::size_t frames = 0;    ///< number of frames that were written
  bool interrupted = false;  ///< whether the conversion was interrupted, so that no file was
                             ///< written
};

/// Writes the selected frames to a file, completely or not at all. A message warns if velocities
/// are lost.
/// @throws Error  if a format is not known or lacks names that the other format needs, if no frame
///   is selected, or under the conditions of check_outputs()
ConversionResult convert(const Conversion& conversion, const OutputOptions& options,
                         const Callbacks& callbacks = {});

}  // namespace polhode
