// SPDX-License-Identifier: MIT
// The two kinds of errors that a user may see. The message gives the invalid value with its unit,
// the bound, a brief reason, and a remedy. The place in the file is added where it is known.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace polhode {

/// Invalid input: a file, a value or an option. Front ends print the message and exit with code 2.
class Error : public std::runtime_error {
 public:
  explicit Error(const std::string& what_and_remedy, std::string where = {})
      : std::runtime_error(what_and_remedy), where_(std::move(where)) {}

  /// The place of the error in the input: file, line and key, as far as these are known, such as
  /// "water.toml:9, forces.cutoff".
  const std::string& where() const { return where_; }

  /// Returns this error with a place added, unless a more precise place is already known.
  Error at(const std::string& where) const { return where_.empty() ? Error(what(), where) : *this; }

 private:
  std::string where_;
};

/// Calls read(), and adds a place to an Error that it throws.
template <class Read>
decltype(auto) at_place(const std::string& where, const Read& read) {
  try {
    return read();
  } catch (const Error& e) {
    throw e.at(where);
  }
}

/// A run that cannot continue although its input was valid, for example because the trajectory blew
/// up. Exit code 1.
class RunError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace polhode
