// SPDX-License-Identifier: MIT
// The declared options of a verb. The implementation uses CLI11, a long header that only
// command.cpp and main.cpp include.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "polhode/io/settings/overlay.hpp"
#include "run/given.hpp"

namespace CLI {
class App;
}  // namespace CLI

namespace polhode::cli {

/// Marks an option or an argument that must be given.
inline constexpr bool required = true;

/// A verb on the command line. A Command refers to a command object of the parser, which must
/// outlive the Command.
class Command {
 public:
  /// @param typed  whole command as a user could type it
  Command(CLI::App& app, std::string typed)
      : app_(&app), typed_(std::move(typed)), overlay_(std::make_shared<Overlay>()) {}

  /// The command as a user could type it, with all options that affect the output files.
  const std::string& typed() const { return typed_; }
  /// The name of the verb, such as "run".
  std::string verb() const;
  /// The settings given on the command line, after it is parsed.
  const Overlay& overlay() const { return *overlay_; }

  void add_flag(const std::string& name, bool& value, const std::string& meaning);
  /// Declares an option or an argument.
  /// @tparam Value  std::string, or a std::vector of them; command.cpp lists both
  /// @param name    name such as "--step", or "FILE" for an argument without a name
  /// @param value   receives the value when the command line is parsed; before that, it is the
  ///   default
  template <class Value>
  void add_option(const std::string& name, Value& value, const std::string& meaning,
                  bool must_be_given = false);
  /// Declares the settings that the verb takes, such as "--hybrid-steps" for hybrid_steps.
  void add_settings();
  /// Declares the options of a job, such as "--max-force" for max_force.
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

/// A command as it could be typed in a shell, without options that do not affect the contents of
/// its files: --threads, --json, --verbose, --force and --resume.
std::string typed_command(const std::vector<std::string>& words);

}  // namespace polhode::cli
