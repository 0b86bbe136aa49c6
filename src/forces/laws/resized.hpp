// SPDX-License-Identifier: MIT
#pragma once

#include "forces/laws/short_range.hpp"

namespace polhode {

/// The potential u(r/factor), in which all distances are multiplied by a factor.
/// @throws Error  if the factor of a tabulated potential is not 1, because the table would end
///   before the cutoff
ShortRange<double> resized(const ShortRange<double>& potential, double factor);

}  // namespace polhode
