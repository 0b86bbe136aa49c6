// SPDX-License-Identifier: MIT
#include "io/topology/gromacs_mdp.hpp"
#include "../fuzz.hpp"

void polhode::fuzz::read(std::string_view text) { import_mdp(text, "fuzz.mdp"); }
