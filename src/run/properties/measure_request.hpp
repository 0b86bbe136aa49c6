// SPDX-License-Identifier: MIT
// What a front end was given for a measurement, as texts.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "polhode/run/properties/measure.hpp"
#include "run/given.hpp"

namespace polhode {

struct MeasureRequest {
  /// The system: a run file, a molecule file, the name of a model, several models with their
  /// numbers, such as "spce 488, na-spce 12, cl-spce 12", a topology of GROMACS or a data file of
  /// LAMMPS.
  std::string system;
  /// Names of properties. Each may be followed by the requested error, as in "density", "0.1 %".
  /// After a topology of GROMACS, the first words are its files, as in "conf.gro", "run.mdp".
  std::vector<std::string> properties;
  Given at, molecules, mixing, solute, replicas, paired_runs, sampling, scheme, step, shard,
      time_limit, seed, output;

  static std::vector<RequestOption<MeasureRequest>> options();
  std::string prefix() const { return output ? output.text : "measure"; }
  /// The settings that the request describes.
  /// @throws Error  if an option or word is invalid; the message names it
  MeasureSettings settings() const;
};

/// Parses state points, such as "298.15 K, 1 bar" or "298.15 K, 997 kg/m3". Either value can be a
/// range, as in "250 K to 320 K, 7 points". The default pressure is 1 bar.
/// @throws Error  if a part cannot be read; the message names it
std::vector<StatePoint> state_points(std::string_view text);

/// Help text on the words of a request, with the names of all properties.
std::string properties_help();

/// Parses properties with their requested errors; the default error is 1 %.
/// @throws Error  if a word is invalid; the message names it
std::vector<RequestedProperty> requested_properties(const std::vector<std::string>& words);

}  // namespace polhode
