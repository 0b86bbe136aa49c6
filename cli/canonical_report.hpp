// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "polhode/run/canonical/canonical_report.hpp"

namespace polhode::cli {

/// Prints the report of a canonical study as text or JSON.
/// @param record  of its runs
/// @return  exit code
int print_canonical_study(const CanonicalReport& report, const std::string& record, bool json);

}  // namespace polhode::cli
