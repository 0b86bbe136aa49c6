// SPDX-License-Identifier: MIT
#include "prepare_report.hpp"

#include <fmt/core.h>

#include "../terminal/streams.hpp"
#include "run_report.hpp"

namespace polhode::cli {

void print_preparation(const PreparationReport& r) {
  if (!r.properties) return;
  fmt::print("{}", preparation_text(r));
  print_files(r.files);
  fmt::print("next                  polhode run {}\n", r.run_file);
  print_warnings(r.properties->warnings);
}

}  // namespace polhode::cli
