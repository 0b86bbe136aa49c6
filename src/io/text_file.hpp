// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace polhode {

/// The whole text of a file, or an Error that names it.
std::string file_text(const std::string& path);

}  // namespace polhode
