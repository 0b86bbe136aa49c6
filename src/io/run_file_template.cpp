// SPDX-License-Identifier: MIT
#include "polhode/io/run_file_template.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "polhode/base/error.hpp"
#include "polhode/base/suggest.hpp"
#include "polhode/io/embedded.hpp"

namespace polhode {

std::string_view run_file_template(std::string_view kind) {
  if (std::find(run_file_kinds.begin(), run_file_kinds.end(), kind) == run_file_kinds.end())
    throw Error(
        fmt::format("the kind of run file '{}' {}", kind, must_be_one_of(run_file_kinds, kind)));
  return embedded_text(fmt::format("runs/{}.toml", kind)).value();
}

}  // namespace polhode
