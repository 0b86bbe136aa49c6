// SPDX-License-Identifier: MIT
#include "option_values.hpp"

#include <fmt/core.h>

#include "polhode/io/nested_scheme_text.hpp"

namespace polhode::cli {

double positive_time(const std::string& text, const std::string& option) {
  const double t = quantity(text, Dimension::time, option);
  if (!(t > 0))
    throw Error(
        fmt::format("{} = \"{}\" must be longer than 0; write for example \"2 fs\"", option, text));
  return t;
}

std::string typed_command(std::string command,
                          const std::vector<std::pair<std::string, std::string>>& options) {
  for (const auto& [option, value] : options) {
    if (value.empty()) continue;
    if (!option.empty()) command += " " + option;
    const bool plain = value.find_first_of(" ()'\"") == std::string::npos;
    command += plain ? " " + value : " \"" + value + "\"";
  }
  return command;
}

NestedScheme scheme_option(const std::string& text, const std::string& option) {
  try {
    return nested_scheme_of(text);
  } catch (const Error& e) {
    throw e.at(option);
  }
}

Config read_config_option(const std::string& file, const std::string& precision) {
  Config config = file.empty() ? default_config() : read_config(file);
  if (!precision.empty()) set_precision(config, named_option<Precision>(precision, "--precision"));
  return config;
}

ExistingFiles existing_files(bool resume, bool force) {
  if (resume && force)
    throw Error(
        "--continue and --force contradict each other: one resumes the existing run, the other "
        "starts over; give one of them");
  return resume ? ExistingFiles::resume : force ? ExistingFiles::replace : ExistingFiles::refuse;
}

}  // namespace polhode::cli
