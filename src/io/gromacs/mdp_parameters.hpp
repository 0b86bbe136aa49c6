// SPDX-License-Identifier: MIT
// The parameters of an .mdp file, which remember which of them were asked for.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/topology/gromacs_mdp.hpp"
#include "polhode/io/settings/text_place.hpp"

namespace polhode::gromacs {

class MdpParameters {
 public:
  /// @throws Error  if a line is not "name = value", or a name occurs twice
  MdpParameters(std::string_view text, const std::string& file);

  /// The value of a parameter, which counts as translated; empty if it is absent or has none.
  std::string text(std::string_view name);
  /// Whether the value is this word, by its letters and digits; an absent parameter has `fallback`.
  bool is(std::string_view name, std::string_view word, std::string_view fallback = "no");
  std::vector<double> numbers(std::string_view name);
  double number(std::string_view name, double fallback);

  /// Records that a parameter has another meaning in the run file. An absent one is the default.
  void differs(std::string_view name, const std::string& reason, std::string_view fallback = "");

  /// What was recorded, and all parameters that were not asked for, in the order of the file.
  std::vector<MdpDifference> differences() const;

 private:
  struct Parameter {
    std::string name, value;  // as written
    TextPlace place;
    bool asked = false;
    std::string reason{};
  };
  Parameter* find(std::string_view name);

  std::vector<Parameter> parameters_;
  std::map<std::string, std::size_t> index_;  // by letters and digits
  std::vector<MdpDifference> of_defaults_;
};

}  // namespace polhode::gromacs
