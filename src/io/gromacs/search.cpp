// SPDX-License-Identifier: MIT
// The search path of GROMACS for included files.
#include <cstdlib>
#include <filesystem>

#include "io/files/text_file.hpp"
#include "polhode/io/topology/gromacs.hpp"

namespace polhode {
namespace {

using std::filesystem::path;

constexpr const char* data_below_prefix = "gromacs/top";

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

void add_list(std::vector<std::string>& folders, const std::string& list) {
  for (std::size_t begin = 0; begin < list.size();) {
    const auto end = std::min(list.find(':', begin), list.size());
    if (end > begin) folders.push_back(list.substr(begin, end - begin));
    begin = end + 1;
  }
}

}  // namespace

std::optional<std::string> gromacs_data_folder() {
  std::vector<path> candidates;
  if (const std::string data = environment("GMXDATA"); !data.empty())
    candidates.push_back(path(data) / "top");
  for (const char* share : {"share", "local/share", "local/gromacs/share"})
    candidates.push_back(path("/usr") / share / data_below_prefix);
  for (const path& folder : candidates) {
    std::error_code unreadable;
    if (std::filesystem::is_directory(folder, unreadable)) return folder.string();
  }
  return std::nullopt;
}

IncludeLoader file_loader(std::vector<std::string> folders) {
  add_list(folders, environment("GMXLIB"));
  if (const auto data = gromacs_data_folder()) folders.push_back(*data);
  return
      [folders](const std::string& name, const std::string& includer) -> std::optional<LoadedText> {
        std::vector<path> candidates = {path(includer).parent_path() / name};
        for (const std::string& folder : folders) candidates.push_back(path(folder) / name);
        for (const path& candidate : candidates)
          if (is_file(candidate.string())) {
            const std::string file = candidate.lexically_normal().string();
            return LoadedText{file, file_text(file)};
          }
        return std::nullopt;
      };
}

}  // namespace polhode
