// SPDX-License-Identifier: MIT
// A verb's options as they are declared. Behind it is CLI11, a long header that only command.cpp
// and main.cpp include.
#pragma once

#include <optional>
#include <string>

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
  /// The value is a number from min to max. Number: int or double.
  template <class Number>
  const CommandOption& in_range(Number min, Number max) const;
  /// One word may hold several values with this character between them.
  const CommandOption& separated_by(char delimiter) const;
  /// Help texts show the present value as the default.
  const CommandOption& show_default() const;
  const CommandOption& excludes(const CommandOption& other) const;

 private:
  CLI::Option* option_;
};

/// A verb on the command line. It refers to the parser's own command, which outlives it.
class Command {
 public:
  explicit Command(CLI::App& app) : app_(&app) {}

  std::string name() const;
  /// The value as typed, or nothing if the option is not given.
  std::optional<std::string> given(const std::string& option) const;

  CommandOption add_flag(const std::string& name, bool& value, const std::string& meaning);
  /// @tparam Value  std::string, a number, or a std::vector of either; command.cpp lists them
  /// @param name    "--step", or "FILE" for an argument without a name
  /// @param value   takes the value when the command line is parsed; until then it is the default
  template <class Value>
  CommandOption add_option(const std::string& name, Value& value, const std::string& meaning);

 private:
  CLI::App* app_;
};

}  // namespace polhode::cli
