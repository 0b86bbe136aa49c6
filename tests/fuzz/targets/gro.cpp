// SPDX-License-Identifier: MIT
#include "fuzz.hpp"
#include "polhode/io/gro.hpp"

void polhode::fuzz::read(std::string_view text) { parse_gro(text, "fuzz.gro"); }
