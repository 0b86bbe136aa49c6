// SPDX-License-Identifier: MIT
#include <nanobind/stl/string.h>

#include <filesystem>
#include <string>

#include "base/output_error.hpp"
#include "bind.hpp"

namespace polhode::python {
namespace {

namespace nb = nanobind;

/// Raises the exception polhode.errors.NAME with these arguments.
template <class... Arguments>
void raise(const char* name, const Arguments&... arguments) {
  try {
    const nb::object type = nb::module_::import_("polhode.errors").attr(name);
    const nb::object error = type(arguments...);
    PyErr_SetObject(type.ptr(), error.ptr());
  } catch (nb::python_error& e) {
    e.restore();
  }
}

void translate(const std::exception_ptr& thrown, void*) {
  try {
    std::rethrow_exception(thrown);
  } catch (const OutputError& e) {
    raise("OutputError", e.what(), e.where(), e.resumable());
  } catch (const Error& e) {
    raise("Error", e.what(), e.where());
  } catch (const std::filesystem::filesystem_error& e) {
    raise("Error", e.code().message(), e.path1().string());
  } catch (const RunError& e) {
    raise("RunError", e.what());
  }
}

}  // namespace

void translate_errors() { nb::register_exception_translator(translate); }

}  // namespace polhode::python
