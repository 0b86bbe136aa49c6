// SPDX-License-Identifier: MIT
// Output of the adviser: a page of text, JSON, a table and a figure.
#pragma once

#include <string>
#include <vector>

#include "polhode/io/table_file.hpp"
#include "polhode/run/adviser/adviser.hpp"

namespace polhode::cli {

struct AdviceFiles {
  std::string prefix, points, json, script, figure;

  /// @param plot  "svg", "png" or "none"
  AdviceFiles(const std::string& common, const std::string& plot);
  std::vector<std::string> all() const;
};

/// "an R of at most 0.5 %".
std::string description(const Criterion& criterion);

/// Why no scheme was found, and what to change.
std::string unreachable(const Advice& advice, const Criterion& criterion);

/// "hoa2 at 4.52 fs: R = 0.44 ± 0.01 %, below 0.49 % in 97.5 of 100 runs of 15 ps"
std::string answer(const Advice& advice);

void write_advice(const AdviceFiles& files, const Advice& advice, const Criterion& criterion,
                  const Provenance& provenance);
std::string advice_json(const Advice& advice, const Criterion& criterion, int threads);
void print_advice(const Advice& advice, const Criterion& criterion, int threads);

}  // namespace polhode::cli
