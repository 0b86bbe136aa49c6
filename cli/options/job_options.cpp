// SPDX-License-Identifier: MIT
#include "job_options.hpp"

#include "../terminal/streams.hpp"
#include "base/threads.hpp"
#include "polhode/base/error.hpp"
#include "run/job_settings.hpp"

namespace polhode::cli {

void ResultForm::declare_verbose(Command& command) {
  command.add_flag("--verbose", verbose, "print tables and other details before the results");
}

void JobOptions::declare(Command& command, const std::string& of_threads) {
  declare_file(command);
  declare_threads(command, of_threads);
  command.add_flag("--json", json, "print the results as JSON");
}

void JobOptions::declare_file(Command& command, bool must_be_given) {
  command_ = command;
  command.add_option("FILE", file,
                     "run file (TOML), whose settings the options override; default: 512 TIP4P "
                     "waters",
                     must_be_given);
}

void JobOptions::declare_threads(Command& command, const std::string& of_threads) {
  command_ = command;
  command.add_option("--threads", threads,
                     "number of " + of_threads + "; default: one for each available core");
}

void JobOptions::declare_force(Command& command) {
  command_ = command;
  command.add_flag("--force", force, "overwrite output files that exist");
}

void JobOptions::declare_resume(Command& command) {
  command.add_flag("--resume,--continue", resume,
                   "resume from the last checkpoint; start a new run if there is none");
}

Config JobOptions::config(bool quick) const {
  Overlay overlay = overlay_of_job(command_->verb(), quick);
  for (const Override& one : command_->overlay().settings) overlay.settings.push_back(one);
  Config config = file.empty() ? default_config(overlay) : read_config(file, overlay);
  for (const std::string& note : config.notes) log("{}\n", note);
  return config;
}

OutputOptions JobOptions::output() const {
  if (resume && force)
    throw Error(
        "--resume and --force contradict each other: --resume continues the existing run, and "
        "--force starts over; give only one of the two");
  return {resume  ? ExistingFiles::resume
          : force ? ExistingFiles::replace
                  : ExistingFiles::refuse,
          command_->typed()};
}

Workers JobOptions::workers() const { return Workers(requested_threads(threads, "--threads")); }

}  // namespace polhode::cli
