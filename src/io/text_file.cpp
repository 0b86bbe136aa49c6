// SPDX-License-Identifier: MIT
#include "text_file.hpp"

#include <fmt/core.h>

#include <fstream>
#include <sstream>

#include "polhode/base/error.hpp"

namespace polhode {

std::string file_text(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (file) text << file.rdbuf();
  if (!file || file.bad())
    throw Error(fmt::format("there is no readable file '{}'; check its path", path));
  return text.str();
}

}  // namespace polhode
