// SPDX-License-Identifier: MIT
#include "forces/mesh/mesh_heat_flux.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "math/b_spline.hpp"
#include "math/pocketfft.hpp"

namespace polhode {
namespace {

using Weights = std::array<double, MeshSettings::max_order>;

/// The weights of a spline of an order that is known at run time.
template <int order = MeshSettings::min_order>
void spline(int wanted, double u, Weights& weight, Weights& slope) {
  if (wanted == order)
    b_spline<order>(u, weight.data(), slope.data());
  else if constexpr (order < MeshSettings::max_order)
    spline<order + 1>(wanted, u, weight, slope);
}

pocketfft::shape_t shape_of(const MeshSettings& s) {
  return {s.points[0], s.points[1], s.points[2]};
}
std::size_t half(const MeshSettings& s) { return s.points[2] / 2 + 1; }
template <class Number>
pocketfft::stride_t strides(std::size_t ny, std::size_t nz) {
  constexpr auto size = static_cast<std::ptrdiff_t>(sizeof(Number));
  const auto y = static_cast<std::ptrdiff_t>(nz) * size;
  return {static_cast<std::ptrdiff_t>(ny) * y, y, size};
}

}  // namespace

MeshHeatFlux::MeshHeatFlux(const Molecule& molecule, const MeshSettings& settings, const Box& box)
    : settings_(settings), box_(box) {
  const InteractionSites sites(molecule);
  for (std::size_t a = 0; a < sites.charged; ++a) charge_.push_back(sites.sites[a].charge);
  const Influence influence(settings, box);
  const auto [nx, ny, nz] = settings.points;
  for (std::size_t d = 0; d < 3; ++d)
    for (std::size_t n = 0; n < settings.points[d]; ++n) {
      k_[d].push_back(influence.k(d, n));
      odd_k_[d].push_back(2 * n == settings.points[d] ? 0 : influence.k(d, n));
    }
  const InfluenceTable table(influence, settings.points, box, Workers::serial());
  for (std::size_t x = 0; x < nx; ++x)
    for (std::size_t y = 0; y < ny; ++y)
      for (std::size_t z = 0; z < half(settings); ++z) influence_.push_back(table({x, y, z}));
  potential_ = change_ = Grid(nx * ny * nz);
  modes_ = change_modes_ = std::vector<std::complex<double>>(influence_.size());
}

MeshHeatFlux::Charge MeshHeatFlux::place(const Vec3<double>& position) const {
  Charge charge;
  for (std::size_t d = 0; d < 3; ++d) {
    const auto points = static_cast<double>(settings_.points[d]);
    const double edge = box_.edge[d], x = position[d] / edge;
    const double at = (x - std::floor(x)) * points, below = std::floor(at);
    charge.first[d] = static_cast<std::size_t>(below) % settings_.points[d];
    spline(settings_.order, at - below, charge.weight[d], charge.slope[d]);
    for (double& slope : charge.slope[d]) slope *= points / edge;
  }
  return charge;
}

/// Calls visit(index, weight, gradient of the weight) for each grid point near a charge.
template <class Visit>
void MeshHeatFlux::each_point(const Charge& charge, const Visit& visit) const {
  const auto order = static_cast<std::size_t>(settings_.order);
  const auto [nx, ny, nz] = settings_.points;
  const auto& [wx, wy, wz] = charge.weight;
  const auto& [sx, sy, sz] = charge.slope;
  for (std::size_t i = 0; i < order; ++i)
    for (std::size_t j = 0; j < order; ++j) {
      const std::size_t row = ((charge.first[0] + i) % nx * ny + (charge.first[1] + j) % ny) * nz;
      for (std::size_t k = 0; k < order; ++k)
        visit(row + (charge.first[2] + k) % nz, wx[i] * wy[j] * wz[k],
              Vec3<double>{sx[i] * wy[j] * wz[k], wx[i] * sy[j] * wz[k], wx[i] * wy[j] * sz[k]});
    }
}

void MeshHeatFlux::transform(const Grid& grid, std::vector<std::complex<double>>& modes) const {
  const auto [nx, ny, nz] = settings_.points;
  pocketfft::r2c(shape_of(settings_), strides<double>(ny, nz),
                 strides<std::complex<double>>(ny, half(settings_)), {0, 1, 2}, pocketfft::FORWARD,
                 grid.data(), modes.data(), 1.0);
}

void MeshHeatFlux::transform_back(const std::vector<std::complex<double>>& modes,
                                  Grid& grid) const {
  const auto [nx, ny, nz] = settings_.points;
  pocketfft::c2r(shape_of(settings_), strides<std::complex<double>>(ny, half(settings_)),
                 strides<double>(ny, nz), {0, 1, 2}, pocketfft::BACKWARD, modes.data(), grid.data(),
                 1.0);
}

/// Replaces charges by potentials. Returns Σ H k Im(dS/dt S*); the coefficients of the transform
/// are S*.
Vec3<double> MeshHeatFlux::convolve() {
  transform(potential_, modes_);
  transform(change_, change_modes_);
  const auto [nx, ny, nz] = settings_.points;
  Vec3<double> flux{};
  std::size_t at = 0;
  for (std::size_t x = 0; x < nx; ++x)
    for (std::size_t y = 0; y < ny; ++y)
      for (std::size_t z = 0; z < half(settings_); ++z, ++at) {
        const double both = z == 0 || 2 * z == nz ? 1 : 2;  // waves with k_z > 0 also represent −k
        const double turning = std::imag(std::conj(change_modes_[at]) * modes_[at]);
        flux += (both * influence_[at].slope * turning) *
                Vec3<double>{odd_k_[0][x], odd_k_[1][y], odd_k_[2][z]};
        modes_[at] *= influence_[at].factor;
        change_modes_[at] *= influence_[at].factor;
      }
  transform_back(modes_, potential_);
  transform_back(change_modes_, change_);
  return flux;
}

Vec3<double> MeshHeatFlux::operator()(const Motion& motion) {
  const std::size_t sites = charge_.size();
  const auto velocity = [&](std::size_t i, std::size_t a) {
    return motion.v[i] + cross(motion.omega[i], motion.arms[a][i]);
  };
  std::ranges::fill(potential_, 0);
  std::ranges::fill(change_, 0);
  std::vector<Charge> charges;
  charges.reserve(motion.q.size() * sites);
  for (std::size_t i = 0; i < motion.q.size(); ++i)
    for (std::size_t a = 0; a < sites; ++a) {
      const Vec3<double> v = velocity(i, a);
      each_point(charges.emplace_back(place(motion.q[i] + motion.arms[a][i])),
                 [&](std::size_t at, double weight, const Vec3<double>& gradient) {
                   potential_[at] += charge_[a] * weight;
                   change_[at] += charge_[a] * dot(v, gradient);
                 });
    }
  Vec3<double> flux = 0.5 * convolve();
  std::size_t number = 0;
  for (std::size_t i = 0; i < motion.q.size(); ++i)
    for (std::size_t a = 0; a < sites; ++a) {
      double phi = 0, chi = 0;
      Vec3<double> gradient_phi{};
      each_point(charges[number++],
                 [&](std::size_t at, double weight, const Vec3<double>& gradient) {
                   phi += weight * potential_[at];
                   chi += weight * change_[at];
                   gradient_phi += potential_[at] * gradient;
                 });
      const Vec3<double> v = velocity(i, a);
      flux += (charge_[a] / 2) *
              (phi * (motion.v[i] + v) + (dot(gradient_phi, v) - chi) * motion.arms[a][i]);
    }
  return flux;
}

/// The waves of the charges, each multiplied by factor(influence, k), as a function on the grid.
template <class Factor>
MeshHeatFlux::Grid MeshHeatFlux::convolved(const Factor& factor) {
  const auto [nx, ny, nz] = settings_.points;
  std::size_t at = 0;
  for (std::size_t x = 0; x < nx; ++x)
    for (std::size_t y = 0; y < ny; ++y)
      for (std::size_t z = 0; z < half(settings_); ++z, ++at)
        change_modes_[at] =
            factor(influence_[at], Vec3<double>{k_[0][x], k_[1][y], k_[2][z]}) * modes_[at];
  Grid grid(potential_.size());
  transform_back(change_modes_, grid);
  return grid;
}

void MeshHeatFlux::add_virials(const Motion& motion, Vec3Column& virials) {
  const std::size_t sites = charge_.size();
  std::ranges::fill(potential_, 0);
  std::vector<Charge> charges;
  charges.reserve(motion.q.size() * sites);
  for (std::size_t i = 0; i < motion.q.size(); ++i)
    for (std::size_t a = 0; a < sites; ++a)
      each_point(charges.emplace_back(place(motion.q[i] + motion.arms[a][i])),
                 [&](std::size_t at, double weight, const Vec3<double>&) {
                   potential_[at] += charge_[a] * weight;
                 });
  transform(potential_, modes_);
  const Grid phi =
      convolved([](const InfluenceValue& value, const Vec3<double>&) { return value.factor; });
  std::array<Grid, 3> along;
  for (std::size_t d = 0; d < 3; ++d)
    along[d] = convolved([d](const InfluenceValue& value, const Vec3<double>& k) {
      return value.factor + value.slope * k[d] * k[d];
    });
  std::size_t number = 0;
  for (std::size_t i = 0; i < motion.q.size(); ++i)
    for (std::size_t a = 0; a < sites; ++a) {
      Vec3<double> virial{}, gradient{};
      each_point(charges[number++], [&](std::size_t at, double weight, const Vec3<double>& slope) {
        virial += weight / 2 * Vec3<double>{along[0][at], along[1][at], along[2][at]};
        gradient += phi[at] * slope;
      });
      virials.add(i, charge_[a] * (virial + scaled(motion.arms[a][i], gradient)));
    }
}

}  // namespace polhode
