// SPDX-License-Identifier: MIT
// Frames of a file converted to another format.
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
  std::string from, to;  ///< files, whose extensions are those of their formats
  std::string names;  ///< file with the names of the atoms; empty: `from` has them, or `to` needs
                      ///< none
  std::optional<Topology> particles;  ///< each particle of `from` is one of these molecules
  std::size_t every = 1;              ///< n: every n-th of the selected frames is written
  double first = -std::numeric_limits<double>::infinity();  ///< earlier frames are skipped [ps]
  double last = std::numeric_limits<double>::infinity();    ///< later frames are skipped [ps]
};

struct ConversionResult {
  std::size_t frames = 0;    ///< that were written
  bool interrupted = false;  ///< and no file was written
};

/// The molecules of a run file, for Conversion::particles.
Topology molecules_of_run(const Config& config);

/// Writes the selected frames to a file, whole or not at all. A message says if velocities are
/// lost.
/// @throws Error  if a format is not known or lacks names that the other needs, if no frame is
///                selected, or as check_outputs()
ConversionResult convert(const Conversion& conversion, const OutputOptions& options,
                         const Callbacks& callbacks = {});

}  // namespace polhode
