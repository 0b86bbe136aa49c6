// SPDX-License-Identifier: MIT
#include "job_options.hpp"

#include <utility>
#include <vector>

#include "option_values.hpp"
#include "polhode/base/threads.hpp"

namespace polhode::cli {

void JobOptions::declare(CLI::App& app, const std::string& of_threads) {
  app_ = &app;
  app.add_option("FILE", file, "run file (TOML); default: 512 TIP4P waters");
  app.add_option("--threads", threads,
                 "number of " + of_threads + "; default: one for each available core");
  app.add_flag("--json", json, "print the results as JSON");
}

void JobOptions::declare_precision(CLI::App& app) {
  app.add_option("--precision", precision,
                 "precision of pair interactions, double or mixed; default: the run file's");
}

void JobOptions::declare_initial_motion(CLI::App& app) {
  app.add_option(
      "--temperature", temperature,
      "for drawing velocities, and for equilibration: \"298 K\"; default: the run file's");
  app.add_option("--seed", seed,
                 "a whole number, for lattice and velocities; default: the run file's");
}

Config JobOptions::config() const {
  Config config = read_config_option(file, precision);
  set_initial_motion(config, temperature, seed);
  return config;
}

std::string JobOptions::command(std::initializer_list<const char*> options) const {
  std::vector<std::pair<std::string, std::string>> typed = {{"", file}};
  for (const char* option : options)
    if (const CLI::Option* given = app_->get_option(option); given->count() > 0)
      typed.emplace_back(option, given->as<std::string>());
  return typed_command("polhode " + app_->get_name(), typed);
}

Workers JobOptions::workers() const { return Workers(requested_threads(threads, "--threads")); }

}  // namespace polhode::cli
