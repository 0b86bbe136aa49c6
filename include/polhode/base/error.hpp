// SPDX-License-Identifier: MIT
// The two ways in which things go wrong for a user. Form of a text: what is (value, unit), what
// must be (bound), why in half a sentence, what to do; then, added where it is known, the place.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace polhode {

/// Wrong input: a file, a value, an option. Front ends print it and exit with code 2.
class Error : public std::runtime_error {
 public:
  explicit Error(const std::string& what_and_remedy, std::string where = {})
      : std::runtime_error(what_and_remedy), where_(std::move(where)) {}

  /// File, line and key, as far as known: "water.toml:9, forces.cutoff".
  const std::string& where() const { return where_; }

  /// The same error with its place, unless a more exact one is known already.
  Error at(const std::string& where) const { return where_.empty() ? Error(what(), where) : *this; }

 private:
  std::string where_;
};

/// A run that cannot go on although its input was sound: the trajectory blew up. Exit code 1.
class RunError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace polhode
