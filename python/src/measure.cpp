// SPDX-License-Identifier: MIT
// Measurements of properties. A Python executor may compute the replicas of a measurement.
#include <nanobind/stl/array.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "bind.hpp"
#include "job_options.hpp"
#include "run/properties/measure_request.hpp"

namespace polhode::python {
namespace {

namespace nb = nanobind;
using namespace nb::literals;
using Words = std::vector<std::string>;

MeasureSettings settings_of(const std::string& system, const Words& properties,
                            const Options& given) {
  auto request = request_of<MeasureRequest>(given);
  request.system = system;
  request.properties = properties;
  return request.settings();
}

nb::tuple as_tuple(const ReplicaTask& task) {
  std::vector<std::array<double, 3>> path;
  for (const CouplingStage& stage : task.path)
    path.push_back({stage.size, stage.charge, stage.next});
  return nb::make_tuple(task.point, task.replica, task.segments, task.step,
                        nb::bytes(task.record.data(), task.record.size()), path);
}

/// Makes an executor from a Python function. The function is called with a list of tasks and
/// returns their records as bytes.
ReplicaExecutor executor_of(const nb::object& function) {
  if (function.is_none()) return {};
  return [&function](const std::vector<ReplicaTask>& tasks) {
    const nb::gil_scoped_acquire held;
    nb::list list;
    for (const ReplicaTask& task : tasks) list.append(as_tuple(task));
    std::vector<std::string> records;
    for (const nb::handle record : function(list)) {
      const auto bytes = nb::cast<nb::bytes>(record);
      records.emplace_back(bytes.c_str(), bytes.size());
    }
    return records;
  };
}

nb::tuple measure(const std::string& system, const Words& properties, const Options& given,
                  bool only_evaluate, const nb::object& executor, const JobOptions& options) {
  MeasureSettings settings = settings_of(system, properties, given);
  settings.only_evaluate = only_evaluate;
  settings.command = options.output.command;
  const MeasureReport report = options.run([&](const Callbacks& callbacks, Workers& workers) {
    return polhode::measure(settings, callbacks, workers, executor_of(executor));
  });
  return nb::make_tuple(report_text(quantities(report)), report.files);
}

nb::bytes perform_replica(const std::string& system, const Words& properties, const Options& given,
                          std::size_t point, std::uint64_t replica,
                          const std::vector<std::size_t>& segments, double step,
                          const nb::bytes& record, const std::vector<std::array<double, 3>>& path) {
  const MeasureSettings settings = settings_of(system, properties, given);
  ReplicaTask task{.point = point,
                   .replica = replica,
                   .segments = segments,
                   .step = step,
                   .record = std::string(record.c_str(), record.size())};
  for (const auto& [size, charge, next] : path) task.path.push_back({size, charge, next});
  const std::string after = [&] {
    const nb::gil_scoped_release released;
    return perform(settings, task);
  }();
  return nb::bytes(after.data(), after.size());
}

}  // namespace

void bind_measure(nb::module_& m) {
  m.def("measure", &measure, "system"_a, "properties"_a, "given"_a, "only_evaluate"_a,
        "executor"_a.none(), "options"_a);
  m.def("perform_replica", &perform_replica);
}

}  // namespace polhode::python
