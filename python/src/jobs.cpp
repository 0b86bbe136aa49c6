// SPDX-License-Identifier: MIT
// The jobs of the command line that compute and write files, each by the library function that its
// verb calls. They return their reports as JSON; options have been read by the caller, except for
// quantities, which are texts with units.
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <limits>

#include "base/instruction_set.hpp"
#include "bind.hpp"
#include "io/settings/ensemble_names.hpp"
#include "job_options.hpp"
#include "polhode/io/topology/molecule_file.hpp"
#include "polhode/run/prepare/minimisation.hpp"
#include "polhode/run/prepare/preparation.hpp"
#include "polhode/run/simulation/simulation.hpp"
#include "polhode/run/simulation/system/single_point.hpp"
#include "polhode/run/study/tune.hpp"
#include "run/adviser/advice_report.hpp"
#include "run/analysis/analysis_report.hpp"
#include "run/benchmark/benchmark_report.hpp"
#include "run/canonical/hybrid_adviser.hpp"
#include "run/conversion/conversion.hpp"
#include "run/conversion/lammps_export.hpp"

namespace polhode::python {
namespace {

namespace nb = nanobind;
using namespace nb::literals;
// Simulations.

nb::tuple run(const Config& config, const JobOptions& options) {
  const RunResult result = options.run([&](const Callbacks& callbacks, Workers& workers) {
    return Simulation(config, workers).run(options.output, callbacks);
  });
  const auto& report = result.report;
  return nb::make_tuple(
      report ? json_text(flattened(run_quantities(*report)), text_rows(run_quantities(*report)))
             : "null",
      report ? report->files.all() : std::vector<std::string>{}, result.end == RunEnd::complete);
}

std::string energy(const Config& config, bool derivative, nb::object message) {
  return Job({nb::none(), std::move(message)}).run([&](const Callbacks& callbacks) {
    return report_text(quantities(single_point(config, derivative, callbacks)));
  });
}

void set_stage(double& length, const Text& text, const std::string& name) {
  if (!text) return;
  length = quantity(*text, Dimension::time, name);
  if (!(length >= 0))
    throw Error(name + " = \"" + *text + "\" must be 0 or longer; write for example \"20 ps\"");
}

std::string prepare_start(Config config, const Text& pressure, const Text& nvt, const Text& npt,
                          const JobOptions& options) {
  if (pressure) {
    auto& barostat = config.ensemble.barostat;
    if (!barostat) barostat = default_barostat();
    barostat->pressure = quantity(*pressure, Dimension::pressure, "pressure");
  }
  set_stage(config.prepare.nvt, nvt, "nvt");
  set_stage(config.prepare.npt, npt, "npt");
  return options.run([&](const Callbacks& callbacks, Workers& workers) {
    return report_text(quantities(prepare(config, options.output, callbacks, workers)));
  });
}

std::string minimise_start(const Config& config, const Text& force, const Text& torque,
                           std::size_t max_steps, const JobOptions& options) {
  MinimisationSettings settings;
  set_positive(settings.force, force, Dimension::force, "max_force");
  set_positive(settings.torque, torque, Dimension::energy, "max_torque");
  settings.max_steps = max_steps;
  return options.run([&](const Callbacks& callbacks, Workers& workers) {
    return report_text(
        quantities(minimise_configuration(config, settings, options.output, callbacks, workers)));
  });
}

// Trajectories.

struct AnalysisOptions {
  Texts what, pairs;
  Text from, interval, window, cutoff, bin, viscosity, temperature, electrostatics, energies;
  Texts fit;
};

/// "OW-HW", split where both names are those of sites.
SitePair site_pair(const std::string& text, const Topology& topology) {
  for (auto at = text.find('-'); at != text.npos; at = text.find('-', at + 1)) {
    SitePair pair{text.substr(0, at), text.substr(at + 1)};
    if (!molecules_with(topology, pair[0]).empty() && !molecules_with(topology, pair[1]).empty())
      return pair;
  }
  throw Error("pairs: '" + text +
              "' is not two names of sites of these molecules; write for example \"OW-HW\"");
}

AnalysisSettings analysis_settings(const AnalysisOptions& o, const Config* config,
                                   const Topology& topology) {
  AnalysisSettings s;
  s.from = o.from ? quantity(*o.from, Dimension::time, "start")
                  : -std::numeric_limits<double>::infinity();
  if (o.what)
    for (const std::string& name : *o.what) s.what.insert(observable(name));
  if (o.pairs)
    for (const std::string& pair : *o.pairs) s.pairs.push_back(site_pair(pair, topology));
  s.interval = positive(o.interval, Dimension::time, "interval");
  s.cutoff = positive(o.cutoff, Dimension::length, "cutoff");
  set_positive(s.window, o.window, Dimension::time, "window");
  set_positive(s.bin, o.bin, Dimension::length, "bin");
  if (o.energies && !config)
    throw Error(
        "energies is for the bias of the step, which depends on what the run held constant; give "
        "run as well");
  if (o.energies) s.step_errors = step_error_settings(*o.energies, *config);
  return s;
}

SummarySettings summary_settings(const AnalysisOptions& o, const Config* config) {
  SummarySettings s;
  s.no_surroundings = "it depends on the electrostatics of the run; give run or electrostatics";
  if (config) s.set_run(*config);
  if (o.electrostatics) {
    ForceSettings forces;
    forces.electrostatics = named<Electrostatics>(*o.electrostatics, "electrostatics");
    s.set_surroundings(forces);
  }
  s.temperature = positive(o.temperature, Dimension::temperature, "temperature");
  s.viscosity = positive(o.viscosity, Dimension::viscosity, "viscosity");
  if (!o.fit) return s;
  if (o.fit->size() != 2)
    throw Error("fit must be two lags; write for example (\"2 ps\", \"10 ps\")");
  s.fit = FitWindow{quantity((*o.fit)[0], Dimension::time, "fit"),
                    quantity((*o.fit)[1], Dimension::time, "fit")};
  if (!(0 <= s.fit->from && s.fit->from < s.fit->to))
    throw Error("fit must begin at 0 or later and end after its beginning");
  return s;
}

/// @param molecules  (model, count) in the order of the file, instead of a config
nb::tuple analyze_trajectory(const std::string& trajectory, const Config* config,
                             const std::vector<std::pair<std::string, std::size_t>>& molecules,
                             const std::string& names, const AnalysisOptions& o,
                             const std::string& prefix, const std::string& plot,
                             const JobOptions& options) {
  Topology topology;
  std::string origin;
  if (config) topology = build_topology(config->system), origin = config->text;
  for (const auto& [model, count] : molecules) {
    topology.parts.push_back({read_molecule(model), count});
    origin += model + " " + std::to_string(count) + " ";
  }
  AnalysisInput input{.trajectory = trajectory,
                      .names = names,
                      .topology = topology,
                      .origin = origin,
                      .seed = config ? config->system.seed : 0,
                      .settings = analysis_settings(o, config, topology),
                      .summary = summary_settings(o, config),
                      .prefix = prefix,
                      .plot = plot};
  const AnalysisReport report = options.run([&](const Callbacks& callbacks, Workers& workers) {
    return run_analysis(input, options.output, callbacks, workers);
  });
  return nb::make_tuple(report_text(analysis_quantities(report)), report.files);
}

std::size_t convert_file(const std::string& from, const std::string& to, const std::string& names,
                         const Config* particles, std::size_t every, const Text& first,
                         const Text& last, const JobOptions& options) {
  Conversion conversion{.from = from, .to = to, .names = names, .every = every};
  if (particles != nullptr) conversion.particles = molecules_of_run(*particles);
  if (first) conversion.first = quantity(*first, Dimension::time, "start");
  if (last) conversion.last = quantity(*last, Dimension::time, "stop");
  return options.run([&](const Callbacks& callbacks, Workers&) {
    return convert(conversion, options.output, callbacks).frames;
  });
}

std::vector<std::string> export_lammps(const Config& config, const std::string& pair_style,
                                       const JobOptions& options) {
  const auto style = named<LammpsPairStyle>(pair_style, "pair_style");
  return options.run([&](const Callbacks& callbacks, Workers&) {
    return export_to_lammps(config, style, options.output, callbacks);
  });
}

// Schemes and steps.

double bounded_fraction(const std::string& text, const std::string& name) {
  const double value = quantity(text, Dimension::fraction, name);
  if (const std::string wrong = wrong_bound(value); !wrong.empty())
    throw Error(name + " = \"" + text + "\" " + wrong);
  return value;
}

Criterion criterion(const Config& config, const Text& accuracy, const Text& drift,
                    const Text& temperature_bias, const Text& bias) {
  if (accuracy.has_value() + drift.has_value() + temperature_bias.has_value() + bias.has_value() >
      1)
    throw Error(
        "accuracy, drift, temperature_bias and bias exclude each other: the step meets one bound; "
        "give one of them");
  if (accuracy) return {Quality::ratio, bounded_fraction(*accuracy, "accuracy")};
  if (drift) return {Quality::drift, *positive(drift, Dimension::power, "drift")};
  if (temperature_bias)
    return {Quality::temperature_bias, bounded_fraction(*temperature_bias, "temperature_bias")};
  if (bias) return criterion_of(required_bias(*bias, "bias"), config.ensemble);
  if (config.integrator.accuracy) return criterion_of(*config.integrator.accuracy, config.ensemble);
  throw Error(
      "no accuracy is requested; give accuracy=\"0.5 %\", drift=\"0.1 kJ/mol/ns\", "
      "temperature_bias=\"0.5 %\" or bias=\"0.1 K\"");
}

nb::tuple advise(Config config, const Text& accuracy, const Text& drift,
                 const Text& temperature_bias, const Text& bias, const Texts& schemes,
                 double seconds, const std::string& prefix, const JobOptions& options) {
  set_schemes(config.integrator.candidates, schemes, config);
  const AdviserSettings settings{criterion(config, accuracy, drift, temperature_bias, bias),
                                 config.integrator.candidates, seconds};
  const AdviceReport report = options.run([&](const Callbacks& callbacks, Workers& workers) {
    return run_adviser(config, settings, prefix, options.output, callbacks, workers);
  });
  if (!report.advice.stopped && !report.advice.best)
    throw RunError(unreachable(report.advice, settings.criterion));
  return nb::make_tuple(report_text(quantities(report)), report.files.all(),
                        report.advice.stopped ? "" : answer(report.advice));
}

nb::tuple advise_nvt(const Config& config, const Text& scheme, std::size_t evaluations,
                     const JobOptions& options) {
  HybridAdviserSettings settings;
  if (scheme) settings.scheme = *scheme;
  settings.evaluations = evaluations;
  const HybridAdvice advice = options.run([&](const Callbacks& callbacks, Workers& workers) {
    return advise_hybrid(config, settings, callbacks, workers);
  });
  if (!advice.stopped && advice.finalists.empty()) throw RunError(answer(advice));
  return nb::make_tuple(report_text(quantities(advice)), answer(advice));
}

std::string tune_scheme(const Config& config, const Text& scheme, const Text& step, int runs,
                        const Text& length, const Text& decorrelate, const Text& sample,
                        const JobOptions& options) {
  TuneSettings settings;
  if (scheme) settings.scheme = with_own_schemes(*scheme, config.schemes);
  set_positive(settings.step, step, Dimension::time, "step");
  set_positive(settings.length, length, Dimension::time, "length");
  set_positive(settings.decorrelate, decorrelate, Dimension::time, "decorrelate");
  set_positive(settings.sample, sample, Dimension::time, "sample");
  settings.runs = runs;
  return report_text(quantities(options.run([&](const Callbacks& callbacks, Workers& workers) {
    return tune(config, settings, callbacks, workers);
  })));
}

std::string bench(bool is_quick, const std::optional<std::vector<std::size_t>>& sizes,
                  const Text& precision, const std::string& processor, const JobOptions& options) {
  BenchmarkSettings settings;
  settings.quick = is_quick;
  if (is_quick) settings.sizes = {512};
  if (sizes) settings.sizes = *sizes;
  if (precision) settings.precisions = {named<Precision>(*precision, "precision")};
  if (options.threads > 1) settings.threads.push_back(options.threads);
  const Benchmark result = options.run(
      [&](const Callbacks& callbacks, Workers&) { return run_benchmark(settings, callbacks); });
  return report_text(
      quantities(result, {processor, name(current_instruction_set()), settings.threads}));
}

}  // namespace

void bind_jobs(nb::module_& m) {
  nb::class_<JobOptions>(m, "JobOptions")
      .def(
          "__init__",
          [](JobOptions* self, int threads, const std::string& existing, const std::string& command,
             nb::object progress, nb::object message) {
            const ExistingFiles files = existing == "resume"    ? ExistingFiles::resume
                                        : existing == "replace" ? ExistingFiles::replace
                                                                : ExistingFiles::refuse;
            new (self)
                JobOptions{threads, {files, command}, std::move(progress), std::move(message)};
          },
          "threads"_a, "existing"_a, "command"_a, "progress"_a.none(), "message"_a.none());
  nb::class_<AnalysisOptions>(m, "AnalysisOptions")
      .def(nb::init<>())
      .def_rw("what", &AnalysisOptions::what)
      .def_rw("pairs", &AnalysisOptions::pairs)
      .def_rw("start", &AnalysisOptions::from)
      .def_rw("interval", &AnalysisOptions::interval)
      .def_rw("window", &AnalysisOptions::window)
      .def_rw("cutoff", &AnalysisOptions::cutoff)
      .def_rw("bin", &AnalysisOptions::bin)
      .def_rw("viscosity", &AnalysisOptions::viscosity)
      .def_rw("temperature", &AnalysisOptions::temperature)
      .def_rw("electrostatics", &AnalysisOptions::electrostatics)
      .def_rw("energies", &AnalysisOptions::energies)
      .def_rw("fit", &AnalysisOptions::fit);
  m.def("run", &run);
  m.def("energy", &energy, "config"_a, "derivative"_a, "message"_a.none());
  m.def("prepare", &prepare_start);
  m.def("minimise", &minimise_start);
  m.def("analyze", &analyze_trajectory, "trajectory"_a, "config"_a.none(), "molecules"_a, "names"_a,
        "analysis"_a, "prefix"_a, "plot"_a, "options"_a);
  m.def("convert", &convert_file, "source"_a, "target"_a, "names"_a, "particles"_a.none(),
        "every"_a, "first"_a.none(), "last"_a.none(), "options"_a);
  m.def("export_lammps", &export_lammps);
  m.def("advise", &advise);
  m.def("advise_nvt", &advise_nvt);
  m.def("tune_scheme", &tune_scheme);
  m.def("bench", &bench);
}

}  // namespace polhode::python
