// SPDX-License-Identifier: MIT
// polhode._core: the library for the Python package. Work is done without the interpreter's lock.
#include <nanobind/stl/string.h>

#include "base/instruction_set.hpp"
#include "base/version.hpp"
#include "bind.hpp"

NB_MODULE(_core, m) {
  using namespace polhode;
  python::translate_errors();
  m.attr("version") = version();
  m.def("instruction_set", [] { return std::string(name(current_instruction_set())); });
  python::bind_config(m);
  python::bind_simulation(m);
  python::bind_jobs(m);
  python::bind_measure(m);
  python::bind_lookup(m);
  python::bind_top(m);
  python::bind_frames(m);
}
