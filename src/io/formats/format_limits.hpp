// SPDX-License-Identifier: MIT
// Checks before writing that a format can store a frame.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "polhode/io/coordinates/frame_file.hpp"

namespace polhode {

/// The limits of a file format.
struct FormatLimits {
  std::size_t atoms = std::numeric_limits<std::size_t>::max();
  double min = -std::numeric_limits<double>::infinity();  ///< smallest coordinate [nm]
  double max = std::numeric_limits<double>::infinity();   ///< largest coordinate [nm]
  double edge = std::numeric_limits<double>::infinity();  ///< longest edge of the box [nm]
  bool same_atoms = false;       ///< whether all frames must have the same number of atoms
  bool same_velocities = false;  ///< whether all frames or none must have velocities
  bool even_times = false;       ///< whether the interval between frames must be constant
};

/// The properties of a frame that a format limits.
struct FrameExtent {
  std::size_t atoms = 0;
  double min = 0, max = 0;  ///< smallest and largest coordinate [nm]
  double edge = 0;          ///< longest edge of the box [nm]
  bool has_velocities = false;
  double time = 0;        ///< time [ps]
  bool of_a_run = false;  ///< whether the interval is constant, except before the last frame
};

FrameExtent extent_of(const Frame& frame);

/// The extent of all frames that a run with a given box can write. Molecular centres are in the
/// box, but sites may be outside.
FrameExtent extent_of(const State& state, const Topology& topology, const FrameChoice& choice);

/// Checks the frames that are written to one file.
class FrameFit {
 public:
  /// @param format  file extension of the format, for error messages
  FrameFit(std::string_view format, const FormatLimits& limits)
      : format_(format), limits_(limits) {}

  /// Checks a frame.
  /// @throws Error  if the file cannot store the frame after the previous ones
  void check(const FrameExtent& frame);

 private:
  void check_alone(const FrameExtent& frame) const;
  void check_time(const FrameExtent& frame) const;

  std::string format_;
  FormatLimits limits_;
  std::optional<FrameExtent> first_;
  double interval_ = 0;     // interval between the first two frames [ps]
  std::size_t before_ = 0;  // number of frames checked so far
};

}  // namespace polhode
