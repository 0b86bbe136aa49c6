// SPDX-License-Identifier: MIT
// Locks that reserve files for one process. The files of a run or study are reserved by a separate
// lock file. A growing file is locked directly.
#pragma once

#include <string>

namespace polhode {

/// Locks a file for this process with flock(2). The system releases the lock when the process ends,
/// for whatever reason. On NFS, other computers also see the lock. The file contains the name of
/// the process and is removed with the lock. A lock file that a killed process left behind does not
/// lock anything.
class FileLock {
 public:
  /// @throws Error  if another process holds the lock, if the file contains anything but the text
  ///   of a lock, or if the file cannot be written. The message gives process, host and time of the
  ///   lock
  explicit FileLock(std::string path);
  ~FileLock();
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

  /// Whether the lock is held; false if the file system does not support locks.
  bool is_held() const { return held_; }

 private:
  void take();
  bool is_at_its_path() const;

  std::string path_;
  int file_ = -1;
  bool held_ = false;
};

/// A growing file that no other process may append to or truncate. The lock file of the run is not
/// enough, because another run may write to the same file through a symbolic or hard link.
class HeldFile {
 public:
  HeldFile() = default;
  ~HeldFile();
  HeldFile(const HeldFile&) = delete;
  HeldFile& operator=(const HeldFile&) = delete;

  /// Locks an existing file for the lifetime of this object. Does nothing if the file cannot be
  /// opened for writing, or if the file system does not support locks.
  /// @throws Error  if another process holds the file
  void hold(const std::string& path);

 private:
  int file_ = -1;
};

}  // namespace polhode
