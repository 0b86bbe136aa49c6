// SPDX-License-Identifier: MIT
#include "step_bias_report.hpp"

#include <fmt/core.h>

#include <array>

#include "polhode/io/quantity.hpp"
#include "polhode/io/with_error.hpp"
#include "polhode/run/simulation/run_report.hpp"

namespace polhode::cli {
namespace {

/// "name -0.12 ± 0.01 unit, without it 3.45 unit"
/// @param unit  of the text, in internal units
void print_line(const char* name, const SeriesEstimate& bias, double mean, double unit,
                const char* unit_text, int decimals) {
  const std::string size =
      bias.known == Known::yes
          ? with_error(bias.value / unit, bias.error / unit)
          : fmt::format("{:.2g} (error not known: {})", bias.value / unit, reason(bias.known));
  fmt::print("  {:<20}{} {}, without it {:.{}f} {}\n", name, size, unit_text,
             (mean - bias.value) / unit, decimals, unit_text);
}

/// Of all axes; nothing without degrees of freedom.
void print_rotation(const RunSummary& s) {
  const StepBias& bias = *s.step_bias;
  const DegreesOfFreedom& n = s.degrees_of_freedom;
  const double rotations = n.all() - n.translation;
  if (rotations == 0) return;
  double rotation = 0;
  for (std::size_t k = 0; k < 3; ++k)
    rotation += s.temperatures.rotation[k].value * n.rotation[k] / rotations;
  print_line("T of rotation", bias.rotation, rotation, 1, "K", 2);
  print_line("their difference", bias.difference, rotation - s.temperatures.translation.value, 1,
             "K", 2);
}

}  // namespace

void print_step_bias(const RunSummary& s) {
  if (!s.step_bias) return;
  const StepBias& bias = *s.step_bias;
  const auto molecules = static_cast<double>(s.molecules);
  fmt::print("bias of the step\n");
  print_line("potential energy", bias.potential, s.potential.value * molecules, molecules,
             "kJ/mol per molecule", 4);
  print_line("pressure", bias.pressure, s.pressure.value, unit("bar", Dimension::pressure), "bar",
             1);
  if (const auto& barostat = s.ensemble.barostat) {
    print_line("density", bias.density, barostat->density.value, unit("kg/m3", Dimension::density),
               "kg/m3", 2);
    print_line("compressibility", bias.compressibility, barostat->compressibility.value,
               1e-6 * unit("1/bar", Dimension::compressibility), "1e-6/bar", 2);
  }
  print_line("T of translation", bias.translation, s.temperatures.translation.value, 1, "K", 2);
  print_rotation(s);
  static constexpr std::array names{"T_conf, translation", "T_conf, axis 1", "T_conf, axis 2",
                                    "T_conf, axis 3"};
  for (std::size_t k = 0; k < names.size(); ++k)
    if (const auto& known = s.configurational_bias[k])
      print_line(names[k], *known, s.configurational[k]->value, 1, "K", 2);
}

}  // namespace polhode::cli
