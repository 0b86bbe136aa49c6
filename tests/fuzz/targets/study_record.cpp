// SPDX-License-Identifier: MIT
#include "run/study/run_record.hpp"

#include <sstream>

#include "../fuzz.hpp"

void polhode::fuzz::read(std::string_view text) {
  std::istringstream in{std::string(text)};
  const Provenance provenance{"1", "", "of the seeds", "scalar", 1};
  StudyRecord::read(in, "fuzz-runs.csv", &provenance);
}
