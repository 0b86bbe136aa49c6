// SPDX-License-Identifier: MIT
#include "run/simulation/report/truncation_walk.hpp"

#include <array>
#include <cmath>
#include <vector>

#include "forces/pairs/cutoff_treatment.hpp"
#include "forces/pairs/pair_table.hpp"
#include "polhode/base/units.hpp"
#include "polhode/math/random.hpp"

namespace polhode {
namespace {

/// The Bernoulli polynomial of degree 2n + 2 for n from 1 to 3, divided by (2n + 2)!.
double bernoulli(int n, double x) {
  const double y = x * x;
  switch (n) {
    case 1:
      return (y * y - 2 * x * y + y - 1.0 / 30) / 24;
    case 2:
      return (y * (y * (y - 3 * x + 2.5) - 0.5) + 1.0 / 42) / 720;
    default:
      return (y * (y * (y * (y - 4 * x + 14.0 / 3) - 7.0 / 3) + 2.0 / 3) - 1.0 / 30) / 40320;
  }
}

/// Number of random orientations: the mean square of an average then has an error of about 10 %.
constexpr int orientations = 400;

/// The energies of the site pairs between two molecule types.
class SitePairs {
 public:
  SitePairs(const Molecule& a, const Molecule& b, const PairTable& table,
            const ForceSettings& forces)
      : a_(a),
        b_(b),
        table_(table),
        laws_(forces),
        charges_(!vanishes_at_cutoff(forces.electrostatics)) {}

  const std::vector<Site>& first() const { return a_.sites; }
  const std::vector<Site>& second() const { return b_.sites; }

  /// The interaction of two sites without truncation: u and −u'/r.
  PairValue<double> operator()(std::size_t i, std::size_t j, double r2) const {
    const InversePowers<double> inverse_r(r2);
    PairValue<double> sum{0, 0};
    const auto add = [&](const PairValue<double>& value, double factor) {
      sum.u += factor * value.u, sum.s += factor * value.s;
    };
    const PairStrengths<ShortRange<double>>& strengths = table_.any_law<double>();
    const std::size_t pair = j * table_.sites_a + i;
    if (charges_) add(laws_.reaction_field(inverse_r, r2), strengths.charge[pair]);
    add(strengths.law[pair](inverse_r, r2), 1);
    return sum;
  }

 private:
  InteractionSites a_, b_;
  const PairTable& table_;
  PairLaws<double> laws_;
  bool charges_;
};

/// The mean square velocity ⟨v²⟩/kT of a site along a body-frame direction, at thermal velocities
/// [1/u].
double inverse_mass(const Molecule& molecule, const Vec3<double>& r,
                    const Vec3<double>& direction) {
  const Vec3<double> lever = cross(r, direction);
  double sum = 1 / molecule.mass;
  for (std::size_t k = 0; k < 3; ++k)
    if (molecule.J[k] > 0) sum += lever[k] * lever[k] / molecule.J[k];
  return sum;
}

/// The mean square energy of two molecules at a given distance of their centres, over random
/// orientations.
double mean_square_energy(const SitePairs& pairs, double distance) {
  Random random(1);
  double sum = 0;
  for (int n = 0; n < orientations; ++n) {
    const Quaternion<double> qa = random.orientation(), qb = random.orientation();
    double u = 0;
    for (std::size_t i = 0; i < pairs.first().size(); ++i)
      for (std::size_t j = 0; j < pairs.second().size(); ++j) {
        const Vec3<double> apart = Vec3<double>{distance, 0, 0} + to_lab(qb, pairs.second()[j].r) -
                                   to_lab(qa, pairs.first()[i].r);
        u += pairs(i, j, dot(apart, apart)).u;
      }
    sum += u * u;
  }
  return sum / orientations;
}

/// The second derivative u''(r) of a pair of sites, from the slope u' = −s r at two close
/// distances.
double curvature(const SitePairs& pairs, std::size_t i, std::size_t j, double r) {
  const double d = 1e-4 * r;
  const auto slope = [&](double x) { return -pairs(i, j, x * x).s * x; };
  return (slope(r + d) - slope(r - d)) / (2 * d);
}

/// The discontinuities at a given distance between sites or molecules: their order, and a sum over
/// pairs. The terms of the sum are the squares of the jumps times ⟨|v|^{2n+3}⟩.
struct Passages {
  const ForceSettings& forces;
  double kT;
  int n;

  /// The moment ⟨|v|^{2n+3}⟩ of a normally distributed velocity. The variance of the velocity is kT
  /// times the sum of inverse masses.
  double moment(double inverse_masses) const {
    return std::pow(2 * kT * inverse_masses, n + 1.5) * std::tgamma(n + 2.0) / std::sqrt(units::pi);
  }

  /// The moment of the relative velocity of two sites along the line between them, averaged over
  /// orientations. The average is needed because a site is faster in some directions than in
  /// others.
  double moment(const Molecule& a, const Vec3<double>& ra, const Molecule& b,
                const Vec3<double>& rb) const {
    Random random(2);
    double sum = 0;
    for (int k = 0; k < orientations; ++k)
      sum += moment(inverse_mass(a, ra, to_body(random.orientation(), {1, 0, 0})) +
                    inverse_mass(b, rb, to_body(random.orientation(), {1, 0, 0})));
    return sum / orientations;
  }

  double sum(const Molecule& a, const Molecule& b, const SitePairs& pairs, double r) const {
    const bool shift = cutoff_treatment(forces) == CutoffTreatment::site_shift;
    // The derivatives w^{(n+1)} of the switching function w at the ends of its range.
    const double width = forces.cutoff - forces.switch_from;
    const double jump =
        std::array{6.0, 60.0, 840.0}[static_cast<std::size_t>(n - 1)] / std::pow(width, n + 1);
    if (cutoff_treatment(forces) == CutoffTreatment::molecule_switch)
      return jump * jump * mean_square_energy(pairs, r) * moment(1 / a.mass + 1 / b.mass);
    double all = 0;
    for (std::size_t i = 0; i < pairs.first().size(); ++i)
      for (std::size_t j = 0; j < pairs.second().size(); ++j) {
        const double J = shift ? curvature(pairs, i, j, r) : jump * pairs(i, j, r * r).u;
        if (J != 0) all += J * J * moment(a, pairs.first()[i].r, b, pairs.second()[j].r);
      }
    return all;
  }
};

}  // namespace

double passage_error(const Scheme& scheme, int n) {
  std::vector<std::array<double, 2>> kicks;  // sum of the drifts before each kick, and its weight
  double drifted = 0;
  for (const Stage& stage : scheme.stages()) {
    if (stage.flow == Flow::drift) drifted += stage.fraction;
    if (stage.flow == Flow::kick) kicks.push_back({drifted, stage.fraction});
  }
  double sum = 0;
  for (const auto& [c, b] : kicks)
    for (const auto& [d, e] : kicks)
      sum += b * e * bernoulli(n, c - d - std::floor(c - d)) * (n % 2 == 0 ? 1 : -1);
  return sum;
}

double truncation_walk(const Topology& topology, const ForceSettings& forces, double volume,
                       double temperature, const Scheme& scheme, double step) {
  const bool shift = cutoff_treatment(forces) == CutoffTreatment::site_shift;
  const Passages passages{forces, units::boltzmann * temperature, shift ? 1 : forces.smoothness};
  const PairTables tables(topology, forces.mixing);
  double sum = 0;
  for (std::size_t a = 0; a < topology.parts.size(); ++a)
    for (std::size_t b = 0; b < topology.parts.size(); ++b) {
      const auto& [first, count] = topology.parts[a];
      const auto& [second, other] = topology.parts[b];
      const SitePairs pairs(first, second, tables(a, b), forces);
      const double number = static_cast<double>(count) * static_cast<double>(other) / (2 * volume);
      for (const double r : {forces.switch_from, forces.cutoff})
        if (r == forces.cutoff || !shift)
          sum += number * 4 * units::pi * r * r * passages.sum(first, second, pairs, r);
    }
  return sum * std::pow(step, 2 * passages.n + 2) * passage_error(scheme, passages.n);
}

}  // namespace polhode
