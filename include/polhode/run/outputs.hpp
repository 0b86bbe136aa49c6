// SPDX-License-Identifier: MIT
// The output files of a job: whether existing ones are refused, replaced or resumed, and the lock
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

/// What a job does where its outputs exist already.
enum class ExistingFiles {
  refuse,   ///< they are an error
  replace,  ///< they are overwritten
  resume    ///< the job continues from them
};

/// How a job is named in its outputs, and what it may do to existing ones.
struct OutputOptions {
  ExistingFiles existing = ExistingFiles::refuse;
  std::string command = "polhode";  ///< command that writes the files, for their headers
};

/// The provenance of the files of this process.
/// @param config  text that determines them
Provenance provenance(const std::string& command, const std::string& config, std::uint64_t seed);

/// Checks the names of output files, and that their folders can be written to, before anything is
/// computed.
/// @throws Error  if one of them cannot be written, or exists and is not to be replaced
void check_outputs(const std::vector<std::string>& files, ExistingFiles existing);

/// Checks a prefix of output files, and the lengths of their names.
/// @throws Error  if it is empty or ends in '/', which would begin the names of the files with '-',
///                or if a name is too long
void check_prefix(const std::string& prefix, const std::vector<std::string>& files = {});

/// A lock for the outputs of a job, with a note where the file system has no locks.
class OutputLock {
 public:
  /// @throws Error  as FileLock()
  OutputLock(const std::string& path, const Callbacks& callbacks);

 private:
  FileLock lock_;
};

/// Passes lines of text that a function writes on to the message callback.
void pass_messages(const Callbacks& callbacks, const std::function<void(std::ostream&)>& write);

}  // namespace polhode
