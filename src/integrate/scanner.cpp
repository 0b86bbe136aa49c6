// SPDX-License-Identifier: MIT
#include "scanner.hpp"

#include <fmt/core.h>

#include <array>
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

namespace {

struct Function {
  std::string_view name;
  double (*value)(double);
};
constexpr std::array<Function, 2> functions{{
    {"sqrt", [](double x) { return std::sqrt(x); }},
    {"cbrt", [](double x) { return std::cbrt(x); }},
}};

constexpr int max_depth = 32;  // maximum nesting of parentheses, signs and powers, because each is
                               // a recursive call

/// Recursive-descent parser of sums of products of powers.
class Arithmetic {
 public:
  Arithmetic(Scanner& scanner, const NamedValues& names) : scanner_(scanner), names_(names) {}

  double sum() {
    double value = product();
    while (scanner_.next_is('+') || scanner_.next_is('-')) {
      const bool plus = scanner_.take('+');
      if (!plus) scanner_.expect('-');
      const std::size_t begin = scanner_.at();
      const double next = product();
      value = checked(plus ? value + next : value - next, begin);
    }
    return value;
  }

 private:
  double product() {
    double value = power();
    while (scanner_.next_is('*') || scanner_.next_is('/')) {
      const bool times = scanner_.take('*');
      if (!times) scanner_.expect('/');
      const std::size_t begin = scanner_.at();
      const double next = power();
      if (!times && next == 0) refuse_at(begin, "a denominator other than 0");
      value = checked(times ? value * next : value / next, begin);
    }
    return value;
  }

  double power() {
    if (++depth_ > max_depth)
      scanner_.refuse(fmt::format("an expression of at most {} levels", max_depth));
    double value = 0;
    if (scanner_.take('-')) {
      value = -power();
    } else if (scanner_.take('+')) {
      value = power();
    } else {
      value = operand();
      const std::size_t begin = scanner_.at();
      if (scanner_.take('^')) value = checked(std::pow(value, power()), begin);
    }
    --depth_;
    return value;
  }

  double operand() {
    if (scanner_.take('(')) {
      const double value = sum();
      scanner_.expect(')');
      return value;
    }
    return scanner_.next_is_letter() ? named() : scanner_.decimal();
  }

  double named() {
    const std::string_view word = scanner_.next_word();
    for (const Function& function : functions)
      if (function.name == word) return call(function);
    const auto name = names_.find(word);
    if (name == names_.end())
      scanner_.refuse(fmt::format(
          "a finite number, or a name that is defined before the stages, as in \"{} = 1/6;\",",
          word));
    scanner_.word();
    return name->second;
  }

  double call(const Function& function) {
    scanner_.word();
    scanner_.expect('(');
    const std::size_t begin = scanner_.at();
    const double argument = sum();
    scanner_.expect(')');
    return checked(function.value(argument), begin);
  }

  double checked(double value, std::size_t begin) {
    if (!std::isfinite(value)) refuse_at(begin, "an argument with a finite real result");
    return value;
  }

  [[noreturn]] void refuse_at(std::size_t at, const std::string& expected) {
    scanner_.go_to(at);
    scanner_.refuse(expected);
  }

  Scanner& scanner_;
  const NamedValues& names_;
  int depth_ = 0;
};

}  // namespace

double expression(Scanner& scanner, const NamedValues& names) {
  return Arithmetic(scanner, names).sum();
}

bool is_function(std::string_view word) {
  for (const Function& function : functions)
    if (function.name == word) return true;
  return false;
}

}  // namespace polhode
