// SPDX-License-Identifier: MIT
#include "forces/laws/check_settings.hpp"

#include <fmt/core.h>

#include <cmath>
#include <utility>

#include "forces/laws/damped_shifted_force.hpp"
#include "forces/laws/setting_names.hpp"
#include "forces/pairs/cutoff_treatment.hpp"
#include "polhode/base/error.hpp"

namespace polhode {
namespace {

using Fault = std::optional<SettingFault>;

constexpr double min_pme_accuracy = 1e-7, max_pme_accuracy = 0.1;
constexpr double min_pme_accuracy_in_mixed = 1e-5;

std::string in_nm(double length) { return fmt::format("{} nm", length); }

bool is_positive(double length) { return length > 0 && std::isfinite(length); }

Fault fault_of_lengths(const ForceSettings& s) {
  if (!is_positive(s.cutoff))
    return SettingFault{"cutoff", in_nm(s.cutoff),
                        "must be longer than 0 nm and finite; 0.9 to 1.2 nm is usual"};
  if (!(s.switch_from > 0 && s.switch_from < s.cutoff))
    return SettingFault{
        "switch", in_nm(s.switch_from),
        fmt::format("must be longer than 0 nm and shorter than the cutoff, {} nm: without a "
                    "switching range the forces are discontinuous, and no scheme reaches its order",
                    s.cutoff)};
  if (!is_positive(s.skin))
    return SettingFault{"skin", in_nm(s.skin),
                        fmt::format("must be longer than 0 nm and finite, so that the neighbour "
                                    "list is valid for several steps; {} nm is usual",
                                    ForceSettings{}.skin)};
  return std::nullopt;
}

Fault fault_of_truncation(const ForceSettings& s) {
  if (vanishes_at_cutoff(s.electrostatics) && s.truncation != Truncation::site_switch)
    return SettingFault{
        "truncation", fmt::format("\"{}\"", name_of(s.truncation)),
        fmt::format(
            "cannot be combined with electrostatics = \"{}\", since this method truncates charge "
            "interactions itself; use \"site-switch\", which then applies only to Lennard-Jones",
            name_of(s.electrostatics))};
  if (s.smoothness < 1 || s.smoothness > 3)
    return SettingFault{
        "smoothness", fmt::format("{}", s.smoothness),
        "must be 1, 2 or 3, the number of continuous derivatives of the switching function"};
  for (const auto& [key, given] : {std::pair("dispersion_correction", s.dispersion_correction),
                                   {"slab_dispersion", s.slab_dispersion}})
    if (given && s.truncation == Truncation::site_shift)
      return SettingFault{
          key, "true",
          fmt::format(
              "cannot be combined with truncation = \"site-shift\", which shifts the potential at "
              "all distances; leave {} out, or use \"site-switch\"",
              key)};
  if (s.slab_dispersion && s.dispersion_correction)
    return SettingFault{
        "slab_dispersion", "true",
        "cannot be combined with dispersion_correction = true, which assumes a uniform density; "
        "give one of them"};
  return std::nullopt;
}

Fault fault_of_electrostatics(const ForceSettings& s) {
  if (!(s.dielectric >= 1))
    return SettingFault{"dielectric", fmt::format("{}", s.dielectric),
                        "must be 1 (vacuum) or more, or \"infinite\""};
  if (s.electrostatics == Electrostatics::damped_shifted_force &&
      !(s.damping >= 0 && s.damping * s.cutoff <= max_damping))
    return SettingFault{
        "damping", fmt::format("{:g} 1/nm", s.damping),
        fmt::format("must be from 0 to {:g} / cutoff = {:.4g} 1/nm, since this maximum already "
                    "screens charges completely; {:g} 1/nm is usual",
                    max_damping, max_damping / s.cutoff, ForceSettings{}.damping)};
  if (s.coulomb_cutoff && s.electrostatics != Electrostatics::pme)
    return SettingFault{"coulomb_cutoff", in_nm(*s.coulomb_cutoff),
                        fmt::format("has no meaning without electrostatics = \"{}\"; leave it out",
                                    name_of(Electrostatics::pme))};
  if (s.coulomb_cutoff && !is_positive(*s.coulomb_cutoff))
    return SettingFault{
        "coulomb_cutoff", in_nm(*s.coulomb_cutoff),
        "must be longer than 0 nm and finite; without this setting the fastest cutoff is chosen"};
  if (s.electrostatics != Electrostatics::pme) return std::nullopt;
  if (!(s.pme_accuracy >= min_pme_accuracy && s.pme_accuracy <= max_pme_accuracy))
    return SettingFault{
        "pme_accuracy", fmt::format("{:g}", s.pme_accuracy),
        fmt::format("must be from {:g} to {:g} (rms error of the electrostatic forces, divided by "
                    "the rms force); {:g} is usual",
                    min_pme_accuracy, max_pme_accuracy, ForceSettings{}.pme_accuracy)};
  if (s.precision == Precision::mixed && s.pme_accuracy < min_pme_accuracy_in_mixed)
    return SettingFault{
        "pme_accuracy", fmt::format("{:g}", s.pme_accuracy),
        fmt::format("must be {:g} or more in mixed precision, since a single-precision mesh has "
                    "about this rounding error; otherwise use precision = \"double\"",
                    min_pme_accuracy_in_mixed)};
  return std::nullopt;
}

}  // namespace

std::string SettingFault::message() const {
  return fmt::format("{} = {} {}", key, value, complaint);
}

std::optional<SettingFault> find_fault(const ForceSettings& settings) {
  for (const auto fault_of : {fault_of_lengths, fault_of_truncation, fault_of_electrostatics})
    if (auto fault = fault_of(settings)) return fault;
  return std::nullopt;
}

const ForceSettings& checked(const ForceSettings& settings) {
  if (const auto fault = find_fault(settings)) throw Error(fault->message());
  return settings;
}

}  // namespace polhode
