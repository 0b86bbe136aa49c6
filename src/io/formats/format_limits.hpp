// SPDX-License-Identifier: MIT
// What a format cannot hold is refused here, before any of it is written.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "polhode/io/frame_file.hpp"

namespace polhode {

/// What the frames of a file can hold.
struct FormatLimits {
  std::size_t atoms = std::numeric_limits<std::size_t>::max();
  double lowest = -std::numeric_limits<double>::infinity();  ///< coordinate [nm]
  double highest = std::numeric_limits<double>::infinity();  ///< coordinate [nm]
  double edge = std::numeric_limits<double>::infinity();     ///< longest edge of the box [nm]
  bool same_atoms = false;       ///< all frames have as many atoms as the first
  bool same_velocities = false;  ///< all frames have velocities, or none
  bool even_times = false;       ///< one interval of time lies between all frames
};

/// What of a frame may be too much for a format.
struct FrameExtent {
  std::size_t atoms = 0;
  double lowest = 0, highest = 0;  ///< coordinates [nm]
  double edge = 0;                 ///< longest edge of the box [nm]
  bool has_velocities = false;
  double time = 0;        ///< [ps]
  bool of_a_run = false;  ///< frames come in the run's own interval, but for a last one perhaps
};

FrameExtent extent_of(const Frame& frame);

/// Of all frames that a run with this box can write: centres lie in the box, sites around them.
FrameExtent extent_of(const State& state, const Topology& topology, const FrameChoice& choice);

/// Checks frames on their way into one file.
class FrameFit {
 public:
  /// @param format  its ending, for errors
  FrameFit(std::string_view format, const FormatLimits& limits)
      : format_(format), limits_(limits) {}

  /// @throws Error  if the file cannot hold the frame after those before it
  void check(const FrameExtent& frame);

 private:
  void check_alone(const FrameExtent& frame) const;
  void check_time(const FrameExtent& frame) const;

  std::string format_;
  FormatLimits limits_;
  std::optional<FrameExtent> first_;
  double interval_ = 0;     // between the first two frames [ps]
  std::size_t before_ = 0;  // frames checked
};

}  // namespace polhode
