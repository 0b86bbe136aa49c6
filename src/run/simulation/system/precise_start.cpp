// SPDX-License-Identifier: MIT
#include "run/simulation/system/precise_start.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/version.hpp"
#include "polhode/base/error.hpp"
#include "run/simulation/files/checkpoint.hpp"

namespace polhode {
namespace {

constexpr double max_deviation = 0.002;  // maximum deviation [nm], which is twice the last digit of
                                         // most GRO files
constexpr auto remedy =
    "give the coordinate file that was written with the checkpoint, or leave the checkpoint out to "
    "start from the rounded coordinates of the file";

/// The largest distance between the positions of a site in two states, up to periodic images [nm].
double deviation(const Molecule& molecule, std::size_t i, const State& a, const State& b) {
  const Vec3<double> centre = a.box.minimum_image(a.q[i] - b.q[i]);
  double largest = norm(centre);
  for (const Site& site : molecule.sites)
    largest = std::max(largest, norm(centre + to_lab(a.orientation[i], site.r) -
                                     to_lab(b.orientation[i], site.r)));
  return largest;
}

void check_same(const System& system, const State& state) {
  const State& start = system.state;
  if (state.size() != start.size())
    throw Error(
        fmt::format("the checkpoint has {} molecules, but the initial configuration has {}; {}",
                    state.size(), start.size(), remedy));
  for (std::size_t k = 0; k < 3; ++k)
    if (!(std::abs(state.box.edge[k] - start.box.edge[k]) <= max_deviation))
      throw Error(
          fmt::format("the box of the checkpoint has an edge of {:.6g} nm, but the initial "
                      "configuration has {:.6g} nm; {}",
                      state.box.edge[k], start.box.edge[k], remedy));
  for (std::size_t i = 0; i < state.size(); ++i)
    if (const double d =
            deviation(system.topology.parts[system.bodies.part[i]].molecule, i, state, start);
        !(d <= max_deviation))
      throw Error(
          fmt::format("molecule {} of the checkpoint is {:.3g} nm from its position in the initial "
                      "configuration, more than {:g} nm; {}",
                      i + 1, d, max_deviation, remedy));
}

}  // namespace

void take_checkpoint(System& system, const std::string& path) {
  State state = state_of_checkpoint(path, version());
  check_same(system, state);
  state.time = system.state.time;
  system.state = std::move(state);
}

}  // namespace polhode
