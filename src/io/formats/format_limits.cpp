// SPDX-License-Identifier: MIT
#include "format_limits.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "polhode/base/error.hpp"

namespace polhode {
namespace {

double max_edge(const Box& box) { return std::max({box.edge.x, box.edge.y, box.edge.z}); }

}  // namespace

FrameExtent extent_of(const Frame& frame) {
  FrameExtent extent{.atoms = frame.atoms.size(),
                     .edge = max_edge(frame.box),
                     .has_velocities = frame.has_velocities,
                     .time = frame.time};
  for (const Atom& atom : frame.atoms) {
    extent.min = std::min({extent.min, atom.r.x, atom.r.y, atom.r.z});
    extent.max = std::max({extent.max, atom.r.x, atom.r.y, atom.r.z});
  }
  return extent;
}

FrameExtent extent_of(const State& state, const Topology& topology, const FrameChoice& choice) {
  double extent = 0;
  for (const auto& part : topology.parts)
    for (const Site& site : part.molecule.sites) extent = std::max(extent, norm(site.r));
  const double edge = max_edge(state.box);
  return {.atoms = atom_count(topology, choice.massless),
          .min = -extent,
          .max = edge + extent,
          .edge = edge,
          .has_velocities = choice.velocities,
          .time = state.time,
          .of_a_run = true};
}

void FrameFit::check(const FrameExtent& frame) {
  check_alone(frame);
  if (!first_) first_ = frame;
  if (limits_.same_atoms && frame.atoms != first_->atoms)
    throw Error(
        fmt::format("the frame at {:g} ps has {} atoms, but the first frame has {}; all frames of "
                    "a .{} file must have the same number of atoms, so write GRO, PDB or XYZ",
                    frame.time, frame.atoms, first_->atoms, format_));
  if (limits_.same_velocities && frame.has_velocities != first_->has_velocities)
    throw Error(
        fmt::format("the frame at {:g} ps has {} velocities, but the first frame has {}; in a .{} "
                    "file either all frames or no frames have velocities, so write TRR or GRO",
                    frame.time, frame.has_velocities ? "its" : "no",
                    first_->has_velocities ? "them" : "none", format_));
  if (before_ == 1) interval_ = frame.time - first_->time;
  if (limits_.even_times && !frame.of_a_run) check_time(frame);
  ++before_;
}

void FrameFit::check_alone(const FrameExtent& frame) const {
  if (frame.atoms > limits_.atoms)
    throw Error(fmt::format(
        "a frame has {} atoms, but a frame of a .{} file can have at most {}; write another format",
        frame.atoms, format_, limits_.atoms));
  for (const double coordinate : {frame.min, frame.max})
    if (!(limits_.min <= coordinate && coordinate <= limits_.max))
      throw Error(fmt::format(
          "a coordinate may reach {:.10g} nm, but coordinates in a .{} file must be from {:.10g} "
          "to {:.10g} nm; write another format, or wrap molecules into the box",
          coordinate, format_, limits_.min, limits_.max));
  if (!(frame.edge <= limits_.edge))
    throw Error(
        fmt::format("a box edge is {:.10g} nm; in a .{} file box edges must be at most {:.10g} nm, "
                    "so write another format",
                    frame.edge, format_, limits_.edge));
}

// In the format with the lowest precision, times are floats with a relative round-off error of
// 2⁻²⁴. This round-off error affects the expected time twice: directly and, multiplied by the
// number of frames, through the interval.
void FrameFit::check_time(const FrameExtent& frame) const {
  if (before_ < 2) return;
  const auto n = static_cast<double>(before_);
  const double due = first_->time + n * interval_;
  const double rounding = 0x1p-22 * std::abs(frame.time) * (1 + n);
  if (std::abs(frame.time - due) <= 0.01 * std::abs(interval_) + rounding) return;
  throw Error(
      fmt::format("frame {} is at {:g} ps instead of {:g} ps (the first two frames are {:g} ps "
                  "apart); a .{} file needs equal intervals between frames, so choose evenly "
                  "spaced frames, or write another format",
                  before_ + 1, frame.time, due, interval_, format_));
}

}  // namespace polhode
