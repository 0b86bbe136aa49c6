// SPDX-License-Identifier: MIT
#include "arithmetic.hpp"

#include <fmt/core.h>

#include <array>
#include <cmath>

namespace polhode {
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
