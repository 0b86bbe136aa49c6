// SPDX-License-Identifier: MIT
#include "job_options.hpp"

#include <utility>
#include <vector>

#include "base/threads.hpp"
#include "option_values.hpp"

namespace polhode::cli {

void JobOptions::declare(Command& command, const std::string& of_threads) {
  command_ = command;
  command.add_option("FILE", file, "run file (TOML); default: 512 TIP4P waters");
  command.add_option("--threads", threads,
                     "number of " + of_threads + "; default: one for each available core");
  command.add_flag("--json", json, "print the results as JSON");
}

void JobOptions::declare_precision(Command& command) {
  command.add_option("--precision", precision,
                     "precision of pair interactions, double or mixed; default: the run file's");
}

void JobOptions::declare_initial_motion(Command& command) {
  command.add_option(
      "--temperature", temperature,
      "of thermostats, of new velocities and of the equilibration: \"298 K\"; default: the run "
      "file's");
  command.add_option("--seed", seed,
                     "a whole number, for lattice and velocities; default: the run file's");
}

Config JobOptions::config(const std::function<void(Config&)>& more) const {
  Config config = read_config_option(file, precision);
  if (more) more(config);
  set_initial_motion(config, temperature, seed);
  return config;
}

std::string JobOptions::command(std::initializer_list<const char*> options) const {
  std::vector<std::pair<std::string, std::string>> typed = {{"", file}};
  for (const char* option : options)
    if (const auto value = command_->given(option)) typed.emplace_back(option, *value);
  return typed_command("polhode " + command_->name(), typed);
}

Workers JobOptions::workers() const { return Workers(requested_threads(threads, "--threads")); }

}  // namespace polhode::cli
