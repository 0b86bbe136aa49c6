// SPDX-License-Identifier: MIT
#include "io/topology/potential_table.hpp"
#include "../fuzz.hpp"

void polhode::fuzz::read(std::string_view text) { parse_potential_table(text, "fuzz.txt"); }
