// SPDX-License-Identifier: MIT
#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "polhode/io/quantity.hpp"
#include "polhode/io/with_error.hpp"
#include "polhode/run/prepare/minimisation.hpp"
#include "polhode/run/prepare/preparation.hpp"

namespace polhode {
namespace {

using nlohmann::json;

json error_of(const SeriesEstimate& e, double unit) {
  return e.known == Known::yes ? json(e.error / unit) : json();
}

json properties_json(const PreparedProperties& p) {
  const double bar = unit("bar", Dimension::pressure), density = unit("g/cm3", Dimension::density);
  const double kg_per_m3 = unit("kg/m3", Dimension::density);
  const double per_bar = unit("1/bar", Dimension::compressibility);
  const bool known = p.compressibility.known == Known::yes;
  const RunSummary& s = p.summary;
  json warnings = json::array();
  for (const Warning& w : p.warnings)
    warnings.push_back({{"kind", w.kind}, {"text", w.text}, {"remedy", w.remedy}});
  return {{"length_ps", s.length},
          {"density_g_per_cm3", p.density.value / density},
          {"density_error_g_per_cm3", error_of(p.density, density)},
          {"density_kg_per_m3", p.density.value / kg_per_m3},
          {"density_error_kg_per_m3", error_of(p.density, kg_per_m3)},
          {"compressibility_per_bar", known ? json(p.compressibility.value / per_bar) : json()},
          {"compressibility_error_per_bar", error_of(p.compressibility, per_bar)},
          {"temperature_K", s.temperatures.all.value},
          {"temperature_error_K", error_of(s.temperatures.all, 1)},
          {"pressure_bar", s.pressure.value / bar},
          {"pressure_error_bar", error_of(s.pressure, bar)},
          {"pressure_of_barostat_bar", p.pressure ? json(*p.pressure / bar) : json()},
          {"potential_kJ_per_mol", s.potential.value},
          {"potential_error_kJ_per_mol", error_of(s.potential, 1)},
          {"potential_drift_p_value", s.potential_drift.p_value},
          {"warnings", warnings}};
}

}  // namespace

std::string compressibility_text(const SeriesEstimate& measured, double in_use) {
  const double scale = 1e-6 * unit("1/bar", Dimension::compressibility);
  if (measured.known == Known::yes)
    return fmt::format("{} 1e-6/bar, from the fluctuations of the volume",
                       with_error(measured.value / scale, measured.error / scale));
  return fmt::format("not known yet; the moves of the barostat assume {:.3g} 1e-6/bar",
                     in_use / scale);
}

std::string preparation_json(const PreparationReport& r) {
  const bool lattice = r.lattice_density > 0;
  return json{
      {"molecules", r.molecules},
      {"lattice_density_g_per_cm3",
       lattice ? json(r.lattice_density / unit("g/cm3", Dimension::density)) : json()},
      {"lattice_density_kg_per_m3",
       lattice ? json(r.lattice_density / unit("kg/m3", Dimension::density)) : json()},
      {"density_estimated", r.estimated},
      {"minimisation",
       {{"steps", r.minimisation.steps},
        {"end", reason(r.minimisation.end)},
        {"force_kJ_per_mol_nm", r.minimisation.after.force},
        {"torque_kJ_per_mol", r.minimisation.after.torque}}},
      {"compressibility_per_bar",
       r.compressibility > 0 ? json(r.compressibility / unit("1/bar", Dimension::compressibility))
                             : json()},
      {"interrupted", !r.properties},
      {"properties", r.properties ? properties_json(*r.properties) : json()},
      {"files", r.files}}
      .dump(2);
}

}  // namespace polhode
