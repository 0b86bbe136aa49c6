// SPDX-License-Identifier: MIT
// Names that a user may have meant.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace polhode {

/// "did you mean 'gier4'? " if a candidate is close by edit distance, else nothing; to be put
/// inside a longer message.
std::string did_you_mean(std::string_view name, const std::vector<std::string>& candidates);

}  // namespace polhode
