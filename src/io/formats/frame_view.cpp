// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include "format.hpp"

namespace polhode {

FrameView view_of(const State& state, const Topology& topology, const FrameChoice& choice) {
  return {.title = title_of(state),
          .kinds = atom_kinds(topology, choice.massless),
          .atoms = atom_count(topology, choice.massless),
          .has_velocities = choice.velocities,
          .box = state.box,
          .time = state.time,
          .each_atom = [&state, &topology, massless = choice.massless](const auto& visit) {
            each_atom(state, topology, massless, visit);
          }};
}

FrameView view_of(const Frame& frame, const FrameChoice& choice) {
  return {.title = frame.title.empty() ? fmt::format("t= {:.6f}", frame.time) : frame.title,
          .kinds = frame.kinds,
          .atoms = frame.atoms.size(),
          .has_velocities = frame.has_velocities && choice.velocities,
          .box = frame.box,
          .time = frame.time,
          .each_atom = [&frame](const auto& visit) {
            for (const Atom& atom : frame.atoms) visit(atom);
          }};
}

}  // namespace polhode
