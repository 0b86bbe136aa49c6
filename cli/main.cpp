// SPDX-License-Identifier: MIT
// polhode: a table of verbs, one file each.
#include <fmt/core.h>

#include <algorithm>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include "polhode/base/error.hpp"
#include "polhode/base/memory.hpp"
#include "polhode/base/printable.hpp"
#include "polhode/base/suggest.hpp"
#include "polhode/base/version.hpp"
#include "streams.hpp"
#include "verbs.hpp"

namespace polhode::cli {
namespace {

struct Verb {
  const char* name;
  const char* description;
  Action (*declare)(CLI::App&);
};

const std::vector<Verb> verbs = {
    {"run", "simulate: a trajectory with its energies and summary", run_verb},
    {"study", "accuracy against cost of each scheme: the paper's figure", study_verb},
    {"advise", "choose scheme and step for a required accuracy, and confirm them by runs",
     advise_verb},
    {"energy", "energies, and with --forces the forces and torques, of an initial configuration",
     energy_verb},
    {"convert",
     "convert coordinates and trajectories between formats: GRO, PDB, XYZ, XTC, TRR, DCD, H5MD",
     convert_verb},
    {"analyze", "structure and dynamics from a trajectory: g(r), diffusion, relaxation",
     analyze_verb},
    {"molecules", "list the molecule models, or show one", molecules_verb},
    {"schemes", "list the splitting schemes, or show one", schemes_verb},
    {"top", "rotate a free top, exactly and by NO_SQUISH, or a table of tops", top_verb},
    {"verify", "measure the order of a scheme", verify_verb},
    {"tune-scheme", "optimise the scheme parameters for a system and step", tune_scheme_verb},
    {"bench", "measure the speed for water on this computer, and what limits it", bench_verb},
};

/// Options before the verb are left to the parser.
void check_verb(const std::string& word) {
  std::vector<std::string> names;
  for (const Verb& verb : verbs) names.emplace_back(verb.name);
  if (word.empty())
    throw Error(
        fmt::format("no verb is given; write 'polhode VERB' with one of: {}", join_names(names)));
  if (word[0] == '-' || std::find(names.begin(), names.end(), word) != names.end()) return;
  throw Error(fmt::format("there is no verb '{}'{} (there are: {})", word,
                          did_you_mean(word, names), join_names(names)));
}

int run(int argc, char** argv) {
  CLI::App app{"polhode: molecular dynamics of rigid molecules with the exact free rotor",
               "polhode"};
  app.set_version_flag("--version", fmt::format("polhode {}", version()));
  app.require_subcommand(1);
  std::vector<std::pair<CLI::App*, Action>> actions;
  for (const Verb& verb : verbs) {
    CLI::App* command = app.add_subcommand(verb.name, verb.description);
    actions.emplace_back(command, verb.declare(*command));
  }
  check_verb(argc > 1 ? argv[1] : "");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) return app.exit(e);  // help, version
    throw Error(
        fmt::format("{}; 'polhode {} --help' lists the options", uncapitalized(e.what()), argv[1]));
  }
  for (const auto& [command, action] : actions)
    if (command->parsed()) return action();
  return 2;
}

/// The message when memory runs out unexpectedly.
std::string no_memory() {
  return fmt::format(
      "there is not enough memory: this process may use {:.3g} GB; take fewer molecules, frames, "
      "lags or bins",
      memory_limit() / 1e9);
}

}  // namespace
}  // namespace polhode::cli

int main(int argc, char** argv) {
  using namespace polhode;
  cli::prepare_streams();
  try {
    return cli::exit_code(cli::run(argc, argv));
  } catch (const Error& e) {
    cli::log("error: {}\n", printable(e.what()));
    if (!e.where().empty()) cli::log("  in   {}\n", printable(e.where()));
    return cli::exit_code(2);
  } catch (const std::bad_alloc&) {
    cli::log("error: {}\n", cli::no_memory());
    return cli::exit_code(1);
  } catch (const std::length_error&) {  // more than can be addressed
    cli::log("error: {}\n", cli::no_memory());
    return cli::exit_code(1);
  } catch (const std::exception& e) {
    if (std::ferror(stdout)) return cli::exit_code(1);  // no more tokens
    cli::log("error: {}\n", printable(e.what()));
    return cli::exit_code(1);
  }
}
