// SPDX-License-Identifier: MIT
#include "forces/mesh/particle_mesh.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "base/blocks.hpp"
#include "base/memory.hpp"
#include "forces/laws/ewald_split.hpp"
#include "fourier_loops.hpp"
#include "mesh_influence.hpp"
#include "polhode/base/error.hpp"

namespace polhode {
namespace {

template <class T>
void check(const MeshSettings& settings) {
  if (settings.order < MeshSettings::min_order || settings.order > MeshSettings::max_order)
    throw Error(fmt::format("the spline order of the mesh is {}; it must be from {} to {}",
                            settings.order, MeshSettings::min_order, MeshSettings::max_order));
  if (settings.exponent < 1 || settings.exponent > CompactSplit::max_exponent)
    throw Error(fmt::format("the splitting exponent is {}; it must be from 1 to {}",
                            settings.exponent, CompactSplit::max_exponent));
  for (const std::size_t points : settings.points)
    if (points < MeshSettings::max_order || points % mesh_multiple != 0)
      throw Error(
          fmt::format("the mesh has {} points along an edge; the number must be a multiple of {} "
                      "and at least {}, so that a spline does not overlap with itself",
                      points, mesh_multiple, MeshSettings::max_order));
  const auto [nx, ny, nz] = settings.points;
  // Memory per grid point: one number for charge or potential, one for the Fourier coefficient, and
  // half a number each for the influence function and its slope.
  const double bytes =
      3 * sizeof(T) * static_cast<double>(nx) * static_cast<double>(ny) * static_cast<double>(nz);
  require_memory(bytes, fmt::format("{} x {} x {} mesh points", nx, ny, nz),
                 "use a larger pme_accuracy, a longer cutoff or a smaller box");
}

void add_scaled(Mat3<double>& to, const Mat3<double>& what, double factor) {
  for (std::size_t d = 0; d < 3; ++d) to[d] += factor * what[d];
}

/// The shape of a tile for the instruction set in use.
template <class T>
MeshTile current_tile() {
  return POLHODE_CURRENT_OVERLOAD(mesh_tile, MeshTile(*)(const MeshGrid<T>*))(nullptr);
}

}  // namespace

template <class T>
struct ParticleMesh<T>::Plans {
  pocketfft::detail::cfftp<T> x, y;
  pocketfft::detail::rfftp<T> z;
  explicit Plans(const std::array<std::size_t, 3>& points)
      : x(points[0]), y(points[1]), z(points[2]) {}
};

template <class T>
struct ParticleMesh<T>::Field {
  MeshGrid<T> grid;
  MeshModes<T> modes;
  explicit Field(const MeshSettings& settings)
      : grid(settings.points, current_tile<T>(), static_cast<std::size_t>(settings.order - 1)),
        modes(grid) {}
};

template <class T>
ParticleMesh<T>::ParticleMesh(const Topology& topology, const MeshSettings& settings,
                              const Box& box, Workers& workers)
    : workers_(workers), settings_(settings), charges_(topology, settings) {
  check<T>(settings);
  plans_ = std::make_unique<Plans>(settings.points);
  field_ = std::make_unique<Field>(settings);
  set_box(box);
}

template <class T>
ParticleMesh<T>::~ParticleMesh() = default;

template <class T>
void ParticleMesh<T>::set_box(const Box& box) {
  has_potential_ = false;
  if (factors_.box == box) return;
  std::swap(factors_, earlier_);
  if (factors_.box != box) factors_ = factors_of(box);
}

/// Lays out the grid again if the instruction set has changed.
template <class T>
void ParticleMesh<T>::use_tiles() {
  if (field_->grid.tile == current_tile<T>()) return;
  field_ = std::make_unique<Field>(settings_);
  derivative_.reset();
  has_potential_ = false;
  earlier_ = {};
  factors_ = factors_of(factors_.box);
}

template <class T>
typename ParticleMesh<T>::Factors ParticleMesh<T>::factors_of(const Box& box) {
  Factors factors{box, {}, {}, {}};
  const Influence influence(settings_, box);
  const auto [nx, ny, nz] = settings_.points;
  for (std::size_t d = 0; d < 3; ++d) {
    for (std::size_t n = 0; n < settings_.points[d]; ++n) {
      factors.axes[d].k.push_back(influence.k(d, n));
      factors.axes[d].odd.push_back(2 * n == settings_.points[d] ? 0 : influence.k(d, n));
    }
  }
  const MeshModes<T>& modes = field_->modes;
  const std::size_t half_y = ny / 2 + 1, pack = modes.tile.size();
  loads_.resize(modes.columns());
  factors.influence = factors.slope = Column<T>(modes.columns() * half_y * pack);
  const InfluenceTable table(influence, settings_.points, box, workers_);
  workers_.each(modes.columns(), [&](std::size_t column) {
    for (std::size_t lane = 0; lane < pack; ++lane) {
      const auto [x, z] = modes.wave(column, lane);
      if (z > settings_.points[2] / 2) continue;
      for (std::size_t y = 0; y < half_y; ++y) {
        const InfluenceValue value = table({x, y, z});
        const std::size_t at = (column * half_y + y) * pack + lane;
        factors.influence[at] = static_cast<T>(value.factor);
        factors.slope[at] = static_cast<T>(value.slope);
      }
    }
  });
  return factors;
}

template <class T>
MeshLoad ParticleMesh<T>::operator()(const Slots& slots, const SiteRecords<T>& records, T* sums,
                                     bool energies) {
  spread(slots, records);
  MeshLoad load = convolve(energies);
  add_scaled(load.virial, gather(slots, records, sums, energies), -1);
  return load;
}

template <class T>
void ParticleMesh<T>::spread(const Slots& slots, const SiteRecords<T>& records) {
  use_tiles();
  spread_on(*field_, slots, records, nullptr);
}

template <class T>
void ParticleMesh<T>::spread_on(Field& field, const Slots& slots, const SiteRecords<T>& records,
                                const SiteRecords<T>* displacements) {
  charges_.place(slots, records, displacements, factors_.box, workers_);
  MeshGrid<T>& grid = field.grid;
  workers_.each(grid.rows(),
                [&](std::size_t y) { std::fill_n(&grid.values[y * grid.row], grid.row, T{}); });
  using Spread = void (*)(const SpreadJob<T>&);
  const auto spread = displacements ? POLHODE_CURRENT_OVERLOAD(spread_dipoles, Spread)
                                    : POLHODE_CURRENT_OVERLOAD(spread_charges, Spread);
  for (const std::size_t parity : {0u, 1u})
    workers_.each((charges_.slabs() + 1 - parity) / 2, [&](std::size_t k) {
      const auto listed = charges_.in_slab(2 * k + parity);
      spread({charges_.records(), charges_.moves(), listed.data(), listed.data() + listed.size(),
              settings_.order, grid});
    });
}

template <class T>
MeshLoad ParticleMesh<T>::convolve(bool energies) {
  has_potential_ = true;
  return convolve_on(*field_, energies);
}

template <class T>
MeshLoad ParticleMesh<T>::convolve_on(Field& field, bool energies) {
  using Transform = void (*)(const FourierRowJob<T>&);
  const auto to_modes = POLHODE_CURRENT_OVERLOAD(rows_to_modes, Transform),
             to_rows = POLHODE_CURRENT_OVERLOAD(modes_to_rows, Transform);
  const auto row = [&](std::size_t y) {
    return FourierRowJob<T>{plans_->z, plans_->x, field.grid, y, field.modes};
  };
  workers_.each(field.grid.rows(), [&](std::size_t y) { to_modes(row(y)); });
  workers_.each(field.modes.columns(),
                [&](std::size_t column) { convolve_column(field, column, energies); });
  workers_.each(field.grid.rows(), [&](std::size_t y) { to_rows(row(y)); });
  MeshLoad load;
  if (energies)
    for (const MeshLoad& column : loads_) {
      load.energy += column.energy;
      add_scaled(load.virial, column.virial, 1);
    }
  return load;
}

/// A unit of work: all k_y for a few values of k_x and k_z.
template <class T>
void ParticleMesh<T>::convolve_column(Field& field, std::size_t column, bool energies) {
  MeshModes<T>& modes = field.modes;
  const std::size_t ny = settings_.points[1], pack = modes.tile.size();
  const std::size_t at = column * (ny / 2 + 1) * pack;
  ModeSums sums;
  POLHODE_CURRENT_OVERLOAD(convolve, void (*)(const ConvolveJob<T>&, ModeSums*))
  ({plans_->y, &modes.values[column * modes.column], ny, &factors_.influence[at],
    &factors_.slope[at], factors_.axes[1].k.data(), factors_.axes[1].odd.data()},
   energies ? &sums : nullptr);
  if (!energies) return;
  MeshLoad load;
  Mat3<double>& virial = load.virial;
  for (std::size_t lane = 0; lane < pack; ++lane) {
    const auto [x, z] = modes.wave(column, lane);
    if (z > settings_.points[2] / 2) continue;
    // Only half of the sum over k is needed, because waves with k_z > 0 also represent −k.
    const double half = z == 0 || 2 * z == settings_.points[2] ? 0.5 : 1;
    const double energy = half * sums.energy[lane], slope = half * sums.slope[lane],
                 slope_y = half * sums.slope_y[lane];
    const double kx = factors_.axes[0].k[x], kz = factors_.axes[2].k[z],
                 odd_x = factors_.axes[0].odd[x], odd_z = factors_.axes[2].odd[z];
    load.energy += energy;
    virial[0].x += energy + slope * kx * kx;
    virial[1].y += energy + half * sums.slope_yy[lane];
    virial[2].z += energy + slope * kz * kz;
    virial[0].y += slope_y * odd_x;
    virial[0].z += slope * odd_x * odd_z;
    virial[1].z += slope_y * odd_z;
  }
  virial[1].x = virial[0].y, virial[2].x = virial[0].z, virial[2].y = virial[1].z;
  loads_[column] = load;
}

/// Calls gather(block, bodies) for the bodies in each task.
template <class T>
template <class Gather>
void ParticleMesh<T>::each_charged_block(const Slots& slots, const Gather& gather) {
  for (std::size_t p = 0; p < slots.parts.size(); ++p) {
    if (charges_.of_part(p).empty()) continue;
    const Slots::Part& part = slots.parts[p];
    each_block(part.count, slots_at_once, workers_, [&](std::size_t first, std::size_t end) {
      gather((part.first + first) / slot_block,
             MeshBodies{charges_.of_part(p), part.first + first, part.first + end});
    });
  }
}

template <class T>
Mat3<double> ParticleMesh<T>::gather(const Slots& slots, const SiteRecords<T>& records, T* sums,
                                     bool arms) {
  const auto gather_forces = POLHODE_CURRENT_OVERLOAD(gather_forces, void (*)(const GatherJob<T>&));
  arms_.assign(arms ? blocks(slots.size(), slot_block) : 0, {});
  each_charged_block(slots, [&](std::size_t block, const MeshBodies& bodies) {
    gather_forces({factors_.box, records, bodies, settings_.order, field_->grid, sums,
                   arms ? &arms_[block] : nullptr});
  });
  Mat3<double> total{};
  for (const Mat3<double>& own : arms_) add_scaled(total, own, 1);
  return total;
}

template <class T>
void ParticleMesh<T>::derivative(const Slots& slots, const SiteRecords<T>& records,
                                 const SiteRecords<T>& displacements, T* sums, bool charges_moved) {
  use_tiles();
  if (charges_moved || !has_potential_) {
    spread(slots, records);
    convolve(false);
  }
  if (!derivative_) derivative_ = std::make_unique<Field>(settings_);
  spread_on(*derivative_, slots, records, &displacements);
  convolve_on(*derivative_, false);
  const auto gather_derivative =
      POLHODE_CURRENT_OVERLOAD(gather_derivative, void (*)(const GatherDerivativeJob<T>&));
  each_charged_block(slots, [&](std::size_t, const MeshBodies& bodies) {
    gather_derivative(
        {{factors_.box, records, bodies, settings_.order, field_->grid, sums, nullptr},
         displacements,
         derivative_->grid});
  });
}

template class ParticleMesh<double>;
template class ParticleMesh<float>;

}  // namespace polhode
