// SPDX-License-Identifier: MIT
#include "run/properties/second_virial.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "forces/pairs/pair_table.hpp"
#include "polhode/base/quaternion.hpp"
#include "polhode/base/units.hpp"
#include "polhode/math/random.hpp"

namespace polhode {
namespace {

constexpr std::size_t shifts = 16;
/// Distance of two sites below which their cores overlap [nm]. A potential without a repulsive core
/// would have a singularity due to the charges at these distances.
constexpr double closest = 0.08;
/// Distances of the centres, with even numbers of intervals for Simpson's rule [nm].
struct Panel {
  double from, to;
  std::size_t intervals;
};
constexpr std::array panels = {Panel{0, 0.8, 200}, Panel{0.8, 4, 200}};
constexpr double farthest = panels.back().to;

/// Quasi-random directions and orientations that fill their space evenly. They are multiples of
/// powers of the root of x⁶ = x + 1, modulo 1, with a random shift.
class EvenPoints {
 public:
  explicit EvenPoints(std::uint64_t shift) {
    double root = 1;
    for (int k = 0; k < 64; ++k) root = std::pow(1 + root, 1.0 / 6);
    Random random(shift);
    for (std::size_t k = 0; k < by_.size(); ++k) {
      by_[k] = std::pow(root, -static_cast<double>(k + 1));
      from_[k] = random.uniform();
    }
  }
  double coordinate(std::size_t point, std::size_t k) const {
    const double x = from_[k] + static_cast<double>(point + 1) * by_[k];
    return x - std::floor(x);
  }
  Vec3<double> direction(std::size_t point) const {
    const double z = 2 * coordinate(point, 0) - 1, phi = 2 * units::pi * coordinate(point, 1);
    const double r = std::sqrt(1 - z * z);
    return {r * std::cos(phi), r * std::sin(phi), z};
  }
  /// A uniformly distributed orientation [shoemake1992].
  Quaternion<double> orientation(std::size_t point) const {
    const double u = coordinate(point, 2), a = 2 * units::pi * coordinate(point, 3),
                 b = 2 * units::pi * coordinate(point, 4);
    const double p = std::sqrt(1 - u), q = std::sqrt(u);
    return {q * std::cos(b), p * std::sin(a), p * std::cos(a), q * std::sin(b)};
  }

 private:
  std::array<double, 5> by_{}, from_{};
};

class PairOfMolecules {
 public:
  PairOfMolecules(const Molecule& molecule, const Mixing& mixing)
      : sites_(molecule), table_(Topology{{{molecule, 2}}}, mixing) {}

  /// The energy of two molecules at a vector between their centres [kJ/mol]; infinite if cores
  /// overlap.
  double energy(const Vec3<double>& R, const std::vector<Vec3<double>>& second) const {
    const auto& strengths = table_(0, 0).any_law<double>();
    double u = 0;
    std::size_t k = 0;
    for (std::size_t b = 0; b < sites_.size(); ++b)
      for (std::size_t a = 0; a < sites_.size(); ++a, ++k) {
        if (strengths.charge[k] == 0 && strengths.law[k].is_zero()) continue;
        const double r2 = norm2(R + second[b] - sites_.sites[a].r);
        if (r2 < closest * closest) return std::numeric_limits<double>::infinity();
        const InversePowers<double> inverse_r(r2);
        u += strengths.charge[k] * inverse_r.first() + strengths.law[k](inverse_r, r2).u;
      }
    return u;
  }
  std::vector<Vec3<double>> turned(const Quaternion<double>& orientation) const {
    std::vector<Vec3<double>> sites;
    for (const Site& site : sites_.sites) sites.push_back(to_lab(orientation, site.r));
    return sites;
  }
  /// The integral 4π ∫ u r² dr of the short-range potentials beyond a distance [kJ/mol nm³].
  double beyond(double r) const {
    double sum = 0;
    for (const ShortRange<double>& law : table_(0, 0).any_law<double>().law)
      if (!law.is_zero()) sum += law.integral_beyond(r);
    return 4 * units::pi * sum;
  }

 private:
  InteractionSites sites_;
  PairTables table_;
};

/// The integrand at a distance: the Mayer function, averaged over orientations.
double at_distance(const PairOfMolecules& pair, double r, double kT,
                   const std::vector<Vec3<double>>& directions,
                   const std::vector<std::vector<Vec3<double>>>& orientations) {
  double sum = 0;
  for (std::size_t k = 0; k < directions.size(); ++k)
    sum += std::exp(-(pair.energy(r * directions[k], orientations[k]) / kT)) - 1;
  return sum / static_cast<double>(directions.size());
}

double with_shift(const PairOfMolecules& pair, double kT, std::size_t points, std::uint64_t shift,
                  const std::function<bool()>& stop) {
  const EvenPoints even(shift);
  std::vector<Vec3<double>> directions;
  std::vector<std::vector<Vec3<double>>> orientations;
  for (std::size_t k = 0; k < points; ++k) {
    directions.push_back(even.direction(k));
    orientations.push_back(pair.turned(even.orientation(k)));
  }
  double sum = 0;
  for (const Panel& panel : panels) {
    const double h = (panel.to - panel.from) / static_cast<double>(panel.intervals);
    for (std::size_t k = 0; k <= panel.intervals; ++k) {
      const double r = panel.from + static_cast<double>(k) * h;
      const double simpson = k == 0 || k == panel.intervals ? 1 : k % 2 == 1 ? 4 : 2;
      const double weight = -2 * units::pi * simpson * h / 3 * r * r;
      if (weight == 0) continue;
      if (stop && stop()) return std::nan("");
      sum += weight * at_distance(pair, r, kT, directions, orientations);
    }
  }
  return sum;
}

/// The contribution of distances beyond the farthest panel: −½ ∫ of ⟨u²⟩/2(kT)² for two dipoles and
/// of −⟨u⟩/kT for dispersion.
double tail(const Molecule& molecule, const PairOfMolecules& pair, double kT) {
  const double mu2 = units::coulomb * molecule.dipole() * molecule.dipole() / kT;  // [nm³]
  const double dipoles = -2 * units::pi * mu2 * mu2 / (9 * std::pow(farthest, 3));
  const double dispersion = pair.beyond(farthest) / (2 * kT);
  return dipoles + dispersion;
}

}  // namespace

Estimate second_virial(const Molecule& molecule, const Mixing& mixing, double temperature,
                       std::size_t points, Workers& workers, const std::function<bool()>& stop) {
  const double kT = units::boltzmann * temperature;
  const PairOfMolecules pair(molecule, mixing);
  const double far = tail(molecule, pair, kT);
  std::vector<double> values(shifts);
  workers.each(shifts,
               [&](std::size_t k) { values[k] = with_shift(pair, kT, points, k + 1, stop) + far; });
  return mean(values);
}

}  // namespace polhode
