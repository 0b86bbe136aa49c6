// SPDX-License-Identifier: MIT
#include "polhode/io/topology/molecule_file.hpp"
#include "../fuzz.hpp"

void polhode::fuzz::read(std::string_view text) { parse_molecule(text, "fuzz.toml"); }
