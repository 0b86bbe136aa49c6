// SPDX-License-Identifier: MIT
// Numbers with as many digits as their errors justify.
#pragma once

#include <string>

namespace polhode {

/// "0.98834 ± 0.00021": the error with two digits, the value with the same decimals. A value whose
/// error is only rounding, or unknown (not finite), stands alone with six digits.
std::string with_error(double value, double error);

}  // namespace polhode
