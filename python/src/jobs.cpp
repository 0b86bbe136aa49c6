// SPDX-License-Identifier: MIT
// The jobs of the command line that compute and write files. Each job calls the same library
// function as the verb of the command line. Requests are passed as texts, as from the command line.
// The jobs return their reports as JSON.
#include <nanobind/stl/map.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include "base/instruction_set.hpp"
#include "bind.hpp"
#include "job_options.hpp"
#include "polhode/run/prepare/minimisation.hpp"
#include "polhode/run/prepare/preparation.hpp"
#include "polhode/run/simulation/simulation.hpp"
#include "polhode/run/simulation/system/single_point.hpp"
#include "run/adviser/advice_report.hpp"
#include "run/analysis/analysis_request.hpp"
#include "run/benchmark/benchmark.hpp"
#include "run/conversion/lammps_export.hpp"
#include "run/new_run_file.hpp"
#include "run/quantity_lists.hpp"
#include "run/requests.hpp"

namespace polhode::python {
namespace {

namespace nb = nanobind;
using namespace nb::literals;
// Functions for simulations follow.

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

std::string energy(const Config& config, bool gradient, nb::object message) {
  return Job(nb::none(), std::move(message)).run([&](const Callbacks& callbacks) {
    return report_text(quantities(single_point(config, gradient, callbacks)));
  });
}

std::string prepare_start(const Config& config, const JobOptions& options) {
  return options.run([&](const Callbacks& callbacks, Workers& workers) {
    return report_text(quantities(prepare(config, options.output, callbacks, workers)));
  });
}

std::string minimise_start(const Config& config, const Options& given, const JobOptions& options) {
  const auto settings = request_of<MinimisationRequest>(given).settings();
  return options.run([&](const Callbacks& callbacks, Workers& workers) {
    return report_text(
        quantities(minimise_configuration(config, settings, options.output, callbacks, workers)));
  });
}

std::string write_run_file(const std::string& kind, const std::string& file, const Options& given,
                           const JobOptions& options) {
  const auto request = request_of<NewRunFileRequest>(given);
  return options.run([&](const Callbacks& callbacks, Workers&) {
    return new_run_file(kind, file, request, callbacks);
  });
}

// Functions for trajectories follow.

nb::tuple analyze_trajectory(const std::string& trajectory, const Config* run, const Options& given,
                             const JobOptions& options) {
  const AnalysisInput input = analysis_input(request_of<AnalysisRequest>(given), trajectory, run);
  const AnalysisReport report = options.run([&](const Callbacks& callbacks, Workers& workers) {
    return run_analysis(input, options.output, callbacks, workers);
  });
  return nb::make_tuple(report_text(analysis_quantities(report)), report.files);
}

std::size_t convert_file(const std::string& from, const std::string& to, const Config* particles,
                         const Options& given, const JobOptions& options) {
  const Conversion conversion =
      request_of<ConversionRequest>(given).conversion(from, to, particles);
  return options.run([&](const Callbacks& callbacks, Workers&) {
    return convert(conversion, options.output, callbacks).frames;
  });
}

std::vector<std::string> export_lammps(const Config& config, const std::string& pair_style,
                                       const JobOptions& options) {
  const auto style = given_name<LammpsPairStyle>({pair_style, "pair_style"});
  return options.run([&](const Callbacks& callbacks, Workers&) {
    return export_to_lammps(config, style, options.output, callbacks);
  });
}

std::tuple<std::string, std::vector<std::string>, bool> study(const Config& config, bool quick,
                                                              const Options& given,
                                                              const JobOptions& options) {
  auto request = request_of<StudyRequest>(given);
  request.quick = quick;
  const auto tuple_of = [](const auto& report) {
    return std::tuple(report_text(quantities(report)), report.files, !report.interrupted);
  };
  return options.run([&](const Callbacks& callbacks, Workers& workers) {
    return perform_study(config, request, options.output, callbacks, workers, tuple_of);
  });
}

nb::tuple advise(const Config& config, const Options& given, bool schemes_given,
                 const JobOptions& options) {
  const auto request = request_of<AdviceRequest>(given);
  if (request.is_canonical()) {
    const auto length = given.find("length");
    const HybridAdviserSettings settings = request.hybrid_settings(
        config, schemes_given, length != given.end() ? Given{length->second, "length"} : Given{});
    const HybridAdvice advice = options.run([&](const Callbacks& callbacks, Workers& workers) {
      return advise_hybrid(config, settings, callbacks, workers);
    });
    if (!advice.stopped && advice.finalists.empty()) throw RunError(answer(advice));
    return nb::make_tuple(report_text(quantities(advice)), std::vector<std::string>{},
                          answer(advice));
  }
  const AdviserSettings settings = request.settings(config);
  const AdviceReport report = options.run([&](const Callbacks& callbacks, Workers& workers) {
    return run_adviser(config, settings, request.prefix(), options.output, callbacks, workers);
  });
  if (!report.advice.stopped && !report.advice.best)
    throw RunError(unreachable(report.advice, settings.criterion));
  return nb::make_tuple(report_text(quantities(report)), report.files.all(),
                        report.advice.stopped ? "" : answer(report.advice));
}

std::string tune_scheme(const Config& config, const Options& given, const JobOptions& options) {
  const TuneSettings settings = request_of<TuneRequest>(given).settings(config);
  return report_text(quantities(options.run([&](const Callbacks& callbacks, Workers& workers) {
    return tune(config, settings, callbacks, workers);
  })));
}

std::string bench(bool is_quick, const Options& given, const std::string& processor,
                  const JobOptions& options) {
  const BenchmarkSettings settings =
      request_of<BenchmarkRequest>(given).settings(is_quick, options.threads);
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
  m.def("new_run_file", &write_run_file);
  m.def("run", &run);
  m.def("energy", &energy, "config"_a, "gradient"_a, "message"_a.none());
  m.def("prepare", &prepare_start);
  m.def("minimise", &minimise_start);
  m.def("analyze", &analyze_trajectory, "trajectory"_a, "run"_a.none(), "given"_a, "options"_a);
  m.def("convert", &convert_file, "source"_a, "target"_a, "particles"_a.none(), "given"_a,
        "options"_a);
  m.def("export_lammps", &export_lammps);
  m.def("study", &study);
  m.def("advise", &advise);
  m.def("tune_scheme", &tune_scheme);
  m.def("bench", &bench);
}

}  // namespace polhode::python
