// SPDX-License-Identifier: MIT
#include "io/settings/ensemble_text.hpp"

#include <fmt/core.h>

#include "io/settings/ensemble_names.hpp"
#include "io/settings/output_units.hpp"
#include "io/settings/quantity.hpp"

namespace polhode {
namespace {

std::string in_ps(double time) { return fmt::format("{:.12g} ps", time); }
std::string in_bar(double pressure) {
  return fmt::format("{:.12g} bar", pressure / unit("bar", Dimension::pressure));
}
std::string per_bar(double compressibility) {
  return fmt::format("{:.12g} 1/bar", compressibility / unit("1/bar", Dimension::compressibility));
}
std::string per_ps(double rate) { return fmt::format("{:.12g} 1/ps", rate); }

std::string thermostat_text(const ThermostatSettings& t) {
  if (t.kind != ThermostatKind::langevin)
    return fmt::format("{} with a time constant of {}",
                       t.kind == ThermostatKind::rescaling ? "stochastic velocity rescaling"
                                                           : "stochastic velocity rescaling of "
                                                             "translation and rotation apart",
                       in_ps(t.time_constant));
  const std::string rotation =
      t.rotational_friction == t.friction
          ? ""
          : fmt::format(" ({} for rotation)", per_ps(t.rotational_friction));
  return fmt::format("Langevin thermostat with a friction of {}{}", per_ps(t.friction), rotation);
}

std::string barostat_text(const BarostatSettings& b) {
  return fmt::format(
      "{} of the box to {}",
      b.kind == BarostatKind::cell_rescaling ? "stochastic cell rescaling" : "Monte Carlo moves",
      in_bar(b.pressure));
}

}  // namespace

std::string edges_text(const std::vector<CoupledEdges>& groups) {
  std::string text;
  for (const CoupledEdges& edges : groups) {
    if (!text.empty()) text += ' ';
    for (std::size_t k = 0; k < 3; ++k)
      if (edges[k]) text += "xyz"[k];
  }
  return text;
}

std::vector<std::pair<std::string, std::string>> ensemble_texts(const EnsembleSettings& settings) {
  std::vector<std::pair<std::string, std::string>> texts;
  if (const auto& t = settings.thermostat) {
    texts.emplace_back("thermostat.type", name_of(t->kind));
    if (t->kind == ThermostatKind::langevin) {
      texts.emplace_back("thermostat.friction", per_ps(t->friction));
      texts.emplace_back("thermostat.rotational_friction", per_ps(t->rotational_friction));
    } else {
      texts.emplace_back("thermostat.time_constant", in_ps(t->time_constant));
    }
  }
  if (const auto& b = settings.barostat) {
    texts.emplace_back("barostat.type", name_of(b->kind));
    texts.emplace_back("barostat.pressure", in_bar(b->pressure));
    texts.emplace_back("barostat.compressibility", per_bar(b->compressibility));
    texts.emplace_back("barostat.every", in_ps(b->every));
    texts.emplace_back("barostat.edges", edges_text(b->edges));
    if (b->kind == BarostatKind::cell_rescaling) {
      texts.emplace_back("barostat.time_constant", in_ps(b->time_constant));
      texts.emplace_back("barostat.metropolis", b->metropolis ? "true" : "false");
    }
  }
  if (const auto& h = settings.hybrid_monte_carlo) {
    texts.emplace_back("hybrid_monte_carlo.steps", fmt::format("{}", h->steps));
    texts.emplace_back("hybrid_monte_carlo.refresh", fmt::format("{:.12g} %", 100 * h->refresh));
  }
  return texts;
}

std::string description(const EnsembleSettings& s) {
  if (s.constant_energy()) return "constant energy";
  std::string text = fmt::format("{:g} K", s.temperature);
  if (s.thermostat) text += ", " + thermostat_text(*s.thermostat);
  if (s.hybrid_monte_carlo)
    text += fmt::format(", hybrid Monte Carlo with trajectories of {} steps",
                        s.hybrid_monte_carlo->steps);
  if (s.barostat) text += ", " + barostat_text(*s.barostat);
  return text;
}

}  // namespace polhode
