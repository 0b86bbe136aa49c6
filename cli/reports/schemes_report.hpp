// SPDX-License-Identifier: MIT
// Schemes as text and as JSON.
#pragma once

#include <string>

#include "polhode/integrate/scheme.hpp"

namespace polhode::cli {

/// A scheme with its stages and its error.
void print_scheme(const Scheme& scheme);
/// All schemes of the table, one per line.
void print_schemes();

}  // namespace polhode::cli
