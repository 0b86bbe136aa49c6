// SPDX-License-Identifier: MIT
#include "config.hpp"

#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>

#include "bind.hpp"
#include "polhode/base/threads.hpp"
#include "polhode/io/embedded.hpp"
#include "polhode/io/run_file_template.hpp"
#include "polhode/run/simulation/system.hpp"

namespace polhode::python {

namespace nb = nanobind;
using namespace nb::literals;

void bind_config(nb::module_& m) {
  nb::class_<Config>(m, "Config", nb::dynamic_attr())
      .def(nb::init<const Config&>())
      .def_ro("source", &Config::source)
      .def_ro("text", &Config::text)
      .def_prop_rw(
          "prefix", [](const Config& c) { return c.output.prefix; },
          [](Config& c, const std::string& prefix) { c.output.prefix = prefix; })
      .def_prop_ro("step", [](const Config& c) { return c.integrator.step; })
      .def_prop_ro("length", [](const Config& c) { return c.run.length; })
      .def_prop_ro("sample", [](const Config& c) { return c.run.sample; })
      .def("set_forces",
           [](Config& c, const nb::callable& function, const std::string& name, bool has_virial) {
             c.forces.external = external_forces(function, name, has_virial);
           });
  m.def("read_config", &read_config, "path"_a);
  m.def("parse_config",
        [](const std::string& text, const std::string& file) { return parse_config(text, file); });
  m.def("default_config", &default_config);
  m.def("default_text", [] { return std::string(embedded_text("runs/default.toml").value()); });
  m.def("run_file_template",
        [](const std::string& kind) { return std::string(run_file_template(kind)); });
  m.def(
      "threads", [](std::optional<int> threads) { return requested_threads(threads); },
      "threads"_a = nb::none());
}

}  // namespace polhode::python
