// SPDX-License-Identifier: MIT
// A verb's options as they are declared. Behind it is CLI11, a long header that only command.cpp
// and main.cpp include.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "polhode/io/settings/overlay.hpp"
#include "run/given.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace polhode::cli {

/// An option that has been declared, and what its value must be.
class CommandOption {
 public:
  explicit CommandOption(CLI::Option& option) : option_(&option) {}

  const CommandOption& required() const;
  /// One word may hold several values with this character between them.
  const CommandOption& separated_by(char delimiter) const;

 private:
  CLI::Option* option_;
};

/// A verb on the command line. It refers to the parser's own command, which outlives it.
class Command {
 public:
  /// @param typed  the whole command as it could be typed
  Command(CLI::App& app, std::string typed)
      : app_(&app), typed_(std::move(typed)), overlay_(std::make_shared<Overlay>()) {}

  /// The command as it could be typed, with all that was given and has an effect on its files.
  const std::string& typed() const { return typed_; }
  /// The name of the verb: "run".
  std::string verb() const;
  /// The settings that were given, once the command line is parsed.
  const Overlay& overlay() const { return *overlay_; }

  CommandOption add_flag(const std::string& name, bool& value, const std::string& meaning);
  /// @tparam Value  std::string, a number, or a std::vector of either; command.cpp lists them
  /// @param name    "--step", or "FILE" for an argument without a name
  /// @param value   takes the value when the command line is parsed; until then it is the default
  template <class Value>
  CommandOption add_option(const std::string& name, Value& value, const std::string& meaning);
  /// The settings that the verb takes: "--hybrid-steps" for hybrid_steps.
  void add_settings();
  /// The options of a request: "--max-force" for max_force.
  template <class Request>
  void add_request(Request& request) {
    for (const RequestOption<Request>& row : Request::options())
      add_given(row.name, row.old_name, request.*row.member, row.doc);
  }

 private:
  void add_given(const char* name, const char* old_name, Given& value, const std::string& doc);

  CLI::App* app_;
  std::string typed_;
  std::shared_ptr<Overlay> overlay_;
};

/// The words of a command as they could be typed in a shell, without the options that have no
/// effect on what its files contain: --threads, --json, --verbose, --force and --resume.
std::string typed_command(const std::vector<std::string>& words);

}  // namespace polhode::cli
