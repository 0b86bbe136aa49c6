// SPDX-License-Identifier: MIT
#include "ensemble_report.hpp"

#include <fmt/core.h>

#include "estimate_text.hpp"
#include "polhode/io/ensemble_text.hpp"
#include "polhode/io/output_units.hpp"
#include "polhode/io/quantity.hpp"
#include "polhode/io/with_error.hpp"

namespace polhode::cli {
namespace {

std::string in_unit(const SeriesEstimate& e, double unit, std::uint64_t samples, int digits,
                    const char* name) {
  return estimate_text({e.value / unit, e.error / unit}, e.known, samples, digits, name);
}

/// "1200 of 2000 accepted, 60.0 ± 1.1 %".
std::string accepted(std::uint64_t some, std::uint64_t all, const SeriesEstimate& share) {
  return all == 0
             ? "none yet"
             : fmt::format("{} of {} accepted, {}", some, all, in_unit(share, 0.01, all, 3, "%"));
}

void print_barostat(const BarostatSummary& s, std::uint64_t samples) {
  fmt::print("density               {}\n",
             in_unit(s.density, unit("kg/m3", Dimension::density), samples, 5, "kg/m3"));
  fmt::print("volume                {}\n", in_unit(s.volume, 1, samples, 5, "nm3"));
  fmt::print(
      "compressibility       {}, isothermal, from the fluctuations of the volume\n",
      in_unit(s.compressibility, unit("1/bar", Dimension::compressibility), samples, 3, "1/bar"));
  fmt::print("moves of the box      {}; one every {:g} fs\n",
             accepted(s.accepted, s.moves, s.accepted_share), s.interval * units::fs_per_ps);
}

/// How many independent samples of the potential energy the run is worth.
void print_effective_samples(const HybridMonteCarloSummary& s, std::uint64_t samples) {
  fmt::print("effective samples     ");
  if (s.effective_samples.known == Known::yes)
    fmt::print("{} of the potential energy, whose autocorrelation time is {} ps\n",
               with_error(s.effective_samples.value, s.effective_samples.error),
               with_error(s.correlation_time.value, s.correlation_time.error));
  else
    fmt::print("{}\n", s.effective_samples.known == Known::too_short
                           ? "not known, the run is too short to estimate them"
                       : s.effective_samples.known == Known::not_defined
                           ? "not defined: the potential energy is constant"
                           : not_known(samples));
}

void print_hybrid_monte_carlo(const HybridMonteCarloSummary& s, std::uint64_t samples) {
  fmt::print("trajectories          {}\n", accepted(s.accepted, s.trajectories, s.accepted_share));
  if (s.trajectories > 0)
    fmt::print(
        "<exp(-dH/kT)>         {}, which must be 1\n",
        estimate_text({s.weight.value, s.weight.error}, s.weight.known, s.trajectories, 4, ""));
  print_effective_samples(s, samples);
}

}  // namespace

void print_ensemble(const EnsembleSummary& s) {
  if (!s.settings.constant_energy())
    fmt::print("ensemble              {}\n", description(s.settings));
}

void print_ensemble_results(const RunSummary& s) {
  const EnsembleSummary& e = s.ensemble;
  if (e.barostat) print_barostat(*e.barostat, s.samples);
  if (e.hybrid_monte_carlo) print_hybrid_monte_carlo(*e.hybrid_monte_carlo, s.samples);
  if (e.settings.thermostat) fmt::print("heat received         {:.4g} kJ/mol\n", e.heat);
  const double work =
      (e.barostat ? e.barostat->work : 0) + (e.hybrid_monte_carlo ? e.hybrid_monte_carlo->work : 0);
  if (e.barostat || e.hybrid_monte_carlo) fmt::print("work received         {:.4g} kJ/mol\n", work);
}

}  // namespace polhode::cli
