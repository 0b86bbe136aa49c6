// SPDX-License-Identifier: MIT
// A frame on its way into a file.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "polhode/io/frame_file.hpp"

namespace polhode {

/// A frame that need not be held whole: its atoms are visited one after another. It refers to what
/// it was made from.
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

/// Its atoms are all kept: which ones have no mass, a frame does not tell.
FrameView view_of(const Frame& frame, const FrameChoice& choice = {});

}  // namespace polhode
