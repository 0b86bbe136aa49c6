// SPDX-License-Identifier: MIT
// Functions for the output files of jobs.
#pragma once

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

#include "polhode/io/files/table_file.hpp"
#include "polhode/io/settings/config.hpp"
#include "polhode/run/outputs.hpp"

namespace polhode {

/// The provenance of the files that this process writes.
/// @param config  text of the settings that determine the files
Provenance provenance(const std::string& command, const std::string& config, std::uint64_t seed);

/// Checks, before anything is computed, the names of output files and whether their folders can be
/// written to.
/// @param inputs  files that the job reads, and that must not be replaced
/// @throws Error  if a file cannot be written, is an input, or exists and must not be replaced
void check_outputs(const std::vector<std::string>& files, ExistingFiles existing,
                   const std::vector<std::string>& inputs = {});
/// The run file and the initial configuration of a run.
std::vector<std::string> inputs_of(const Config& config);

/// Checks a prefix of output files, and the lengths of their names.
/// @throws Error  if the prefix is empty or ends in '/', so that file names would begin with '-',
///   or if a name is too long
void check_prefix(const std::string& prefix, const std::vector<std::string>& files = {});

/// Passes each line of text that a function writes to the message callback.
void pass_messages(const Callbacks& callbacks, const std::function<void(std::ostream&)>& write);

}  // namespace polhode
