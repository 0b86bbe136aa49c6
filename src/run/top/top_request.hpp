// SPDX-License-Identifier: MIT
// The options that a front end received for a free top or a table of free tops, as texts.
#pragma once

#include <string>
#include <vector>

#include "polhode/base/vec3.hpp"
#include "run/given.hpp"

namespace polhode {

/// A free top and the times of its trajectory, in any consistent units.
struct FreeTop {
  Vec3<double> J, L;  ///< principal moments, and angular momentum in the body frame
  double step = 0, length = 0;
};

struct TopRequest {
  Given J, L, step, length, output, table, method;

  static std::vector<RequestOption<TopRequest>> options();
  /// The top that the request describes.
  /// @throws Error  unless the request has three moments and three components of L; the message
  ///   names the option
  FreeTop top() const;
  /// The rotations of a table of tops, see rotate_table().
  std::string rotated_table() const;
};

}  // namespace polhode
