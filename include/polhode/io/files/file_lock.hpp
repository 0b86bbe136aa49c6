// SPDX-License-Identifier: MIT
// Locks that reserve files for one process: those of a run or a study by a file of its own, and
// growing files themselves.
#pragma once

#include <string>

namespace polhode {

/// Locks a file for this process by flock(2). The system releases the lock when the process ends,
/// for whatever reason, and NFS passes it on to other computers. The file names the process and is
/// removed with the lock. A file that a killed process left behind locks nothing.
class FileLock {
 public:
  /// @throws Error  if another process holds the lock, with process, host and time; if the file
  ///                contains anything but the text of a lock, or cannot be written
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

/// A growing file that no other process may append to or truncate. The lock of its run is not
/// enough: another run may reach the file by a symbolic or a hard link.
class HeldFile {
 public:
  HeldFile() = default;
  ~HeldFile();
  HeldFile(const HeldFile&) = delete;
  HeldFile& operator=(const HeldFile&) = delete;

  /// Holds an existing file until this object's end; does nothing if the file cannot be opened for
  /// writing, or if the file system does not support locks.
  /// @throws Error  if another process holds it
  void hold(const std::string& path);

 private:
  int file_ = -1;
};

}  // namespace polhode
