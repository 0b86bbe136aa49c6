// SPDX-License-Identifier: MIT
// The output files of a job. This file decides whether existing outputs are rejected, replaced or
// resumed, and locks them against other processes.
#pragma once

#include <string>

#include "polhode/io/files/file_lock.hpp"
#include "polhode/run/callbacks.hpp"

namespace polhode {

/// What a job does if its output files already exist.
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

/// Locks the outputs of a job. If the file system does not support locks, the job prints a note.
class OutputLock {
 public:
  /// @throws Error  under the same conditions as FileLock()
  OutputLock(const std::string& path, const Callbacks& callbacks);

 private:
  FileLock lock_;
};

}  // namespace polhode
