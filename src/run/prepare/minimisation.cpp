// SPDX-License-Identifier: MIT
#include "polhode/run/prepare/minimisation.hpp"

#include <fmt/core.h>

#include "io/coordinates/gro.hpp"
#include "io/files/write_file.hpp"
#include "polhode/base/error.hpp"
#include "run/output_files.hpp"
#include "run/quantity_lists.hpp"
#include "run/simulation/system/relaxation.hpp"
#include "run/simulation/system/system_notes.hpp"

namespace polhode {
namespace {

void check_settings(const MinimisationSettings& s) {
  if (!(s.force > 0) || !(s.torque > 0))
    throw Error(
        fmt::format("the bounds of a minimisation are {:g} kJ/mol/nm and {:g} kJ/mol; both must be "
                    "above 0, since forces are rounded (usual: 10 kJ/mol/nm and 1 kJ/mol)",
                    s.force, s.torque));
}

Quantity of_steepness(const char* key, const Steepness& s, std::size_t molecules) {
  return {key, "",
          Quantities{{"potential", "kJ/mol", s.potential / static_cast<double>(molecules),
                      "potential energy per molecule", "potential energy", " per molecule", "", 7},
                     {"force", "kJ/mol/nm", s.force, "largest force on a molecule", "largest force",
                      "", "", 7},
                     {"torque", "kJ/mol", s.torque, "largest torque on a molecule",
                      "largest torque", "", "", 7}},
          "", key};
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
  check_outputs({file}, options.existing, inputs_of(run_file));
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
  constexpr const char* reasons[] = {"converged", "maximum number of steps", "interrupted"};
  return reasons[static_cast<std::size_t>(end)];
}

Quantities quantities(const MinimisationReport& r) {
  const Minimisation& m = r.minimisation;
  return {{"molecules", "", r.molecules, "number of molecules", "molecules"},
          {"steps", "", m.steps, "number of steps", "steps"},
          {"end", "", reason(m.end), "`converged`, `maximum number of steps` or `interrupted`",
           "ended"},
          of_steepness("before", m.before, r.molecules),
          of_steepness("after", m.after, r.molecules),
          {"bound_force", "kJ/mol/nm", r.settings.force, "bound on the largest force",
           "bound of the force"},
          {"bound_torque", "kJ/mol", r.settings.torque, "bound on the largest torque",
           "bound of the torque"},
          {"files", "", std::vector{r.file}, "name of the file that was written"},
          row_of_files({r.file})};
}

}  // namespace polhode
