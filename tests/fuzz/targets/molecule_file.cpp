// SPDX-License-Identifier: MIT
#include "fuzz.hpp"
#include "polhode/io/molecule_file.hpp"

void polhode::fuzz::read(std::string_view text) { parse_molecule(text, "fuzz.toml"); }
