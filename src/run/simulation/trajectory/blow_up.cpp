// SPDX-License-Identifier: MIT
#include "blow_up.hpp"

#include <fmt/core.h>

#include <optional>

#include "forces/laws/law_range.hpp"
#include "io/settings/output_units.hpp"
#include "polhode/io/settings/nested_scheme_text.hpp"
#include "run/simulation/system/relaxation.hpp"
#include "run/simulation/system/stable_step.hpp"

namespace polhode {
namespace {

/// Copies the positions, which show the molecules that collided. Copying only the positions takes
/// half as long as copying the whole state.
void copy_positions(const State& from, State& to) {
  to.q = from.q;
  to.orientation = from.orientation;
  to.box = from.box;
}

/// Advice on how to avoid the blow-up.
/// @param shorter  step to try [ps]; empty if no step is short enough
std::string remedy(const TrajectorySettings& s, std::optional<double> shorter) {
  if (!shorter)
    return "molecules of the initial configuration overlap, so a shorter step does not help: use "
           "minimise = true and equilibrate in [run], or 'polhode prepare'";
  return fmt::format(
      "the step of {:g} fs is too long for {}, or the initial configuration is too far from "
      "equilibrium: try {}, or equilibrate first",
      s.step * units::fs_per_ps, name_of({s.scheme, s.inner}), rounded_fs(*shorter));
}

}  // namespace

BlowUpReport::BlowUpReport(const System& system, const TrajectorySettings& settings,
                           Workers& workers)
    : system_(system), settings_(settings), workers_(workers) {
  copy_positions(system.state, first_);
}

void BlowUpReport::before_step() { copy_positions(system_.state, before_); }

void BlowUpReport::blow_up(std::size_t step, std::string cause) const {
  std::string contact = strongest_contact(system_, system_.state);
  if (contact.empty()) contact = strongest_contact(system_, before_);
  if (!contact.empty()) cause += "; " + contact;
  throw BlowUp(fmt::format("the run blew up at step {} ({:.4f} ps): {}; {}", step,
                           static_cast<double>(step) * settings_.step, cause,
                           remedy(settings_, shorter_step(system_, first_, settings_, workers_))),
               cause);
}

void BlowUpReport::not_finite(std::size_t step, const std::string& cause) const {
  blow_up(step, cause + inner_limit_note(system_.topology));
}

}  // namespace polhode
