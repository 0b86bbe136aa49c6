// SPDX-License-Identifier: MIT
#include "run/canonical/canonical_report.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "../study/study_job.hpp"
#include "io/figures/plot.hpp"
#include "io/files/with_error.hpp"
#include "io/settings/ensemble_text.hpp"
#include "io/settings/output_units.hpp"
#include "math/prediction.hpp"
#include "polhode/base/error.hpp"
#include "run/quantity_lists.hpp"
#include "run/simulation/system/system_notes.hpp"

namespace polhode {
namespace {

/// Whether the costs of two points differ: the 95 % confidence interval of their difference
/// excludes 0.
bool distinguishable(const CanonicalPoint& one, const CanonicalPoint& other) {
  const Estimate a = one.evaluations_per_sample(), b = other.evaluations_per_sample();
  const ErrorPart doubt = summed({{a.error, one.runs - 1.0}, {b.error, other.runs - 1.0}});
  return std::abs(a.value - b.value) > confidence_half_width(doubt);
}

/// The result for a scheme from its points, in the order of the steps.
CanonicalClaim claim_of(const std::string& scheme, BiasCriterion criterion,
                        const std::vector<CanonicalPoint>& points) {
  std::vector<std::size_t> own;
  for (std::size_t k = 0; k < points.size(); ++k)
    if (points[k].method.name == scheme) own.push_back(k);
  std::sort(own.begin(), own.end(),
            [&](auto a, auto b) { return points[a].method.step < points[b].method.step; });
  CanonicalClaim claim{.scheme = scheme, .accurate = {}, .beyond = {}};
  bool accurate = true;
  for (const std::size_t k : own) {
    const Accuracy accuracy = points[k].accuracy(criterion);
    accurate = accurate && accuracy == Accuracy::below;
    if (accurate) claim.accurate = k;
    if (accuracy == Accuracy::above && !claim.beyond) claim.beyond = k;
  }
  return claim;
}

std::string step_text(const CanonicalPoint& point) {
  return fmt::format("{:g} fs", point.method.step * units::fs_per_ps);
}

std::string sentence(const CanonicalClaim& claim, BiasCriterion criterion,
                     const std::vector<CanonicalPoint>& points) {
  std::string text = claim.scheme;
  if (claim.accurate)
    text += fmt::format(
        ": all biases are below their bounds for steps up to {}, at {:.0f} force evaluations per "
        "ps",
        step_text(points[*claim.accurate]), points[*claim.accurate].method.cost());
  else
    text += ": no time step is shown to have all biases below their bounds";
  if (claim.beyond) {
    const CanonicalPoint& point = points[*claim.beyond];
    text += fmt::format("; at {} ", step_text(point));
    if (!point.stable) return text + "a run blew up";
    std::string which;
    for (std::size_t k = 0; k < canonical_quantities.size(); ++k)
      if (point.accuracy(k, criterion) == Accuracy::above)
        which += fmt::format(
            "{}{} ({} {})", which.empty() ? "" : ", ", canonical_quantities[k].label,
            with_error(point.bias[k]->value, point.bias[k]->error), canonical_quantities[k].unit);
    text += "above: " + which;
  }
  return text;
}

/// The names of methods as text, such as "baoab at 4 fs, hoa2-ends at 8 fs".
std::string names_of(const std::vector<std::size_t>& which,
                     const std::vector<CanonicalPoint>& points) {
  std::string names;
  for (const std::size_t k : which)
    names += fmt::format("{}{} at {}", names.empty() ? "" : ", ", points[k].method.name,
                         step_text(points[k]));
  return names;
}

/// The mark of a bias that is significantly above its bounds.
std::string mark_on(const CanonicalPoint& point, std::size_t quantity) {
  if (point.accuracy(quantity, BiasCriterion::loose) == Accuracy::above) return "**";
  return point.accuracy(quantity, BiasCriterion::strict) == Accuracy::above ? "* " : "  ";
}

std::string note_on(const CanonicalPoint& p) {
  if (!p.stable) return "blew up";
  std::string text = fmt::format("{}, loosely {}", in_words(p.accuracy(BiasCriterion::strict)),
                                 in_words(p.accuracy(BiasCriterion::loose)));
  if (p.method.hybrid)
    text += fmt::format(", acceptance {:.0f} %, <exp(-dH/kT)> {}", 100 * p.acceptance.value,
                        with_error(p.weight.value, p.weight.error));
  return text;
}

SeriesEstimate known(const std::optional<Estimate>& e) {
  return nested(e.value_or(Estimate{std::nan(""), std::nan("")}));
}

/// The unit of a quantity as text; empty if the quantity is dimensionless.
std::string unit_text(const CanonicalQuantity& q) {
  return std::string_view(q.unit) == "1" ? "" : q.unit;
}

/// The k-th quantity of a point: the mean, the bias, and whether the bias is below the bounds.
Quantity of_quantity(const CanonicalPoint& p, std::size_t k) {
  const CanonicalQuantity& q = canonical_quantities[k];
  const std::string column = q.name;
  const std::string unit = unit_text(q).empty() ? "" : fmt::format("[{}]", q.unit);
  const auto verdict = [&](BiasCriterion criterion) -> Value {
    const auto accuracy = p.accuracy(k, criterion);
    return accuracy ? Value(in_words(*accuracy)) : Value();
  };
  return {
      q.name, "",
      Quantities{
          {"mean", "", nested(p.mean[k]), "mean over the runs"},
          {"bias", "", nested(p.bias[k]), "bias of the mean over the runs"},
          {"", unit, known(p.mean[k]), "", "", "", column},
          {"", unit, known(p.bias[k]), "", q.label, mark_on(p, k), column + "_bias"},
          {"accuracy", "", verdict(BiasCriterion::strict), "verdict for the strict bound"},
          {"loose_accuracy", "", verdict(BiasCriterion::loose), "verdict for the loose bound"}}};
}

Quantities of_point(const CanonicalPoint& p) {
  const std::string acceptance = p.method.hybrid ? "acceptance" : "";
  const std::string weight = p.method.hybrid ? "exp_dH" : "";
  Quantities by_name;
  for (std::size_t k = 0; k < canonical_quantities.size(); ++k)
    by_name.push_back(of_quantity(p, k));
  return {{"scheme", "", p.method.name, "name of the scheme, or its stages", "scheme"},
          {"step", "fs", p.method.step * units::fs_per_ps, "time step", "step"},
          {"force_evaluations", "1/ps", p.method.cost(), "cost in force evaluations per ps", "cost",
           "", "cost"},
          {"hybrid_monte_carlo", "", p.method.hybrid,
           "whether hybrid Monte Carlo uses the scheme to propose trajectories", "", "", "-"},
          {"runs", "", p.runs, "number of independent runs", "runs"},
          {"stable", "", p.stable, "whether no run blew up"},
          {"accuracy", "", in_words(p.accuracy(BiasCriterion::strict)),
           "verdict for the strict bounds: `below the bound`, `above the bound` or `undecided`"},
          {"loose_accuracy", "", in_words(p.accuracy(BiasCriterion::loose)),
           "verdict for the loose bounds: `below the bound`, `above the bound` or `undecided`"},
          {"correlation_time", "ps", nested(p.correlation_time),
           "integrated autocorrelation time of U"},
          {"force_evaluations_per_sample", "", nested(p.evaluations_per_sample()),
           "force evaluations per independent sample of the potential energy U", "cost/sample", "",
           "evaluations_per_sample"},
          {"", "", p.acceptance.value, "", "", "", "acceptance"},
          {acceptance, "", nested(p.acceptance), "acceptance of proposals", "", "", "-"},
          {weight, "", nested(p.weight), "mean of exp(-dH/kT)", "", "", "exp_dH"},
          {"quantities", "", by_name, ""},
          row("biases", note_on(p))};
}

std::vector<Quantities> point_records(const CanonicalReport& report) {
  std::vector<Quantities> records;
  for (const CanonicalPoint& point : report.points) records.push_back(of_point(point));
  return records;
}

/// The conclusions for a criterion. The title gives the bounds of the criterion.
Quantity of_findings(const char* key, const CanonicalReport& report,
                     const CanonicalFindings& findings) {
  std::string bounds;
  for (const CanonicalQuantity& q : canonical_quantities)
    bounds +=
        fmt::format("{} {} {:g}{}{}", bounds.empty() ? "" : ",", q.label,
                    q.bound(findings.criterion), unit_text(q).empty() ? "" : " ", unit_text(q));
  return {key, "", canonical_sentences(findings, report.points),
          fmt::format("conclusions about the biases, judged by the {} bounds",
                      in_words(findings.criterion)),
          fmt::format("{} bounds:{}; with 95 % confidence", in_words(findings.criterion), bounds)};
}

/// The quantities shown in the figure. Each panel shows a quantity. The last panel shows the cost
/// of a sample.
constexpr std::array<std::size_t, 5> drawn = {0, 1, 2, 5, 4};

/// A panel that shows a column of the table of points.
CanonicalFigure::Panel panel(const std::string& title, const std::string& column,
                             std::string_view unit) {
  return {title, fmt::format("{} [{}]", column, unit), fmt::format("{}_error [{}]", column, unit)};
}

CanonicalFigure figure(const CanonicalReport& report, const std::string& csv) {
  CanonicalFigure figure{csv, {}, {}};
  for (const std::size_t k : drawn) {
    const CanonicalQuantity& q = canonical_quantities[k];
    figure.panels.push_back(
        panel(fmt::format("bias of {}{}", q.label,
                          unit_text(q).empty() ? "" : fmt::format("  ({})", q.unit)),
              fmt::format("{}_bias", q.name), q.unit));
    figure.panels.back().strict = q.strict, figure.panels.back().loose = q.loose;
  }
  figure.panels.push_back(
      panel("force evaluations per independent U", "evaluations_per_sample", "1"));
  for (std::size_t row = 0; row < report.points.size(); ++row) {
    const CanonicalPoint& p = report.points[row];
    if (!p.stable) continue;
    if (figure.schemes.empty() || figure.schemes.back().scheme != p.method.name)
      figure.schemes.push_back({p.method.name, row, row});
    figure.schemes.back().last = row;
  }
  figure.caption = fmt::format(
      "Shaded: the strict and the loose bounds. Points with equal cost are drawn side by side. "
      "Hybrid Monte Carlo (hmc) is exact and serves as the reference. {} runs of {:g} ps per "
      "point, standard "
      "errors.",
      report.config.study.runs, report.config.study.length);
  return figure;
}

/// A study of canonical averages.
struct CanonicalStudy {
  using Run = CanonicalRun;
  using Report = CanonicalReport;

  static constexpr const char* title = "canonical study";
  static constexpr auto identity = canonical_identity;
  static constexpr auto perform = perform_canonical_runs;
  static constexpr auto records_of = point_records;
  static constexpr auto figure_of = figure;

  const Config& config;
  std::vector<CanonicalMethod> methods = canonical_methods(config.study);

  std::size_t points() const { return methods.size(); }

  void check(const System&) const {
    if (config.ensemble.barostat)
      throw Error("a canonical study requires constant volume; leave the table [barostat] out",
                  config.source);
    check_not_processed(config, "a canonical study");
    for (const CanonicalMethod& method : methods)
      if (config.study.length < 100 * method.step)
        throw Error(
            fmt::format(
                "the study's length of {:g} fs is less than a hundred steps of {:g} fs, too few "
                "for averages; use longer runs, or leave out long steps",
                config.study.length * units::fs_per_ps, method.step * units::fs_per_ps),
            config.source);
  }

  void note(const Callbacks&) const {}

  CanonicalReport report(const System&, const std::vector<CanonicalRun>& runs) const {
    return {config, canonical_points(methods, runs, config.system.temperature)};
  }
};

/// A sentence on the forces, runs and heat bath of a canonical study.
std::string canonical_conditions(const Config& config) {
  EnsembleSettings bath;
  bath.temperature = config.system.temperature;
  bath.thermostat = config.ensemble.thermostat.value_or(ThermostatSettings{});
  const auto hybrid = config.ensemble.hybrid_monte_carlo.value_or(HybridMonteCarloSettings{});
  return fmt::format(
      "at most {} runs of {:g} ps, of which the first {:g} ps are left out; every scheme starts "
      "from the "
      "same "
      "canonical configurations; schemes with a bath: {}; hybrid Monte Carlo: {} steps per "
      "trajectory; the reference is {:g} K for temperatures, and hybrid Monte Carlo for other "
      "averages",
      config.study.runs, config.study.length, relaxation(config.study.length), description(bath),
      hybrid.steps, config.system.temperature);
}

}  // namespace

CanonicalFindings::CanonicalFindings(BiasCriterion chosen,
                                     const std::vector<CanonicalPoint>& points)
    : criterion(chosen) {
  for (const CanonicalPoint& point : points)
    if (claims.empty() || claims.back().scheme != point.method.name)
      claims.push_back(claim_of(point.method.name, criterion, points));
  std::vector<std::size_t> known;  // points with a known cost
  for (std::size_t k = 0; k < points.size(); ++k)
    if (std::isfinite(points[k].evaluations_per_sample().value)) known.push_back(k);
  const auto sample = [&](std::size_t k) { return points[k].evaluations_per_sample(); };
  for (const std::size_t k : known)
    if (points[k].accuracy(criterion) == Accuracy::below &&
        (!cheapest || sample(k).value < sample(*cheapest).value))
      cheapest = k;
  if (!cheapest) return;
  for (const std::size_t k : known) {
    const bool distinct = distinguishable(points[k], points[*cheapest]);
    const Accuracy accuracy = points[k].accuracy(criterion);
    if (k != *cheapest && accuracy == Accuracy::below && !distinct) as_cheap.push_back(k);
    if (accuracy == Accuracy::undecided && (!distinct || sample(k).value < sample(*cheapest).value))
      undecided.push_back(k);
  }
}

CanonicalReport::CanonicalReport(const Config& config_used,
                                 const std::vector<CanonicalPoint>& points_found)
    : config(config_used),
      points(points_found),
      findings{CanonicalFindings(BiasCriterion::strict, points),
               CanonicalFindings(BiasCriterion::loose, points)} {}

std::vector<std::string> canonical_sentences(const CanonicalFindings& findings,
                                             const std::vector<CanonicalPoint>& points) {
  std::vector<std::string> sentences;
  for (const CanonicalClaim& claim : findings.claims)
    sentences.push_back(sentence(claim, findings.criterion, points));
  if (!findings.cheapest) {
    sentences.emplace_back(
        "the cheapest unbiased sample is not known: no point has both a known correlation time and "
        "all biases below their bounds");
    return sentences;
  }
  const Estimate cost = points[*findings.cheapest].evaluations_per_sample();
  std::string text = fmt::format(
      "the cheapest independent sample with all biases below their bounds: {}, {} force "
      "evaluations",
      names_of({*findings.cheapest}, points), with_error(cost.value, cost.error));
  if (!findings.as_cheap.empty())
    text += "; not distinguishable in cost: " + names_of(findings.as_cheap, points);
  if (!findings.undecided.empty())
    text += "; equally cheap or cheaper, but with biases not known to be below their bounds: " +
            names_of(findings.undecided, points);
  sentences.push_back(text);
  return sentences;
}

Quantities quantities(const CanonicalReport& report) {
  Quantities bounds;
  for (const CanonicalQuantity& q : canonical_quantities)
    bounds.push_back({q.name, "",
                      Quantities{{"value", "", q.strict, "strict bound on the bias"},
                                 {"loose", "", q.loose, "loose bound"},
                                 {"unit", "", q.unit, "unit of the bounds"}}});
  return {{"conditions", "", canonical_conditions(report.config),
           "conditions that all runs have in common"},
          detail(row("", canonical_conditions(report.config))),
          {"bounds", "", bounds, ""},
          detail({"points", "", point_records(report), "results for each scheme and step",
                  "points, with the biases of averages; * above the strict bound, ** above the "
                  "loose bound"}),
          of_findings("claims", report, report.findings[0]),
          detail(of_findings("loose_claims", report, report.findings[1])),
          row_of_files(report.files)};
}

CanonicalReport run_canonical_study(const Config& config, const std::string& record,
                                    const std::string& prefix, const OutputOptions& options,
                                    const Callbacks& callbacks, Workers& workers) {
  const CanonicalStudy study{config};
  return StudyJob(study, prefix, options, callbacks).perform(record, workers);
}

}  // namespace polhode
