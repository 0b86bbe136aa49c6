// SPDX-License-Identifier: MIT
// The dielectric constant from the fluctuations of the total dipole.
#include "measure/dielectric.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "convergence_results.hpp"
#include "curves.hpp"
#include "model/dipole.hpp"
#include "polhode/model/degrees_of_freedom.hpp"
#include "run/analysis/analysis_summary.hpp"
#include "run/quantity_lists.hpp"

namespace polhode {
namespace {

std::string why_no_dipole(const FirstFrames& f) {
  const auto& parts = f.analysis.topology.parts;
  for (const auto& part : parts)
    if (const double charge = part.molecule.charge(); std::abs(charge) > 1e-6)
      return fmt::format(
          "'{}' has a charge of {:g} e, but the dipole of a periodic box with mobile ions is not "
          "defined",
          part.molecule.name, charge);
  const bool any =
      std::ranges::any_of(parts, [](const auto& part) { return has_dipole(part.molecule); });
  return any ? "" : "no molecule has a dipole";
}

AnalysisFile file_of(const Analysis& a, const TotalDipole::Result& d) {
  AnalysisFile file =
      file_over_time(a, "dielectric", d.frames,
                     {{}, "dielectric constant from the frames up to each time", {}, "ε"});
  CurvesFigure::Panel panel;
  draw(panel, "", add(file.table, "epsilon", "1", d.stages), d.stages);
  file.figure.panels.push_back(std::move(panel));
  finish(file.figure, true);
  return file;
}

Quantity row_of(const TotalDipole::Result& d) {
  const std::string value =
      d.convergence.converged()
          ? short_text(d.constant) + "; Kirkwood factor " + short_text(d.kirkwood)
          : not_converged(d.convergence, dipole_relaxation);
  return row("dielectric constant",
             fmt::format("{}; |<M>| is {:.2f} times the rms M", value, d.mean_over_rms));
}

class Dielectric : public Observable {
 public:
  explicit Dielectric(const FirstFrames& f) : dipole_(f.analysis.topology) {}
  void add(const State& state, const std::optional<StepError>& error, Workers&) override {
    dipole_.add(state, error);
  }
  ObservableResults results(const AllFrames& frames) override;

 private:
  TotalDipole dipole_;
};

ObservableResults Dielectric::results(const AllFrames& all) {
  const Analysis& a = all.analysis;
  const SummarySettings& settings = all.settings;
  if (!settings.surroundings_permittivity)
    all.notes.push_back("no dielectric: " + settings.no_surroundings);
  else if (!all.temperature)
    all.notes.push_back(
        "no dielectric constant: the frames have no velocities, so the temperature is unknown; "
        "give a temperature");
  if (!settings.surroundings_permittivity || !all.temperature) return {};
  const double surroundings = *settings.surroundings_permittivity;
  const TotalDipole::Result d = dipole_.result(*all.temperature, surroundings, a.mean_interval());
  Quantities list = {{"constant", "", converging(d.constant, d.convergence, dipole_relaxation)},
                     {"kirkwood", "", converging(d.kirkwood, d.convergence, dipole_relaxation)},
                     {"mean_over_rms_dipole", "", d.mean_over_rms},
                     row_of(d)};
  if (a.frames_with_step_error > 0) {
    // A temperature from velocities has a time-step bias, and a given temperature has no bias.
    const TotalDipole::StepBias bias = dipole_.step_bias(
        settings.temperature || !a.has_velocities ? all.temperature : std::nullopt, surroundings,
        degrees_of_freedom(a.topology).all(), *a.fixed);
    list.push_back({"step_bias", "",
                    Quantities{{"constant", "", bias.constant}, {"kirkwood", "", bias.kirkwood}}});
    list.push_back(row("  time-step bias", d.convergence.converged()
                                               ? bias_text(bias.constant, d.constant.value)
                                               : short_text(bias.constant)));
  }
  return {.quantities = {{"dielectric", "", std::move(list)}}, .files = {file_of(a, d)}};
}

}  // namespace

ObservableKind dielectric() {
  return {"dielectric", {"dielectric"}, false, why_no_dipole, [](const FirstFrames& f) {
            return std::make_unique<Dielectric>(f);
          }};
}

}  // namespace polhode
