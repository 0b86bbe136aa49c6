// SPDX-License-Identifier: MIT
// Results of a run in words.
#pragma once

#include <string>

#include "polhode/run/adviser/guarantee.hpp"

namespace polhode {

/// The result of a drift test as text: "significant", "not significant", or the reason why the
/// significance is not known.
std::string verdict(const Drift& drift);

/// A guarantee check as text, such as "R = 0.31 ± 0.02 % over 15 ps; the accuracy guarantee is 0.4
/// %". If a bias is bounded, the text gives the bias instead of R.
std::string guarantee_text(const GuaranteeCheck& check);

}  // namespace polhode
