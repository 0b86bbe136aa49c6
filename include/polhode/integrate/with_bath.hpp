// SPDX-License-Identifier: MIT
// Where the bath O of a thermostat stands among the stages of a scheme.
#pragma once

#include <algorithm>
#include <vector>

#include "polhode/base/error.hpp"
#include "polhode/integrate/scheme.hpp"

namespace polhode {

enum class BathPlace {
  ends,   ///< half of the bath before the first stage and half after the last stage: velocity
          ///< Verlet becomes OBABO
  middle  ///< bath within the middle stage: velocity Verlet becomes BAOAB [leimkuhler2013]
};

/// Adds bath stages O to a scheme. The fractions of the bath stages sum to one step. The new scheme
/// is e^{Oh/2} e^{Lh} e^{Oh/2}, or the bath stage O divides the middle stage into two halves.
/// @param name  name of the result, at most Scheme::max_name characters
/// @throws Error  if the scheme already has a bath, is not a palindrome (and so has no middle
///   stage), or would have too many stages
inline Scheme with_bath(const Scheme& scheme, BathPlace place, std::string_view name = "") {
  if (scheme.has(Flow::bath))
    throw Error("the scheme already has a bath O; use the scheme without with_bath()");
  std::vector<Stage> stages(scheme.stages().begin(), scheme.stages().end());
  if (stages.size() + 2 > Scheme::max_stages)
    throw Error("the scheme has too many stages for a bath; use a shorter scheme");
  switch (place) {
    case BathPlace::ends:
      stages.insert(stages.begin(), O(0.5));
      stages.push_back(O(0.5));
      break;
    case BathPlace::middle: {
      if (!scheme.palindromic())
        throw Error(
            "the scheme is not a palindrome, so it has no middle stage; put the bath at the ends, "
            "or write its stages O(...) yourself");
      const auto middle = stages.begin() + static_cast<std::ptrdiff_t>(stages.size() / 2);
      if (stages.size() % 2 == 0) {
        stages.insert(middle, O(1));
      } else {
        middle->fraction /= 2;
        const Stage half = *middle;
        stages.insert(middle + 1, {O(1), half});
      }
      break;
    }
  }
  return Scheme(stages, 0, name);
}

}  // namespace polhode
