// SPDX-License-Identifier: MIT
// The preprocessor of GROMACS topologies: comments, continued lines, includes, conditions, macros.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "polhode/io/topology/gromacs.hpp"

namespace polhode::gromacs {

/// A preprocessed line, which has no comment and is not empty.
struct Line {
  std::string text;
  TextPlace place;
};

/// A preprocessor that returns the lines of a text and of all included files, one after another.
class Preprocessor {
 public:
  Preprocessor(std::string_view text, const std::string& file, const IncludeLoader& loader,
               const std::vector<std::string>& defines);
  std::optional<Line> next();

 private:
  struct Source {
    std::shared_ptr<const std::string> file;
    std::string text;
    std::size_t at = 0;          // position of the first unread character
    std::size_t line = 0;        // number of the last line read
    std::size_t conditions = 0;  // number of open conditions at the beginning of the file
  };
  struct Condition {
    bool taken, reached;  // whether these lines, and the enclosing lines, are active
    bool otherwise;       // whether #else was found
    TextPlace place;
  };
  struct Expansion {
    std::vector<std::string_view> within;  // macros that are being expanded
    std::string& out;
    std::size_t words;  // number of words expanded so far
  };

  bool skipped() const;
  TextPlace place() const { return {sources_.back().file, line_}; }
  std::optional<std::string> logical_line();
  void directive(std::string_view line);
  void include(std::string_view name);
  void define(std::string_view definition);
  std::string expand_macros(std::string_view text);
  void expand(std::string_view text, Expansion& expansion);
  void end_source();
  [[noreturn]] void refuse(const std::string& what) const;

  const IncludeLoader& loader_;
  std::vector<Source> sources_;  // sources, each of which includes the next
  std::vector<Condition> conditions_;
  std::map<std::string, std::string, std::less<>> macros_;
  std::size_t line_ = 0;  // number of the line where the logical line begins
  std::size_t includes_ = 0, characters_ = 0, replaced_ = 0;
};

}  // namespace polhode::gromacs
