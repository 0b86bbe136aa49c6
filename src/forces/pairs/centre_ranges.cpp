// SPDX-License-Identifier: MIT
#include "forces/pairs/centre_ranges.hpp"

#include <algorithm>
#include <optional>

#include "forces/pairs/cutoff_treatment.hpp"

namespace polhode {
namespace {

/// The largest distance of an interacting site from the centre of its molecule [nm].
template <class Has>
std::optional<double> extent(const Molecule& molecule, const Has& has) {
  std::optional<double> far;
  for (const Site& site : molecule.sites)
    if (has(site)) far = std::max(far.value_or(0), norm(site.r));
  return far;
}

}  // namespace

CentreRanges centre_ranges(const ForceSettings& settings, const Molecule& a, const Molecule& b) {
  const CutoffTreatment treatment = cutoff_treatment(settings);
  const double switched = changes_all_distances(treatment) ? 0 : settings.switch_from;
  CentreRanges ranges;
  ranges.inside = settings.cutoff;
  // Adds an interaction that has its full strength up to `whole` and is zero beyond `cutoff`.
  const auto add = [&](const auto& has, double whole, double cutoff) {
    const auto of_a = extent(a, has), of_b = extent(b, has);
    if (!of_a || !of_b) return;
    const double apart = treatment == CutoffTreatment::molecule_switch ? 0 : *of_a + *of_b;
    ranges.largest = std::max(ranges.largest, cutoff + apart);
    ranges.inside = std::min(ranges.inside, whole - apart);
  };
  const double charges = cutoff_of_charges(settings);
  add([](const Site& site) { return site.charge != 0; },
      treatment == CutoffTreatment::smooth ? charges : switched, charges);
  add([](const Site& site) { return site.has_short_range(); }, switched, settings.cutoff);
  return ranges;
}

}  // namespace polhode
