// SPDX-License-Identifier: MIT
// Files that exist either completely or not at all.
#pragma once

#include <string>
#include <vector>

namespace polhode {

/// A file that gets its final name only when it is complete. An incomplete file has no name or, if
/// the file system supports only named files or the extension must show the format, a unique
/// temporary name. A draft that is never completed disappears. No other file is overwritten or
/// removed.
class Draft {
 public:
  enum class Name { none, unique };

  /// Creates the draft.
  /// @throws Error  if no file can be created next to `path`
  explicit Draft(const std::string& path, Name name = Name::none);
  ~Draft();
  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;

  /// The path under which the draft is opened for writing.
  const std::string& path() const { return draft_; }
  /// Returns a message in which the name of the draft is replaced by the final name of the file.
  std::string with_final_name(std::string message) const;
  /// Syncs the draft to disk and renames it to the final name.
  /// @param keep  new name for an existing file; if empty, the existing file is replaced
  /// @throws RunError  if syncing or renaming fails
  void finish(const std::string& keep = {});

 private:
  void create_named();
  bool link(const std::string& name);
  void replace();
  [[noreturn]] void refuse(int error) const;

  std::string path_, draft_;
  int file_ = -1;
  bool has_name_ = false;
};

/// Rejects a file name if the name, or the name of its draft, is too long for the file system.
/// @throws Error  with the length
void check_length_of_name(const std::string& path);

/// Removes the drafts of files in one folder; such drafts are left behind by killed processes. Lock
/// the files before this call, because a draft's name does not show whether the process that writes
/// the draft still exists.
void remove_drafts(const std::vector<std::string>& files);

}  // namespace polhode
