// SPDX-License-Identifier: MIT
// The settings of a run file, with forces that are Python functions.
#include <fmt/core.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "arrays.hpp"
#include "base/threads.hpp"
#include "bind.hpp"
#include "io/settings/config_parts.hpp"
#include "io/settings/quantity.hpp"
#include "io/settings/settings.hpp"
#include "polhode/base/error.hpp"
#include "polhode/run/simulation/system/system.hpp"
#include "run/job_settings.hpp"
#include "run/listing/lists.hpp"

namespace polhode::python {

namespace nb = nanobind;
using namespace nb::literals;

namespace {

using Array = nb::ndarray<const double, nb::c_contig, nb::device::cpu>;

/// A weak reference to a Python object; any thread may drop the reference. The only strong
/// reference is an attribute of another Python object. A function may refer to the simulation that
/// calls it, and Python's garbage collector finds only reference cycles of Python objects.
struct Reference {
  nb::object weak;
  explicit Reference(const nb::object& object) : weak(nb::weakref(object)) {}
  Reference(const Reference&) = delete;
  Reference& operator=(const Reference&) = delete;
  ~Reference() {
    if (!Py_IsInitialized()) {
      weak.release();
      return;
    }
    const nb::gil_scoped_acquire acquired;
    weak.reset();
  }
};

void add_rows(const Array& rows, Vec3Column& to) {
  const double* const x = rows.data();
  for (std::size_t i = 0; i < to.size(); ++i) to.add(i, {x[3 * i], x[3 * i + 1], x[3 * i + 2]});
}

void add_result(const nb::tuple& result, Load& load) {
  add_rows(nb::cast<Array>(result[0]), load.f);
  add_rows(nb::cast<Array>(result[1]), load.tau);
  load.external += nb::cast<double>(result[2]);
  if (result[3].is_none()) return;
  const auto virial = nb::cast<Array>(result[3]);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) load.virial[i][k] += virial.data()[3 * i + k];
}

/// Makes external forces from a Python function. The function is called with copies of the
/// positions (n, 3) [nm], orientations (n, 4) and box (3) [nm]. The function returns forces (n, 3),
/// torques (n, 3), an energy, and a virial (3, 3) or None, as checked arrays of doubles. The
/// reference to the function is weak, so the caller must keep the function alive.
/// @param name  name as in ExternalForces
std::shared_ptr<const ExternalForces> external_forces(const nb::callable& function,
                                                      const std::string& name, bool has_virial) {
  const auto reference = std::make_shared<Reference>(function);
  ExternalForces forces{.name = name, .has_virial = has_virial};
  forces.add = [reference, name](const State& state, Load& load) {
    const nb::gil_scoped_acquire acquired;
    const nb::object called = reference->weak();
    if (called.is_none())
      throw Error(
          fmt::format("the external forces '{}' no longer exist; keep a reference to the settings "
                      "that contain these forces",
                      name));
    const Vec3<double>& edge = state.box.edge;
    const nb::object result = called(rows_of(state.q), rows_of(state.orientation),
                                     nb::make_tuple(edge.x, edge.y, edge.z));
    add_result(nb::cast<nb::tuple>(result), load);
  };
  return std::make_shared<const ExternalForces>(std::move(forces));
}

/// The type of a thermostat or barostat; empty if there is none.
std::optional<std::string> type_of(const std::string& table, const Config& config) {
  const std::string type = value_text(setting(table + ".type"), config);
  return type.empty() ? std::nullopt : std::optional(type);
}

std::optional<double> kept_temperature(const Config& config) {
  return config.ensemble.constant_energy() ? std::nullopt
                                           : std::optional(config.ensemble.temperature);
}

std::optional<double> pressure_in_bar(const Config& config) {
  const auto& barostat = config.ensemble.barostat;
  return barostat ? std::optional(barostat->pressure / unit("bar", Dimension::pressure))
                  : std::nullopt;
}

/// All settings as tuples (table, key, kinds of the value).
std::vector<std::tuple<std::string, std::string, std::vector<std::string>>> keys() {
  std::vector<std::tuple<std::string, std::string, std::vector<std::string>>> all;
  for (const auto& [name, kind] : setting_table_names())
    all.emplace_back("", name, std::vector{std::string(name_of(kind))});
  for (const Setting& one : settings()) {
    std::vector<std::string> kinds;
    for (const SettingKind kind : one.kinds) kinds.emplace_back(name_of(kind));
    all.emplace_back(one.table, one.key, std::move(kinds));
  }
  return all;
}

/// A configuration whose run file text also contains the overlay.
Config with_text(Config config, const Overlay& overlay) {
  config.text = overlaid_text(config.text, config.source, overlay);
  return config;
}

/// For each option of a job that sets a run file setting, the key of this setting.
std::map<std::string, std::string> keys_of_job(const std::string& job) {
  std::map<std::string, std::string> keys;
  for (const JobSetting& setting : settings_of_job(job)) keys[setting.name] = setting.key;
  return keys;
}

/// Binds the readers of run files. Keywords become an overlay.
void bind_readers(nb::module_& m) {
  nb::class_<Overlay>(m, "Overlay")
      .def(
          "__init__",
          [](Overlay* self, const std::string& job, bool quick) {
            new (self) Overlay(overlay_of_job(job, quick));
          },
          "job"_a, "quick"_a)
      .def(
          "add",
          [](Overlay& self, const std::string& key, const std::string& toml,
             const std::string& place) {
            self.settings.push_back({key, {}, place, toml});
          },
          "key"_a, "toml"_a, "place"_a);
  m.def("read_config", [](const std::string& path, const Overlay& overlay) {
    return with_text(read_config(path, overlay), overlay);
  });
  m.def("parse_config",
        [](const std::string& text, const std::string& file, const Overlay& overlay) {
          return with_text(parse_config(text, file, overlay), overlay);
        });
  m.def("default_config",
        [](const Overlay& overlay) { return with_text(default_config(overlay), overlay); });
  m.def("job_settings", &keys_of_job);
}

}  // namespace

void bind_config(nb::module_& m) {
  nb::class_<Config>(m, "Config", nb::dynamic_attr())
      .def_ro("text", &Config::text)
      .def_ro("notes", &Config::notes)
      .def_prop_ro("step", [](const Config& c) { return c.integrator.step; })
      .def_prop_ro("scheme", [](const Config& c) { return c.integrator.scheme.text; })
      .def_prop_ro("kept_temperature", &kept_temperature)
      .def_prop_ro("pressure", &pressure_in_bar)
      .def_prop_ro("thermostat", [](const Config& c) { return type_of("thermostat", c); })
      .def_prop_ro("barostat", [](const Config& c) { return type_of("barostat", c); })
      .def_prop_ro("length", [](const Config& c) { return c.run.length; })
      .def_prop_ro("sample", [](const Config& c) { return c.run.sample; })
      .def("set_forces",
           [](Config& c, const nb::callable& function, const std::string& name, bool has_virial) {
             c.forces.external = external_forces(function, name, has_virial);
           });
  bind_readers(m);
  m.def("setting_keys", &keys);
  m.def(
      "settings_json",
      [](const std::string& name, const Config* config) { return settings_json(name, config); },
      "name"_a, "config"_a.none());
  m.def(
      "threads", [](std::optional<int> threads) { return requested_threads(threads); },
      "threads"_a = nb::none());
}

}  // namespace polhode::python
