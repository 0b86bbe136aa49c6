// SPDX-License-Identifier: MIT
#include "polhode/integrate/scheme_text.hpp"

#include <fmt/core.h>

#include <cctype>
#include <charconv>
#include <cmath>
#include <vector>

#include "polhode/base/error.hpp"
#include "polhode/base/suggest.hpp"
#include "polhode/integrate/schemes.hpp"

namespace polhode {
namespace {

constexpr const char* example = "B(1/6) A(1/2) B(2/3, 1/48) A(1/2) B(1/6)";

/// Parses a scheme from left to right; errors give the position.
class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  std::vector<Stage> stages() {
    std::vector<Stage> all;
    for (skip_space(); at_ < text_.size(); skip_space()) {
      all.push_back(stage());
      if (all.size() > Scheme::max_stages)
        throw Error(fmt::format("the scheme has more than {} stages; write a shorter one",
                                Scheme::max_stages));
    }
    return all;
  }

 private:
  Stage stage() {
    Stage result{.flow = flow()};
    expect('(');
    result.fraction = number();
    if (next_is(',')) {
      switch (result.flow) {
        case Flow::drift:
        case Flow::bath:
          refuse(fmt::format("')': a {} has one argument", name_of(result.flow)));
        case Flow::kick:
          read_gradient(result);
          break;
      }
    }
    expect(')');
    return result;
  }

  Flow flow() {
    for (const Flow flow : all_flows)
      if (text_[at_] == letter_of(flow)) {
        ++at_;
        return flow;
      }
    refuse("A(...) for a drift, B(...) for a kick or O(...) for a bath");
  }

  void read_gradient(Stage& kick) {
    expect(',');
    skip_space();
    if (text_.substr(at_).starts_with("xi")) {
      at_ += 2;
      expect('=');
    }
    kick.xi = number();
    if (!next_is(',')) return;
    expect(',');
    skip_space();
    if (!text_.substr(at_).starts_with("fd"))
      refuse("'fd', for the gradient by finite difference,");
    at_ += 2;
    kick.gradient = Gradient::finite_difference;
  }

  double number() {  // a decimal number, or a fraction of two
    const double above = decimal();
    skip_space();
    if (at_ >= text_.size() || text_[at_] != '/') return above;
    ++at_;
    const double below = decimal();
    if (below == 0) refuse("a denominator other than 0");
    return above / below;
  }

  double decimal() {
    skip_space();
    double value = 0;
    const auto [end, error] =
        std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
    if (error != std::errc() || !std::isfinite(value)) refuse("a finite number like 0.25 or 1/4");
    at_ = static_cast<std::size_t>(end - text_.data());
    return value;
  }

  bool next_is(char c) {
    skip_space();
    return at_ < text_.size() && text_[at_] == c;
  }

  void expect(char c) {
    if (!next_is(c)) refuse(fmt::format("'{}'", c));
    ++at_;
  }

  void skip_space() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_]))) ++at_;
  }

  [[noreturn]] void refuse(const std::string& expected) const {
    const std::string found =
        at_ < text_.size() ? fmt::format("'{}'", text_.substr(at_, 10)) : "the end";
    throw Error(fmt::format(
        "scheme text has {} at character {} where {} is expected; a scheme is written like \"{}\"",
        found, at_ + 1, expected, example));
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace

Scheme scheme_of(std::string_view name_or_text) {
  for (const Scheme& scheme : schemes)
    if (scheme.name() == name_or_text) return scheme;
  if (name_or_text.find('(') == std::string_view::npos) {
    std::vector<std::string> names;
    for (const Scheme& scheme : schemes) names.emplace_back(scheme.name());
    throw Error(
        fmt::format("there is no scheme '{}'{} ('polhode schemes' lists all of them; or write the "
                    "stages, like \"{}\")",
                    name_or_text, did_you_mean(name_or_text, names), example));
  }
  const Scheme scheme(Reader(name_or_text).stages(), 0);
  if (!scheme.consistent())
    throw Error(fmt::format(
        "the drifts A of the scheme sum to {:.17g} and the kicks B to {:.17g}{}; each must sum to "
        "1, so that a step advances time by h; adjust the coefficients",
        scheme.total(Flow::drift), scheme.total(Flow::kick),
        scheme.has(Flow::bath) ? fmt::format(", the baths O to {:.17g}", scheme.total(Flow::bath))
                               : ""));
  return scheme;
}

std::string text_of(const Scheme& scheme) {
  std::string text;
  for (const Stage& stage : scheme.stages()) {
    text += text.empty() ? "" : " ";
    text += fmt::format("{}({}", letter_of(stage.flow), stage.fraction);
    if (stage.xi != 0) text += fmt::format(", {}", stage.xi);
    text += stage.has(Gradient::finite_difference) ? ", fd)" : ")";
  }
  return text;
}

}  // namespace polhode
