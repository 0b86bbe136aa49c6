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
  const double step = settings.step;
  const auto segments = [&](MeasuredIn kind) { return static_cast<double>(target[kind]); };
  const double dynamics = (segments(MeasuredIn::dynamics) + segments(MeasuredIn::elongated) +
                           segments(MeasuredIn::conduction)) *
                          steps_of_dynamics;
  std::string text = fmt::format(
      "plan at {}: {} replicas of {} molecules, {} at {:g} fs; first {:.0f} ps of each at "
      "constant {}",
      settings.at.text(), replicas, molecules, text_of(settings.sampling, settings.scheme),
      step * units::fs_per_ps, segments(MeasuredIn::averages) * steps_of_averages * step,
      settings.at.constant_volume() ? "volume" : "pressure");
  if (dynamics > 0)
    text += fmt::format(" and {:.0f} ps for dynamics{}", dynamics * step,
                        paired_runs ? ", of which an eighth is repeated at half of the step" : "");
  if (target[MeasuredIn::coupling] > 0)
    text += fmt::format(" and {:.0f} ps at each of {} stages of the coupling of a molecule",
                        segments(MeasuredIn::coupling) * steps_of_coupling * step,
                        settings.path.size());
  if (target[MeasuredIn::slab] > 0)
    text +=
        fmt::format(" and {:.0f} ps of a slab of {} molecules",
                    segments(MeasuredIn::slab) * steps_of_averages * step, slab_copies * molecules);
  if (seconds > 0) text += fmt::format(", about {}", duration_text(seconds));
  return text + "; longer where an error is not reached";
}

}  // namespace polhode
