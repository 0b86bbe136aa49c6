// SPDX-License-Identifier: MIT
#include "io/coordinates/gro.hpp"
#include "../fuzz.hpp"

void polhode::fuzz::read(std::string_view text) { parse_gro(text, "fuzz.gro"); }
