// SPDX-License-Identifier: MIT
// The options that all jobs on a run file have.
#pragma once

#include <CLI/CLI.hpp>
#include <initializer_list>
#include <string>

#include "polhode/base/workers.hpp"
#include "polhode/io/config.hpp"

namespace polhode::cli {

struct JobOptions {
  std::string file, precision, temperature, seed, threads;
  bool json = false;

  /// Declares FILE, --threads and --json.
  /// @param of_threads  what the threads do: "simultaneous runs"
  void declare(CLI::App& app, const std::string& of_threads);
  void declare_precision(CLI::App& app);
  /// Declares --temperature and --seed.
  void declare_initial_motion(CLI::App& app);

  /// The run file, or the default one, with this precision, temperature and seed.
  /// @throws Error  as read_config_option() and set_initial_motion()
  Config config() const;

  /// The command as it could be typed: the file, and those of these options that are given. Only
  /// options that affect the results should be among them.
  std::string command(std::initializer_list<const char*> options) const;

  /// @throws Error  naming --threads
  Workers workers() const;

 private:
  const CLI::App* app_ = nullptr;
};

}  // namespace polhode::cli
