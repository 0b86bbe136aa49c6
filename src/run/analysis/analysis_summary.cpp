// SPDX-License-Identifier: MIT
#include "run/analysis/analysis_summary.hpp"

#include <fmt/core.h>

#include <iterator>
#include <utility>

#include "run/quantity_lists.hpp"

namespace polhode {
namespace {

constexpr const char* of_run_file = "of the run file";

void find_temperature(AnalysisSummary& s, const Analysis& a, const SummarySettings& settings) {
  const double kinetic = a.conditions->temperature().value;
  const auto take = [&](double temperature, const char* source) {
    s.temperature = temperature;
    s.temperature_source = source;
  };
  if (settings.temperature)
    take(*settings.temperature, "as given");
  else if (kinetic > 0)
    take(kinetic, "of the velocities");
  else if (settings.run_temperature)
    take(*settings.run_temperature, of_run_file);
  if (s.temperature_source == of_run_file && settings.constant_energy)
    s.notes.push_back(fmt::format(
        "the frames have no velocities, so the temperature of the run file, {:g} K, is used; for a "
        "run at constant energy, give the mean temperature from the summary of the run",
        *s.temperature));
}

}  // namespace

void SummarySettings::set_surroundings(const ForceSettings& forces) {
  surroundings_permittivity = permittivity_of_surroundings(forces);
  if (!surroundings_permittivity)
    no_surroundings =
        "dipole fluctuations give no dielectric constant if electrostatics is truncated or "
        "switched; pme or a reaction field is needed";
}

void SummarySettings::set_run(const Config& config) {
  set_surroundings(config.forces);
  constant_energy = config.ensemble.constant_energy();
  // The default temperature of a run at constant energy is not the temperature of its velocities.
  const bool told = config.gives("system.temperature") || !constant_energy;
  if (told && config.system.temperature > 0) run_temperature = config.system.temperature;
}

AnalysisSummary summary(const Analysis& a, const SummarySettings& settings, Workers& workers) {
  AnalysisSummary s;
  s.notes = a.notes;
  find_temperature(s, a, settings);
  std::vector<Quantities> parts;
  for (const auto& [molecule, count] : a.topology.parts)
    parts.push_back({{"molecule", "", molecule.name}, {"count", "", count}});
  for (const auto& observable : a.observables) {
    ObservableResults found = observable->results({a, settings, s.temperature, workers, s.notes});
    append(s.quantities, std::move(found.quantities));
    for (std::size_t part = 0; part < found.parts.size(); ++part)
      append(parts[part], std::move(found.parts[part]));
    std::move(found.files.begin(), found.files.end(), std::back_inserter(s.files));
  }
  s.quantities.push_back({"parts", "", std::move(parts)});
  std::erase_if(s.files, [](const AnalysisFile& file) { return file.table.rows.empty(); });
  return s;
}

}  // namespace polhode
