// SPDX-License-Identifier: MIT
// Suggestions for mistyped names.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace polhode {

/// The edit distance: the number of insertions, deletions, replacements and swaps of adjacent
/// letters that turn one word into the other.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The name that is most similar to a word. A name that differs only in case and punctuation has
/// precedence: for spce, this is "SPC/E". Otherwise the result is the name with the smallest edit
/// distance. The result is empty if this distance exceeds about a third of the word (one letter of
/// a short word).
std::optional<std::string> nearest_name(std::string_view word, std::span<const std::string> names);

/// A suggestion to be appended to an error message, such as "; did you mean 'gier4'?". The
/// suggestion is empty if no name is similar.
std::string did_you_mean(std::string_view word, std::span<const std::string> names);

/// The letters and digits of a word, in lower case.
std::string letters_and_digits(std::string_view word);

/// Whether two words have the same letters and digits, regardless of case.
bool same_letters(std::string_view a, std::string_view b);

/// Converts the first letter of a sentence to lower case. A first word in capitals is unchanged, as
/// in "SCHEME is required".
std::string uncapitalized(std::string sentence);

/// Joins names with commas: "a, b, c".
std::string join_names(std::span<const std::string> names);

/// The text for an unknown name, such as "must be one of: a, b, c; did you mean 'b'?".
std::string must_be_one_of(std::span<const std::string_view> names, std::string_view word);

}  // namespace polhode
