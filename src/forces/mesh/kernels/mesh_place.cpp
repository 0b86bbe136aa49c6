// SPDX-License-Identifier: MIT
// Records of charges on the grid.
#include "mesh_positions.hpp"

namespace polhode::POLHODE_LOOPS {
namespace {

template <class T>
void place(const PlaceChargesJob<T>& job) {
  using Real = Pack<T>;
  constexpr std::size_t stride = ChargeRecord::stride;
  const std::size_t sites = job.bodies.charges.size();
  const auto rows = static_cast<std::int32_t>(job.points[1]);
  GridPositions<T> places(job.box, job.points, sites), moves(job.box, job.points, sites);
  for (std::size_t slot = job.bodies.first; slot < job.bodies.end; slot += Real::width) {
    places.load(job.records, slot);
    if (job.moves) moves.load(*job.displacements, slot);
    const std::size_t in_range = slot - job.bodies.first,
                      block = in_range / slot_block * slot_block;
    for (std::size_t site = 0; site < sites; ++site) {
      const std::size_t first = block * sites + site * slot_block + (in_range - block);
      Real numbers[4] = {places.place(site, 0), places.place(site, 1), places.place(site, 2),
                         Real(static_cast<T>(job.bodies.charges[site]))};
      beyond_point(numbers[1], rows, job.row + first);
      store_four<T>(numbers,
                    [&](std::size_t lane) { return job.charges + (first + lane) * stride; });
      if (!job.moves) continue;
      const Vec3<Real> v = moves.in_spacings(site);
      Real move[4] = {v.x, v.y, v.z, Real()};
      store_four<T>(move, [&](std::size_t lane) { return job.moves + (first + lane) * stride; });
    }
  }
}

}  // namespace

void place_charges(const PlaceChargesJob<double>& job) { place(job); }
void place_charges(const PlaceChargesJob<float>& job) { place(job); }

MeshTile mesh_tile(const MeshGrid<double>*) { return {Tile<double>::columns, Tile<double>::rows}; }
MeshTile mesh_tile(const MeshGrid<float>*) { return {Tile<float>::columns, Tile<float>::rows}; }

}  // namespace polhode::POLHODE_LOOPS
