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

/// How results are printed: by default what was asked for, which fits on a screen.
struct ResultForm {
  bool json = false;
  bool verbose = false;  ///< whether to print details, too, such as the tables of a study

  void declare_verbose(Command& command);
};

struct JobOptions : ResultForm {
  std::string file, threads;
  bool force = false, resume = false;

  /// Declares FILE, --threads and --json.
  /// @param of_threads  what the threads do: "simultaneous runs"
  void declare(Command& command, const std::string& of_threads);
  CommandOption declare_file(Command& command);
  void declare_threads(Command& command, const std::string& of_threads);
  void declare_force(Command& command);
  void declare_resume(Command& command);

  /// The run file, or the default one, with the settings of the command line. Notes on what these
  /// select are printed.
  /// @param quick  whether the quick version of the job is requested
  /// @throws Error  as read_config()
  Config config(bool quick = false) const;
  /// @throws Error  if both --resume and --force are given
  OutputOptions output() const;
  /// @throws Error  naming --threads
  Workers workers() const;

 private:
  std::optional<Command> command_;  // that these options are declared on
};

template <class Request>
struct RequestOptions : JobOptions {
  Request request;
};

}  // namespace polhode::cli
