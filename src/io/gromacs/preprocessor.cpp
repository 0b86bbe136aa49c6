// SPDX-License-Identifier: MIT
#include "preprocessor.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "io/files/field_line.hpp"
#include "io/files/split_words.hpp"
#include "polhode/base/error.hpp"

namespace polhode::gromacs {
namespace {

// Limits far above the needs of real topologies. The limits guarantee that the preprocessor
// terminates for any file. The limits apply to the depth of includes, the total numbers of files
// and characters, the depths of macros and conditions, and the length of a line in characters and
// words. Macros can make a short file long, so the total number of words from macros is also
// limited.
constexpr std::size_t max_include_depth = 32, max_includes = 10'000, max_characters = 1 << 25;
constexpr std::size_t max_macro_depth = 16, max_condition_depth = 256, max_line_length = 1 << 16;
constexpr std::size_t max_replaced = 1 << 22;

}  // namespace

Preprocessor::Preprocessor(std::string_view text, const std::string& file,
                           const IncludeLoader& loader, const std::vector<std::string>& defines)
    : loader_(loader) {
  sources_.push_back({std::make_shared<const std::string>(file), std::string(text)});
  for (const std::string& definition : defines) {
    const auto equals = definition.find('=');
    define(definition.substr(0, equals) + ' ' +
           (equals == definition.npos ? "" : definition.substr(equals + 1)));
  }
}

std::optional<Line> Preprocessor::next() {
  while (!sources_.empty()) {
    const auto line = logical_line();
    if (!line) {
      end_source();
      continue;
    }
    const std::string_view text = trimmed(*line);
    if (text.empty() || text.front() == '*') continue;  // a line that begins with '*' is a comment
    if (text.front() == '#') {
      directive(text.substr(1));
    } else if (!skipped()) {
      std::string whole = expand_macros(text);
      if (!whole.empty()) return Line{std::move(whole), place()};
    }
  }
  return std::nullopt;
}

bool Preprocessor::skipped() const {
  return !conditions_.empty() && !(conditions_.back().reached && conditions_.back().taken);
}

// The next line, joined with its continuation lines, without comments. As in GROMACS, a comment
// includes the continuation lines that follow it.
std::optional<std::string> Preprocessor::logical_line() {
  Source& source = sources_.back();
  const std::string_view text = source.text;
  if (source.at >= text.size()) return std::nullopt;
  std::string joined;
  line_ = source.line + 1;
  for (bool continued = true; continued && source.at < text.size();) {
    const auto end = std::min(text.find('\n', source.at), text.size());
    std::string_view line = text.substr(source.at, end - source.at);
    source.at = end + 1;
    ++source.line;
    line = trimmed(line);
    continued = line.ends_with('\\');
    if (continued) line.remove_suffix(1);
    joined += line;
    if (continued) joined += ' ';
    characters_ += line.size() + 1;
  }
  return joined.substr(0, joined.find(';'));
}

void Preprocessor::directive(std::string_view line) {
  const std::string_view word = take_word(line);
  const bool is_condition = word == "ifdef" || word == "ifndef";
  if (is_condition) {
    const std::string_view name = take_word(line);
    if (name.empty())
      refuse(fmt::format("#{} must be followed by a macro name; add the name", word));
    if (conditions_.size() >= max_condition_depth)
      refuse(fmt::format(
          "conditions are nested {} levels deep, the maximum; end some conditions with #endif",
          max_condition_depth));
    const bool taken = (macros_.find(name) != macros_.end()) == (word == "ifdef");
    conditions_.push_back({taken, !skipped(), false, place()});
    return;
  }
  if (word == "else" || word == "endif") {
    if (conditions_.size() == sources_.back().conditions)
      refuse(
          fmt::format("there is no #ifdef or #ifndef in this file before this #{}; delete the line "
                      "or begin the condition",
                      word));
    Condition& last = conditions_.back();
    if (word == "endif") {
      conditions_.pop_back();
      return;
    }
    if (last.otherwise)
      refuse(fmt::format("the condition of line {} has two #else; delete one", last.place.line));
    last.otherwise = true;
    last.taken = !last.taken;
    return;
  }
  if (skipped()) return;
  if (word == "include") {
    include(trimmed(line));
  } else if (word == "define") {
    define(line);
  } else if (word == "undef") {
    const auto known = macros_.find(take_word(line));
    if (known != macros_.end()) macros_.erase(known);
  } else if (word == "error") {
    refuse(fmt::format("the topology stops with #error: {}", trimmed(line)));
  } else {
    refuse(
        fmt::format("there is no directive '#{}'; the directives are: include, define, undef, "
                    "ifdef, ifndef, else, endif, error",
                    word));
  }
}

void Preprocessor::include(std::string_view name) {
  const auto take_quoted = [&](char open, char close) {
    return name.size() > 2 && name.front() == open && name.back() == close;
  };
  if (!take_quoted('"', '"') && !take_quoted('<', '>'))
    refuse(fmt::format("#include is followed by '{}' instead of a file name in quotes", name));
  const std::string included(name.substr(1, name.size() - 2));
  if (sources_.size() >= max_include_depth)
    refuse(
        fmt::format("included files are nested {} levels deep, the maximum; check whether a file "
                    "includes itself",
                    max_include_depth));
  if (++includes_ > max_includes || characters_ > max_characters)
    refuse(fmt::format(
        "{} files with {} characters were included; the maximum is {} files and {} characters",
        includes_, characters_, max_includes, max_characters));
  auto loaded = loader_(included, *sources_.back().file);
  if (!loaded)
    refuse(
        fmt::format("there is no file '{}' in the folder of this file, nor in 'include', GMXLIB, "
                    "GMXDATA or the data of GROMACS; check its path",
                    included));
  for (const Source& open : sources_)
    if (*open.file == loaded->file)
      refuse(fmt::format("'{}' includes itself endlessly; delete one #include", included));
  sources_.push_back({std::make_shared<const std::string>(std::move(loaded->file)),
                      std::move(loaded->text), 0, 0, conditions_.size()});
}

void Preprocessor::define(std::string_view definition) {
  const std::string name(take_word(definition));
  if (name.empty()) refuse("#define must be followed by a macro name; add the name");
  macros_[name] = trimmed(definition);
}

std::string Preprocessor::expand_macros(std::string_view text) {
  std::string out;
  Expansion e{{}, out, 0};
  expand(text, e);
  return out;
}

// Replaces macros, also nested ones, but never a macro within itself.
void Preprocessor::expand(std::string_view text, Expansion& e) {
  for (std::string_view word = take_word(text); !word.empty(); word = take_word(text)) {
    const auto macro = macros_.find(word);
    const bool plain = macro == macros_.end() ||
                       std::find(e.within.begin(), e.within.end(), word) != e.within.end();
    if (++e.words > max_line_length || e.out.size() + (plain ? word.size() : 0) > max_line_length)
      refuse(
          fmt::format("the line is longer than {} characters when macros are replaced"
                      "; shorten it",
                      max_line_length));
    if (!e.within.empty() && ++replaced_ > max_replaced)
      refuse(
          fmt::format("macros were expanded to {} words in this topology, the maximum; write "
                      "shorter macros, or replace macros by their values",
                      max_replaced));
    if (plain) {
      if (!e.out.empty()) e.out += ' ';
      e.out += word;
      continue;
    }
    if (e.within.size() >= max_macro_depth)
      refuse(
          fmt::format("macro '{}' is nested {} levels deep, the maximum; write its value instead",
                      word, max_macro_depth));
    e.within.push_back(macro->first);
    expand(macro->second, e);
    e.within.pop_back();
  }
}

void Preprocessor::end_source() {
  if (conditions_.size() > sources_.back().conditions) {
    const Condition& open = conditions_.back();
    throw Error("the file ends before the #endif of this condition; add the #endif",
                text_of(open.place));
  }
  sources_.pop_back();
}

void Preprocessor::refuse(const std::string& what) const { throw Error(what, text_of(place())); }

}  // namespace polhode::gromacs
