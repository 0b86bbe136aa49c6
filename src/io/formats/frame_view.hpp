// SPDX-License-Identifier: MIT
// A frame to be written to a file.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "polhode/io/coordinates/frame_file.hpp"

namespace polhode {

/// A frame whose atoms are not all stored at once. A view visits the atoms one after another, and
/// stores only references to its sources.
struct FrameView {
  std::string title;
  std::vector<AtomKind> kinds;
  std::size_t atoms = 0;
  bool has_velocities = false;
  Box box;          ///< box [nm]
  double time = 0;  ///< time [ps]
  std::function<void(const std::function<void(const Atom&)>&)> each_atom;
};

FrameView view_of(const State& state, const Topology& topology, const FrameChoice& choice = {});

/// Makes a view of a frame. All atoms are written, because massless sites cannot be recognized
/// without masses.
FrameView view_of(const Frame& frame, const FrameChoice& choice = {});

}  // namespace polhode
