// SPDX-License-Identifier: MIT
// The keys of GromacsEquilibrium.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace polhode::gromacs {

/// Bonded types of atoms as one text, "C O", independent of their order.
inline std::string bonded_key(const std::vector<std::string>& types) {
  std::string forth, back;
  for (const std::string& type : types) {
    forth += (forth.empty() ? "" : " ") + type;
    back = type + (back.empty() ? "" : " ") + back;
  }
  return std::min(forth, back);
}

}  // namespace polhode::gromacs
