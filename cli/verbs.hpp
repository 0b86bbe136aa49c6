// SPDX-License-Identifier: MIT
// The verbs of the command line. A verb declares its options on its own subcommand and returns a
// function to call after parsing, whose return value is the exit code.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace polhode::cli {

using Action = std::function<int()>;

Action advise_verb(CLI::App& app);
Action analyze_verb(CLI::App& app);
Action bench_verb(CLI::App& app);
Action convert_verb(CLI::App& app);
Action energy_verb(CLI::App& app);
Action run_verb(CLI::App& app);
Action molecules_verb(CLI::App& app);
Action schemes_verb(CLI::App& app);
Action study_verb(CLI::App& app);
Action top_verb(CLI::App& app);
Action tune_scheme_verb(CLI::App& app);
Action verify_verb(CLI::App& app);

}  // namespace polhode::cli
