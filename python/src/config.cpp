// SPDX-License-Identifier: MIT
#include "config.hpp"

#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "base/threads.hpp"
#include "bind.hpp"
#include "io/settings/config_parts.hpp"
#include "io/settings/quantity.hpp"
#include "io/settings/settings.hpp"
#include "polhode/run/simulation/system/system.hpp"
#include "run/job_settings.hpp"
#include "run/listing/lists.hpp"

namespace polhode::python {

namespace nb = nanobind;
using namespace nb::literals;

namespace {

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
      .def(nb::init<const Config&>())
      .def_ro("source", &Config::source)
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
