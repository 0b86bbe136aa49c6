// SPDX-License-Identifier: MIT
// The parameters of an .mdp file, with a record of the parameters that were used.
#pragma once

#include <cstddef>
#include <initializer_list>
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
  /// Reads the parameters of an .mdp file.
  /// @throws Error  if a line is not "name = value", or a name occurs twice
  MdpParameters(std::string_view text, const std::string& file);

  /// Returns the value of a parameter, and marks the parameter as translated. The text is empty if
  /// the parameter is absent or has no value.
  std::string text(std::string_view name);
  /// Whether the value of a parameter is a given word, compared by letters and digits. An absent
  /// parameter has the value `fallback`.
  bool is(std::string_view name, std::string_view word, std::string_view fallback = "no");
  /// Whether the value of a parameter is one of several words.
  bool is(std::string_view name, std::initializer_list<std::string_view> words,
          std::string_view fallback = "no");
  std::vector<double> numbers(std::string_view name);
  double number(std::string_view name, double fallback);

  /// Records that a parameter has a different meaning in the run file. An absent parameter has the
  /// value `fallback`.
  void differs(std::string_view name, const std::string& reason, std::string_view fallback = "");

  /// All parameters with recorded differences or without translation, in the order of the file.
  std::vector<MdpDifference> differences() const;

 private:
  struct Parameter {
    std::string name, value;  // name and value as written
    TextPlace place;
    bool asked = false;
    std::string reason{};
  };
  Parameter* find(std::string_view name);

  std::vector<Parameter> parameters_;
  std::map<std::string, std::size_t> index_;  // index of each parameter by its letters and digits
  std::vector<MdpDifference> of_defaults_;
};

}  // namespace polhode::gromacs
