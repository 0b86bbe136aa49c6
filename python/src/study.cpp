// SPDX-License-Identifier: MIT
// Studies: accuracy against cost of schemes.
#include <nanobind/stl/map.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <string>
#include <tuple>
#include <vector>

#include "bind.hpp"
#include "job_options.hpp"
#include "run/requests.hpp"

namespace polhode::python {
namespace {

namespace nb = nanobind;

std::tuple<std::string, std::vector<std::string>, bool> study(const Config& config, bool quick,
                                                              const Options& given,
                                                              const JobOptions& options) {
  auto request = request_of<StudyRequest>(given);
  request.quick = quick;
  const auto tuple_of = [](const auto& report) {
    return std::tuple(report_text(quantities(report)), report.files, !report.interrupted);
  };
  return options.run([&](const Callbacks& callbacks, Workers& workers) {
    return perform_study(config, request, options.output, callbacks, workers, tuple_of);
  });
}

}  // namespace

void bind_study(nb::module_& m) { m.def("study", &study); }

}  // namespace polhode::python
