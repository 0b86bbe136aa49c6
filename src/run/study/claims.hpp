// SPDX-License-Identifier: MIT
// The claims of the paper about its figure [vanzon2008], compared with the curves of a study.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "run/study/guideline.hpp"

namespace polhode {

enum class Verdict { reproduced, not_reproduced, undecided };

/// A verdict as text: "reproduced", "not reproduced" or "not decided by these data".
const char* in_words(Verdict verdict);

/// A claim of the paper, with the number that the study found.
struct Claim {
  std::string text;
  std::optional<Estimate> value;
  Verdict verdict = Verdict::undecided;
};

/// The verdict on whether an estimate agrees with a number printed in the paper. The printed number
/// stands for all values that round to it. The verdict is reproduced if the whole 95 % interval
/// from Student's t agrees, and not reproduced if no part of the interval agrees. If only a part of
/// the interval agrees, the data do not decide.
/// @param degrees_of_freedom  degrees of freedom of the error of x
/// @param half_digit  half a unit of the last printed digit
Verdict rounds_to(const Estimate& x, double degrees_of_freedom, double number, double half_digit);

/// The claims of the paper, if velocity-verlet, hoa2 and gier4-fd are among the curves; otherwise
/// none.
///
/// - HOA2 is "roughly 1.5 times more efficient", which stands for 1.45 to 1.55;
/// - GIER4 is preferable for "R < 0.4 %", for 0.35 to 0.45 %;
/// - for "R > 1.5 %" Verlet "is the only algorithm that is stable": Verlet has steps in this range
///   at which the energy drift is certainly negligible, and the curves of the other schemes end
///   below this R. The claim is not decided if the points around the ends of the three curves have
///   different numbers of runs.
std::vector<Claim> paper_claims(const std::vector<Curve>& curves);

}  // namespace polhode
