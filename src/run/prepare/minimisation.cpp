// SPDX-License-Identifier: MIT
#include "polhode/run/prepare/minimisation.hpp"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "io/coordinates/gro.hpp"
#include "polhode/base/error.hpp"
#include "run/simulation/system/relaxation.hpp"
#include "run/simulation/system/system_notes.hpp"

namespace polhode {
namespace {

void check_settings(const MinimisationSettings& s) {
  if (!(s.force > 0) || !(s.torque > 0))
    throw Error(
        fmt::format("the bounds of minimisation are {:g} kJ/mol/nm and {:g} kJ/mol; they must be "
                    "above 0: rounding keeps forces from vanishing; 10 kJ/mol/nm and 1 kJ/mol are "
                    "usual",
                    s.force, s.torque));
}

nlohmann::json steepness_json(const Steepness& s, std::size_t molecules) {
  return {{"potential_kJ_per_mol", s.potential / static_cast<double>(molecules)},
          {"force_kJ_per_mol_nm", s.force},
          {"torque_kJ_per_mol", s.torque}};
}

}  // namespace

MinimisationReport minimise_configuration(const Config& run_file,
                                          const MinimisationSettings& settings,
                                          const OutputOptions& options, const Callbacks& callbacks,
                                          Workers& workers) {
  check_settings(settings);
  Config config = run_file;
  config.run.minimise = true;
  const std::string file = config.output.prefix + "-minimised.gro";
  check_prefix(config.output.prefix, {file});
  const OutputLock lock(config.output.prefix + "-minimise.lock", callbacks);
  check_outputs({file}, options.existing);
  System system = build_system(config);
  note_molecules(system, callbacks);
  note_forces(system, callbacks);
  const Minimisation result = minimise(system, settings, watch_of(callbacks), workers);
  write_file(file, [&](std::ostream& out) {
    Frame frame = frame_of(system.state, system.topology);
    frame.has_velocities = false;
    write_gro(out, frame);
  });
  return {result, system.topology.size(), settings, file};
}

std::string reason(MinimisationEnd end) {
  switch (end) {
    case MinimisationEnd::converged:
      return "converged";
    case MinimisationEnd::max_steps:
      return "maximum number of steps";
    case MinimisationEnd::stopped:
      return "interrupted";
  }
  return "";
}

std::string minimisation_json(const MinimisationReport& r) {
  const Minimisation& m = r.minimisation;
  return nlohmann::json{{"molecules", r.molecules},
                        {"steps", m.steps},
                        {"end", reason(m.end)},
                        {"before", steepness_json(m.before, r.molecules)},
                        {"after", steepness_json(m.after, r.molecules)},
                        {"bound_force_kJ_per_mol_nm", r.settings.force},
                        {"bound_torque_kJ_per_mol", r.settings.torque},
                        {"files", {r.file}}}
      .dump(2);
}

}  // namespace polhode
