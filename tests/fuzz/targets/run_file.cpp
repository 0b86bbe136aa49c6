// SPDX-License-Identifier: MIT
#include "../fuzz.hpp"
#include "polhode/io/settings/config.hpp"

void polhode::fuzz::read(std::string_view text) { parse_config(text, "fuzz.toml"); }
