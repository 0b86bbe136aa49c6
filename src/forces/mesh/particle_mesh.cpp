// SPDX-License-Identifier: MIT
#include "polhode/forces/mesh/particle_mesh.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "../pairs/cache_lines.hpp"
#include "grid_transform.hpp"
#include "mesh_influence.hpp"
#include "polhode/base/blocks.hpp"
#include "polhode/base/error.hpp"
#include "polhode/base/memory.hpp"
#include "polhode/forces/mesh/self_interaction.hpp"

namespace polhode {
namespace {

constexpr std::size_t slots_at_once = 4 * slot_block;  // gathered per task

template <class T>
void check(const MeshSettings& settings) {
  if (settings.order < MeshSettings::min_order || settings.order > MeshSettings::max_order)
    throw Error(fmt::format("the spline order of the mesh is {}; it must be from {} to {}",
                            settings.order, MeshSettings::min_order, MeshSettings::max_order));
  if (settings.exponent < 1 || settings.exponent > CompactSplit::max_exponent)
    throw Error(fmt::format("the splitting exponent is {}; it must be from 1 to {}",
                            settings.exponent, CompactSplit::max_exponent));
  for (const std::size_t points : settings.points)
    if (points < MeshGrid<double>::overhang + 1)
      throw Error(
          fmt::format("the mesh has {} points along an edge; it must have at least {}, so that a "
                      "spline does not overlap with itself",
                      points, MeshGrid<double>::overhang + 1));
  const auto [nx, ny, nz] = settings.points;
  // Per grid point: the charges or their potential, and a quarter of a number each for the
  // influence function and its slope.
  const double bytes =
      1.5 * sizeof(T) * static_cast<double>(nx) * static_cast<double>(ny) * static_cast<double>(nz);
  require_memory(bytes, fmt::format("{} x {} x {} mesh points", nx, ny, nz),
                 "use a larger pme_accuracy, a longer cutoff or a smaller box");
}

/// Padding of a row, which holds its periodic continuation.
template <class T>
void fold(MeshGrid<T>& grid, std::size_t z, std::size_t beyond) {
  for (std::size_t y = 0; y < grid.points[1]; ++y) {
    T* const row = &grid.values[z * grid.plane + y * grid.row];
    for (std::size_t x = 0; x < beyond; ++x) row[x] += row[grid.points[0] + x];
  }
}
template <class T>
void unfold(MeshGrid<T>& grid, std::size_t z) {
  for (std::size_t y = 0; y < grid.points[1]; ++y) {
    T* const row = &grid.values[z * grid.plane + y * grid.row];
    std::copy_n(row, MeshGrid<T>::overhang, row + grid.points[0]);
  }
}

void add_scaled(Mat3<double>& to, const Mat3<double>& what, double factor) {
  for (std::size_t d = 0; d < 3; ++d) to[d] += factor * what[d];
}

}  // namespace

template <class T>
MeshGrid<T>::MeshGrid(const std::array<std::size_t, 3>& grid_points)
    : points(grid_points),
      row(spread_lines<T>(points[0] + overhang)),
      plane(odd_lines<T>(row * points[1])),
      values(plane * points[2]) {
  for (std::size_t y = 0; y < points[1] + overhang; ++y)
    row_at.push_back(static_cast<std::ptrdiff_t>(y % points[1] * row));
  for (std::size_t z = 0; z < points[2] + overhang; ++z)
    plane_at.push_back(static_cast<std::ptrdiff_t>(z % points[2] * plane));
}

MeshConstant::MeshConstant(const Topology& topology, const CompactSplit& split, const Box& box) {
  const SelfInteraction own(topology, split.polynomial());
  self = own.self;
  intramolecular = own.intramolecular;
  background = -units::coulomb / 2 * own.net * own.net * split.integral() / box.volume();
  for (std::size_t d = 0; d < 3; ++d) virial[d][d] = background;
}

template <class T>
struct ParticleMesh<T>::Field {
  MeshGrid<T> grid;
  GridTransform<T> transform;
  explicit Field(const MeshSettings& settings) : grid(settings.points), transform(grid) {}
};

template <class T>
ParticleMesh<T>::ParticleMesh(const Topology& topology, const MeshSettings& settings,
                              const Box& box, Workers& workers)
    : workers_(workers), settings_(settings) {
  check<T>(settings);
  for (const auto& part : topology.parts) {
    const InteractionSites sites(part.molecule);
    parts_.push_back({{}, part.molecule.extent(), {}});
    for (std::size_t k = 0; k < sites.charged; ++k)
      parts_.back().charges.push_back(sites.sites[k].charge);
  }
  field_ = std::make_unique<Field>(settings);
  const auto [nx, ny, nz] = settings.points;
  const std::size_t row = field_->transform.row();
  weight_ = kx_ = kx_squared_ = Column<T>(row);
  influence_ = slope_ = Column<T>((ny / 2 + 1) * (nz / 2 + 1) * row);
  make_slabs();
  const auto threads = static_cast<std::size_t>(workers.threads());
  const std::size_t tasks = threads == 1 ? 1 : std::min(ny, 4 * threads);
  for (std::size_t k = 0; k < tasks; ++k)
    spaces_.push_back(
        {Column<T>(row * nz), std::vector<const T*>(2 * nz), std::vector<ModeSums>(nz)});
  loads_.resize(ny);
  set_box(box);
}

template <class T>
ParticleMesh<T>::~ParticleMesh() = default;

template <class T>
void ParticleMesh<T>::set_box(const Box& box) {
  box_ = box;
  has_potential_ = false;
  make_influence();
  find_touched_planes();
}

/// The work is divided by the number of threads, but each grid point is summed in the order of
/// slots. Charges that touch two slabs are processed twice, so slabs should not be thin.
template <class T>
void ParticleMesh<T>::make_slabs() {
  const std::size_t nz = settings_.points[2];
  const auto threads = static_cast<std::size_t>(workers_.threads());
  const std::size_t thick = nz / (2 * static_cast<std::size_t>(settings_.order));
  const std::size_t slabs =
      threads == 1 ? 1 : std::min(groups(), std::clamp(thick, threads, 4 * threads));
  for (std::size_t s = 0; s < slabs; ++s) {
    Slab slab{0, std::vector<std::ptrdiff_t>(nz + MeshGrid<T>::overhang, -1), nz, 0};
    for (std::size_t z = 0; z < nz; ++z) {
      const std::size_t group = z * groups() / nz;
      if (group * slabs / groups() != s) continue;
      slab.groups |= std::uint64_t{1} << group;
      slab.first = std::min(slab.first, z), slab.end = z + 1;
    }
    for (std::size_t z = 0; z < slab.plane_at.size(); ++z)
      if (z % nz >= slab.first && z % nz < slab.end) slab.plane_at[z] = field_->grid.plane_at[z];
    slabs_.push_back(std::move(slab));
  }
}

/// Finds the groups of planes that charges can touch, for each plane of their centre.
template <class T>
void ParticleMesh<T>::find_touched_planes() {
  const std::size_t nz = settings_.points[2];
  const double spacing = box_.edge.z / static_cast<double>(nz);
  for (Part& part : parts_) {
    const auto before = static_cast<std::size_t>(std::ceil(part.extent / spacing)) + 1;
    const std::size_t span = 2 * before + static_cast<std::size_t>(settings_.order);
    part.touched.assign(nz + 1, 0);  // one more, as rounding may place a centre at the upper end
    for (std::size_t z = 0; z <= nz; ++z)
      for (std::size_t k = 0; k < std::min(span, nz); ++k)
        part.touched[z] |= std::uint64_t{1} << (z + k + before * (nz - 1)) % nz * groups() / nz;
  }
}

template <class T>
void ParticleMesh<T>::make_influence() {
  const Influence influence(settings_, box_);
  const std::size_t row = field_->transform.row(), modes_x = settings_.points[0] / 2 + 1;
  for (std::size_t d = 0; d < 3; ++d) {
    axes_[d] = {};
    for (std::size_t n = 0; n < settings_.points[d]; ++n) {
      axes_[d].k.push_back(influence.k(d, n));
      axes_[d].odd.push_back(2 * n == settings_.points[d] ? 0 : influence.k(d, n));
    }
  }
  for (std::size_t x = 0; x < modes_x; ++x)
    for (std::size_t part = 0; part < 2; ++part) {
      weight_[2 * x + part] = x == 0 || 2 * x == settings_.points[0] ? 1 : 2;
      kx_[2 * x + part] = static_cast<T>(axes_[0].odd[x]);
      kx_squared_[2 * x + part] = static_cast<T>(axes_[0].k[x] * axes_[0].k[x]);
    }
  const std::size_t half_y = settings_.points[1] / 2 + 1, half_z = settings_.points[2] / 2 + 1;
  workers_.each(half_y, [&](std::size_t y) {
    for (std::size_t z = 0; z < half_z; ++z)
      for (std::size_t x = 0; x < modes_x; ++x) {
        const InfluenceValue value = influence({x, y, z});
        for (std::size_t part = 0; part < 2; ++part) {
          const std::size_t at = (y * half_z + z) * row + 2 * x + part;
          influence_[at] = static_cast<T>(value.factor);
          slope_[at] = static_cast<T>(value.slope);
        }
      }
  });
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
  spread_on(*field_, slots, records, nullptr);
}

template <class T>
void ParticleMesh<T>::spread_on(Field& field, const Slots& slots, const SiteRecords<T>& records,
                                const SiteRecords<T>* displacements) {
  if (slabs_.size() > 1) find_extents(slots, records);
  workers_.each(slabs_.size(),
                [&](std::size_t s) { spread_to(field, s, slots, records, displacements); });
}

/// Finds the planes that the charges of each block of slots can touch.
template <class T>
void ParticleMesh<T>::find_extents(const Slots& slots, const SiteRecords<T>& records) {
  const double planes = static_cast<double>(settings_.points[2]);
  const double scale = planes / (std::is_same_v<T, float> ? fixed_point_edge : box_.edge.z);
  extents_.resize(slots.size() / slot_block);
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    const Slots::Part& part = slots.parts[p];
    const std::vector<std::uint64_t>& touched = parts_[p].touched;
    each_block(part.count, slot_block, workers_, [&](std::size_t first, std::size_t end) {
      std::uint64_t groups = 0;
      for (std::size_t slot = part.first + first; slot < part.first + end; ++slot) {
        double z;
        if constexpr (std::is_same_v<T, float>)
          z = std::bit_cast<std::int32_t>(records.of(slot)[2]);
        else
          z = records.of(slot)[2];
        z *= scale;
        z -= planes * std::floor(z / planes);
        groups |= touched[static_cast<std::size_t>(z)];
      }
      extents_[(part.first + first) / slot_block] = groups;
    });
  }
}

template <class T>
void ParticleMesh<T>::spread_to(Field& field, std::size_t s, const Slots& slots,
                                const SiteRecords<T>& records,
                                const SiteRecords<T>* displacements) {
  const Slab& slab = slabs_[s];
  MeshGrid<T>& grid = field.grid;
  std::fill(&grid.values[slab.first * grid.plane], grid.values.data() + slab.end * grid.plane, T{});
  const auto spread_charges =
      POLHODE_CURRENT_OVERLOAD(spread_charges, void (*)(const SpreadJob<T>&));
  const auto spread_dipoles =
      POLHODE_CURRENT_OVERLOAD(spread_dipoles, void (*)(const SpreadDipolesJob<T>&));
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    if (parts_[p].charges.empty()) continue;
    const Slots::Part& part = slots.parts[p];
    const auto spread_slots = [&](std::size_t first, std::size_t end) {
      const SpreadJob<T> job{box_,
                             records,
                             {parts_[p].charges, first, std::min<std::size_t>(end, part.end())},
                             settings_.order,
                             grid,
                             slab.plane_at.data()};
      if (displacements)
        spread_dipoles({job, *displacements});
      else
        spread_charges(job);
    };
    if (slabs_.size() == 1) {
      spread_slots(part.first, part.end());
      continue;
    }
    for (std::size_t slot = part.first; slot < part.end(); slot += slot_block)
      if (extents_[slot / slot_block] & slab.groups) spread_slots(slot, slot + slot_block);
  }
}

template <class T>
MeshLoad ParticleMesh<T>::convolve(bool energies) {
  has_potential_ = true;
  return convolve_on(*field_, energies);
}

template <class T>
MeshLoad ParticleMesh<T>::convolve_on(Field& field, bool energies) {
  const auto [nx, ny, nz] = settings_.points;
  workers_.each(nz, [&](std::size_t z) {
    fold(field.grid, z, static_cast<std::size_t>(settings_.order - 1));
    field.transform.plane(z);
  });
  workers_.each(spaces_.size(), [&](std::size_t task) {
    Space& space = spaces_[task];
    for (std::size_t y = task; y < settings_.points[1]; y += spaces_.size())
      convolve_row(field, y, space.modes.data(), space.rows.data(),
                   energies ? space.sums.data() : nullptr);
  });
  workers_.each(nz, [&](std::size_t z) {
    field.transform.plane_back(z);
    unfold(field.grid, z);
  });
  MeshLoad load;
  if (energies)
    for (const MeshLoad& row : loads_) {
      load.energy += row.energy;
      add_scaled(load.virial, row.virial, 1);
    }
  return load;
}

/// All k of one k_y: transforms along z, multiplies by the influence function, transforms back.
template <class T>
void ParticleMesh<T>::convolve_row(Field& field, std::size_t y, T* modes, const T** rows,
                                   ModeSums* sums) {
  const auto [nx, ny, nz] = settings_.points;
  const std::size_t row = field.transform.row(), half_z = nz / 2 + 1, row_y = std::min(y, ny - y);
  for (std::size_t z = 0; z < nz; ++z) {
    const std::size_t at = (row_y * half_z + std::min(z, nz - z)) * row;
    rows[z] = &influence_[at];
    rows[nz + z] = &slope_[at];
  }
  field.transform.columns(y, modes);
  POLHODE_CURRENT_OVERLOAD(convolve, void (*)(const ConvolveJob<T>&, ModeSums*))
  ({modes, row, nz, rows, rows + nz, weight_.data(), kx_.data(), kx_squared_.data()}, sums);
  field.transform.columns_back(y, modes);
  if (!sums) return;
  MeshLoad load;
  Mat3<double>& virial = load.virial;
  const double ky = axes_[1].k[y], odd_y = axes_[1].odd[y];
  for (std::size_t z = 0; z < nz; ++z) {
    const double kz = axes_[2].k[z], odd_z = axes_[2].odd[z];
    load.energy += sums[z].energy;
    virial[0].x += sums[z].energy + sums[z].slope_xx;
    virial[1].y += sums[z].energy + sums[z].slope * ky * ky;
    virial[2].z += sums[z].energy + sums[z].slope * kz * kz;
    virial[0].y += sums[z].slope_x * odd_y;
    virial[0].z += sums[z].slope_x * odd_z;
    virial[1].z += sums[z].slope * odd_y * odd_z;
  }
  virial[1].x = virial[0].y, virial[2].x = virial[0].z, virial[2].y = virial[1].z;
  loads_[y] = load;
}

/// Calls gather(block, bodies) for the bodies of each task.
template <class T>
template <class Gather>
void ParticleMesh<T>::each_charged_block(const Slots& slots, const Gather& gather) {
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    if (parts_[p].charges.empty()) continue;
    const Slots::Part& part = slots.parts[p];
    each_block(part.count, slots_at_once, workers_, [&](std::size_t first, std::size_t end) {
      gather((part.first + first) / slot_block,
             MeshBodies{parts_[p].charges, part.first + first, part.first + end});
    });
  }
}

template <class T>
Mat3<double> ParticleMesh<T>::gather(const Slots& slots, const SiteRecords<T>& records, T* sums,
                                     bool arms) {
  const auto gather_forces = POLHODE_CURRENT_OVERLOAD(gather_forces, void (*)(const GatherJob<T>&));
  arms_.assign(arms ? blocks(slots.size(), slot_block) : 0, {});
  each_charged_block(slots, [&](std::size_t block, const MeshBodies& bodies) {
    gather_forces({box_, records, bodies, settings_.order, field_->grid, sums,
                   arms ? &arms_[block] : nullptr});
  });
  Mat3<double> total{};
  for (const Mat3<double>& own : arms_) add_scaled(total, own, 1);
  return total;
}

template <class T>
void ParticleMesh<T>::derivative(const Slots& slots, const SiteRecords<T>& records,
                                 const SiteRecords<T>& displacements, T* sums, bool charges_moved) {
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
    gather_derivative({{box_, records, bodies, settings_.order, field_->grid, sums, nullptr},
                       displacements,
                       derivative_->grid});
  });
}

template struct MeshGrid<double>;
template struct MeshGrid<float>;
template class ParticleMesh<double>;
template class ParticleMesh<float>;

}  // namespace polhode
