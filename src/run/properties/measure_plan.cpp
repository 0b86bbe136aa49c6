// SPDX-License-Identifier: MIT
#include "run/properties/measure_plan.hpp"

#include <fmt/format.h>

#include "io/settings/output_units.hpp"
#include "run/properties/expected_time.hpp"

namespace polhode {

double Plan::steps() const {
  return static_cast<double>(replicas) * steps_at(target, settings.path.size(), paired_runs);
}

std::string Plan::text(double seconds) const {
  const double step = settings.step,
               dynamics =
                   static_cast<double>(target.dynamics + target.elongated) * steps_of_dynamics;
  std::string text = fmt::format(
      "plan at {}: {} replicas of {} molecules, hoa2 at {:g} fs; first {:.0f} ps of each at "
      "constant {}",
      settings.at.text(), replicas, molecules, step * units::fs_per_ps,
      static_cast<double>(target.averages * steps_of_averages) * step,
      settings.at.constant_volume() ? "volume" : "pressure");
  if (dynamics > 0)
    text += fmt::format(" and {:.0f} ps for dynamics{}", dynamics * step,
                        paired_runs ? ", of which an eighth is repeated at half of the step" : "");
  if (target.coupled > 0)
    text += fmt::format(" and {:.0f} ps at each of {} stages of the coupling of a molecule",
                        static_cast<double>(target.coupled * steps_of_coupling) * step,
                        settings.path.size());
  if (seconds > 0) text += fmt::format(", about {}", duration_text(seconds));
  return text + "; longer where an error is not reached";
}

}  // namespace polhode
