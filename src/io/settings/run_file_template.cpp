// SPDX-License-Identifier: MIT
#include "io/settings/run_file_template.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <span>

#include "base/suggest.hpp"
#include "io/files/embedded.hpp"
#include "polhode/base/error.hpp"

namespace polhode {
namespace {

constexpr std::string_view output = "\n[output]", energy = "at constant energy";

std::string template_of(std::string_view kind) {
  return std::string(embedded_text(fmt::format("runs/{}.toml", kind)).value());
}

/// The tables of an ensemble, copied from the run-file template for this ensemble.
std::string tables_of(std::string_view ensemble) {
  const std::string text = template_of(ensemble);
  const auto begin = text.find("\n[thermostat]");
  return text.substr(begin, text.find(output) - begin);
}

void require_one_of(std::span<const std::string_view> names, std::string_view name,
                    std::string_view what) {
  if (std::find(names.begin(), names.end(), name) == names.end())
    throw Error(fmt::format("the {} '{}' {}", what, name, must_be_one_of(names, name)));
}

}  // namespace

std::string run_file_template(std::string_view kind, std::string_view ensemble) {
  require_one_of(run_file_kinds, kind, "kind of run file");
  if (!ensemble.empty()) require_one_of(run_file_ensembles, ensemble, "ensemble");
  std::string text = template_of(kind);
  const auto at = text.find(energy);
  const std::string_view own = at == text.npos ? kind : std::string_view("nve");
  if (ensemble.empty() || ensemble == own) return text;
  if (at == text.npos)
    throw Error(
        fmt::format("run files of the kind '{}' already have an ensemble; give the kind '{}' "
                    "instead, or combine another kind with the ensemble '{}'",
                    kind, ensemble == "nve" ? "water" : ensemble, ensemble));
  text.replace(
      at, energy.size(),
      ensemble == "nvt" ? "at constant temperature" : "at constant temperature and pressure");
  return text.insert(text.find(output), tables_of(ensemble));
}

}  // namespace polhode
