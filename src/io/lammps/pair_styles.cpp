// SPDX-License-Identifier: MIT
#include "pair_styles.hpp"

#include <utility>

#include "io/files/split_words.hpp"

namespace polhode {

std::optional<LammpsLaw> law_of_pair_style(std::string_view style) {
  std::string_view name = take_word(style);
  if (name.empty()) return LammpsLaw::lennard_jones;
  for (const std::string_view suffix : {"/gpu", "/intel", "/kk", "/omp", "/opt"})
    if (name.ends_with(suffix)) {
      name.remove_suffix(suffix.size());
      break;
    }
  // Some unsupported styles begin with the name of a supported style: lj/cut/soft,
  // lj/cut/thole/long, lj/cut/dipole/cut, buck/mdf.
  constexpr std::pair<std::string_view, LammpsLaw> known[] = {
      {"lj/cut", LammpsLaw::lennard_jones},
      {"lj/cut/coul/cut", LammpsLaw::lennard_jones},
      {"lj/cut/coul/debye", LammpsLaw::lennard_jones},
      {"lj/cut/coul/dsf", LammpsLaw::lennard_jones},
      {"lj/cut/coul/long", LammpsLaw::lennard_jones},
      {"lj/cut/coul/msm", LammpsLaw::lennard_jones},
      {"lj/cut/coul/wolf", LammpsLaw::lennard_jones},
      {"buck", LammpsLaw::buckingham},
      {"buck/coul/cut", LammpsLaw::buckingham},
      {"buck/coul/long", LammpsLaw::buckingham},
      {"buck/coul/msm", LammpsLaw::buckingham},
      {"mie/cut", LammpsLaw::mie}};
  for (const auto& [known_name, law] : known)
    if (name == known_name) return law;
  return std::nullopt;
}

}  // namespace polhode
