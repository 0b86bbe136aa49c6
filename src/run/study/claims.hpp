// SPDX-License-Identifier: MIT
// The claims of the paper about its figure [vanzon2008], compared with the curves of a study.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "run/study/guideline.hpp"

namespace polhode {

enum class Verdict { reproduced, not_reproduced, undecided };

/// "reproduced", "not reproduced" or "not decided by these data".
const char* in_words(Verdict verdict);

/// A claim of the paper, with our number.
struct Claim {
  std::string text;
  std::optional<Estimate> value;
  Verdict verdict = Verdict::undecided;
};

/// Whether an estimate agrees with a number as it is printed, which stands for all that round to
/// it. Reproduced: its whole 95 % interval agrees, by Student's t; not reproduced: no part of it
/// does; otherwise the data do not decide.
/// @param degrees_of_freedom  of the error of x
/// @param half_digit  half a unit of the last digit printed
Verdict rounds_to(const Estimate& x, double degrees_of_freedom, double number, double half_digit);

/// The claims, where velocity-verlet, hoa2 and gier4-fd are among the curves; else none.
///
/// - HOA2 is "roughly 1.5 times more efficient", which stands for 1.45 to 1.55;
/// - GIER4 is preferable for "R < 0.4 %", for 0.35 to 0.45 %;
/// - for "R > 1.5 %" Verlet "is the only algorithm that is stable": it has steps there at which
///   the energy drift is known not to matter, and the curves of the others end before they reach
///   it. Not decided where the points about the ends of the three curves differ in their number of
///   runs.
std::vector<Claim> paper_claims(const std::vector<Curve>& curves);

}  // namespace polhode
