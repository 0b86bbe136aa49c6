// SPDX-License-Identifier: MIT
#include "command.hpp"

#include <fmt/core.h>
#include <CLI/CLI.hpp>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace polhode::cli {

const CommandOption& CommandOption::required() const {
  option_->required();
  return *this;
}

template <class Number>
const CommandOption& CommandOption::in_range(Number min, Number max) const {
  const CLI::Range range(min, max);
  const auto check = [range, min, max](std::string& text) {
    if (range(text).empty()) return std::string();
    return fmt::format("'{}' must be a {}number from {:.15g} to {:.15g}", text,
                       std::is_integral_v<Number> ? "whole " : "", static_cast<double>(min),
                       static_cast<double>(max));
  };
  option_->check(CLI::Validator(check, range.get_description()));
  return *this;
}
template const CommandOption& CommandOption::in_range(int, int) const;
template const CommandOption& CommandOption::in_range(double, double) const;

const CommandOption& CommandOption::separated_by(char delimiter) const {
  option_->delimiter(delimiter);
  return *this;
}

const CommandOption& CommandOption::show_default() const {
  option_->capture_default_str();
  return *this;
}

const CommandOption& CommandOption::excludes(const CommandOption& other) const {
  option_->excludes(other.option_);
  return *this;
}

std::string Command::name() const { return app_->get_name(); }

std::optional<std::string> Command::given(const std::string& option) const {
  const CLI::Option* const known = app_->get_option(option);
  if (known->count() == 0) return {};
  return known->as<std::string>();
}

CommandOption Command::add_flag(const std::string& name, bool& value, const std::string& meaning) {
  return CommandOption(*app_->add_flag(name, value, meaning));
}

template <class Value>
CommandOption Command::add_option(const std::string& name, Value& value,
                                  const std::string& meaning) {
  return CommandOption(*app_->add_option(name, value, meaning));
}
template CommandOption Command::add_option(const std::string&, int&, const std::string&);
template CommandOption Command::add_option(const std::string&, double&, const std::string&);
template CommandOption Command::add_option(const std::string&, std::size_t&, const std::string&);
template CommandOption Command::add_option(const std::string&, std::string&, const std::string&);
template CommandOption Command::add_option(const std::string&, std::vector<double>&,
                                           const std::string&);
template CommandOption Command::add_option(const std::string&, std::vector<std::size_t>&,
                                           const std::string&);
template CommandOption Command::add_option(const std::string&, std::vector<std::string>&,
                                           const std::string&);

}  // namespace polhode::cli
