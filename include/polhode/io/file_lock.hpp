// SPDX-License-Identifier: MIT
// A lock that keeps the files of a run or a study to one process.
#pragma once

#include <string>

namespace polhode {

/// Holds a file for this process alone by flock(2): the system releases it when the process ends,
/// in whatever way, and NFS passes it on to other computers. The file names the holder, and is
/// removed with the lock; one that a killed process left behind holds nothing.
class FileLock {
 public:
  /// @throws Error  with process, host and time of who holds the file, if another process does; if
  ///                it holds what is no lock's text, or cannot be written
  explicit FileLock(std::string path);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

  /// False where the file system has no locks.
  bool is_held() const { return held_; }

 private:
  void take();
  bool is_at_its_path() const;

  std::string path_;
  int file_ = -1;
  bool held_ = false;
};

}  // namespace polhode
