// SPDX-License-Identifier: MIT
// The options that jobs have in common.
#pragma once

#include <optional>
#include <string>

#include "command.hpp"
#include "polhode/base/workers.hpp"
#include "polhode/io/settings/config.hpp"
#include "polhode/run/outputs.hpp"

namespace polhode::cli {

/// The output format of results. The default output is only the requested results, which fit on a
/// screen.
struct ResultForm {
  bool json = false;
  bool verbose = false;  ///< whether to print details as well, such as the tables of a study

  void declare_verbose(Command& command);
};

struct JobOptions : ResultForm {
  std::string file, threads;
  bool force = false, resume = false;

  /// Declares FILE, --threads and --json.
  /// @param of_threads  what the threads compute, such as "simultaneous runs"
  void declare(Command& command, const std::string& of_threads);
  void declare_file(Command& command, bool must_be_given = false);
  void declare_threads(Command& command, const std::string& of_threads);
  void declare_force(Command& command);
  void declare_resume(Command& command);

  /// The settings of the run file, or of the default run, combined with the command line. This
  /// function prints a note on each setting that a command-line option implies.
  /// @param quick  whether the quick version of the job is requested
  /// @throws Error  under the same conditions as read_config()
  Config config(bool quick = false) const;
  /// The output options.
  /// @throws Error  if both --resume and --force are given
  OutputOptions output() const;
  /// The worker threads.
  /// @throws Error  if --threads is invalid
  Workers workers() const;

 private:
  std::optional<Command> command_;  // command on which these options are declared
};

template <class Request>
struct RequestOptions : JobOptions {
  Request request;
};

}  // namespace polhode::cli
