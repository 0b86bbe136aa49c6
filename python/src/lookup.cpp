// SPDX-License-Identifier: MIT
// Python functions for schemes, molecules, quantities, errors of means, and the bias of logs.
#include <nanobind/stl/map.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <array>

#include "base/suggest.hpp"
#include "bind.hpp"
#include "io/settings/quantity.hpp"
#include "job_options.hpp"
#include "polhode/base/error.hpp"
#include "polhode/integrate/scheme_text.hpp"
#include "polhode/io/topology/molecule_file.hpp"
#include "polhode/measure/correlated_series.hpp"
#include "run/bias/log_bias.hpp"
#include "run/listing/lists.hpp"
#include "run/listing/verification.hpp"
#include "run/requests.hpp"

namespace polhode::python {
namespace {

namespace nb = nanobind;

constexpr std::pair<std::string_view, Dimension> dimensions[] = {
    {"length", Dimension::length},
    {"time", Dimension::time},
    {"mass", Dimension::mass},
    {"charge", Dimension::charge},
    {"temperature", Dimension::temperature},
    {"force", Dimension::force},
    {"energy", Dimension::energy},
    {"density", Dimension::density},
    {"pressure", Dimension::pressure},
    {"power", Dimension::power},
    {"viscosity", Dimension::viscosity},
    {"fraction", Dimension::fraction},
    {"rate", Dimension::rate},
};

Dimension dimension_of(const std::string& name) {
  for (const auto& [known, dimension] : dimensions)
    if (name == known) return dimension;
  std::vector<std::string> names;
  for (const auto& [known, dimension] : dimensions) names.emplace_back(known);
  throw Error("there is no dimension '" + name + "'" + did_you_mean(name, names) +
              "; there are: " + join_names(names));
}

/// The mean of a series of samples, its standard error, and the reason if the error is not known.
nb::tuple series_mean(const std::vector<double>& samples) {
  TimeBlocks blocks;
  for (const double x : samples) blocks.add(std::array{x});
  const SeriesEstimate e = series_estimate(blocks.means(), [](auto mean) { return mean[0]; });
  if (e.known == Known::yes) return nb::make_tuple(e.value, e.error, nb::none());
  return nb::make_tuple(e.value, nb::none(), reason(e.known));
}

}  // namespace

void bind_lookup(nb::module_& m) {
  m.def("schemes_json", [] { return json_text(all_schemes()); });
  m.def("series_mean", &series_mean);
  m.def("scheme_json",
        [](const std::string& text) { return json_text(quantities(scheme_of(text))); });
  m.def("verify", [](const std::string& text, const Options& given) {
    const NamedScheme scheme = text;
    const auto request = request_of<VerificationRequest>(given);
    const int order = request.expected_order();
    const double lambda = request.gradient_lambda(scheme);
    const nb::gil_scoped_release released;
    return report_text(quantities(verify(scheme, order, lambda)));
  });
  m.def("bias", [](const std::string& path, const std::vector<std::string>& names,
                   const std::vector<std::vector<double>>& columns, const Options& given) {
    const auto request = request_of<BiasRequest>(given);
    const nb::gil_scoped_release released;
    const EngineLog log =
        columns.empty() ? read_engine_log(path) : log_of_columns(path, names, columns);
    return report_text(quantities(log_bias(log, request)));
  });
  m.def("molecules_json",
        [](const std::string& name) { return json_text(records(find_molecules(name))); });
  m.def("molecule_json", [](const std::string& text, const std::string& file) {
    return json_text(quantities(parse_molecule(text, file)));
  });
  m.def("quantity",
        [](const std::string& text, const std::string& dimension, const std::string& name) {
          return quantity(text, dimension_of(dimension), name);
        });
  m.def("no_unit",
        [](const std::string& name, const std::string& number, const std::string& dimension) {
          return no_unit(name, number, dimension_of(dimension));
        });
  m.def("did_you_mean", [](const std::string& word, const std::vector<std::string>& names) {
    return did_you_mean(word, names);
  });
}

}  // namespace polhode::python
