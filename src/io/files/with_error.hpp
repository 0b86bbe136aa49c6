// SPDX-License-Identifier: MIT
// Numbers with as many digits as their errors justify.
#pragma once

#include <string>

namespace polhode {

/// A value with its error as text, such as "0.98834 ± 0.00021". The error has two digits, and the
/// value has the same number of decimals. If the error is only round-off, or unknown (not finite),
/// the value is printed without an error, with six digits.
std::string with_error(double value, double error);

}  // namespace polhode
