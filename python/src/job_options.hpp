// SPDX-License-Identifier: MIT
// Functions that all jobs called from Python share, with job options as texts.
#pragma once

#include <map>
#include <string>

#include "job.hpp"
#include "polhode/base/error.hpp"
#include "polhode/base/workers.hpp"
#include "polhode/io/settings/config.hpp"
#include "polhode/run/outputs.hpp"
#include "polhode/run/quantities.hpp"
#include "run/given.hpp"
#include "run/quantity_lists.hpp"

namespace polhode::python {

/// Options that all jobs have in common.
struct JobOptions {
  int threads = 1;
  OutputOptions output;
  nanobind::object progress, message;

  /// Calls f(callbacks, workers).
  template <class F>
  auto run(const F& f) const {
    return Job(progress, message).run([&](const Callbacks& callbacks) {
      Workers workers(threads);
      return f(callbacks, workers);
    });
  }
};

/// The report of a job as text: its JSON, and the rows that notebooks show.
inline std::string report_text(const Quantities& results) {
  return json_text(results, text_rows(results));
}

/// The options of a job by their names, as texts.
using Options = std::map<std::string, std::string>;

template <class Request>
Request request_of(const Options& given) {
  Request request;
  for (const RequestOption<Request>& row : Request::options()) {
    Given& option = request.*row.member;
    option.name = row.name;
    const auto found = given.find(row.name);
    if (found == given.end()) continue;
    if (found->second.empty())
      throw Error(option.name + " is empty; give a value, or leave the keyword out");
    option.text = found->second;
  }
  return request;
}

}  // namespace polhode::python
