// SPDX-License-Identifier: MIT
#include "run/bias/log_bias.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <span>
#include <string_view>

#include "base/suggest.hpp"
#include "polhode/base/error.hpp"
#include "polhode/base/units.hpp"
#include "polhode/measure/block_means.hpp"
#include "run/quantity_lists.hpp"

namespace polhode {
namespace {

/// Energy units of logs, each with Boltzmann's constant in this unit per kelvin.
struct EnergyUnit {
  const char* name;
  double boltzmann;
};
constexpr EnergyUnit energy_units[] = {{"kJ/mol", units::boltzmann},
                                       {"kcal/mol", units::boltzmann / 4.184},
                                       {"eV", 8.617333262e-5},
                                       {"lj", 1}};

/// A heat bath is present if the total energy fluctuates by at least half as much as the potential
/// energy. At constant energy, R is below 20 % up to the stability limit.
constexpr double bath_ratio = 0.5;

const std::vector<std::string> time_names{"Time", "Step"};
const std::vector<std::string> total_names{"Total Energy", "TotEng", "total", "etotal"};
const std::vector<std::string> potential_names{"Potential", "Potential Energy", "PotEng", "E_pair"};
const std::vector<std::string> temperature_names{"Temperature", "Temp"};
const std::vector<std::string> conserved_names{"Conserved En.", "Conserved-En.", "conserved",
                                               "econserve"};

bool is_one_of(const LogColumn& column, const std::vector<std::string>& names) {
  return EngineLog{.columns = {{column.name, "", {}}}}.find(names) != nullptr;
}

std::vector<std::string_view> names_of(const EngineLog& log) {
  std::vector<std::string_view> names;
  for (const LogColumn& column : log.columns) names.emplace_back(column.name);
  return names;
}

/// The column that an option names, with or without its unit, or the first column with a known
/// name; null if there is none.
const LogColumn* column_for(const EngineLog& log, const Given& given,
                            const std::vector<std::string>& known) {
  if (!given) return log.find(known);
  if (const LogColumn* column = log.titled(given.text)) return column;
  if (const LogColumn* other = log.find({titled_column(given.text).name}))
    refuse(given, fmt::format("is not a column of the log; the unit of '{}' there is {}",
                              other->name, other->unit.empty() ? "not given" : other->unit));
  refuse(given, "is not a column of the log; it " + must_be_one_of(names_of(log), given.text));
}

const LogColumn& total_of(const EngineLog& log, const Given& given) {
  if (const LogColumn* column = column_for(log, given, total_names)) return *column;
  throw Error(fmt::format("no column has a known name of the total energy; name this column with "
                          "the option total; the columns are: {}{}",
                          fmt::join(names_of(log), ", "),
                          log.notes.empty() ? "" : "; " + log.notes.front()),
              log.file);
}

const EnergyUnit* known_unit(std::string_view name) {
  if (name == "kJ/mole") name = "kJ/mol";
  const auto* const unit = std::ranges::find(energy_units, name, &EnergyUnit::name);
  return unit != std::end(energy_units) ? unit : nullptr;
}

/// Checks that another energy of the log has the unit of the total energy.
void check_unit(const EngineLog& log, const LogColumn* other, const LogColumn& total) {
  const EnergyUnit *unit = known_unit(total.unit),
                   *of_other = other ? known_unit(other->unit) : nullptr;
  if (unit == nullptr || of_other == nullptr || unit == of_other) return;
  throw Error(fmt::format("'{}' is in {}, but '{}' is in {}; convert one of them", other->name,
                          other->unit, total.name, total.unit),
              log.file);
}

/// Checks that there are enough rows, and that they are in the order of time.
void check_rows(const EngineLog& log, const LogColumn* time) {
  constexpr std::size_t fewest = 10;
  if (log.samples() < fewest)
    throw Error(fmt::format("the log has {} rows, and at least {} are needed; print energies every "
                            "5 to 20 fs for 20 to 100 ps",
                            log.samples(), fewest),
                log.file);
  if (time == nullptr) return;
  const auto later = std::ranges::adjacent_find(time->values, std::greater<>());
  if (later != time->values.end())
    throw Error(fmt::format("'{}' has {:g} before {:g}; sort the rows by time", time->name, *later,
                            *(later + 1)),
                log.file);
}

/// Checks that no other column has the name of this one, unless the unit was given, too.
void check_unique(const EngineLog& log, const LogColumn* column, const Given& given) {
  if (column == nullptr || !titled_column(given.text).unit.empty()) return;
  if (std::ranges::count(log.columns, column->name, &LogColumn::name) > 1)
    throw Error(
        fmt::format("several columns are called '{}'; give them different names", column->name),
        log.file);
}

const EnergyUnit& unit_of(const LogColumn& total, const BiasRequest& request,
                          const EngineLog& log) {
  const EnergyUnit* const in_log = known_unit(total.unit);
  const EnergyUnit* const unit =
      request.energy_unit ? known_unit(request.energy_unit.text) : in_log;
  if (unit != nullptr && in_log != nullptr && unit != in_log)
    refuse(request.energy_unit,
           fmt::format("contradicts the unit of '{}' in the log, {}; leave it out", total.name,
                       total.unit));
  if (unit != nullptr) return *unit;
  if (request.energy_unit)
    refuse(request.energy_unit, "is not known; write kJ/mol, kcal/mol, eV or lj");
  throw Error(
      fmt::format(
          "the unit of '{}' is {}; give the energy unit as kJ/mol, kcal/mol, eV or lj", total.name,
          total.unit.empty() ? "not in the file" : "'" + total.unit + "', which is not known"),
      log.file);
}

double mean_of(std::span<const double> values) {
  const double first = values.empty() ? 0 : values.front();
  double sum = 0;
  for (const double value : values) sum += value - first;
  return first + sum / static_cast<double>(values.size());
}

double variance_of(std::span<const double> values) {
  const double mean = mean_of(values);
  double sum = 0;
  for (const double value : values) sum += (value - mean) * (value - mean);
  return sum / static_cast<double>(values.size());
}

/// A time in the unit of the log, or a default.
double time_of(const Given& given, const LogColumn& column, double otherwise) {
  if (!given) return otherwise;
  constexpr double unbounded = std::numeric_limits<double>::max();
  try {
    return given_number(given, -unbounded, unbounded);
  } catch (const Error&) {
    refuse(given,
           fmt::format("must be a number without a unit, because times have the unit of "
                       "the log{}; write for example {:g}",
                       column.unit.empty() ? "" : ", " + column.unit, column.values.front()));
  }
}

/// The rows of the log between two times.
EngineLog within(EngineLog log, const LogColumn* time, const BiasRequest& request) {
  if (!request.start && !request.stop) return log;
  if (!time)
    throw Error("the log has no column of times, so start and stop have no meaning; leave them out",
                log.file);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double from = time_of(request.start, *time, -infinity);
  const double to = time_of(request.stop, *time, infinity);
  const std::vector<double> times = time->values;
  for (LogColumn& column : log.columns) {
    std::vector<double> kept;
    for (std::size_t k = 0; k < times.size(); ++k)
      if (times[k] >= from && times[k] <= to) kept.push_back(column.values[k]);
    column.values = std::move(kept);
  }
  if (log.samples() == 0)
    throw Error(fmt::format("no row has a time{}{}; the times are {:g} to {:g}",
                            request.start ? fmt::format(" from {:g}", from) : "",
                            request.stop ? fmt::format(" up to {:g}", to) : "", times.front(),
                            times.back()),
                log.file);
  return log;
}

/// Deviations of an energy from its least-squares line.
std::vector<double> without_line(std::span<const double> energies) {
  const auto n = static_cast<double>(energies.size());
  const double middle = (n - 1) / 2, mean = mean_of(energies);
  double xy = 0, xx = 0;
  for (std::size_t k = 0; k < energies.size(); ++k) {
    const double x = static_cast<double>(k) - middle;
    xy += x * (energies[k] - mean);
    xx += x * x;
  }
  std::vector<double> deviations;
  for (std::size_t k = 0; k < energies.size(); ++k)
    deviations.push_back(energies[k] - mean -
                         (xx > 0 ? xy / xx * (static_cast<double>(k) - middle) : 0));
  return deviations;
}

/// The smallest difference between two different values: one unit of the last printed digit.
double resolution_of(std::vector<double> values) {
  std::ranges::sort(values);
  double smallest = 0;
  for (std::size_t k = 1; k < values.size(); ++k)
    if (const double step = values[k] - values[k - 1];
        step > 0 && (smallest == 0 || step < smallest))
      smallest = step;
  return smallest;
}

/// Sums of e, x, e x and x² for a column x and the deviation e of the energy. x is relative to its
/// first value.
struct ColumnSums {
  TimeBlocks blocks;
  double first = 0, kT = 1;

  ColumnSums(std::span<const double> deviations, std::span<const double> values, double thermal)
      : first(values.front()), kT(thermal) {
    for (std::size_t k = 0; k < values.size(); ++k) {
      const double x = values[k] - first;
      blocks.add(std::array{deviations[k], x, deviations[k] * x, x * x});
    }
  }
  static double covariance(std::span<const double> mean) { return mean[2] - mean[0] * mean[1]; }

  ColumnBias bias(const LogColumn& column) const {
    const BlockMeans means = blocks.means();
    return {
        column.name, column.unit,
        series_estimate(means, [&](auto mean) { return first + mean[1]; }),
        series_estimate(means, [&](auto mean) { return covariance(mean) / kT; }),
        series_estimate(means, [&](auto mean) { return first + mean[1] - covariance(mean) / kT; })};
  }
  /// Eq. (51) for the potential energy: the bias at constant energy, times the ratio C/C_K of the
  /// heat capacity to its kinetic part. At constant energy, var(U) = kT ⟨K⟩ (1 − C_K/C).
  SeriesEstimate at_constant_temperature(double kinetic) const {
    return series_estimate(blocks.means(), [&](auto mean) {
      const double share = (mean[3] - mean[1] * mean[1]) / (kT * kinetic);
      return covariance(mean) / kT / (1 - share);
    });
  }
};

/// The conserved energy of a log, which shows whether the run had a heat bath.
struct Ensemble {
  const LogColumn* energy = nullptr;  ///< energy that is constant in exact dynamics
  bool has_bath = false;              ///< whether this energy contains the heat of a bath
};

/// The energy that exact dynamics conserves: the total energy, or the conserved energy if the total
/// energy fluctuates much more.
Ensemble ensemble_of(const EngineLog& log, const LogColumn& total, const LogColumn* potential) {
  const auto fluctuation = [](const LogColumn& c) {
    return std::sqrt(variance_of(without_line(c.values)));
  };
  const LogColumn* conserved = log.find(conserved_names);
  if (conserved && fluctuation(*conserved) < bath_ratio * fluctuation(total))
    return {conserved, true};
  if (potential && variance_of(potential->values) == 0)
    throw Error(fmt::format("'{}' has the value {:g} in every row; give the log of a run whose "
                            "molecules move, with more digits",
                            potential->name, potential->values.front()),
                log.file);
  if (!potential || fluctuation(total) < bath_ratio * std::sqrt(variance_of(potential->values)))
    return {&total, false};
  throw Error(
      fmt::format("'{}' fluctuates by {:.3g}, more than half of the fluctuation {:.3g} of '{}', so "
                  "a thermostat or barostat changed the energy; also print the conserved energy, "
                  "or continue this run for 20 to 50 ps at constant energy with the same step",
                  total.name, fluctuation(total), std::sqrt(variance_of(potential->values)),
                  potential->name),
      log.file);
}

void check_digits(const EngineLog& log, const LogColumn& total, LogBias& b, double fluctuation) {
  if (b.resolution == 0 || b.resolution > fluctuation)
    throw Error(
        fmt::format("'{}' fluctuates by {:.2g}, and the smallest difference between printed values "
                    "is {:.2g}, so the column has too few digits; print more digits, for example "
                    "with 'thermo_modify format float %.12g' of LAMMPS or 'gmx energy -dp'",
                    total.name, fluctuation, b.resolution),
        log.file);
  // Rounding is uncorrelated with all averages, but adds this share to the energy's variance.
  const double share = std::pow(b.resolution / fluctuation, 2) / 12;
  if (share > 0.01)
    b.warnings.push_back(
        fmt::format("rounding makes {:.0f} % of the variance of the energy; print more "
                    "digits for a smaller error",
                    100 * share));
}

double temperature_of(const EngineLog& log, const BiasRequest& request, const EnergyUnit& unit) {
  if (request.temperature)
    return unit.boltzmann == 1 ? given_number(request.temperature, 1e-6, 1e6)
                               : given_positive(request.temperature, Dimension::temperature);
  const LogColumn* temperature = log.find(temperature_names);
  if (temperature == nullptr)
    throw Error("the log has no temperature; give the temperature, such as \"298 K\"", log.file);
  if (!temperature->unit.empty() && temperature->unit != "K" && unit.boltzmann != 1)
    throw Error(fmt::format("'{}' is in {}; give the temperature in K, such as \"298 K\"",
                            temperature->name, temperature->unit),
                log.file);
  return mean_of(temperature->values);
}

SeriesEstimate deviation_of(std::span<const double> deviations) {
  TimeBlocks blocks;
  for (const double e : deviations) blocks.add(std::array{e, e * e});
  return series_estimate(blocks.means(),
                         [](auto mean) { return std::sqrt(mean[1] - mean[0] * mean[0]); });
}

/// The drift of an energy per time, or per row if there are no times. With a bath the conserved
/// energy performs a random walk, which is not an energy drift.
Drift drift_of(const LogColumn& energy, const LogColumn* time, bool has_bath) {
  TimeBlocks blocks;
  for (std::size_t k = 0; k < energy.values.size(); ++k)
    blocks.add(std::array{time ? time->values[k] - time->values[0] : static_cast<double>(k),
                          energy.values[k] - energy.values[0]});
  return has_bath ? series_drift_over_walk(blocks.means(), 0, 1)
                  : series_drift(blocks.means(), 0, 1);
}

/// A bath that scales all momenta keeps the mean kinetic energy, so the temperature has no bias.
/// The tolerance, five standard errors plus T/300, allows for the finite length of the log.
void check_bath(LogBias& b) {
  for (const ColumnBias& c : b.columns)
    if (is_one_of({c.name, "", {}}, temperature_names) &&
        std::abs(c.bias.value) > 5 * c.bias.error + b.temperature / 300)
      b.warnings.push_back(fmt::format(
          "the temperature has a bias of {:.2g} K, but this bias must be 0: the "
          "thermostat acts on single momenta (Langevin, Andersen) or is not canonical "
          "(Berendsen), or the kinetic energy is averaged over half steps; use a log at "
          "constant energy",
          c.bias.value));
}

/// @param name  column whose bias must be precise
void add_warnings(LogBias& b, const std::string& name) {
  if (b.drift.significant())
    b.warnings.push_back(fmt::format(
        "'{}' drifts by {:.3g} {} per unit of time; the fitted drift is removed, but averages over "
        "a drifting run are uncertain: use a shorter step or higher precision",
        b.energy, b.drift.rate.value, b.energy_unit));
  const auto of = std::ranges::find(b.columns, name, &ColumnBias::name);
  if (of->bias.known != Known::yes)
    b.warnings.push_back(fmt::format(
        "the error of the bias is not known: {}; the log must be longer", reason(of->bias.known)));
  else if (of->bias.error > std::abs(of->bias.value) / 2)
    b.warnings.push_back(fmt::format(
        "the bias of '{}' has an error of {:.2g}, more than half of its value; a log that is "
        "{:.0f} times longer, or sampled more often, reduces the error to 20 % of the bias",
        of->name, of->bias.error,
        std::ceil(std::pow(5 * of->bias.error / std::max(std::abs(of->bias.value), 1e-300), 2))));
}

}  // namespace

std::vector<RequestOption<BiasRequest>> BiasRequest::options() {
  using R = BiasRequest;
  return {{"total", &R::total, "column of the total energy; default: the column with a usual name"},
          {"potential", &R::potential,
           "column of the potential energy; default: the column with a usual name"},
          {"temperature", &R::temperature,
           "temperature; default: the mean of the temperature in the log"},
          {"energy_unit", &R::energy_unit,
           "unit of energies: kJ/mol, kcal/mol, eV or lj; default: the unit in the log"},
          {"start", &R::start,
           "earliest time that is used, in the time unit of the log; default: the first row"},
          {"stop", &R::stop,
           "latest time that is used, in the time unit of the log; default: the last row"}};
}

LogBias log_bias(const EngineLog& whole, const BiasRequest& request) {
  const EngineLog log = within(whole, whole.find(time_names), request);
  const LogColumn& total = total_of(log, request.total);
  const LogColumn* potential = column_for(log, request.potential, potential_names);
  check_rows(log, log.find(time_names));
  check_unique(log, &total, request.total);
  check_unique(log, potential, request.potential);
  check_unit(log, potential, total);
  check_unit(log, log.find(conserved_names), total);
  const EnergyUnit& unit = unit_of(total, request, log);
  LogBias b{
      .format = log.format, .energy_unit = unit.name, .samples = log.samples(), .notes = log.notes};
  b.temperature = temperature_of(log, request, unit);
  const double kT = unit.boltzmann * b.temperature / log.divisor;

  const auto [energy, has_bath] = ensemble_of(log, total, potential);
  const std::vector<double> deviations = without_line(energy->values);
  const double fluctuation = std::sqrt(variance_of(deviations));
  b.energy = energy->name;
  b.has_bath = has_bath;
  b.resolution = resolution_of(energy->values);
  check_digits(log, *energy, b, fluctuation);
  b.fluctuation = deviation_of(deviations);
  b.drift = drift_of(*energy, log.find(time_names), has_bath);
  if (potential) {
    b.R = fluctuation / std::sqrt(variance_of(potential->values));
    if (!has_bath)
      b.at_constant_temperature =
          ColumnSums(deviations, potential->values, kT)
              .at_constant_temperature(mean_of(total.values) - mean_of(potential->values));
  }
  for (const LogColumn& column : log.columns) {
    const auto [min, max] = std::ranges::minmax(column.values);
    if (min == max || &column == &total || is_one_of(column, time_names) ||
        is_one_of(column, conserved_names))
      continue;
    b.columns.push_back(ColumnSums(deviations, column.values, kT).bias(column));
  }
  if (b.columns.empty())
    throw Error("the log has no column besides times and the total energy; print more quantities",
                log.file);
  if (log.format == "xvg file")
    b.notes.push_back(
        "GROMACS prints kinetic energies of full steps with integrator = md-vv; with integrator = "
        "md, the printed kinetic energies are averages over half steps, for which this bias is not "
        "valid");
  if (has_bath) check_bath(b);
  add_warnings(b, potential ? potential->name : b.columns.front().name);
  return b;
}

Quantities quantities(const LogBias& b) {
  std::vector<Quantities> columns;
  for (const ColumnBias& c : b.columns)
    columns.push_back({{"name", "", c.name, "name of the column", "quantity"},
                       {"mean", "", c.mean, "mean over the log, in `unit`", "mean"},
                       {"bias", "", c.bias, "time-step bias of the mean", "time-step bias"},
                       {"corrected", "", c.corrected, "mean without the bias", "corrected mean"},
                       {"unit", "", c.unit, "unit of mean and bias", "unit"}});
  const std::string unit = fmt::format("[{}]", b.energy_unit);
  Quantities list{
      {"format", "", b.format, "format of the log"},
      {"samples", "", b.samples, "number of rows used", "samples"},
      {"ensemble", "", b.has_bath ? "thermostat" : "constant energy",
       "`constant energy`, or `thermostat`: the bias is the difference from exact dynamics at the "
       "same mean energy, or at the same mean kinetic energy and pressure",
       "ensemble"},
      {"energy", "", b.energy, "column of the energy that exact dynamics conserves"},
      {"temperature", b.energy_unit == "lj" ? "" : "[K]", b.temperature,
       "temperature used to compute the biases", "temperature"},
      {"energy_unit", "", b.energy_unit, "unit of energies"},
      {"fluctuation", unit, b.fluctuation,
       "standard deviation of the conserved energy about a fitted line", "fluctuation of E"},
      {"R", "%", b.R > 0 ? Value(b.R) : Value(),
       "fluctuation of the conserved energy, divided by the fluctuation of the potential energy; "
       "null without potential energies",
       "R"},
      {"resolution", unit, b.resolution,
       "smallest difference between printed values of the conserved energy"},
      {"drift", unit, b.drift.rate,
       "drift of the conserved energy per unit of time of the log; this drift is removed"},
      {"drift_p_value", "", b.drift.p_value,
       "probability that chance gives a drift of at least this size"},
      {"columns", "", columns, "averages over the log and their biases", "averages"},
      {"potential_bias_at_constant_temperature", unit, b.at_constant_temperature,
       "time-step bias of the potential energy at the same mean kinetic energy, from a log at "
       "constant energy; null for other logs"},
      {"notes", "", b.notes, "choices that were made when the log was read"},
      {"warnings", "", b.warnings, "reasons why a bias is uncertain"}};
  if (b.at_constant_temperature)
    list.push_back(row("", "time-step bias of the potential energy at constant temperature: " +
                               text_of(*b.at_constant_temperature, b.energy_unit)));
  for (const std::string& note : b.notes) list.push_back(row("", "note: " + note));
  for (const std::string& warning : b.warnings) list.push_back(row("", "WARNING: " + warning));
  return list;
}

}  // namespace polhode
