// SPDX-License-Identifier: MIT
#include "scanner.hpp"

#include <fmt/core.h>

#include <cctype>
#include <cmath>

#include "base/from_chars.hpp"
#include "polhode/base/error.hpp"

namespace polhode {
namespace {

bool is_space(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }
bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

}  // namespace

void Scanner::skip_space() {
  while (at_ < text_.size() && is_space(text_[at_])) ++at_;
}

bool Scanner::at_end() {
  skip_space();
  return at_ == text_.size();
}

bool Scanner::next_is(char c) { return !at_end() && text_[at_] == c; }

bool Scanner::next_is_letter() { return !at_end() && is_letter(text_[at_]); }

bool Scanner::take(char c) {
  const bool found = next_is(c);
  at_ += found ? 1 : 0;
  return found;
}

void Scanner::expect(char c) {
  if (!take(c)) refuse(fmt::format("'{}'", c));
}

std::string_view Scanner::next_word() {
  if (!next_is_letter()) return {};
  std::size_t end = at_;
  while (end < text_.size() && is_word(text_[end])) ++end;
  return text_.substr(at_, end - at_);
}

std::string_view Scanner::word() {
  const std::string_view found = next_word();
  at_ += found.size();
  return found;
}

double Scanner::decimal() {
  skip_space();
  double value = 0;
  const auto [end, error] = from_chars(text_.data() + at_, text_.data() + text_.size(), value);
  if (error != std::errc() || !std::isfinite(value)) refuse("a finite number like 0.25 or 1/4");
  at_ = static_cast<std::size_t>(end - text_.data());
  return value;
}

void Scanner::refuse(const std::string& expected) const {
  const std::string found =
      at_ < text_.size() ? fmt::format("'{}'", text_.substr(at_, 10)) : "the end";
  throw Error(fmt::format(
      "scheme text has {} at character {} where {} is expected; a scheme is written like \"{}\"",
      found, at_ + 1, expected, example_scheme));
}

}  // namespace polhode
