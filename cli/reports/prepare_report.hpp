// SPDX-License-Identifier: MIT
// The results of a preparation as text.
#pragma once

#include "polhode/run/prepare/preparation.hpp"

namespace polhode::cli {

void print_preparation(const PreparationReport& report);

}  // namespace polhode::cli
