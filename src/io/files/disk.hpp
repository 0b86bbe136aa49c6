// SPDX-License-Identifier: MIT
// Functions that sync files to disk, check or reduce their lengths, and explain disk errors.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace polhode {

/// The folder of a file; "." for a name without a folder.
std::filesystem::path folder_of(const std::string& path);

/// A message about a file that cannot be written, with the cause and the remedy for an errno.
std::string cannot_write(const std::string& path, int error);

/// The remedy for an errno from opening a file.
std::string remedy_of(int error);

/// Checks the folder of a file.
/// @throws Error  if the folder does not exist or cannot be written to
void check_folder(const std::string& path);

/// Unlinks an output file that will be written again. Other names of the same file, such as the
/// target of a symbolic link, are kept.
/// @throws Error  if the name cannot be removed
void remove_output(const std::string& path);

/// Syncs the contents of a file to disk.
/// @throws RunError  if syncing fails
void sync_file(const std::string& path);

/// Syncs the name of a file to disk. Errors are ignored if the folder does not support syncing.
void sync_folder(const std::string& path);

/// Checks the length of a file.
/// @throws Error  if the file is missing or shorter than `bytes`
void check_length(const std::string& path, std::uint64_t bytes);

/// Truncates a file to a length.
/// @throws Error  if the file is shorter than this length, or cannot be truncated
void cut_file(const std::string& path, std::uint64_t bytes);

}  // namespace polhode
