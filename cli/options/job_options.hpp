// SPDX-License-Identifier: MIT
// The options that all jobs on a run file have.
#pragma once

#include <functional>
#include <initializer_list>
#include <optional>
#include <string>

#include "command.hpp"
#include "polhode/base/workers.hpp"
#include "polhode/io/settings/config.hpp"

namespace polhode::cli {

struct JobOptions {
  std::string file, precision, temperature, seed, threads;
  bool json = false;

  /// Declares FILE, --threads and --json.
  /// @param of_threads  what the threads do: "simultaneous runs"
  void declare(Command& command, const std::string& of_threads);
  void declare_precision(Command& command);
  /// Declares --temperature and --seed.
  void declare_initial_motion(Command& command);

  /// The run file, or the default one, with this precision, temperature and seed.
  /// @param more  applies the verb's own options, before temperature and seed
  /// @throws Error  as read_config_option() and set_initial_motion()
  Config config(const std::function<void(Config&)>& more = {}) const;

  /// The command as it could be typed: the file, and those of these options that are given. Only
  /// options that affect the results should be among them.
  std::string command(std::initializer_list<const char*> options) const;

  /// @throws Error  naming --threads
  Workers workers() const;

 private:
  std::optional<Command> command_;  // that these options are declared on
};

}  // namespace polhode::cli
