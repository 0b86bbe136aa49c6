// SPDX-License-Identifier: MIT
// What a front end was given for a measurement, as texts.
#pragma once

#include <string>
#include <vector>

#include "polhode/run/properties/measure.hpp"
#include "run/given.hpp"

namespace polhode {

struct MeasureRequest {
  /// A run file, a molecule file, the name of a model, or several of these with their numbers,
  /// "spce 488, na-spce 12, cl-spce 12".
  std::string system;
  /// Names of properties, each of which may be followed by its error: "density", "0.1 %".
  std::vector<std::string> properties;
  Given at, molecules, replicas, shard, time_limit, seed, output;

  static std::vector<RequestOption<MeasureRequest>> options();
  std::string prefix() const { return output ? output.text : "measure"; }
  /// @throws Error  naming the option or the word
  MeasureSettings settings() const;
};

/// What the words of a request are, with the names of all properties.
std::string properties_help();

/// The properties with their errors; 1 % where none is given.
/// @throws Error  naming the word
std::vector<RequestedProperty> requested_properties(const std::vector<std::string>& words);

}  // namespace polhode
