// SPDX-License-Identifier: MIT
#include "option_values.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <system_error>

#include "base/from_chars.hpp"
#include "io/settings/output_units.hpp"
#include "polhode/io/settings/nested_scheme_text.hpp"

namespace polhode::cli {

double positive_time(const std::string& text, const std::string& option) {
  const double t = quantity(text, Dimension::time, option);
  if (!(t > 0))
    throw Error(
        fmt::format("{} = \"{}\" must be longer than 0; write for example \"2 fs\"", option, text));
  return t;
}

double time_option(const std::string& text, const std::string& option) {
  const double t = quantity(text, Dimension::time, option);
  if (!(t >= 0))
    throw Error(
        fmt::format("{} = \"{}\" must be 0 or longer; write for example \"5 ps\"", option, text));
  return t;
}

void set_time(double& time, const std::string& text, const std::string& option) {
  if (!text.empty()) time = positive_time(text, option);
}

std::vector<double> sorted_times(const std::vector<std::string>& texts, const std::string& option) {
  std::vector<double> times;
  for (const std::string& text : texts) times.push_back(positive_time(text, option));
  std::sort(times.begin(), times.end());
  return times;
}

std::string time_text(double time) {
  return time < 1 ? fmt::format("{:g} fs", time * units::fs_per_ps) : fmt::format("{:g} ps", time);
}

void set_schemes(std::vector<NamedScheme>& schemes, const std::vector<std::string>& texts,
                 const std::string& option, const OwnSchemes& own) {
  if (!texts.empty()) schemes.clear();
  for (const std::string& text : texts) schemes.push_back(scheme_option(text, option, own));
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

NamedScheme scheme_option(const std::string& text, const std::string& option,
                          const OwnSchemes& own) try {
  return with_own_schemes(text, own);
} catch (const Error& e) {
  throw e.at(option);
}

Config read_config_option(const std::string& file, const std::string& precision) {
  Config config = file.empty() ? default_config() : read_config(file);
  if (!precision.empty()) set_precision(config, named_option<Precision>(precision, "--precision"));
  return config;
}

std::uint64_t whole_number(const std::string& text, const std::string& option, std::uint64_t max,
                           const std::string& remedy) {
  std::uint64_t value = 0;
  const char* const end = text.data() + text.size();
  const auto [last, status] = from_chars(text.data(), end, value);
  if (status != std::errc() || last != end || value > max)
    throw Error(fmt::format("{} = \"{}\" must be a whole number from 0 to {}; {}", option, text,
                            max, remedy));
  return value;
}

void set_initial_motion(Config& config, const std::string& temperature, const std::string& seed) {
  if (!temperature.empty()) {
    config.system.temperature = quantity(temperature, Dimension::temperature, "--temperature");
    config.given["system.temperature"] = {temperature, "--temperature"};
    if (!(config.system.temperature >= 0))
      throw Error(fmt::format("--temperature = \"{}\" must be above 0 K", temperature));
    if (const std::string wrong = wrong_temperature(config); !wrong.empty())
      throw Error(fmt::format("--temperature = \"{}\" {}", temperature, wrong));
    config.ensemble.temperature = config.system.temperature;
  }
  if (seed.empty()) return;
  config.given["system.seed"] = {seed, "--seed"};
  config.system.seed = whole_number(seed, "--seed", std::numeric_limits<std::uint64_t>::max(),
                                    "write for example 2");
}

ExistingFiles existing_files(bool resume, bool force) {
  if (resume && force)
    throw Error(
        "--continue and --force contradict each other: one resumes the existing run, the other "
        "starts over; give one of them");
  return resume ? ExistingFiles::resume : force ? ExistingFiles::replace : ExistingFiles::refuse;
}

}  // namespace polhode::cli
