// SPDX-License-Identifier: MIT
// Studies: accuracy against cost of schemes.
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <algorithm>

#include "bind.hpp"
#include "job_options.hpp"
#include "run/canonical/canonical_report.hpp"
#include "run/study/study_report.hpp"

namespace polhode::python {
namespace {

namespace nb = nanobind;

template <class Report>
nb::tuple study_result(const Report& report) {
  return nb::make_tuple(report_text(quantities(report)), report.files, !report.interrupted);
}

nb::tuple study(Config config, const Texts& schemes, const Texts& steps, bool is_quick,
                const std::string& prefix, const Text& record, const JobOptions& options) {
  StudySettings& settings = config.study;
  if (is_quick) settings = quick(settings);
  set_schemes(settings.schemes, schemes, config);
  if (steps) {
    settings.steps.clear();
    for (const std::string& step : *steps)
      settings.steps.push_back(*positive(step, Dimension::time, "steps"));
    std::sort(settings.steps.begin(), settings.steps.end());
  }
  const auto perform = [&](auto run_it, auto report_it) {
    return study_result(options.run([&](const Callbacks& callbacks, Workers& workers) {
      return record ? report_it(config, *record, prefix, options.output, callbacks)
                    : run_it(config, prefix, options.output, callbacks, workers);
    }));
  };
  if (settings.ensemble == StudyEnsemble::nvt)
    return perform(run_canonical_study, report_canonical_record);
  return perform(run_study, report_study_record);
}

}  // namespace

void bind_study(nb::module_& m) { m.def("study", &study); }

}  // namespace polhode::python
