// SPDX-License-Identifier: MIT
#include "polhode/io/settings/requirement.hpp"

#include <fmt/core.h>

#include <array>

#include "io/settings/quantity.hpp"
#include "io/settings/required_bias.hpp"
#include "io/settings/settings.hpp"
#include "polhode/base/error.hpp"

namespace polhode {
namespace {

struct Form {
  RequiredOf of;
  const char* word;  // word before the bound
  Dimension dimension;
  const char* unit;
  const char* example;
};

constexpr std::array forms{
    Form{RequiredOf::ratio, "", Dimension::fraction, "%", "0.5 %"},
    Form{RequiredOf::temperature_difference, "", Dimension::temperature, "K", "0.1 K"},
    Form{RequiredOf::energy, "energy", Dimension::energy, "kJ/mol", "energy 0.01 kJ/mol"},
    Form{RequiredOf::pressure, "pressure", Dimension::pressure, "bar", "pressure 4 bar"},
    Form{RequiredOf::density, "density", Dimension::fraction, "%", "density 0.02 %"}};

const Form& form_of(RequiredOf of) { return forms[static_cast<std::size_t>(of)]; }

/// The form of a requirement, selected by the first word of its text. A text with any other first
/// word has the form for temperatures.
const Form& form_of(const std::string& text) {
  for (const Form& form : forms)
    if (*form.word && text.starts_with(form.word)) return form;
  return form_of(RequiredOf::temperature_difference);
}

}  // namespace

std::string wrong_bound(double ratio) { return wrong_value("integrator.accuracy", ratio); }

bool is_of_bias(const std::string& text) { return *form_of(text).word || text.ends_with('K'); }

Requirement required_bias(const std::string& text, const std::string& name) {
  const Form& form = form_of(text);
  const std::string rest = text.substr(std::string(form.word).size());
  if (rest.find_first_not_of(' ') == std::string::npos)
    throw Error(
        fmt::format("{} = \"{}\" has no bound; give for example \"{}\"", name, text, form.example));
  const std::string bound_text = rest.substr(rest.find_first_not_of(' '));
  const double bound = quantity(bound_text, form.dimension, name, form.example);
  if (!(bound > 0))
    throw Error(fmt::format("{} = \"{}\" must be above 0; give for example \"{}\"", name, text,
                            form.example));
  return {form.of, bound};
}

std::string text_of(const Requirement& requirement) {
  const Form& form = form_of(requirement.of);
  return fmt::format("{}{}{:.12g} {}", form.word, *form.word ? " " : "",
                     requirement.bound / unit(form.unit, form.dimension), form.unit);
}

}  // namespace polhode
