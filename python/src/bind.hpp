// SPDX-License-Identifier: MIT
// The parts of the module `polhode._core`. Each bind function declares the Python functions of one
// subject. The Python files that call these functions contain their documentation.
#pragma once

#include <nanobind/nanobind.h>

namespace polhode::python {

void bind_config(nanobind::module_& m);
void bind_simulation(nanobind::module_& m);
void bind_jobs(nanobind::module_& m);
void bind_measure(nanobind::module_& m);
void bind_lookup(nanobind::module_& m);
void bind_top(nanobind::module_& m);
void bind_frames(nanobind::module_& m);

/// Translates Error, OutputError and RunError to the exceptions of polhode.errors.
void translate_errors();

}  // namespace polhode::python
