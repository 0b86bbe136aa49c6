// SPDX-License-Identifier: MIT
// Where bodies and their sites are: records for the loops over pairs.
#include <algorithm>
#include <array>

#include "polhode/base/pack_places.hpp"
#include "polhode/forces/pair_loops.hpp"

namespace polhode::POLHODE_LOOPS {
namespace {

template <class T>
double place(const PlaceJob<T>& job) {
  using Real = Pack<T>;
  using Double = Pack<double>;
  constexpr std::size_t parts = Real::width / Double::width;
  const auto packed = [](const std::array<Double, parts>& a) {
    if constexpr (parts == 1 && sizeof(T) == 8)
      return a[0];
    else
      return narrowed(a);
  };
  const State& state = job.state;
  const std::size_t numbers = 3 + 3 * job.sites.size();
  std::array<Real, 3 + 3 * most_sites + Real::width> column;
  Double largest, all;
  for (std::size_t s = job.first; s < job.end; s += Real::width) {
    std::array<Double, parts> centre[3];
    std::array<Mat3<Double>, parts> S;
    for (std::size_t h = 0; h < parts; ++h) {
      const std::size_t at = s + h * Double::width;
      const std::uint32_t* const body = &job.slots.body[at];
      Double moved2;
      const auto place = [&](const Column<double>& q, const Column<double>& built_at,
                             const Column<double>& in_box) {
        const Double moved = gathered(q.data(), body) - Double::load(&built_at[at]);
        moved2 += moved * moved;
        return Double::load(&in_box[at]) + moved;
      };
      centre[0][h] = place(state.q.x, job.slots.built_at.x, job.slots.place.x);
      centre[1][h] = place(state.q.y, job.slots.built_at.y, job.slots.place.y);
      centre[2][h] = place(state.q.z, job.slots.built_at.z, job.slots.place.z);
      largest = select(largest < moved2, moved2, largest);
      all += moved2;
      const QuaternionColumn& a = state.attitude;
      S[h] = matrix_S(Quaternion<Double>{gathered(a.w.data(), body), gathered(a.x.data(), body),
                                         gathered(a.y.data(), body), gathered(a.z.data(), body)});
    }
    for (std::size_t d = 0; d < 3; ++d) {
      if constexpr (sizeof(T) == 4) {
        for (Double& c : centre[d])
          c *= Double(static_cast<double>(fixed_point_edge) / state.box.edge[d]);
        column[d] = narrowed_to_fixed_point(centre[d]);
      } else {
        column[d] = centre[d][0];
      }
    }
    for (std::size_t k = 0; k < job.sites.size(); ++k) {
      const Vec3<double>& r = job.sites[k];
      std::array<Double, parts> arm[3];
      for (std::size_t h = 0; h < parts; ++h) {
        const Vec3<Double> site =
            S[h].row0 * Double(r.x) + S[h].row1 * Double(r.y) + S[h].row2 * Double(r.z);
        for (std::size_t d = 0; d < 3; ++d) arm[d][h] = site[d];
      }
      for (std::size_t d = 0; d < 3; ++d) column[3 + 3 * k + d] = packed(arm[d]);
    }
    for (std::size_t k = 0; k < numbers; k += Real::width) {
      Real row[Real::width];
      transpose<T>([&](std::size_t i) { return column[k + i]; }, row);
      for (std::size_t i = 0; i < Real::width; ++i) row[i].store(job.records.of(s + i) + k);
    }
  }
  alignas(pack_bytes) double lane[Double::width];
  largest.store(lane);
  const double moved2 = *std::max_element(lane, lane + Double::width);
  return sum(all) < 1e300 ? moved2 : 1e300;  // not where a position is no number
}

}  // namespace

double place_sites(const PlaceJob<double>& job) { return place(job); }
double place_sites(const PlaceJob<float>& job) { return place(job); }

}  // namespace polhode::POLHODE_LOOPS
