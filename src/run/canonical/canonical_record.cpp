// SPDX-License-Identifier: MIT
#include "run/simulation/files/identity.hpp"
#include "run/study/record_columns.hpp"

namespace polhode {
namespace {

/// A number, or empty if the number is NaN.
std::optional<double> known(double value) {
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

}  // namespace

template <>
const std::vector<RecordColumn<CanonicalRun>>& record_columns() {
  static const std::vector<RecordColumn<CanonicalRun>> columns = [] {
    std::vector<RecordColumn<CanonicalRun>> all;
    for (std::size_t k = 0; k < canonical_quantities.size(); ++k)
      all.push_back(
          {fmt::format("{} [{}]", canonical_quantities[k].name, canonical_quantities[k].unit),
           canonical_quantities[k].label,
           [k](const CanonicalRun& run) { return known(run.means[k]); },
           [k](CanonicalRun& run, double mean) { run.means[k] = mean; }, true, false, empty_field});
    all.push_back({"correlation time [ps]", "correlation time",
                   [](const CanonicalRun& run) { return known(run.correlation_time); },
                   [](CanonicalRun& run, double time) { run.correlation_time = time; }, true, false,
                   empty_field});
    all.push_back(column_of("acceptance", "acceptance", &CanonicalRun::acceptance));
    all.push_back(column_of("mean of exp(-dH/kT)", "mean of exp(-dH/kT)", &CanonicalRun::weight));
    return all;
  }();
  return columns;
}

template <>
std::size_t field_count<CanonicalRun>(std::string_view head, const Lines& lines) {
  if (head == record_head<CanonicalRun>())
    return first_column + record_columns<CanonicalRun>().size();
  lines.refuse(
      "these are not the columns that a canonical study of this version of polhode writes; give "
      "another output, or start over");
}

template class RunRecord<CanonicalRun>;

std::string canonical_identity(const Config& config, const System& system) {
  return identity(config, system, {config.study.length, config.study.decorrelate}) + " canonical " +
         fmt::format("{} {}", config.study.configurational_sample, config.integrator.lambda);
}

}  // namespace polhode
