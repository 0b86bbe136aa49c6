// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>

#include "io/files/with_error.hpp"
#include "io/settings/output_units.hpp"
#include "polhode/run/properties/measure.hpp"
#include "run/properties/property.hpp"
#include "run/quantity_lists.hpp"

namespace polhode {
namespace {

Quantities of_state(const StatePoint& at) {
  return {{"temperature", "K", at.temperature, "temperature of the state point"},
          {"pressure", "bar", at.constant_volume() ? Value() : Value(in_bar(at.pressure)),
           "pressure of the state point; null at constant volume"},
          {"density", "kg/m3", at.constant_volume() ? Value(in_kg_m3(at.density)) : Value(),
           "density of a state point at constant volume; null at constant pressure"}};
}

Value text_or_null(const std::string& text) { return text.empty() ? Value() : Value(text); }

/// Remarks on a value: corrections included in the value, and reasons why the value may not meet
/// the request.
std::string remarks(const MeasuredProperty& m) {
  std::string text;
  const auto add = [&](const std::string& remark) { text += (text.empty() ? "" : "; ") + remark; };
  if (!m.obstacle.empty())
    add("not converged: " + m.obstacle);
  else if (!m.reached())
    add(fmt::format("requested: ± {:.2g}", m.requested_error()));
  if (!m.contributions.empty()) add(m.contributions);
  if (m.bias)
    add(fmt::format("time-step bias {} subtracted", with_error(m.bias->value, m.bias->error)));
  if (m.step_bound)
    add(fmt::format("time-step bias below {:.2g} (paired runs at h/2){}", m.step_bound->bound,
                    m.step_bound->bound > m.requested_error() / 3
                        ? ", not below a third of the error requested"
                        : ""));
  if (m.finite_size) add(fmt::format("finite-size correction {:.3g} included", *m.finite_size));
  if (!m.remark.empty()) add(m.remark);
  return text;
}

Value interval(const MeasuredProperty& m, double probability) {
  const auto found = m.interval(probability);
  return found ? Value(std::vector{found->front(), found->back()}) : Value();
}

Quantities of_property(const MeasuredProperty& m) {
  const Property& p = *m.request.property;
  return {
      {"name", "", p.name, "name of the property", "property"},
      {"value", "", m.value, "value with all corrections, in `unit`", "value"},
      {"unit", "", p.unit, "unit of value, error and corrections", "unit"},
      {"interval_68", "", interval(m, 0.68), "68 % confidence interval, by Student's t"},
      {"interval_95", "", interval(m, 0.95), "95 % confidence interval, by Student's t"},
      {"requested_error", "", m.requested_error(), "requested standard error"},
      {"reached", "", m.reached(),
       "whether the requested error is reached and the value has converged"},
      {"step_bias", "", m.bias,
       "time-step bias, which is subtracted; null if it is not known, or with hybrid Monte Carlo"},
      {"step_bias_bound", "", m.step_bound ? Value(m.step_bound->bound) : Value(),
       "95 % bound of the time-step bias of dynamics, from paired runs at half of the step; "
       "null without them"},
      {"step_difference", "", m.step_bound ? Value(m.step_bound->difference) : Value(),
       "difference of the value between the step and half of it; null without paired runs"},
      {"finite_size_correction", "", m.finite_size,
       "finite-size correction included in the value; null without a correction"},
      {"not_converged", "", text_or_null(m.obstacle),
       "reason why the value has not converged; null if it has"},
      {"contributions", "", text_or_null(m.contributions),
       "number of replicas that contribute, and why the others do not; null if all contribute"},
      {"definition", "", p.definition, "definition of the property"},
      {"", "", remarks(m), "", "remarks"}};
}

struct Points {
  std::vector<double> value{}, error{};
  explicit Points(const std::vector<SeriesEstimate>& estimates) {
    for (const SeriesEstimate& e : estimates) {
      value.push_back(e.value);
      error.push_back(e.known == Known::yes ? e.error : std::nan(""));
    }
  }
};

Quantities of_profile(const MeasuredCurve& curve) {
  Points points(curve.value);
  return {
      {"quantity", "", curve.title, "name of the quantity"},
      {"unit", "", curve.unit, "unit of the values"},
      {"distance", "nm", curve.x, "distances from the middle of the slab"},
      {"value", "", std::move(points.value), "value at each distance, in `unit`"},
      {"error", "", std::move(points.error), "standard error of each value; null if not known"}};
}

Quantities of_distribution(const MeasuredDistribution& d) {
  const auto& peak = d.peak;
  const bool shell = peak && peak->shell;
  Points points(d.g);
  return {
      {"pair", "", std::vector<std::string>{d.pair[0], d.pair[1]}, "sites of the pair"},
      {"", "", d.pair[0] + " - " + d.pair[1], "", "pair"},
      {"peak", "nm", peak ? Value(peak->position) : Value(),
       "position of the first maximum of g(r); null without one", "first peak"},
      {"peak_height", "", peak ? Value(peak->height) : Value(), "g(r) at this maximum", "height"},
      {"minimum", "nm", shell ? Value(peak->shell->end) : Value(),
       "position of the first minimum; null if it is beyond the range of g(r)", "first minimum"},
      {"coordination", "", shell ? Value(peak->shell->coordination) : Value(),
       "number of second sites around a first site within this minimum", "neighbours"},
      {"r", "nm", d.r, "middles of the bins"},
      {"g", "", std::move(points.value), "g(r) in each bin, relative to an ideal gas"},
      {"g_error", "", std::move(points.error),
       "standard error of g(r) in each bin; null if not known"}};
}

Quantities of_point(const MeasuredPoint& point) {
  Quantities list = of_state(point.at);
  append(list, {{"molecules", "", static_cast<std::int64_t>(point.molecules),
                 "number of molecules of each replica"},
                {"replicas", "", static_cast<std::int64_t>(point.replicas),
                 "number of independent simulations"},
                {"step", "fs", point.step_max * units::fs_per_ps, "time step"},
                {"scheme", "", point.scheme, "scheme of all runs, with the sampling of averages"},
                {"equilibration", "ps", point.equilibration_max,
                 "longest time that a replica discarded as equilibration"},
                {"averages_length", "ps", point.length_of_averages,
                 "total time simulated at constant pressure or volume in equilibrium, by all "
                 "replicas"},
                {"dynamics_length", "ps", point.length_of_dynamics,
                 "total time simulated for dynamics, by all replicas"},
                {"coupling_length", "ps", point.length_of_coupling,
                 "total time simulated at the stages of a coupling, by all replicas"},
                {"slab_length", "ps", point.length_of_slab,
                 "total time simulated for the slabs, by all replicas"},
                {"edge", "nm", point.edge, "box edge"},
                {"properties", "", groups_of(point.properties, of_property),
                 "properties measured at this state point", point.at.text()},
                {"radial_distributions", "",
                 point.wants_distributions() ? groups_of(point.distributions, of_distribution)
                                             : std::vector<Quantities>(),
                 "radial distribution functions of molecular centres and of sites, with their "
                 "first peaks; if `coordination-number` is requested",
                 "radial distribution functions"},
                {"slab_profiles", "", groups_of(point.profiles, of_profile),
                 "density, normal minus tangential pressure, and its integral, along the normal of "
                 "a slab; empty without a slab"}});
  if (const std::string how = point.conditions("\n  "); !how.empty())
    list.push_back(row("", "  " + how));
  return list;
}

Quantities of_missing(const MissingPoint& point) {
  Quantities list = of_state(point.at);
  append(list, {{"", "", point.at.text(), "", "state point"},
                {"reason", "", point.reason, "why there are no results", "reason"}});
  return list;
}

Quantities of_fit(const StateFit& fit) {
  return {{"degree", "", static_cast<std::int64_t>(fit.degree), "degree of the polynomial: 2 or 3"},
          {"chi_squared", "", fit.chi_squared,
           "sum of the squared deviations from the polynomial in standard errors"},
          {"degrees_of_freedom", "", static_cast<std::int64_t>(fit.degrees_of_freedom()),
           "number of points minus number of coefficients"}};
}

Quantities of_maximum(const DensityMaximum& m) {
  Quantities list{
      {"pressure", "bar", in_bar(m.pressure), "pressure of the state points", "pressure"},
      {"temperature", "K", m.temperature, "temperature at which the density has its maximum",
       "temperature"},
      {"density", "kg/m3", m.density, "density at the maximum", "density"}};
  append(list, of_fit(m.fit));
  list.push_back({"not_known", "", text_or_null(m.obstacle),
                  "reason why there is no maximum; null if there is one"});
  list.push_back({"", "", m.obstacle.empty() ? m.fit.text() : m.obstacle, "", "remarks"});
  return list;
}

Quantities of_slope(const SlopeValue& s) {
  Quantities list{
      {"property", "", s.property->name, "name of the property", "property"},
      {"temperature", "K", s.at.temperature, "temperature of the state point", "temperature"},
      {"pressure", "bar", in_bar(s.at.pressure), "pressure of the state point", "pressure"},
      {"slope", "", s.slope, "value from the slope of the polynomial, in `unit`", "slope"},
      {"fluctuation", "", s.fluctuation, "value of the property from fluctuations, in `unit`",
       "fluctuations"},
      {"unit", "", s.property->unit, "unit of both values", "unit"},
      {"deviation", "", s.deviation,
       "slope minus fluctuation, in standard errors of the difference", "deviation"}};
  list.back().digits = 2;
  append(list, of_fit(s.fit));
  list.push_back({"", "", s.fit.text(), "", "remarks"});
  return list;
}

}  // namespace

std::string MeasuredPoint::conditions(const std::string& line_break) const {
  if (length_of_averages == 0) return "";
  std::string text = fmt::format(
      "{} replicas of {} molecules, {} at {:g} fs; {:.0f} ps at constant {}{}after at most "
      "{:.0f} "
      "ps of equilibration each",
      replicas, molecules, scheme, step_max * units::fs_per_ps, length_of_averages,
      at.constant_volume() ? "volume" : "pressure", line_break, equilibration_max);
  if (length_of_dynamics > 0) text += fmt::format("; {:.0f} ps for dynamics", length_of_dynamics);
  if (length_of_coupling > 0)
    text += fmt::format("; {:.0f} ps for the stages of a coupling", length_of_coupling);
  if (length_of_slab > 0) text += fmt::format("; {:.0f} ps for the slabs", length_of_slab);
  return text;
}

bool MeasureReport::reached() const {
  if (!missing.empty()) return false;
  return std::ranges::all_of(points, [](const MeasuredPoint& point) {
    return std::ranges::all_of(point.properties, &MeasuredProperty::reached);
  });
}

Quantities quantities(const MeasureReport& report) {
  return {{"system", "", report.system, "molecules and their counts"},
          {"points", "", groups_of(report.points, of_point), "state points with their properties"},
          {"missing_points", "", groups_of(report.missing, of_missing),
           "state points without results", "not measured"},
          {"density_maxima", "", groups_of(report.curves.maxima, of_maximum),
           "temperature of maximum density at each pressure with three temperatures or more",
           "temperature of maximum density"},
          {"slopes", "", groups_of(report.curves.slopes, of_slope),
           "properties as slopes over state points, next to their values from fluctuations",
           "slopes over state points"},
          {"reached", "", report.reached(),
           "whether all requested errors were reached, at all state points"},
          {"files", "", report.files, "names of the record files of the replicas"}};
}

}  // namespace polhode
