// SPDX-License-Identifier: MIT
#include "forces/pairs/overlap.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "base/counting_sort.hpp"
#include "model/wrap.hpp"
#include "polhode/base/error.hpp"

namespace polhode {
namespace {

struct Contact {
  std::uint32_t number = 0;  // index of the site in the order of the bodies
  std::uint32_t body = 0;
  Vec3<double> r;  // wrapped position
};

struct Overlap {
  Contact later, earlier;
  double distance = 0;
};

using Cell = std::array<std::int64_t, 3>;

// Sites that can overlap, sorted by the bucket of their cell. Cells are at least as wide as the
// smallest allowed distance, so overlapping sites are in the same or adjacent cells. Cells are
// assigned to buckets row by row and layer by layer; the assignment wraps around if there are more
// cells than buckets. Memory therefore scales with the number of sites rather than the volume of
// the box. Sites that are close in the box are mostly close in memory.
class Buckets {
 public:
  Buckets(const Topology& topology, const State& state);
  /// The first overlap in the order of its later site, and then of its earlier site.
  std::optional<Overlap> first_overlap() const;

 private:
  Cell cell_of(const Vec3<double>& r) const {
    Cell cell;
    for (std::size_t d = 0; d < 3; ++d) {
      const double c = r[d] / edge_[d] * static_cast<double>(cells_[d]);
      cell[d] = static_cast<std::int64_t>(std::clamp(c, 0.0, static_cast<double>(cells_[d] - 1)));
    }
    return cell;
  }
  std::size_t bucket(std::int64_t x, std::int64_t y, std::int64_t z) const {
    return (static_cast<std::uint64_t>(x) + static_cast<std::uint64_t>(y) * row_ +
            static_cast<std::uint64_t>(z) * layer_) &
           mask_;
  }
  double distance2(const Vec3<double>& a, const Vec3<double>& b) const {
    double sum = 0;
    for (std::size_t d = 0; d < 3; ++d) {
      const double inside = std::abs(a[d] - b[d]);
      const double nearest = std::min(inside, std::abs(edge_[d] - inside));
      sum += nearest * nearest;
    }
    return sum;
  }

  Vec3<double> edge_;
  Cell cells_;
  std::uint64_t row_, layer_;        // strides in buckets; odd, so that few cells share a bucket
  std::uint64_t mask_;               // number of buckets, a power of two, minus one
  std::vector<std::uint32_t> ends_;  // one past the last contact of each bucket
  std::vector<Contact> contacts_;    // contacts; within a bucket, in the order of their numbers
};

bool can_overlap(const Site& site) { return site.mass != 0 || site.has_short_range(); }

// Calls visit(body, site position) for each site that can overlap, in the order of the bodies.
template <class Visit>
void each_site(const Topology& topology, const State& state, Visit visit) {
  std::size_t i = 0;
  for (const auto& [molecule, count] : topology.parts) {
    std::vector<Vec3<double>> sites;
    for (const Site& site : molecule.sites)
      if (can_overlap(site)) sites.push_back(site.r);
    for (std::size_t copy = 0; copy < count; ++copy, ++i) {
      const Vec3<double> q = state.q[i];
      const Mat3<double> to_lab = transpose(matrix_S(state.orientation[i]));
      for (const Vec3<double>& site : sites) {
        const Vec3<double> r = q + to_lab * site;
        if (!std::isfinite(norm2(r)))
          throw Error(fmt::format(
              "molecule {} has a position that is not finite; correct the initial configuration",
              i + 1));
        visit(i, wrapped(r, state.box));
      }
    }
  }
}

Buckets::Buckets(const Topology& topology, const State& state) : edge_(state.box.edge) {
  constexpr double max_cells = 1 << 30;
  for (std::size_t d = 0; d < 3; ++d)
    cells_[d] =
        static_cast<std::int64_t>(std::clamp(edge_[d] / (2 * closest_contact), 1.0, max_cells));
  row_ = static_cast<std::uint64_t>(cells_[0]) | 1;
  layer_ = (static_cast<std::uint64_t>(cells_[1]) * row_) | 1;
  std::size_t sites = 0, contacts = 0;
  for (const auto& [molecule, count] : topology.parts) {
    sites += count * molecule.sites.size();
    contacts += count * static_cast<std::size_t>(std::count_if(molecule.sites.begin(),
                                                               molecule.sites.end(), can_overlap));
  }
  if (sites > std::numeric_limits<std::uint32_t>::max())
    throw Error(
        fmt::format("the system has {} sites, more than can be indexed ({}); use a smaller system",
                    sites, std::numeric_limits<std::uint32_t>::max()));
  mask_ = std::bit_ceil(std::max<std::size_t>(sites, 1)) - 1;
  ends_.resize(mask_ + 1);
  const auto bucket_of = [&](const Vec3<double>& r) {
    const Cell cell = cell_of(r);
    return bucket(cell[0], cell[1], cell[2]);
  };
  const auto each = [&](const auto& visit) {
    std::uint32_t number = 0;
    each_site(topology, state, [&](std::size_t body, const Vec3<double>& r) {
      visit(bucket_of(r), Contact{number++, static_cast<std::uint32_t>(body), r});
    });
  };
  contacts_.resize(contacts);
  counting_sort(ends_, 0, each,
                [&](std::uint32_t place, const Contact& contact) { contacts_[place] = contact; });
}

std::optional<Overlap> Buckets::first_overlap() const {
  std::optional<Overlap> first;
  for (const Contact& later : contacts_) {
    if (first && later.number > first->later.number) continue;
    const Cell cell = cell_of(later.r);
    const auto adjacent = [&](std::size_t d, std::int64_t by) {
      const std::int64_t c = cell[d] + by;
      return c < 0 ? c + cells_[d] : c >= cells_[d] ? c - cells_[d] : c;
    };
    const auto compare = [&](std::size_t from, std::size_t to) {
      for (std::size_t k = from; k < to; ++k) {
        const Contact& earlier = contacts_[k];
        if (!(distance2(earlier.r, later.r) < closest_contact * closest_contact)) continue;
        if (earlier.number >= later.number || earlier.body == later.body) continue;
        if (first && first->later.number == later.number && first->earlier.number <= earlier.number)
          continue;
        first = {later, earlier, std::sqrt(distance2(earlier.r, later.r))};
      }
    };
    for (std::int64_t dz = -1; dz <= 1; ++dz)
      for (std::int64_t dy = -1; dy <= 1; ++dy) {
        const std::int64_t y = adjacent(1, dy), z = adjacent(2, dz);
        const std::size_t left = bucket(adjacent(0, -1), y, z),
                          right = bucket(adjacent(0, 1), y, z);
        if (left + 2 == right) {
          compare(begin_of(ends_, left), ends_[right]);
        } else {
          for (const std::size_t b : {left, bucket(cell[0], y, z), right})
            compare(begin_of(ends_, b), ends_[b]);
        }
      }
  }
  return first;
}

}  // namespace

void check_overlap(const Topology& topology, const State& state) {
  const auto found = Buckets(topology, state).first_overlap();
  if (!found) return;
  throw Error(fmt::format(
      "molecules {} and {} overlap: two of their sites are {:.4f} nm apart, closer than {:.3f} nm; "
      "write minimise = true in [run], or use 'polhode minimise', another initial configuration or "
      "a lower density",
      found->earlier.body + 1, found->later.body + 1, found->distance, closest_contact));
}

}  // namespace polhode
