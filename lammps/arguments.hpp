// SPDX-License-Identifier: MIT
// The words after a style in an input script: positional values, and keywords with their values.
#pragma once

#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace polhode::lammps {

class Arguments {
 public:
  Arguments(int count, char** words, LAMMPS_NS::LAMMPS* lammps)
      : words_(words, static_cast<std::size_t>(count)), lammps_(lammps) {}

  /// Reads the next word.
  /// @param meaning  meaning of the word for messages, such as "the temperature"
  /// @throws Error   if there is no further word
  std::string_view word(std::string_view meaning);
  double number(std::string_view meaning);
  /// Reads the next word as a number.
  /// @throws Error  if the number is not above 0
  double positive(std::string_view meaning);
  /// Calls the reader of each keyword. The reader parses the values after the keyword.
  /// @throws Error  if a keyword does not exist
  void each_keyword(const std::map<std::string, std::function<void()>, std::less<>>& readers);

 private:
  std::span<char*> words_;
  LAMMPS_NS::LAMMPS* lammps_;
  std::string keyword_ = "style";
};

}  // namespace polhode::lammps
