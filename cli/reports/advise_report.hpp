// SPDX-License-Identifier: MIT
// The adviser's answer as a page of text.
#pragma once

#include "run/adviser/advice_report.hpp"

namespace polhode::cli {

void print_advice(const AdviceReport& report);

}  // namespace polhode::cli
