// SPDX-License-Identifier: MIT
#include "polhode/run/outputs.hpp"

#include <fmt/core.h>

#include <filesystem>
#include <sstream>
#include <system_error>

#include "base/instruction_set.hpp"
#include "base/version.hpp"
#include "io/files/draft.hpp"
#include "io/files/write_file.hpp"
#include "polhode/base/error.hpp"
#include "run/output_files.hpp"

namespace polhode {

Provenance provenance(const std::string& command, const std::string& config, std::uint64_t seed) {
  return {version(), command, config, name(current_instruction_set()), seed};
}

void check_outputs(const std::vector<std::string>& files, ExistingFiles existing,
                   const std::vector<std::string>& inputs) {
  for (const std::string& file : files) {
    for (const std::string& input : inputs)
      if (std::error_code error; std::filesystem::equivalent(file, input, error))
        throw Error(fmt::format(
            "'{}' is an input of this command and would be overwritten by an output; give another "
            "prefix of the output",
            file));
    refuse_existing(file, existing == ExistingFiles::replace);
  }
}

std::vector<std::string> inputs_of(const Config& config) {
  return {config.source, config.system.initial_configuration};
}

void check_prefix(const std::string& prefix, const std::vector<std::string>& files) {
  if (prefix.empty() || prefix.back() == '/')
    throw Error(
        fmt::format("the prefix '{0}' must not be empty or end in '/', since the names of output "
                    "files begin with it; write for example '{0}run'",
                    prefix));
  for (const std::string& file : files) check_length_of_name(file);
}

OutputLock::OutputLock(const std::string& path, const Callbacks& callbacks) : lock_(path) {
  if (!lock_.is_held())
    callbacks.note(
        "note: the file system does not support locks; do not start a second process with the same "
        "output");
}

void pass_messages(const Callbacks& callbacks, const std::function<void(std::ostream&)>& write) {
  std::stringstream text;
  write(text);
  for (std::string line; std::getline(text, line);) callbacks.note(line);
}

}  // namespace polhode
