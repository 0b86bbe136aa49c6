// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <limits>

#include "polhode/run/prepare/minimisation.hpp"
#include "polhode/run/prepare/preparation.hpp"
#include "run/prepare/compressibility.hpp"
#include "run/quantity_lists.hpp"
#include "run/simulation/report/averages.hpp"

namespace polhode {
namespace {

std::string change_of(const Drift& drift) {
  if (drift.known != Known::yes)
    return "the stage is too short to tell whether the density still changes";
  if (!drift.significant()) return "no longer changing";
  return drift.rate.value < 0 ? "still falling" : "still rising";
}

SeriesEstimate in_kg_per_m3(const SeriesEstimate& density) {
  return in_unit("kg/m3", Dimension::density, density);
}

Value value_of(bool known, const char* symbol, Dimension dimension, double value) {
  return known ? Value(value / unit(symbol, dimension)) : Value();
}

Quantities of_properties(const PreparationReport& r) {
  const PreparedProperties& p = *r.properties;
  const RunSummary& s = p.summary;
  SeriesEstimate compressibility = in_unit("1/bar", Dimension::compressibility, p.compressibility);
  if (compressibility.known != Known::yes)
    compressibility.value = std::numeric_limits<double>::quiet_NaN();
  const SeriesEstimate density = in_kg_per_m3(p.density);
  const std::string lattice =
      r.estimated ? fmt::format(" (lattice: {:.0f})", in_kg_per_m3({r.lattice_density}).value) : "";
  Quantities list = {
      {"length", "ps", s.length},
      {"density", "g/cm3", in_unit("g/cm3", Dimension::density, p.density)},
      {"density", "kg/m3", density, "", p.pressure ? "density" : "", lattice},
      {"temperature", "K", s.temperatures.all, "", "temperature"},
      {"pressure", "bar", in_unit("bar", Dimension::pressure, s.pressure), "", "pressure",
       p.pressure ? fmt::format(" (barostat: {:g})", *p.pressure / unit("bar", Dimension::pressure))
                  : ""},
      {"pressure_of_barostat", "bar",
       value_of(p.pressure.has_value(), "bar", Dimension::pressure, p.pressure.value_or(0))},
      {"potential", "kJ/mol", s.potential, "", "potential energy",
       " per molecule, " + change_of(s.potential_drift)},
      {"potential_drift_p_value", "", s.potential_drift.p_value},
      {"equilibrium_start", "ps", s.equilibrium_start, "", "equilibrium from",
       fmt::format(" of the last {:.3g} ps", s.length)},
      {"compressibility", "1/bar", compressibility}};
  if (p.pressure)
    list.push_back(
        row("compressibility", compressibility_text(p.compressibility, p.moves_compressibility)));
  else
    list.insert(list.begin(),
                row("density", fmt::format("{:.4g} kg/m3, constant{}", density.value, lattice)));
  append(list, of_warnings(p.warnings));
  return list;
}

}  // namespace

std::string compressibility_text(const SeriesEstimate& measured, double in_use) {
  const double scale = 1e-6 * unit("1/bar", Dimension::compressibility);
  if (measured.known == Known::yes)
    return text_of(scaled(measured, 1 / scale), "1e-6/bar") +
           ", from the fluctuations of the volume";
  return fmt::format("not known yet; the barostat assumes {:.3g} 1e-6/bar", in_use / scale);
}

Quantities quantities(const PreparationReport& r) {
  const bool lattice = r.lattice_density > 0;
  Quantities list = {
      {"molecules", "", r.molecules},
      {"lattice_density", "g/cm3",
       value_of(lattice, "g/cm3", Dimension::density, r.lattice_density)},
      {"lattice_density", "kg/m3",
       value_of(lattice, "kg/m3", Dimension::density, r.lattice_density)},
      {"density_estimated", "", r.estimated},
      {"minimisation", "",
       Quantities{{"steps", "", r.minimisation.steps},
                  {"end", "", reason(r.minimisation.end)},
                  {"force", "kJ/mol/nm", r.minimisation.after.force},
                  {"torque", "kJ/mol", r.minimisation.after.torque}}},
      {"compressibility", "1/bar",
       value_of(r.compressibility > 0, "1/bar", Dimension::compressibility, r.compressibility)},
      {"interrupted", "", !r.properties},
      {"properties", "", r.properties ? Value(flattened(of_properties(r))) : Value()},
      {"files", "", r.files}};
  if (r.properties)
    append(list, {row("", fmt::format("{} molecules, averages of the last {:g} ps", r.molecules,
                                      r.properties->summary.length)),
                  row("", ""),
                  {"", "", of_properties(r)},
                  row_of_files(r.files),
                  row("next", "polhode run " + r.run_file)});
  return list;
}

}  // namespace polhode
