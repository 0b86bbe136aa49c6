// SPDX-License-Identifier: MIT
#include "polhode/io/settings/nested_scheme_text.hpp"

#include <fmt/core.h>

#include <regex>
#include <sstream>
#include <utility>

#include "base/from_chars.hpp"
#include "io/settings/quantity.hpp"
#include "io/settings/scheme_labels.hpp"
#include "polhode/base/error.hpp"
#include "polhode/integrate/scheme_text.hpp"

namespace polhode {
namespace {

constexpr int max_steps = 1000;
constexpr std::size_t max_text =
    8192;  // maximum text length of two schemes; it limits the work of a regular expression

/// The end of the outer scheme: the first slash that is not the slash of a fraction. Slashes of
/// fractions are in brackets or between '=' and ';'.
std::size_t slash(std::string_view text) {
  int open = 0;
  bool definition = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    open += text[i] == '(' ? 1 : text[i] == ')' ? -1 : 0;
    if (open == 0 && (text[i] == '=' || text[i] == ';')) definition = text[i] == '=';
    if (text[i] == '/' && open == 0 && !definition) return i;
  }
  return std::string_view::npos;
}

std::string without_blanks(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\n"), last = text.find_last_not_of(" \t\n");
  return first == std::string_view::npos ? "" : std::string(text.substr(first, last - first + 1));
}

int steps_of(const std::string& text) {
  const int steps = parsed_number<int>(text).value_or(0);
  if (steps < 1 || steps > max_steps)
    throw Error(
        fmt::format("the number of inner steps per drift of the outer scheme is {}; it must be a "
                    "whole number from 1 to {}",
                    text, max_steps));
  return steps;
}

InnerScheme inner_scheme_of(const std::string& text) {
  static const std::regex form(
      R"((.+?)\s+x\s+(\S+)\s+within\s+(?:(\S+)\s+to\s+)?([-+.\deE]+)\s*([^-+.\d\s]\S*))");
  std::smatch part;
  if (!std::regex_match(text, part, form))
    throw Error(
        fmt::format("inner scheme '{}' must specify the number of inner steps and the range of the "
                    "near forces; write for example \"hoa2 x 2 within 0.35 to 0.5 nm\"",
                    text));
  const auto length = [&](const std::string& number) {
    return quantity(number + " " + part[5].str(), Dimension::length, "the range of the near forces",
                    "0.5 nm");
  };
  InnerScheme inner{scheme_of(part[1].str()), steps_of(part[2].str())};
  inner.cutoff = length(part[4].str());
  inner.switch_from = part[3].matched ? length(part[3].str()) : default_near_switch * inner.cutoff;
  if (!(inner.switch_from > 0) || !(inner.switch_from < inner.cutoff))
    throw Error(fmt::format(
        "near forces are switched from {:g} to {:g} nm; the first distance must be above 0 nm, and "
        "the second must be longer; write for example \"within 0.35 to 0.5 nm\"",
        inner.switch_from, inner.cutoff));
  return inner;
}

std::string one_line(std::string_view text) {
  std::istringstream words{std::string(text)};
  std::string line;
  for (std::string word; words >> word;) line += (line.empty() ? "" : " ") + word;
  return line;
}

/// The built-in or user-given name of a scheme; its stages if the scheme has no name.
std::string name_or_stages(const Scheme& s) {
  return s.in_table() || s.has_own_name() ? std::string(s.name()) : text_of(s);
}

/// A scheme as text.
/// @param text    function that returns the text of a single scheme
/// @param length  format of the distances
template <class Text>
std::string nested_text(const NestedScheme& scheme, const Text& text, const char* length = "{}") {
  if (!scheme.inner) return text(scheme.outer);
  const InnerScheme& inner = *scheme.inner;
  return fmt::format("{} / {} x {} within {} to {} nm", text(scheme.outer), text(inner.scheme),
                     inner.steps, fmt::format(fmt::runtime(length), inner.switch_from),
                     fmt::format(fmt::runtime(length), inner.cutoff));
}

}  // namespace

NestedScheme nested_scheme_of(std::string_view text) {
  if (text.size() > max_text)
    throw Error(fmt::format("the text of the scheme has {} characters; the maximum is {}",
                            text.size(), max_text));
  const std::size_t at = slash(text);
  const NestedScheme scheme =
      at == std::string_view::npos
          ? NestedScheme(scheme_of(text))
          : NestedScheme(scheme_of(without_blanks(text.substr(0, at))),
                         inner_scheme_of(without_blanks(text.substr(at + 1))));
  if (scheme.inner && scheme.inner->scheme.has(Flow::bath))
    throw Error(
        fmt::format("the inner scheme of '{}' has a bath; move the bath to the outer scheme, where "
                    "it acts once per step",
                    text));
  return scheme;
}

NamedScheme::NamedScheme(std::string given)
    : NestedScheme(nested_scheme_of(given)), text(std::move(given)) {}

Scheme single_scheme_of(const NamedScheme& scheme) {
  if (scheme.inner)
    throw Error(
        fmt::format("scheme '{}' has an inner scheme, but only single schemes are supported here; "
                    "give a single scheme, such as hoa2",
                    scheme.text));
  return scheme.outer;
}

std::string name_of(const NestedScheme& scheme) {
  return nested_text(scheme, name_or_stages, "{:g}");
}

std::string label_of(const NamedScheme& scheme) {
  const bool plain = scheme.text.find_first_of(":;") == std::string::npos;
  return plain ? one_line(scheme.text) : name_of(scheme);
}

std::string named_text_of(const NestedScheme& scheme) {
  return nested_text(scheme, [](const Scheme& s) {
    return s.has_own_name() ? fmt::format("{}: {}", s.name(), text_of(s)) : name_or_stages(s);
  });
}

std::string text_of(const NestedScheme& scheme) {
  return nested_text(scheme, [](const Scheme& s) { return text_of(s); });
}

}  // namespace polhode
