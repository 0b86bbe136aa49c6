// SPDX-License-Identifier: MIT
// What the jobs of the command line have in common, and quantities as their options.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/suggest.hpp"
#include "io/settings/quantity.hpp"
#include "job.hpp"
#include "polhode/base/error.hpp"
#include "polhode/base/workers.hpp"
#include "polhode/io/settings/config.hpp"
#include "polhode/io/settings/nested_scheme_text.hpp"
#include "polhode/run/outputs.hpp"
#include "polhode/run/quantities.hpp"

namespace polhode::python {

using Text = std::optional<std::string>;
using Texts = std::optional<std::vector<std::string>>;

/// What all jobs have in common.
struct JobOptions {
  int threads = 1;
  OutputOptions output;
  nanobind::object progress, message;

  /// Calls f(callbacks, workers).
  template <class F>
  auto run(const F& f) const {
    return Job({progress, message}).run([&](const Callbacks& callbacks) {
      Workers workers(threads);
      return f(callbacks, workers);
    });
  }
};

/// The report of a job: its JSON, and the rows that notebooks show.
inline std::string report_text(const Quantities& results) {
  return json_text(results, text_rows(results));
}

template <NamedEnum Enum>
Enum named(const std::string& text, const std::string& name) {
  if (const auto value = value_of<Enum>(text)) return *value;
  throw Error(name + " = \"" + text + "\" " + must_be_one_of(enum_names<Enum>, text));
}

inline void set_positive(double& value, const Text& text, Dimension dimension,
                         const std::string& name) {
  if (!text) return;
  value = quantity(*text, dimension, name);
  if (!(value > 0)) throw Error(name + " = \"" + *text + "\" must be above 0");
}

inline std::optional<double> positive(const Text& text, Dimension dimension,
                                      const std::string& name) {
  if (!text) return std::nullopt;
  double value = 0;
  set_positive(value, text, dimension, name);
  return value;
}

inline void set_schemes(std::vector<NamedScheme>& schemes, const Texts& texts,
                        const Config& config) {
  if (!texts) return;
  schemes.clear();
  for (const std::string& text : *texts)
    schemes.emplace_back(with_own_schemes(text, config.schemes));
}

}  // namespace polhode::python
