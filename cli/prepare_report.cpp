// SPDX-License-Identifier: MIT
#include "prepare_report.hpp"

#include <fmt/core.h>

#include "polhode/io/quantity.hpp"
#include "polhode/io/with_error.hpp"
#include "run_report.hpp"
#include "streams.hpp"

namespace polhode::cli {
namespace {

std::string text_of(const SeriesEstimate& e, double unit, const char* name) {
  return e.known == Known::yes
             ? fmt::format("{} {}", with_error(e.value / unit, e.error / unit), name)
             : fmt::format("{:.4g} {} (too short for an error)", e.value / unit, name);
}

const char* change_of(const Drift& drift) {
  if (drift.known != Known::yes) return "too short to tell whether it still changes";
  if (!drift.significant()) return "no longer changing";
  return drift.rate.value < 0 ? "still falling" : "still rising";
}

}  // namespace

void print_preparation(const PreparationReport& r) {
  if (!r.properties) return;
  const PreparedProperties& p = *r.properties;
  const double bar = unit("bar", Dimension::pressure), density = unit("kg/m3", Dimension::density);
  fmt::print("{} molecules, averages of the last {:g} ps\n\n", r.molecules, p.summary.length);
  fmt::print("density               {}{}\n",
             p.pressure ? text_of(p.density, density, "kg/m3")
                        : fmt::format("{:.4g} kg/m3, constant", p.density.value / density),
             r.estimated ? fmt::format(" (lattice: {:.0f})", r.lattice_density / density) : "");
  fmt::print("temperature           {}\n", text_of(p.summary.temperatures.all, 1, "K"));
  fmt::print("pressure              {}{}\n", text_of(p.summary.pressure, bar, "bar"),
             p.pressure ? fmt::format(" (barostat: {:g})", *p.pressure / bar) : "");
  fmt::print("potential energy      {}, {}\n",
             text_of(p.summary.potential, 1, "kJ/mol per molecule"),
             change_of(p.summary.potential_drift));
  if (p.pressure)
    fmt::print("compressibility       {}\n",
               compressibility_text(p.compressibility, p.moves_compressibility));
  print_files(r.files);
  fmt::print("next                  polhode run {}\n", r.run_file);
  print_warnings(p.warnings);
}

}  // namespace polhode::cli
