// SPDX-License-Identifier: MIT
// The claims of the paper about its figure (vanzon2008), held against the curves of a study.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "polhode/run/guideline.hpp"

namespace polhode {

/// A claim of the paper, with our number.
struct Claim {
  std::string text;
  std::optional<Estimate> value;
  std::string reproduced;  ///< "reproduced", "not reproduced" or "not decided by these data"
};

/// The claims, where velocity-verlet, hoa2 and gier4 are among the curves; else none.
std::vector<Claim> paper_claims(const std::vector<Curve>& curves);

}  // namespace polhode
