// SPDX-License-Identifier: MIT
#include "polhode/forces/pair_loops.hpp"

#include "polhode/base/pack.hpp"
#include "polhode/base/pack_column.hpp"
#include "polhode/forces/molecule_pair.hpp"

namespace polhode::POLHODE_LOOPS {

using Real = Pack<double>;

void site_arms(const QuaternionColumn& attitude, const std::vector<Vec3<double>>& sites,
               std::size_t first, std::size_t end, Vec3Column* arms) {
  // Whole packs from the one that holds `first` on: bodies of other types get arms, too, that their
  // own call overwrites where it comes later, so types are to be taken in order.
  for (std::size_t i = first / Real::width * Real::width; i < end; i += Real::width) {
    const Mat3<Real> S = matrix_S(load_pack<Real>(attitude, i));
    for (std::size_t k = 0; k < sites.size(); ++k) {
      const Vec3<double>& r = sites[k];
      const Vec3<Real> arm = S.row0 * Real(r.x) + S.row1 * Real(r.y) + S.row2 * Real(r.z);
      if (i >= first) {
        store_pack(arm, arms[k], i);
      } else {
        alignas(64) double x[Real::width], y[Real::width], z[Real::width];
        arm.x.store(x), arm.y.store(y), arm.z.store(z);
        for (std::size_t lane = first - i; lane < Real::width; ++lane)
          arms[k].set(i + lane, {x[lane], y[lane], z[lane]});
      }
    }
  }
}

namespace {

constexpr double far_away = 1e3;  // [nm]: beyond any cutoff, so that all switches are exactly 0

// Leaves in the buffer the partners that are in range now, without those that the list holds for
// its skin only, filled up to whole packs by copies of the first at a distance where nothing acts.
std::size_t gather_in_range(std::span<const Neighbour> partners, const PairJob& job,
                            const Vec3<double>& q_i, PartnerBuffer& buffer) {
  const Vec3Column& q = job.list.wrapped();
  std::size_t count = 0;
  for (const Neighbour partner : partners) {
    const std::size_t j = partner.body();
    const Vec3<double> R = q[j] - q_i + job.image_shifts[partner.image()];
    buffer.body[count] = static_cast<std::int64_t>(j);
    buffer.R.set(count, R);
    count += norm2(R) < job.range2 ? 1 : 0;
  }
  for (std::size_t k = count; k % Real::width != 0; ++k) {
    buffer.body[k] = buffer.body[0];
    buffer.R.set(k, {far_away, 0, 0});
  }
  return count;
}

template <Truncation truncation>
void pair_forces_of(const PairJob& job, PartnerBuffer& buffer, Load& load) {
  const PairTable& table = job.table;
  Vec3<Real> arm_a[most_sites], arm_b[most_sites];
  Real lennard_jones, coulomb;

  for (std::size_t i = job.first; i < job.end; ++i) {
    const std::size_t partners =
        gather_in_range(job.list.partners(i, job.partner_part), job, job.list.wrapped()[i], buffer);
    for (std::size_t a = 0; a < table.sites_a; ++a)
      arm_a[a] = {Real(job.arms[a].x[i]), Real(job.arms[a].y[i]), Real(job.arms[a].z[i])};
    Vec3<Real> f_i, tau_i;

    for (std::size_t start = 0; start < partners; start += Real::width) {
      const auto index = hn::Load(Real::IndexTag(), &buffer.body[start]);
      for (std::size_t b = 0; b < table.sites_b; ++b) {
        const Vec3Column& arms = job.arms[b];
        arm_b[b] = {gather(arms.x.data(), index), gather(arms.y.data(), index),
                    gather(arms.z.data(), index)};
      }
      const PairLoad<Real> pair = molecule_pair<truncation>(
          table, job.laws, load_pack<Real>(buffer.R, start), arm_a, arm_b);
      f_i -= pair.f;
      tau_i += pair.tau_a;
      lennard_jones += pair.lennard_jones;
      coulomb += pair.coulomb;

      alignas(64) double v[6][Real::width];
      pair.f.x.store(v[0]), pair.f.y.store(v[1]), pair.f.z.store(v[2]);
      pair.tau_b.x.store(v[3]), pair.tau_b.y.store(v[4]), pair.tau_b.z.store(v[5]);
      const std::size_t lanes = std::min(Real::width, partners - start);
      for (std::size_t lane = 0; lane < lanes; ++lane) {  // one by one: two lanes may be one body
        const auto j = static_cast<std::size_t>(buffer.body[start + lane]);
        load.f.add(j, {v[0][lane], v[1][lane], v[2][lane]});
        load.tau.add(j, {v[3][lane], v[4][lane], v[5][lane]});
      }
    }
    load.f.add(i, {sum(f_i.x), sum(f_i.y), sum(f_i.z)});
    load.tau.add(i, {sum(tau_i.x), sum(tau_i.y), sum(tau_i.z)});
  }
  load.lennard_jones += sum(lennard_jones);
  load.coulomb += sum(coulomb);
}

}  // namespace

void pair_forces(const PairJob& job, PartnerBuffer& buffer, Load& load) {
  if (job.laws.truncation == Truncation::molecule_switch)
    pair_forces_of<Truncation::molecule_switch>(job, buffer, load);
  else
    pair_forces_of<Truncation::reaction_field>(job, buffer, load);
}

}  // namespace polhode::POLHODE_LOOPS
