// SPDX-License-Identifier: MIT
// Fills the records of positions and of displacements for the pair loops.
#include <algorithm>
#include <array>

#include "base/pack_integers.hpp"
#include "forces/pairs/pair_loops.hpp"

namespace polhode::POLHODE_LOOPS {
namespace {

// Converts one or two packs of doubles to one pack of T.
template <class T, std::size_t parts>
Pack<T> to_pack(const std::array<Pack<double>, parts>& a) {
  if constexpr (parts == 1 && sizeof(T) == 8)
    return a[0];
  else
    return demote(a);
}

// Transposes columns into the records of a pack of slots.
template <class T>
void store_records(const Pack<T>* column, std::size_t numbers, std::size_t slot,
                   SiteRecords<T>& records) {
  constexpr std::size_t width = Pack<T>::width;
  for (std::size_t k = 0; k < numbers; k += width) {
    Pack<T> row[width];
    transpose<T>([&](std::size_t i) { return column[k + i]; }, row);
    for (std::size_t i = 0; i < width; ++i) row[i].store(records.of(slot + i) + k);
  }
}

// The rotation matrix S (lab to body frame) of each body of a pack.
inline Mat3<Pack<double>> orientations(const QuaternionColumn& a, const std::uint32_t* body) {
  return matrix_S(
      Quaternion<Pack<double>>{gather_lanes(a.w.data(), body), gather_lanes(a.x.data(), body),
                               gather_lanes(a.y.data(), body), gather_lanes(a.z.data(), body)});
}

template <class T>
double place(const PlaceJob<T>& job) {
  using Real = Pack<T>;
  using Double = Pack<double>;
  constexpr std::size_t parts = Real::width / Double::width;
  const State& state = job.state;
  const std::size_t numbers = 3 + 3 * job.sites.size();
  std::array<Real, 3 + 3 * max_sites + Real::width> column;
  Double largest, all;
  for (std::size_t s = job.first; s < job.end; s += Real::width) {
    std::array<Double, parts> centre[3];
    std::array<Mat3<Double>, parts> S;
    for (std::size_t h = 0; h < parts; ++h) {
      const std::size_t at = s + h * Double::width;
      const std::uint32_t* const body = &job.slots.body[at];
      Double moved2;
      const auto place = [&](const auto& q, const auto& built_at, const auto& in_box) {
        const Double moved = gather_lanes(q.data(), body) - Double::load(&built_at[at]);
        moved2 += moved * moved;
        return Double::load(&in_box[at]) + moved;
      };
      centre[0][h] = place(state.q.x, job.slots.built_at.x, job.slots.place.x);
      centre[1][h] = place(state.q.y, job.slots.built_at.y, job.slots.place.y);
      centre[2][h] = place(state.q.z, job.slots.built_at.z, job.slots.place.z);
      largest = select(largest < moved2, moved2, largest);
      all += moved2;
      S[h] = orientations(state.orientation, body);
    }
    for (std::size_t d = 0; d < 3; ++d) {
      if constexpr (sizeof(T) == 4) {
        for (Double& c : centre[d])
          c *= Double(static_cast<double>(fixed_point_edge) / state.box.edge[d]);
        column[d] = demote_to_fixed_point(centre[d]);
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
      for (std::size_t d = 0; d < 3; ++d) column[3 + 3 * k + d] = to_pack<T>(arm[d]);
    }
    store_records<T>(column.data(), numbers, s, job.records);
  }
  alignas(pack_bytes) double lane[Double::width];
  largest.store(lane);
  const double moved2 = *std::max_element(lane, lane + Double::width);
  return sum(all) < 1e300 ? moved2 : 1e300;  // very large if any position is not finite
}

// Centres move by dq. A site at r in the body frame moves by Sᵀ (dθ × r) relative to its centre.
template <class T>
void displace(const DisplaceJob<T>& job) {
  using Real = Pack<T>;
  using Double = Pack<double>;
  constexpr std::size_t parts = Real::width / Double::width;
  std::array<Real, 3 + 3 * max_sites + Real::width> column;
  for (std::size_t s = job.first; s < job.end; s += Real::width) {
    std::array<Vec3<Double>, parts> dtheta;
    std::array<Mat3<Double>, parts> S;
    std::array<Double, parts> move[3];
    const auto put = [&](std::size_t k) {
      for (std::size_t d = 0; d < 3; ++d) column[k + d] = to_pack<T>(move[d]);
    };
    for (std::size_t h = 0; h < parts; ++h) {
      const std::uint32_t* const body = &job.slots.body[s + h * Double::width];
      const auto of = [&](const auto& c) { return gather_lanes(c.data(), body); };
      move[0][h] = of(job.dq.x), move[1][h] = of(job.dq.y), move[2][h] = of(job.dq.z);
      dtheta[h] = {of(job.dtheta.x), of(job.dtheta.y), of(job.dtheta.z)};
      S[h] = orientations(job.state.orientation, body);
    }
    put(0);
    for (std::size_t k = 0; k < job.sites.size(); ++k) {
      const Vec3<double>& r = job.sites[k];
      for (std::size_t h = 0; h < parts; ++h) {
        const Vec3<Double> turned =
            cross(dtheta[h], Vec3<Double>{Double(r.x), Double(r.y), Double(r.z)});
        const Vec3<Double> in_lab =
            S[h].row0 * turned.x + S[h].row1 * turned.y + S[h].row2 * turned.z;
        for (std::size_t d = 0; d < 3; ++d) move[d][h] = in_lab[d];
      }
      put(3 + 3 * k);
    }
    store_records<T>(column.data(), 3 + 3 * job.sites.size(), s, job.displacements);
  }
}

}  // namespace

void displace_sites(const DisplaceJob<double>& job) { displace(job); }
void displace_sites(const DisplaceJob<float>& job) { displace(job); }
double place_sites(const PlaceJob<double>& job) { return place(job); }
double place_sites(const PlaceJob<float>& job) { return place(job); }

}  // namespace polhode::POLHODE_LOOPS
