// SPDX-License-Identifier: MIT
// polhode minimise [FILE]: the nearest minimum of the energy, as a coordinate file.
#include <fmt/core.h>

#include <memory>
#include <string>

#include "../options/job_options.hpp"
#include "../options/option_values.hpp"
#include "../reports/reports.hpp"
#include "../terminal/console.hpp"
#include "../terminal/streams.hpp"
#include "../verbs.hpp"
#include "polhode/run/prepare/minimisation.hpp"

namespace polhode::cli {
namespace {

struct Options : JobOptions {
  std::string max_force, max_torque, output;
  int max_steps = static_cast<int>(MinimisationSettings{}.max_steps);
  bool force = false;
};

MinimisationSettings make_settings(const Options& o) {
  MinimisationSettings settings;
  const auto set = [](double& bound, const std::string& text, Dimension dimension,
                      const char* option, const char* example) {
    if (text.empty()) return;
    bound = quantity(text, dimension, option, example);
    if (!(bound > 0))
      throw Error(
          fmt::format("{} = \"{}\" must be above 0: rounding keeps forces from vanishing; "
                      "write for example \"{}\"",
                      option, text, example));
  };
  set(settings.force, o.max_force, Dimension::force, "--max-force", "10 kJ/mol/nm");
  set(settings.torque, o.max_torque, Dimension::energy, "--max-torque", "1 kJ/mol");
  settings.max_steps = static_cast<std::size_t>(o.max_steps);
  return settings;
}

int minimise(const Options& o) {
  const MinimisationSettings settings = make_settings(o);
  Config config = o.config();
  if (!o.output.empty()) config.output.prefix = o.output;
  Workers workers = o.workers();
  const MinimisationReport report = minimise_configuration(
      config, settings, {existing_files(false, o.force)}, console(), workers);
  print_results(quantities(report), o.json);
  if (!o.json) print_files({report.file});
  return report.minimisation.end == MinimisationEnd::stopped ? 130 : 0;
}

}  // namespace

Action minimise_verb(Command& command) {
  auto o = std::make_shared<Options>();
  o->declare(command, "threads");
  command.add_option("--max-force", o->max_force,
                     fmt::format("bound of the largest force on a molecule; default: \"{:g} "
                                 "kJ/mol/nm\"",
                                 MinimisationSettings{}.force));
  command.add_option("--max-torque", o->max_torque,
                     fmt::format("bound of the largest torque; default: \"{:g} kJ/mol\"",
                                 MinimisationSettings{}.torque));
  command.add_option("--max-steps", o->max_steps, "maximum number of steps")
      .in_range(1, 100'000'000)
      .show_default();
  command.add_option("--output", o->output, "prefix of the output file; default: the run file's");
  command.add_flag("--force", o->force, "overwrite an output file that exists");
  return [o] { return minimise(*o); };
}

}  // namespace polhode::cli
