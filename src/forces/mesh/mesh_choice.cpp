// SPDX-License-Identifier: MIT
#include "polhode/forces/mesh/mesh_choice.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "forces/laws/ewald_split.hpp"
#include "forces/mesh/mesh_grid.hpp"
#include "forces/pairs/centre_ranges.hpp"
#include "forces/pairs/pair_table.hpp"
#include "math/smooth_size.hpp"
#include "polhode/base/error.hpp"

namespace polhode {
namespace {

/// The charges of a system, and their mean structure factor ⟨|S(k)|²⟩ for randomly placed bodies
/// [e²].
class ChargeDistribution {
 public:
  explicit ChargeDistribution(const Topology& topology) {
    for (const auto& part : topology.parts) {
      const InteractionSites sites(part.molecule);
      const auto count = static_cast<double>(part.count);
      charges_ += count * static_cast<double>(sites.charged);
      for (std::size_t a = 0; a < sites.charged; ++a)
        for (std::size_t b = a; b < sites.charged; ++b) {
          const Site &first = sites.sites[a], &second = sites.sites[b];
          const double strength = count * first.charge * second.charge;
          if (a == b)
            squares_ += strength;
          else
            pairs_.push_back({2 * strength, norm(second.r - first.r)});
        }
    }
  }
  double charges() const { return charges_; }
  double mean_square() const { return squares_ / charges_; }
  double form(double k) const {
    double sum = squares_;
    for (const Pair& pair : pairs_) {
      const double x = k * pair.r;
      sum += pair.strength * (x < 1e-3 ? 1 - x * x / 6 : std::sin(x) / x);
    }
    return sum;
  }

 private:
  struct Pair {
    double strength, r;
  };
  double charges_ = 0, squares_ = 0;
  std::vector<Pair> pairs_;
};

/// A table of the required energy 4 π ρ(k)/k² and of the form factor as functions of k². If all k²
/// are multiples of one number, each entry is computed only once.
class WaveTable {
 public:
  struct Value {
    double required, form;
  };
  /// @param unit  all k² are multiples of the square of this number; 0 if k² may have any value
  WaveTable(const ChargeDistribution& distribution, const CompactSplit& split, double unit)
      : distribution_(distribution), split_(split), per_unit2_(unit == 0 ? 0 : 1 / (unit * unit)) {}

  Value operator()(double k2) {
    if (per_unit2_ == 0) return value(k2);
    const auto n = static_cast<std::size_t>(std::lround(k2 * per_unit2_));
    if (values_.size() <= n) values_.resize(n + 1);
    if (!values_[n]) values_[n] = value(k2);
    return *values_[n];
  }

 private:
  Value value(double k2) const {
    const double k = std::sqrt(k2);
    return {4 * units::pi / k2 * split_.transform(k).value, distribution_.form(k)};
  }
  const ChargeDistribution& distribution_;
  const CompactSplit& split_;
  double per_unit2_;
  std::vector<std::optional<Value>> values_;
};

/// The mean square error of forces for given grid spacings in a box of 1 nm³. The mean square error
/// scales as 1/V and does not otherwise depend on the box, because the sum over wave vectors
/// approximates an integral. The error is therefore computed for a small grid.
double mean_square_error(const ChargeDistribution& distribution, const Vec3<double>& spacing,
                         int order, const CompactSplit& split) {
  constexpr std::size_t points = 12, half = points / 2, aliases = 3;
  constexpr double pi = units::pi;
  struct Alias {
    double k, share;
  };
  std::array<std::array<std::array<Alias, aliases>, half + 1>, 3> axis{};
  for (std::size_t d = 0; d < 3; ++d)
    for (std::size_t n = 0; n <= half; ++n)
      for (std::size_t l = 0; l < aliases; ++l) {
        const double turn = pi * (static_cast<double>(n) / points + static_cast<double>(l) - 1);
        axis[d][n][l] = {2 * turn / spacing[d],
                         turn == 0 ? 1 : std::pow(std::sin(turn) / turn, 2 * order)};
      }
  const bool cubic = spacing.x == spacing.y && spacing.y == spacing.z;
  WaveTable waves(distribution, split, cubic ? 2 * pi / (points * spacing.x) : 0);
  double total = 0;
  for (std::size_t x = 0; x <= half; ++x)
    for (std::size_t y = 0; y <= half; ++y)
      for (std::size_t z = 0; z <= half; ++z) {
        if (x + y + z == 0) continue;
        if (cubic && (x > y || y > z)) continue;  // computed once for all orders of x, y and z
        const int orders = !cubic || (x == y && y == z) ? 1 : x == y || y == z ? 3 : 6;
        // Sums over aliases: U², U² k², U² k² γ, and the form factor times U², U² k² γ, k² γ².
        double u = 0, uk = 0, ukg = 0, u_form = 0, ukg_form = 0, kgg_form = 0;
        for (const Alias& a : axis[0][x])
          for (const Alias& b : axis[1][y])
            for (const Alias& c : axis[2][z]) {
              const double k2 = a.k * a.k + b.k * b.k + c.k * c.k;
              const double share = a.share * b.share * c.share;
              const auto [required, form] = waves(k2);
              u += share, uk += share * k2, ukg += share * k2 * required;
              u_form += share * form, ukg_form += share * k2 * required * form;
              kgg_form += k2 * required * required * form;
            }
        const double G = ukg / (u * uk);
        const auto weight = [](std::size_t n) { return n == 0 || n == half ? 1 : 2; };
        total += orders * weight(x) * weight(y) * weight(z) *
                 (kgg_form - 2 * G * ukg_form + G * G * uk * u_form);
      }
  const double volume = points * points * points * spacing.x * spacing.y * spacing.z;
  return units::coulomb * units::coulomb * distribution.mean_square() * std::max(total, 0.0) /
         volume;
}

double points_of(const MeshSettings& mesh) {
  double points = 1;
  for (const std::size_t n : mesh.points) points *= static_cast<double>(n);
  return points;
}

/// The smallest suitable grid whose points are at most `spacing` apart: its edges have whole tiles
/// and lengths that suit the transform.
std::array<std::size_t, 3> grid_of(const Box& box, double spacing) {
  std::array<std::size_t, 3> points{};
  for (std::size_t d = 0; d < 3; ++d) {
    points[d] = std::max<std::size_t>(8, static_cast<std::size_t>(box.edge[d] / spacing));
    while (points[d] % mesh_multiple != 0 || !is_smooth_size(points[d]) ||
           box.edge[d] > spacing * static_cast<double>(points[d]))
      ++points[d];
  }
  return points;
}

/// The maximum number of grid points. Meshes for liquids have 10 to 100 points per charge. In a
/// sparsely filled box, a longer cutoff is better than a finer mesh, because a longer cutoff allows
/// a coarser mesh and adds few pairs.
double max_points_for(double charges) { return std::max(0x1p21, 4096 * charges); }

// The expected time of a force evaluation is a formula that does not depend on the processor, so
// the chosen mesh is the same on all computers. The times were measured on one core in mixed
// precision with AVX-512. The choice of the mesh depends only on ratios of the times. The ratios
// are similar in double precision and with other instruction sets.
constexpr double per_point = 1.3e-9;    // time per grid point for the transforms in both
                                        // directions
constexpr double per_charge = 9.5e-9;   // time per charge for the grid position and the weights
constexpr double per_tile = 1.05e-9;    // time per charge for each grid tile to which it is spread
constexpr double per_pair = 2.3e-9;     // time per pair of molecules for its records and sums
constexpr double per_charges = 0.4e-9;  // time per pair of charges
constexpr double per_short_range = 0.6e-9;  // time per pair of sites with a short-range potential

/// Expected time of the mesh [s]. Without grid points, the result is the time to spread and gather
/// charges.
double expected_mesh_seconds(double charges, const MeshSettings& mesh) {
  // Along an edge, a narrow spline overlaps with two tiles, and a wide spline with more tiles.
  const double tiles = mesh.order <= 5 ? 2 : (mesh.order + 4) / 4.0;
  return charges * (per_charge + per_tile * mesh.order * tiles * tiles) +
         points_of(mesh) * per_point;
}

/// Expected time of the pairs [s], for a given cutoff of the charges [nm].
double expected_pair_seconds(const Topology& topology, ForceSettings settings,
                             double coulomb_cutoff, const Box& box) {
  settings.mesh.reset();
  settings.coulomb_cutoff = coulomb_cutoff;
  double seconds = 0;
  for (const auto& a : topology.parts)
    for (const auto& b : topology.parts) {
      const double range = centre_ranges(settings, a.molecule, b.molecule).largest + settings.skin;
      const double sphere = 4 * units::pi / 3 * range * range * range;
      const double pairs = static_cast<double>(a.count) * static_cast<double>(b.count) / 2 *
                           std::min(1.0, sphere / box.volume());
      const InteractionSites one(a.molecule), other(b.molecule);
      seconds +=
          pairs * (per_pair + per_charges * static_cast<double>(one.charged * other.charged) +
                   per_short_range * static_cast<double>(one.dispersive * other.dispersive));
    }
  return seconds;
}

/// Grid spacings that are tried. The spacings form a geometric series, so that errors computed for
/// other boxes can be reused.
double spacing_of(int n) { return 0.25 * std::pow(1.03, -n); }
int index_of(double spacing) {
  return static_cast<int>(std::floor(std::log(0.25 / spacing) / std::log(1.03)));
}

/// Cutoffs of the short-range Coulomb interaction that are tried. The cutoffs are about 3 % apart,
/// and multiples of 0.01 nm.
double cutoff_of(int n) { return std::round(40 * std::pow(1.03, n)) / 100; }

/// The longest cutoff that the neighbour list allows in a box.
double max_cutoff(const Topology& topology, const Box& box) {
  return std::min(box.shortest_edge() / 2, 0.99 * (box.shortest_edge() - 2 * topology.extent()));
}

}  // namespace

double expected_mesh_error(const Topology& topology, const Box& box, const MeshSettings& settings) {
  Vec3<double> spacing;
  for (std::size_t d = 0; d < 3; ++d)
    spacing[d] = box.edge[d] / static_cast<double>(settings.points[d]);
  return std::sqrt(mean_square_error(ChargeDistribution(topology), spacing, settings.order,
                                     CompactSplit(settings.cutoff, settings.exponent)) /
                   box.volume());
}

double typical_force(const Topology& topology, const Box& box) {
  const ChargeDistribution distribution(topology);
  return 0.75 * units::coulomb * distribution.mean_square() *
         std::pow(distribution.charges() / box.volume(), 2.0 / 3);
}

MeshChoice::MeshChoice(const Topology& topology, const ForceSettings& settings)
    : topology_(topology), settings_(settings) {
  if (!(settings.pme_accuracy >= 1e-7 && settings.pme_accuracy <= 0.1))
    throw Error(fmt::format(
        "the requested relative force error of the mesh is {}; it must be from 1e-7 to 0.1",
        settings.pme_accuracy));
  if (ChargeDistribution(topology).charges() == 0)
    throw Error(
        "no molecule has a charge, so PME has nothing to compute; use electrostatics = "
        "\"coulomb\"");
}

double MeshChoice::error(double cutoff, int spacing, int order, int exponent) {
  const auto [found, is_new] = errors_.try_emplace({cutoff, spacing, order, exponent});
  const double h = spacing_of(spacing);
  if (is_new)
    found->second = std::sqrt(mean_square_error(ChargeDistribution(topology_), {h, h, h}, order,
                                                CompactSplit(cutoff, exponent)));
  return found->second;
}

/// Index of the coarsest spacing whose error is within the required error. Spacings from 1/2 to
/// 1/40 of the cutoff are tried.
int MeshChoice::coarsest(double cutoff, int order, int exponent, double required_in_unit_box) {
  int coarse = index_of(cutoff / 2), fine = index_of(cutoff / 40);
  while (fine - coarse > 1) {
    const int middle = (coarse + fine) / 2;
    (error(cutoff, middle, order, exponent) < required_in_unit_box ? fine : coarse) = middle;
  }
  return fine;
}

void MeshChoice::try_cutoff(double cutoff, Orders orders, const Box& box, Best& best) {
  // In water the actual error of mesh forces is 0.3 to 1.5 times the expected error. The error can
  // be smaller because molecules screen each other. The error can be larger because the sum over
  // wave vectors is coarse. The safety margin covers an error that is larger than expected.
  constexpr double margin = 1.5;
  const double required = settings_.pme_accuracy * typical_force(topology_, box) / margin;
  const double required_in_unit_box = required * std::sqrt(box.volume());
  const double pairs = expected_pair_seconds(topology_, settings_, cutoff, box),
               charges = ChargeDistribution(topology_).charges();
  for (int order = orders.first; order <= orders.last; ++order) {
    MeshSettings mesh{{}, order, 0, cutoff};
    if (pairs + expected_mesh_seconds(charges, mesh) > best.seconds) continue;
    // For each exponent, find the coarsest spacing that is accurate enough. As a function of the
    // exponent, the sufficient spacing has a single maximum.
    int coarse = std::numeric_limits<int>::max();
    for (int m = 3; m <= CompactSplit::max_exponent; ++m) {
      const int spacing = coarsest(cutoff, order, m, required_in_unit_box);
      if (spacing > coarse) break;
      if (spacing < coarse) mesh.exponent = m;
      coarse = spacing;
    }
    mesh.points = grid_of(box, spacing_of(coarse));
    const double seconds = pairs + expected_mesh_seconds(charges, mesh);
    if (seconds < best.seconds) best = {mesh, seconds};
  }
}

/// Finds the cheapest mesh. First, every fourth cutoff is tried, with splines of the usual order.
/// After that, the cutoffs around the best cutoff are tried with splines of all orders.
MeshSettings MeshChoice::cheapest(const Box& box) {
  constexpr int stride = 4;
  constexpr Orders all{MeshSettings::min_order, MeshSettings::max_order}, usual{5, 5};
  const double max = max_cutoff(topology_, box);
  Best best{{}, std::numeric_limits<double>::infinity()};
  if (settings_.coulomb_cutoff || max < cutoff_of(0)) {
    try_cutoff(settings_.coulomb_cutoff.value_or(settings_.cutoff), all, box, best);
    return best.mesh;
  }
  int around = 0;
  for (int n = 0; cutoff_of(n) <= max; n += stride) {
    const double before = best.seconds;
    try_cutoff(cutoff_of(n), usual, box, best);
    if (best.seconds < before) around = n;
  }
  for (int n = std::max(0, around - stride + 1); n < around + stride; ++n)
    if (cutoff_of(n) <= max) try_cutoff(cutoff_of(n), all, box, best);
  return best.mesh;
}

/// Advice for a mesh that is too fine: a longer cutoff, which allows a coarser mesh. Cutoffs are
/// tried in steps of 25 %.
std::string MeshChoice::remedy(const Box& box, const MeshSettings& best) const {
  const double max_points = max_points_for(ChargeDistribution(topology_).charges());
  ForceSettings longer = settings_;
  for (double cutoff = 1.25 * best.cutoff; cutoff < 0.45 * box.shortest_edge(); cutoff *= 1.25) {
    longer.coulomb_cutoff = cutoff;
    if (points_of(MeshChoice(topology_, longer).cheapest(box)) <= max_points)
      return fmt::format(
          "use a coulomb_cutoff of {:.2g} nm; even this longer cutoff includes only few pairs",
          1.05 * cutoff);
  }
  return "use a smaller box, or a larger pme_accuracy";
}

MeshSettings MeshChoice::operator()(const Box& box) {
  const MeshSettings best = cheapest(box);
  const double charges = ChargeDistribution(topology_).charges();
  const double max_points = max_points_for(charges);
  if (points_of(best) > max_points)
    throw Error(fmt::format(
        "a charge cutoff of {:g} nm and an accuracy of {:g} need {} x {} x {} mesh points for "
        "{:.0f} charges; the maximum for this number of charges is {:.2g} points, so {}",
        best.cutoff, settings_.pme_accuracy, best.points[0], best.points[1], best.points[2],
        charges, max_points, remedy(box, best)));
  return best;
}

MeshSettings mesh_for(const ForceSettings& settings, const Box& box, const Topology& topology) {
  return MeshChoice(topology, settings)(box);
}

MeshSettings mesh_for(double relative_error, double cutoff, const Box& box,
                      const Topology& topology) {
  ForceSettings settings;
  settings.pme_accuracy = relative_error;
  settings.coulomb_cutoff = cutoff;
  return mesh_for(settings, box, topology);
}

}  // namespace polhode
