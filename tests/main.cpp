// SPDX-License-Identifier: MIT
#define DOCTEST_CONFIG_IMPLEMENT
#include "skip.hpp"

int main(int argc, char** argv) { return polhode::exit_code(doctest::Context(argc, argv).run()); }
