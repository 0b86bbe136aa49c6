// SPDX-License-Identifier: MIT
#include "../frames.hpp"
#include "../fuzz.hpp"

void polhode::fuzz::read(std::string_view bytes) { read_all_frames(bytes, "dump"); }
