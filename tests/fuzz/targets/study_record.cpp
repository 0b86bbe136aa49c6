// SPDX-License-Identifier: MIT
#include "polhode/run/study/study_record.hpp"

#include <sstream>

#include "../fuzz.hpp"

void polhode::fuzz::read(std::string_view text) {
  std::istringstream in{std::string(text)};
  read_study_record(in, "fuzz-runs.csv", {"1", "", "of the seeds", "scalar", 1});
}
