// SPDX-License-Identifier: MIT
#include "base/suggest.hpp"

#include <algorithm>
#include <cctype>
#include <vector>

namespace polhode {

// Computes the optimal-string-alignment distance, row by row.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), above(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) above[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, replaced});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before.swap(above);
    above.swap(row);
  }
  return above[b.size()];
}

std::string letters_and_digits(std::string_view word) {
  std::string kept;
  for (const char c : word)
    if (std::isalnum(static_cast<unsigned char>(c)))
      kept += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return kept;
}

bool same_letters(std::string_view a, std::string_view b) {
  const std::string kept = letters_and_digits(a);
  return !kept.empty() && kept == letters_and_digits(b);
}

std::string uncapitalized(std::string sentence) {
  const auto is_capital = [&](std::size_t i) {
    return i < sentence.size() && std::isupper(static_cast<unsigned char>(sentence[i]));
  };
  if (is_capital(0) && !is_capital(1))
    sentence[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(sentence[0])));
  return sentence;
}

std::optional<std::string> nearest_name(std::string_view word, std::span<const std::string> names) {
  for (const std::string& name : names)
    if (same_letters(word, name)) return name;
  std::optional<std::string> best;
  // A name that shares no letter with the word, such as K for C, is not a useful suggestion.
  std::size_t min_distance =
      std::min(std::max<std::size_t>(1, (word.size() + 1) / 3) + 1, word.size());
  for (const std::string& name : names) {
    const std::size_t distance = edit_distance(word, name);
    if (distance >= min_distance) continue;
    min_distance = distance;
    best = name;
  }
  return best;
}

std::string did_you_mean(std::string_view word, std::span<const std::string> names) {
  const auto name = nearest_name(word, names);
  return name ? "; did you mean '" + *name + "'?" : "";
}

std::string join_names(std::span<const std::string> names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return list;
}

std::string must_be_one_of(std::span<const std::string_view> names, std::string_view word) {
  const std::vector<std::string> known(names.begin(), names.end());
  return "must be one of: " + join_names(known) + did_you_mean(word, known);
}

}  // namespace polhode
