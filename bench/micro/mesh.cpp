// SPDX-License-Identifier: MIT
// Times the particle mesh of 512 TIP4P waters for every instruction set and precision. Separate
// times are measured for charge spreading, transforms with the influence function, and
// interpolation of the forces. The whole mesh is timed with and without energies. A mesh chosen for
// a given accuracy and larger boxes of water are timed as well. The time per charge should be the
// same for all box sizes.
#include <benchmark/benchmark.h>

#include <cmath>
#include <random>
#include <string>

#include "base/instruction_set.hpp"
#include "forces/mesh/particle_mesh.hpp"
#include "polhode/forces/mesh/mesh_choice.hpp"
#include "waters.hpp"

namespace {

using namespace polhode;
using bench::waters;

constexpr double cutoff = 0.9;

/// A state, stored in the data structures that the mesh code uses.
template <class T>
struct Placed {
  NeighbourList list;
  SiteRecords<T> records;
  Column<T> sums;

  explicit Placed(const System& system)
      : list(system.topology, {.cutoff = cutoff, .switch_from = 0.85 * cutoff, .skin = 0.05},
             system.state.box) {
    list.build(system.state, 16);
    const InteractionSites sites(system.topology.parts[0].molecule);
    records = SiteRecords<T>(list.slots().size(), sites.size());
    std::vector<Vec3<double>> places;
    for (const Site& site : sites.sites) places.push_back(site.r);
    POLHODE_CURRENT_OVERLOAD(place_sites, double (*)(const PlaceJob<T>&))
    ({system.state, list.slots(), places, 0, list.slots().size(), records});
    sums = Column<T>(list.slots().size() * ChunkSums<T>::stride);
  }
};

enum class What { spread, convolve, gather, forces, energies };

template <class T>
void mesh(benchmark::State& loop, InstructionSet instruction_set, What what, std::size_t copies,
          const MeshSettings& settings, int threads) {
  force_instruction_set(instruction_set);
  const System system = waters(copies);
  Placed<T> placed(system);
  Workers workers(threads);
  ParticleMesh<T> mesh(system.topology, settings, system.state.box, workers);
  const Slots& slots = placed.list.slots();
  for (auto _ : loop) switch (what) {
      case What::spread:
        mesh.spread(slots, placed.records);
        break;
      case What::convolve:  // acts on the previous result, so that it neither grows nor vanishes
        loop.PauseTiming();
        mesh.spread(slots, placed.records);
        loop.ResumeTiming();
        benchmark::DoNotOptimize(mesh.convolve(false));
        break;
      case What::gather:
        benchmark::DoNotOptimize(mesh.gather(slots, placed.records, placed.sums.data(), false));
        break;
      default:
        benchmark::DoNotOptimize(
            mesh(slots, placed.records, placed.sums.data(), what == What::energies));
    }
  loop.counters["points"] = static_cast<double>(settings.points[0]);
  loop.counters["order"] = settings.order;
  loop.counters["per_charge"] = benchmark::Counter(
      static_cast<double>(loop.iterations()) * 3 * static_cast<double>(system.state.size()),
      benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

template <class T>
void add(const std::string& name, InstructionSet instruction_set, What what, std::size_t copies,
         const MeshSettings& settings, int threads = 1) {
  benchmark::RegisterBenchmark(name.c_str(), mesh<T>, instruction_set, what, copies, settings,
                               threads)
      ->Unit(benchmark::kMicrosecond)
      ->UseRealTime();
}

template <class T>
void add_all(const std::string& precision) {
  // With these mesh settings, the relative force error in this water is 0.9e-4.
  const MeshSettings usual{{20, 20, 20}, 5, 5, cutoff};
  for (const InstructionSet instruction_set : available_instruction_sets()) {
    const std::string on = precision + "/" + name(instruction_set);
    add<T>("spread" + on, instruction_set, What::spread, 1, usual);
    add<T>("convolve" + on, instruction_set, What::convolve, 1, usual);
    add<T>("gather" + on, instruction_set, What::gather, 1, usual);
    add<T>("forces" + on, instruction_set, What::forces, 1, usual);
    add<T>("energies" + on, instruction_set, What::energies, 1, usual);
  }
  const InstructionSet best = available_instruction_sets().back();
  const System water = waters(1);
  for (const double error : {1e-3, 1e-4, 1e-5, 1e-6})
    add<T>("chosen/error=" + std::to_string(error).substr(0, 8) + precision, best, What::forces, 1,
           mesh_for(error, cutoff, water.state.box, water.topology));
  // Measures how the times depend on the spline order and on the number of grid points. The choice
  // of a mesh is based on the measured times (mesh_choice.cpp).
  for (int order = MeshSettings::min_order; order <= MeshSettings::max_order; ++order)
    add<T>("order=" + std::to_string(order) + precision, best, What::forces, 1,
           {{20, 20, 20}, order, 5, cutoff});
  for (std::size_t n = 16; n <= 64; n += n < 32 ? 4 : 8)
    add<T>("points=" + std::to_string(n) + precision, best, What::convolve, 1,
           {{n, n, n}, 5, 5, cutoff});
  for (const std::size_t copies : {2u, 4u, 6u}) {
    const std::size_t n = 20 * copies;
    add<T>("waters=" + std::to_string(512 * copies * copies * copies) + precision, best,
           What::forces, copies, {{n, n, n}, 5, 5, cutoff});
  }
  add<T>("threads=2" + precision, best, What::forces, 4, {{80, 80, 80}, 5, 5, cutoff}, 2);
}

}  // namespace

int main(int argc, char** argv) {
  add_all<double>("/double");
  add_all<float>("/mixed");
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
