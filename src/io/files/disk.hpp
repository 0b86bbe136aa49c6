// SPDX-License-Identifier: MIT
// Files that grow and must survive: what is on the disk, and how much of it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace polhode {

/// The folder of a file; "." for a bare name.
std::filesystem::path folder_of(const std::string& path);

/// A message about a file that cannot be written, with the remedy for this errno.
std::string cannot_write(const std::string& path, int error);

/// What to do about an errno of opening a file.
std::string remedy_of(int error);

/// Refuses a file name whose folder does not exist or cannot be written to.
/// @throws Error  in both cases
void check_folder(const std::string& path);

/// Removes the name of an output that is written again. What else has its contents, such as
/// the target of a symbolic link, is not changed.
/// @throws Error  if that cannot be done
void remove_output(const std::string& path);

/// Syncs the contents of a file to disk.
/// @throws RunError  if that cannot be done
void sync_file(const std::string& path);

/// Syncs the name of a file to disk. Folders that do not support this are ignored.
void sync_folder(const std::string& path);

/// Refuses a file that is missing or shorter than it was.
/// @throws Error  in both cases
void check_length(const std::string& path, std::uint64_t bytes);

/// Truncates a file to its first bytes.
/// @throws Error  if it is shorter than that, or cannot be truncated
void cut_file(const std::string& path, std::uint64_t bytes);

}  // namespace polhode
