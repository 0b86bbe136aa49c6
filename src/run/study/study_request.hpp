// SPDX-License-Identifier: MIT
// The options of a study that a front end received in addition to settings, and the kind of study
// that they select.
#pragma once

#include <string>
#include <vector>

#include "run/canonical/canonical_report.hpp"
#include "run/given.hpp"
#include "run/study/study_report.hpp"

namespace polhode {

struct StudyRequest {
  Given from_record, output;
  bool quick = false;

  static std::vector<RequestOption<StudyRequest>> options();
  std::string prefix() const { return output ? output.text : "study"; }
};

/// Performs the study of the settings, or makes the tables and the figure of a record. An
/// interrupted study resumes from its record.
/// @param use  function that receives the report of either kind of study; its result is returned
template <class Use>
auto perform_study(Config config, const StudyRequest& request, OutputOptions output,
                   const Callbacks& callbacks, Workers& workers, const Use& use) {
  config.study.coarse = request.quick;
  if (output.existing == ExistingFiles::refuse && !request.from_record)
    output.existing = ExistingFiles::resume;
  const auto perform = [&](auto run, auto report) {
    return use(request.from_record
                   ? report(config, request.from_record.text, request.prefix(), output, callbacks)
                   : run(config, request.prefix(), output, callbacks, workers));
  };
  if (config.study.ensemble == StudyEnsemble::nvt)
    return perform(run_canonical_study, report_canonical_record);
  return perform(run_study, report_study_record);
}

}  // namespace polhode
