// SPDX-License-Identifier: MIT
#include "polhode/forces/pair_loops.hpp"

#include <array>

#include "polhode/base/pack.hpp"
#include "polhode/base/pack_column.hpp"
#include "polhode/forces/molecule_pair.hpp"

namespace polhode::POLHODE_LOOPS {

using Real = Pack<double>;

void site_arms(const QuaternionColumn& attitude, const std::vector<Vec3<double>>& sites,
               std::size_t first, std::size_t end, ArmRecords& arms) {
  for (std::size_t i = first / Real::width * Real::width; i < end; i += Real::width) {
    const Mat3<Real> S = matrix_S(load_pack<Real>(attitude, i));
    for (std::size_t k = 0; k < sites.size(); ++k) {
      const Vec3<double>& r = sites[k];
      const Vec3<Real> arm = S.row0 * Real(r.x) + S.row1 * Real(r.y) + S.row2 * Real(r.z);
      alignas(pack_bytes) double x[Real::width], y[Real::width], z[Real::width];
      arm.x.store(x), arm.y.store(y), arm.z.store(z);
      const std::size_t last = std::min(Real::width, end - i);
      for (std::size_t lane = i < first ? first - i : 0; lane < last; ++lane) {
        double* const record = arms.of(i + lane) + 3 * k;
        record[0] = x[lane], record[1] = y[lane], record[2] = z[lane];
      }
    }
  }
}

namespace {

constexpr double far_away = 1e3;  // [nm]: beyond any cutoff, so that all switches are exactly 0

// Leaves in the buffer the partners that are in range now, without those that the list holds for
// its skin only, filled up to whole packs by copies of the first at a distance where nothing acts.
std::size_t select_in_range(std::span<const Neighbour> partners, const PairJob& job,
                            const Vec3<double>& q_i, PartnerBuffer& buffer) {
  const Vec3Column& q = job.list.wrapped();
  std::size_t count = 0;
  for (const Neighbour partner : partners) {
    const std::size_t j = partner.body();
    const Vec3<double> R = q[j] - q_i + job.image_shifts[partner.image()];
    buffer.body[count] = static_cast<std::uint32_t>(j);
    buffer.R.set(count, R);
    count += norm2(R) < job.range2 ? 1 : 0;
  }
  for (std::size_t n = count; n % Real::width != 0; ++n) {
    buffer.body[n] = buffer.body[0];
    buffer.R.set(n, {far_away, 0, 0});
  }
  return count;
}

// The arms of the partners in the lanes of a pack.
template <class Shape>
class PartnerArms {
 public:
  PartnerArms(const PairJob& job, const std::uint32_t* body) {
    const Shape shape(job.table);
    const std::size_t numbers = 3 * (shape.charged_b + shape.dispersive_b);
    const double* row[Real::width];
    for (std::size_t lane = 0; lane < Real::width; ++lane) row[lane] = job.arms.of(body[lane]);
    for (std::size_t k = 0; k < numbers; k += Real::width) {
      load_transposed(row, &number_[k]);
      for (const double*& r : row) r += Real::width;
    }
  }
  Vec3<Real> operator()(std::size_t k) const {
    return {number_[3 * k], number_[3 * k + 1], number_[3 * k + 2]};
  }

 private:
  std::array<Real, 3 * Shape::most + Real::width> number_;
};

template <Truncation truncation, class Shape>
void pair_forces_of(const PairJob& job, PartnerBuffer& buffer, Load& load) {
  const PairTable& table = job.table;
  Vec3<Real> arm_a[Shape::most];
  Real lennard_jones, coulomb;

  for (std::size_t i = job.first; i < job.end; ++i) {
    const std::size_t partners =
        select_in_range(job.list.partners(i, job.partner_part), job, job.list.wrapped()[i], buffer);
    const double* const record = job.arms.of(i);
    for (std::size_t a = 0; a < table.arms_a(); ++a)
      arm_a[a] = {Real(record[3 * a]), Real(record[3 * a + 1]), Real(record[3 * a + 2])};
    Vec3<Real> f_i, tau_i;

    for (std::size_t start = 0; start < partners; start += Real::width) {
      const PairLoad<Real> pair =
          molecule_pair<truncation, Shape>(table, job.laws, load_pack<Real>(buffer.R, start), arm_a,
                                           PartnerArms<Shape>(job, &buffer.body[start]));
      f_i -= pair.f;
      tau_i += pair.tau_a;
      lennard_jones += pair.lennard_jones;
      coulomb += pair.coulomb;

      alignas(pack_bytes) double v[6][Real::width];
      pair.f.x.store(v[0]), pair.f.y.store(v[1]), pair.f.z.store(v[2]);
      pair.tau_b.x.store(v[3]), pair.tau_b.y.store(v[4]), pair.tau_b.z.store(v[5]);
      const std::size_t lanes = std::min(Real::width, partners - start);
      for (std::size_t lane = 0; lane < lanes; ++lane) {  // one by one: two lanes may be one body
        const std::size_t j = buffer.body[start + lane];
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

template <Truncation truncation>
void pair_forces_by_shape(const PairJob& job, PartnerBuffer& buffer, Load& load) {
  using Water = FixedShape<3, 3, 1, 1>;  // of three or four sites
  if (Water::fits(job.table))
    pair_forces_of<truncation, Water>(job, buffer, load);
  else
    pair_forces_of<truncation, AnyShape>(job, buffer, load);
}

}  // namespace

void pair_forces(const PairJob& job, PartnerBuffer& buffer, Load& load) {
  if (job.laws.truncation == Truncation::molecule_switch)
    pair_forces_by_shape<Truncation::molecule_switch>(job, buffer, load);
  else
    pair_forces_by_shape<Truncation::reaction_field>(job, buffer, load);
}

}  // namespace polhode::POLHODE_LOOPS
