// SPDX-License-Identifier: MIT
// The output files of a job: whether existing files are rejected, replaced or resumed, and the lock
// against other processes.
#pragma once

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

#include "polhode/io/files/file_lock.hpp"
#include "polhode/io/files/table_file.hpp"
#include "polhode/run/callbacks.hpp"

namespace polhode {

/// What a job does if its output files exist already.
enum class ExistingFiles {
  refuse,   ///< existing files are an error
  replace,  ///< existing files are overwritten
  resume    ///< the job continues from the existing files
};

/// Options for the output files of a job: the command that they record, and the treatment of
/// existing files.
struct OutputOptions {
  ExistingFiles existing = ExistingFiles::refuse;
  std::string command = "polhode";  ///< command that writes the files, recorded in their headers
};

/// The provenance of the files that this process writes.
/// @param config  text of the settings that determine the files
Provenance provenance(const std::string& command, const std::string& config, std::uint64_t seed);

/// Checks, before anything is computed, the names of output files and whether their folders can be
/// written to.
/// @throws Error  if a file cannot be written, or exists and must not be replaced
void check_outputs(const std::vector<std::string>& files, ExistingFiles existing);

/// Checks a prefix of output files, and the lengths of their names.
/// @throws Error  if the prefix is empty or ends in '/', so that file names would begin with '-',
///   or if a name is too long
void check_prefix(const std::string& prefix, const std::vector<std::string>& files = {});

/// Locks the outputs of a job. If the file system has no locks, it gives a note instead.
class OutputLock {
 public:
  /// @throws Error  under the same conditions as FileLock()
  OutputLock(const std::string& path, const Callbacks& callbacks);

 private:
  FileLock lock_;
};

/// Passes each line of text that a function writes to the message callback.
void pass_messages(const Callbacks& callbacks, const std::function<void(std::ostream&)>& write);

}  // namespace polhode
