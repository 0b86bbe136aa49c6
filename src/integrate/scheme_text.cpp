// SPDX-License-Identifier: MIT
#include "polhode/integrate/scheme_text.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "arithmetic.hpp"
#include "base/suggest.hpp"
#include "polhode/base/error.hpp"
#include "polhode/integrate/error_terms.hpp"
#include "polhode/integrate/schemes.hpp"
#include "polhode/integrate/with_bath.hpp"
#include "scanner.hpp"

namespace polhode {
namespace {

constexpr std::size_t max_text = 4096, max_names = 32;

const Scheme* built_in(std::string_view name) {
  for (const Scheme& scheme : schemes)
    if (scheme.name() == name) return &scheme;
  return nullptr;
}

struct BathName {
  std::string_view name, meaning;
};
/// Common names for velocity Verlet and position Verlet, both with a heat bath.
constexpr std::array bath_names = {
    BathName{"obabo", "velocity-verlet-ends"}, BathName{"baoab", "velocity-verlet-middle"},
    BathName{"oabao", "position-verlet-ends"}, BathName{"aboba", "position-verlet-middle"}};

/// A built-in scheme with a bath: "hoa2-ends", "hoa2-middle", or one of the names in bath_names.
std::optional<Scheme> built_in_with_bath(std::string_view name) {
  std::string_view meaning = name, short_name = name;
  for (const BathName& known : bath_names)
    if (known.name == name || known.meaning == name)
      meaning = known.meaning, short_name = known.name;
  const auto dash = meaning.rfind('-');
  if (dash == std::string_view::npos) return std::nullopt;
  const std::string_view place = meaning.substr(dash);
  const Scheme* scheme = built_in(meaning.substr(0, dash));
  if (!scheme || (place != "-ends" && place != "-middle")) return std::nullopt;
  return with_bath(*scheme, place == "-ends" ? BathPlace::ends : BathPlace::middle, short_name);
}

bool is_flow(std::string_view word) {
  return word.size() == 1 && std::any_of(all_flows.begin(), all_flows.end(), [&](Flow flow) {
           return letter_of(flow) == word.front();
         });
}

/// The user-given name before the colon, as in "mine: B(1/2) A(1) B(1/2)"; empty if there is none.
std::string_view own_name(std::string_view text) {
  const auto colon = text.find(':');
  if (colon == std::string_view::npos) return {};
  const auto begin = text.find_first_not_of(" \t\n"),
             end = text.find_last_not_of(" \t\n", colon - 1) + 1;
  const std::string_view name = begin < colon ? text.substr(begin, end - begin) : "";
  const auto good = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_' || c == '.';
  };
  if (name.empty() || name.size() > Scheme::max_name ||
      !std::all_of(name.begin(), name.end(), good))
    throw Error(
        fmt::format("scheme name '{}' must have 1 to {} letters, digits, '-', '_' or '.', since "
                    "the name appears in tables and figures; write for example \"mine: {}\"",
                    name, Scheme::max_name, example_scheme));
  if (built_in(name))
    throw Error(
        fmt::format("the name '{0}' is the name of a built-in scheme (see 'polhode schemes {0}'); "
                    "choose another name",
                    name));
  return name;
}

/// Reads definitions and stages from left to right.
class SchemeReader {
 public:
  SchemeReader(std::string_view text, std::size_t begin, std::span<const FreeParameter> values)
      : scanner_(text), values_(values) {
    scanner_.go_to(begin);
  }

  void definitions() {
    while (scanner_.next_is_letter() && !is_flow(scanner_.next_word())) define();
  }

  std::vector<Stage> stages() {
    std::vector<Stage> all;
    while (!scanner_.at_end()) {
      all.push_back(stage());
      if (all.size() > Scheme::max_stages)
        throw Error(fmt::format("the scheme has more than {} stages; write a shorter scheme",
                                Scheme::max_stages));
    }
    return all;
  }

  const std::vector<FreeParameter>& free_parameters() const { return free_; }

 private:
  /// Reads a definition: "x = 1/sqrt(3);" or "free x = 0.2;".
  void define() {
    std::size_t begin = scanner_.at();
    std::string_view name = scanner_.word();
    const bool free = name == "free" && scanner_.next_is_letter();
    if (free) begin = scanner_.at(), name = scanner_.word();
    if (!scanner_.next_is('=') || is_function(name) || is_flow(name) || name == "free" ||
        names_.contains(name)) {
      scanner_.go_to(begin);
      scanner_.refuse(
          "A(...) for a drift, B(...) for a kick or O(...) for a bath, or a new name of a constant "
          "like \"x = 1/6;\",");
    }
    if (names_.size() == max_names)
      scanner_.refuse(fmt::format("a stage, after {} names,", max_names));
    scanner_.expect('=');
    double value = expression(scanner_, names_);
    scanner_.expect(';');
    for (const FreeParameter& given : values_)
      if (free && given.name == name) value = given.value;
    names_.emplace(name, value);
    if (free) free_.push_back({std::string(name), value});
  }

  Stage stage() {
    Stage result{.flow = flow()};
    scanner_.expect('(');
    result.fraction = expression(scanner_, names_);
    if (scanner_.next_is(',')) {
      switch (result.flow) {
        case Flow::drift:
        case Flow::bath:
          scanner_.refuse(fmt::format("')' (a {} has one argument)", name_of(result.flow)));
        case Flow::kick:
          read_gradient(result);
          break;
      }
    }
    scanner_.expect(')');
    return result;
  }

  Flow flow() {
    for (const Flow flow : all_flows)
      if (scanner_.take(letter_of(flow))) return flow;
    scanner_.refuse("A(...) for a drift, B(...) for a kick or O(...) for a bath");
  }

  void read_gradient(Stage& kick) {
    scanner_.expect(',');
    if (scanner_.next_word() == "xi" && !names_.contains("xi")) {
      scanner_.word();
      scanner_.expect('=');
    }
    kick.xi = expression(scanner_, names_);
    if (!scanner_.take(',')) return;
    if (scanner_.next_word() != "fd") scanner_.refuse("'fd', for the finite-difference gradient,");
    scanner_.word();
    kick.gradient = Gradient::finite_difference;
  }

  Scanner scanner_;
  std::span<const FreeParameter> values_;
  NamedValues names_;
  std::vector<FreeParameter> free_;
};

SchemeReader reader_of(std::string_view text, std::span<const FreeParameter> values) {
  if (text.size() > max_text)
    throw Error(fmt::format(
        "the text of the scheme has {} characters; the maximum is {}, enough for {} stages",
        text.size(), max_text, Scheme::max_stages));
  const auto colon = text.find(':');
  SchemeReader reader(text, colon == std::string_view::npos ? 0 : colon + 1, values);
  reader.definitions();
  return reader;
}

void check_sums(const Scheme& scheme) {
  if (scheme.consistent()) return;
  throw Error(fmt::format(
      "the drifts A of the scheme sum to {:.16g} and the kicks B to {:.16g}{}; each must sum to 1, "
      "so that a step advances time by h",
      scheme.total(Flow::drift), scheme.total(Flow::kick),
      scheme.has(Flow::bath) ? fmt::format(", the baths O to {:.16g}", scheme.total(Flow::bath))
                             : ""));
}

/// The order of a scheme: 2 for a palindrome of drifts and kicks with an error of order h². The
/// result is 0 if the order is higher or unknown, as for a scheme of order 4 with rounded
/// coefficients.
int order_of(const Scheme& scheme) {
  if (!scheme.palindromic() || scheme.has(Flow::bath)) return 0;
  constexpr double rounding = 1e-4;  // largest error term due to coefficients rounded to five
                                     // digits or more; an error term of hoa2 is 7e-3
  const ErrorTerms error = error_terms(scheme);
  return std::hypot(error.alpha, error.beta) > rounding ? 2 : 0;
}

[[noreturn]] void refuse_name(std::string_view name) {
  std::vector<std::string> names;
  for (const Scheme& scheme : schemes) names.emplace_back(scheme.name());
  throw Error(
      fmt::format("there is no scheme '{}'{} ('polhode schemes' lists all schemes; you can also "
                  "write the stages of a scheme, like \"{}\")",
                  name, did_you_mean(name, names), example_scheme));
}

}  // namespace

Scheme scheme_of(std::string_view name_or_text, std::span<const FreeParameter> values) {
  if (const Scheme* scheme = built_in(name_or_text)) return *scheme;
  if (const auto scheme = built_in_with_bath(name_or_text)) return *scheme;
  if (name_or_text.find_first_of("(:") == std::string_view::npos) refuse_name(name_or_text);
  const std::string_view name = own_name(name_or_text);
  const std::vector<Stage> stages = reader_of(name_or_text, values).stages();
  const Scheme scheme(stages, 0, name);
  check_sums(scheme);
  return Scheme(stages, order_of(scheme), name);
}

std::vector<FreeParameter> free_parameters(std::string_view name_or_text) {
  if (built_in(name_or_text) || built_in_with_bath(name_or_text)) return {};
  return reader_of(name_or_text, {}).free_parameters();
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
