// SPDX-License-Identifier: MIT
// Files that exist either completely or not at all.
#pragma once

#include <string>
#include <vector>

namespace polhode {

/// A file that gets its name when it is complete. Until then it has no name, or a unique one if the
/// file system supports only named files or if the name must show the format. If it is never
/// completed it disappears; no other file is overwritten or removed.
class Draft {
 public:
  enum class Name { none, unique };

  /// @throws Error  if no file can be created next to `path`
  explicit Draft(const std::string& path, Name name = Name::none);
  ~Draft();
  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;

  /// The path under which it is opened for writing.
  const std::string& path() const { return draft_; }
  /// A message about the draft, with the final name of the file in place of its own.
  std::string with_final_name(std::string message) const;
  /// Syncs it to disk and gives it its name.
  /// @param keep  new name for an existing file; if empty, that file is replaced
  /// @throws RunError  if that cannot be done
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

/// Refuses a file name that is too long for the file system, or whose draft's name is.
/// @throws Error  with the length
void check_length_of_name(const std::string& path);

/// Removes drafts of these files, all in one folder, that killed processes left behind. Their names
/// do not tell whether their process still exists, so call it only with a lock for the files.
void remove_drafts(const std::vector<std::string>& files);

}  // namespace polhode
