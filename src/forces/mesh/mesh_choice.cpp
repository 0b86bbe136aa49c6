// SPDX-License-Identifier: MIT
#include "polhode/forces/mesh/mesh_choice.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "polhode/base/error.hpp"
#include "polhode/forces/laws/ewald_split.hpp"
#include "polhode/forces/pairs/pair_table.hpp"

namespace polhode {
namespace {

/// The charges of a system, and ⟨|S(k)|²⟩ for randomly placed bodies [e²].
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

/// The mean square error for given grid spacings in a box of 1 nm³; it falls as 1/V, and depends on
/// the box in no other way: the sum over wave vectors approximates an integral, so a small grid
/// suffices.
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
  double total = 0;
  for (std::size_t x = 0; x <= half; ++x)
    for (std::size_t y = 0; y <= half; ++y)
      for (std::size_t z = 0; z <= half; ++z) {
        if (x + y + z == 0) continue;
        if (cubic && (x > y || y > z)) continue;  // once for all orders of the three
        const int orders = !cubic || (x == y && y == z) ? 1 : x == y || y == z ? 3 : 6;
        // Sums over aliases of U², U² k², U² k² γ, and of the first and the last two times the form
        // factor.
        double u = 0, uk = 0, ukg = 0, u_form = 0, ukg_form = 0, kgg_form = 0;
        for (const Alias& a : axis[0][x])
          for (const Alias& b : axis[1][y])
            for (const Alias& c : axis[2][z]) {
              const double k2 = a.k * a.k + b.k * b.k + c.k * c.k, k = std::sqrt(k2);
              const double share = a.share * b.share * c.share, form = distribution.form(k);
              const double required = 4 * pi / k2 * split.transform(k).value;
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

/// Sizes suited to the transform: even, with small prime factors.
bool is_fft_size(std::size_t n) {
  if (n % 2 != 0) return false;
  for (const std::size_t factor : {2u, 3u, 5u, 7u})
    while (n % factor == 0) n /= factor;
  return n == 1;
}

/// Time per evaluation [s] from timings of bench_mesh on one core: a cost per charge and one per
/// grid point, both directions. The latter is that of FFTW, which has dedicated code for some
/// sizes; pocketfft takes 2.7 to 3.8 ns for nearly all sizes. With its costs, meshes would differ
/// in a third of the cases and be cheaper by 2 %; they are not used, so that results do not depend
/// on the library.
double expected_seconds(double charges, const MeshSettings& settings) {
  double points = 1, each = 0;
  for (const std::size_t n : settings.points) {
    points *= static_cast<double>(n);
    each += (n <= 16 || n == 20 || n == 32 || n == 64 || n == 128 ? 3.2e-9 : 6.2e-9) / 3;
  }
  return charges * (4e-9 + 1.25e-9 * settings.order * settings.order) + points * each;
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

namespace {

double points_of(const MeshSettings& mesh) {
  double points = 1;
  for (const std::size_t n : mesh.points) points *= static_cast<double>(n);
  return points;
}

/// The smallest grid of a suitable size whose points are at most `spacing` apart.
std::array<std::size_t, 3> grid_of(const Box& box, double spacing) {
  std::array<std::size_t, 3> points{};
  for (std::size_t d = 0; d < 3; ++d) {
    points[d] = std::max<std::size_t>(8, static_cast<std::size_t>(box.edge[d] / spacing));
    while (!is_fft_size(points[d]) || box.edge[d] > spacing * static_cast<double>(points[d]))
      ++points[d];
  }
  return points;
}

/// Liquids have 10 to 100 points per charge. In a sparsely filled box, a mesh with this many is
/// wasted work: there are few pairs even up to a longer cutoff, which allows a coarser mesh.
double max_points_for(double charges) { return std::max(0x1p21, 4096 * charges); }

}  // namespace

MeshChoice::MeshChoice(const Topology& topology, double relative_error, double cutoff)
    : topology_(topology), relative_error_(relative_error), cutoff_(cutoff) {
  if (!(relative_error >= 1e-7 && relative_error <= 0.1))
    throw Error(
        fmt::format("a relative force error of {} is requested of the mesh; it must be from 1e-7 "
                    "to 0.1",
                    relative_error));
  if (ChargeDistribution(topology).charges() == 0)
    throw Error(
        "no molecule has a charge, so PME has nothing to compute; use electrostatics = "
        "\"coulomb\"");
}

double MeshChoice::error(double spacing, int order, int exponent) {
  const auto [found, is_new] = errors_.try_emplace({spacing, order, exponent});
  if (is_new)
    found->second =
        std::sqrt(mean_square_error(ChargeDistribution(topology_), {spacing, spacing, spacing},
                                    order, CompactSplit(cutoff_, exponent)));
  return found->second;
}

MeshSettings MeshChoice::cheapest(const Box& box) {
  // In water the actual error is 0.3 to 1.5 times the expected one: smaller where molecules screen
  // each other, larger because of the coarse sum over wave vectors. The margin covers the larger
  // values.
  constexpr double margin = 1.5;
  const double required = relative_error_ * typical_force(topology_, box) / margin;
  const double required_in_unit_box = required * std::sqrt(box.volume());
  const double charges = ChargeDistribution(topology_).charges();
  MeshSettings best{{}, 0, 0, cutoff_};
  double min_seconds = std::numeric_limits<double>::infinity();
  for (int order = MeshSettings::min_order; order <= MeshSettings::max_order; ++order) {
    // For each exponent the coarsest sufficient spacing, which has a single maximum over exponents.
    double coarsest = 0;
    int exponent = 0;
    for (int m = 3; m <= CompactSplit::max_exponent; ++m) {
      double low = cutoff_ / 40, high = cutoff_ / 2;
      while (high / low > 1.03) {
        const double h = std::sqrt(low * high);
        (error(h, order, m) < required_in_unit_box ? low : high) = h;
      }
      if (low < coarsest) break;
      coarsest = low, exponent = m;
    }
    const MeshSettings found{grid_of(box, coarsest), order, exponent, cutoff_};
    const double seconds = expected_seconds(charges, found);
    if (seconds < min_seconds) min_seconds = seconds, best = found;
  }
  return best;
}

/// What to do about a mesh that is too fine: use the cutoff, increased in steps of a quarter, at
/// which it no longer is.
std::string MeshChoice::remedy(const Box& box, double max_points) const {
  for (double longer = 1.25 * cutoff_; longer < 0.45 * box.shortest_edge(); longer *= 1.25)
    if (points_of(MeshChoice(topology_, relative_error_, longer).cheapest(box)) <= max_points)
      return fmt::format("use a cutoff of {:.2g} nm, within which there are still few pairs",
                         1.05 * longer);
  return "use a smaller box, or a larger pme_accuracy";
}

MeshSettings MeshChoice::operator()(const Box& box) {
  const MeshSettings best = cheapest(box);
  const double charges = ChargeDistribution(topology_).charges();
  const double max_points = max_points_for(charges);
  if (points_of(best) > max_points)
    throw Error(fmt::format(
        "a cutoff of {:g} nm and an accuracy of {:g} need a mesh of {} x {} x {} points in this "
        "box, for {:.0f} charges; the limit for so few bodies is {:.2g}: {}",
        cutoff_, relative_error_, best.points[0], best.points[1], best.points[2], charges,
        max_points, remedy(box, max_points)));
  return best;
}

MeshSettings mesh_for(double relative_error, double cutoff, const Box& box,
                      const Topology& topology) {
  return MeshChoice(topology, relative_error, cutoff)(box);
}

}  // namespace polhode
