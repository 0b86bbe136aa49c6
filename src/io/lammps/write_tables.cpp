// SPDX-License-Identifier: MIT
// The pair potentials as tables for pair_style table of LAMMPS.
#include <fmt/core.h>
#include <fmt/ostream.h>

#include <cmath>
#include <ostream>

#include "forces/pairs/molecule_pair.hpp"
#include "io/settings/quantity.hpp"
#include "io/topology/lammps_export.hpp"
#include "polhode/base/error.hpp"

namespace polhode {
namespace {

/// The energy and force between two atom types at a distance, with the cutoff treatment of the
/// settings.
struct TabulatedPair {
  double u;  ///< energy [kJ/mol]
  double f;  ///< force −u' [kJ/mol/nm]
};

// The potential of a pair of types, evaluated for two molecules that have a single site at their
// centre.
class PairLaw {
 public:
  PairLaw(const LammpsTypes::Type& a, const LammpsTypes::Type& b, const Topology& topology,
          const ForceSettings& settings, bool charges)
      : table_(alone(a, topology, charges), alone(b, topology, charges), settings.mixing),
        laws_(settings),
        treatment_(cutoff_treatment(settings)) {}

  bool interacts() const {
    return (table_.charged_a > 0 && table_.charged_b > 0) ||
           (table_.dispersive_a > 0 && table_.dispersive_b > 0);
  }

  TabulatedPair at(double r) const {
    switch (treatment_) {
      case CutoffTreatment::site_switch:
        return at<CutoffTreatment::site_switch>(r);
      case CutoffTreatment::site_shift:
        return at<CutoffTreatment::site_shift>(r);
      case CutoffTreatment::smooth:
        return at<CutoffTreatment::smooth>(r);
      default:
        throw Error(
            "forces.truncation = \"molecule-switch\" depends on the distance between centres of "
            "mass, but no pair style of LAMMPS uses this distance; use --pair-style polhode, or "
            "choose "
            "\"site-switch\" or \"site-shift\"");
    }
  }

 private:
  static Molecule alone(const LammpsTypes::Type& type, const Topology& topology, bool charges) {
    return lone_site(type, topology, charges ? type.site.charge : 0);
  }

  template <CutoffTreatment treatment>
  TabulatedPair at(double r) const {
    const auto centre = [](std::size_t) { return Vec3<double>{}; };
    const PairLoad<double> load =
        molecule_pair<treatment, true>(AnyShape<4>(table_), table_.any_law<double>(), laws_,
                                       Vec3<double>{r, 0, 0}, centre, centre);
    return {load.van_der_waals + load.coulomb, load.f.x};
  }

  PairTable table_;
  PairLaws<double> laws_;
  CutoffTreatment treatment_;
};

}  // namespace

std::vector<std::string> write_lammps_tables(std::ostream& out, const Topology& topology,
                                             const ForceSettings& settings,
                                             const LammpsTypes& types, bool charges) {
  const double angstrom = unit("A", Dimension::length), kcal = unit("kcal/mol", Dimension::energy);
  const double first2 = lammps_table_start * lammps_table_start;
  const double last2 = settings.cutoff * settings.cutoff;
  std::vector<std::string> sections;
  const auto& all = types.types();
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = i; j < all.size(); ++j) {
      const PairLaw law(all[i], all[j], topology, settings, charges);
      sections.emplace_back();
      if (!law.interacts()) continue;
      sections.back() = fmt::format("PAIR_{}_{}", i + 1, j + 1);
      fmt::print(out, "# {} with {}\n{}\nN {} RSQ {:.17g} {:.17g}\n\n", all[i].name, all[j].name,
                 sections.back(), lammps_table_size, lammps_table_start / angstrom,
                 settings.cutoff / angstrom);
      for (std::size_t k = 0; k < lammps_table_size; ++k) {
        const double x = static_cast<double>(k) / static_cast<double>(lammps_table_size - 1);
        const double r = std::sqrt(first2 + x * (last2 - first2));
        const TabulatedPair value = law.at(r);
        fmt::print(out, "{} {:.17g} {:.17g} {:.17g}\n", k + 1, r / angstrom, value.u / kcal,
                   value.f / (kcal / angstrom));
      }
      fmt::print(out, "\n");
    }
  return sections;
}

}  // namespace polhode
