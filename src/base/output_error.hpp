// SPDX-License-Identifier: MIT
// The error about existing outputs that a job cannot use.
#pragma once

#include "polhode/base/error.hpp"

namespace polhode {

/// An error about files of an earlier job that the present job can neither overwrite nor continue.
/// The message advises the user to choose another output, to restore a file, or to start again. The
/// front end adds the name of the suitable option.
class OutputError : public Error {
 public:
  /// @param resumable  whether the earlier job can also be resumed
  explicit OutputError(const std::string& what_and_remedy, bool resumable = false)
      : Error(what_and_remedy), resumable_(resumable) {}
  explicit OutputError(const Error& error) : Error(error) {}

  bool resumable() const { return resumable_; }

 private:
  bool resumable_ = false;
};

}  // namespace polhode
