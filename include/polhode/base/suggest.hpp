// SPDX-License-Identifier: MIT
// What a mistyped name probably meant.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace polhode {

/// Insertions, deletions, replacements and swaps of neighbours that turn one word into the other.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The name with the smallest edit distance, unless even that changes more than about a third of
/// the word (one letter of a short one).
std::optional<std::string> nearest_name(std::string_view word, std::span<const std::string> names);

/// "; did you mean 'gier4'?", or nothing if no name is near; the end of an error's text.
std::string did_you_mean(std::string_view word, std::span<const std::string> names);

/// "a, b, c".
std::string listed(std::span<const std::string> names);

}  // namespace polhode
