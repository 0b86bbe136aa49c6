// SPDX-License-Identifier: MIT
// The keys of GromacsEquilibrium.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace polhode::gromacs {

/// The bonded types of atoms as a text, such as "C O"; the reverse order of atoms gives the same
/// text.
inline std::string bonded_key(const std::vector<std::string>& types) {
  std::string forth, back;
  for (const std::string& type : types) {
    forth += (forth.empty() ? "" : " ") + type;
    back = type + (back.empty() ? "" : " ") + back;
  }
  return std::min(forth, back);
}

}  // namespace polhode::gromacs
