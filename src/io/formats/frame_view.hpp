// SPDX-License-Identifier: MIT
// A frame to be written to a file.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "polhode/io/coordinates/frame_file.hpp"

namespace polhode {

/// A frame that is not stored as a whole: its atoms are visited one after another. It only refers
/// to its sources.
struct FrameView {
  std::string title;
  std::vector<AtomKind> kinds;
  std::size_t atoms = 0;
  bool has_velocities = false;
  Box box;          ///< [nm]
  double time = 0;  ///< [ps]
  std::function<void(const std::function<void(const Atom&)>&)> each_atom;
};

FrameView view_of(const State& state, const Topology& topology, const FrameChoice& choice = {});

/// All atoms are written, since a frame does not say which ones have no mass.
FrameView view_of(const Frame& frame, const FrameChoice& choice = {});

}  // namespace polhode
