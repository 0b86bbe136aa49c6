// SPDX-License-Identifier: MIT
#include "base/control_groups.hpp"

#include <fstream>
#include <sstream>

namespace polhode {

std::string control_group_membership() {
  std::ifstream in("/proc/self/cgroup");
  std::ostringstream membership;
  membership << in.rdbuf();
  return membership.str();
}

std::vector<std::filesystem::path> control_groups(const std::string& controller,
                                                  const std::string& membership,
                                                  const std::filesystem::path& mount) {
  namespace fs = std::filesystem;
  std::vector<fs::path> found;
  const auto add_up_to_root = [&](const fs::path& root, const fs::path& group) {
    found.push_back(root);
    for (fs::path each = group.relative_path(); !each.empty(); each = each.parent_path())
      found.push_back(root / each);
  };
  // A line has the form "number:controllers:/group"; version 2 has the number 0 and no controllers.
  std::istringstream lines(membership);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t first = line.find(':'), second = line.find(':', first + 1);
    if (first == std::string::npos || second == std::string::npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1);
    const fs::path group = line.substr(second + 1);
    if (controllers.empty())
      for (const fs::path& root : {mount, mount / "unified"}) add_up_to_root(root, group);
    else if (("," + controllers + ",").find("," + controller + ",") != std::string::npos)
      for (const std::string& folder : {controllers, controller})
        add_up_to_root(mount / folder, group);
  }
  return found;
}

}  // namespace polhode
