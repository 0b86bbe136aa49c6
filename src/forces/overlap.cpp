// SPDX-License-Identifier: MIT
#include "polhode/forces/overlap.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "polhode/base/error.hpp"

namespace polhode {
namespace {

struct Contact {
  std::uint32_t number = 0;  // of the site, in the order of the bodies
  std::uint32_t body = 0;
  Vec3<double> r;  // wrapped
};

struct Overlap {
  Contact later, earlier;
  double distance = 0;
};

using Cell = std::array<std::int64_t, 3>;

// Contacts sorted by the bucket of their cell. Cells are at least as wide as the closest contact,
// so that partners are in a cell or next to it. A bucket holds cells that may lie anywhere in the
// box: memory goes with the number of sites and not with the size of the box. Cells that follow one
// another along x are in buckets that do so, too.
class Buckets {
 public:
  Buckets(const Topology& topology, const State& state);
  /// The overlap whose later site, and then whose earlier one, comes first.
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
  // The start of a row of cells along x, mixed by odd constants (the golden ratio's and π's bits).
  static std::uint64_t row(std::int64_t y, std::int64_t z) {
    const std::uint64_t h = static_cast<std::uint64_t>(y) * 0x9E3779B97F4A7C15 +
                            static_cast<std::uint64_t>(z) * 0x243F6A8885A308D3;
    return h ^ h >> 29;
  }
  std::size_t bucket(std::uint64_t row_start, std::int64_t x) const {
    return (row_start + static_cast<std::uint64_t>(x)) & mask_;
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
  std::size_t mask_;
  std::vector<std::uint32_t> begin_;  // of each bucket, and the end
  std::vector<Contact> contacts_;     // of one bucket in the order of their numbers
};

// Calls visit(body, site position) for all sites that can touch, in the order of the bodies.
template <class Visit>
void each_site(const Topology& topology, const State& state, Visit visit) {
  std::size_t i = 0;
  for (const auto& [molecule, count] : topology.parts) {
    std::vector<Vec3<double>> sites;
    for (const Site& site : molecule.sites)
      if (site.mass != 0 || site.epsilon != 0) sites.push_back(site.r);
    for (std::size_t copy = 0; copy < count; ++copy, ++i) {
      const Vec3<double> q = state.q[i];
      const Mat3<double> to_lab = transpose(matrix_S(state.attitude[i]));
      for (const Vec3<double>& site : sites) {
        Vec3<double> r = q + to_lab * site;
        if (!std::isfinite(norm2(r)))
          throw Error(
              fmt::format("molecule {} has a position that is not finite; mend the start", i + 1));
        for (std::size_t d = 0; d < 3; ++d) {
          const double edge = state.box.edge[d];
          r[d] -= std::floor(r[d] / edge) * edge;
        }
        visit(i, r);
      }
    }
  }
}

Buckets::Buckets(const Topology& topology, const State& state) : edge_(state.box.edge) {
  constexpr double most = 1 << 30;
  for (std::size_t d = 0; d < 3; ++d)
    cells_[d] = static_cast<std::int64_t>(std::clamp(edge_[d] / (2 * closest_contact), 1.0, most));
  std::size_t sites = 0;
  for (const auto& [molecule, count] : topology.parts) sites += count * molecule.sites.size();
  if (sites > std::numeric_limits<std::uint32_t>::max())
    throw Error(fmt::format("{} sites are more than can be numbered ({}); run a smaller system",
                            sites, std::numeric_limits<std::uint32_t>::max()));
  mask_ = std::bit_ceil(std::max<std::size_t>(sites, 1)) - 1;
  begin_.assign(mask_ + 2, 0);
  const auto bucket_of = [&](const Vec3<double>& r) {
    const Cell cell = cell_of(r);
    return bucket(row(cell[1], cell[2]), cell[0]);
  };
  each_site(topology, state,
            [&](std::size_t, const Vec3<double>& r) { ++begin_[bucket_of(r) + 1]; });
  for (std::size_t k = 0; k <= mask_; ++k) begin_[k + 1] += begin_[k];
  contacts_.resize(begin_.back());
  std::uint32_t number = 0;
  each_site(topology, state, [&](std::size_t body, const Vec3<double>& r) {
    contacts_[begin_[bucket_of(r)]++] = {number++, static_cast<std::uint32_t>(body), r};
  });
  // Every bucket has been filled up to the beginning of the next.
  std::copy_backward(begin_.begin(), begin_.end() - 1, begin_.end());
  begin_.front() = 0;
}

std::optional<Overlap> Buckets::first_overlap() const {
  std::optional<Overlap> first;
  for (const Contact& later : contacts_) {
    if (first && later.number > first->later.number) continue;
    const Cell cell = cell_of(later.r);
    const auto beside = [&](std::size_t d, std::int64_t by) {
      const std::int64_t c = cell[d] + by;
      return c < 0 ? c + cells_[d] : c >= cells_[d] ? c - cells_[d] : c;
    };
    const std::array x = {beside(0, -1), cell[0], beside(0, 1)};
    for (std::int64_t dz = -1; dz <= 1; ++dz)
      for (std::int64_t dy = -1; dy <= 1; ++dy) {
        const std::uint64_t start = row(beside(1, dy), beside(2, dz));
        for (const std::int64_t cx : x) {
          const std::size_t b = bucket(start, cx);
          for (std::size_t k = begin_[b]; k < begin_[b + 1]; ++k) {
            const Contact& earlier = contacts_[k];
            if (earlier.number >= later.number) break;
            if (earlier.body == later.body) continue;
            const double d2 = distance2(earlier.r, later.r);
            if (!(d2 < closest_contact * closest_contact)) continue;
            if (first && first->later.number == later.number &&
                first->earlier.number <= earlier.number)
              continue;
            first = {later, earlier, std::sqrt(d2)};
          }
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
      "molecules {} and {} overlap: two of their sites are {:.4f} nm apart, closer "
      "than {:.3f} nm, half of a hydrogen bond; take a lower density or another start",
      found->earlier.body + 1, found->later.body + 1, found->distance, closest_contact));
}

}  // namespace polhode
