// SPDX-License-Identifier: MIT
// Files that are there whole or not at all.
#pragma once

#include <string>

namespace polhode {

/// A file that takes its name when it is complete. Until then it has no name, or, where the file
/// system knows only named files or the name must tell the format, one that no other file has. If
/// it is never completed it is gone; nothing of anybody else's is overwritten or removed.
class Draft {
 public:
  enum class Name { none, unique };

  /// @throws Error  if no file can be created in the folder of `path`
  explicit Draft(const std::string& path, Name name = Name::none);
  ~Draft();
  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;

  /// By which it is opened to be written.
  const std::string& path() const { return draft_; }
  /// Syncs it to disk and gives it its name.
  /// @param keep  name that what was there takes; without it, it is lost
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

}  // namespace polhode
