// SPDX-License-Identifier: MIT
// A lock that reserves the files of a run or a study for one process.
#pragma once

#include <string>

namespace polhode {

/// Locks a file for this process by flock(2): the system releases it when the process ends, for
/// whatever reason, and NFS passes it on to other computers. The file names the process that holds
/// the lock and is removed with it; one that a killed process left behind locks nothing.
class FileLock {
 public:
  /// @throws Error  if another process holds the lock, with that process, its host and the time; if
  ///                the file contains anything but the text of a lock, or cannot be written
  explicit FileLock(std::string path);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

  /// False if the file system does not support locks.
  bool is_held() const { return held_; }

 private:
  void take();
  bool is_at_its_path() const;

  std::string path_;
  int file_ = -1;
  bool held_ = false;
};

}  // namespace polhode
