// SPDX-License-Identifier: MIT
// Suggestions for mistyped names.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace polhode {

/// The number of insertions, deletions, replacements and swaps of adjacent letters that turn one
/// word into the other.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The name that differs in case and punctuation only, such as spce for "SPC/E"; otherwise the one
/// with the smallest edit distance, unless that distance exceeds about a third of the word (one
/// letter of a short word).
std::optional<std::string> nearest_name(std::string_view word, std::span<const std::string> names);

/// "; did you mean 'gier4'?", or nothing if no name is close; appended to an error message.
std::string did_you_mean(std::string_view word, std::span<const std::string> names);

/// Whether two words have the same letters and digits, regardless of case.
bool same_letters(std::string_view a, std::string_view b);

/// A sentence with a small first letter; words in capitals stay, as in "SCHEME is required".
std::string uncapitalized(std::string sentence);

/// "a, b, c".
std::string join_names(std::span<const std::string> names);

/// "must be one of: a, b, c; did you mean 'b'?"
std::string must_be_one_of(std::span<const std::string_view> names, std::string_view word);

}  // namespace polhode
