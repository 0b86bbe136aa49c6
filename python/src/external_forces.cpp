// SPDX-License-Identifier: MIT
#include <fmt/core.h>
#include <nanobind/ndarray.h>

#include <algorithm>
#include <array>
#include <memory>

#include "config.hpp"
#include "polhode/base/error.hpp"

namespace polhode::python {
namespace {

namespace nb = nanobind;
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

/// A new NumPy array with the rows of some columns.
template <std::size_t n>
nb::object rows_of(const Components<n>& columns) {
  const std::size_t size = columns.size();
  auto* const data = new double[std::max<std::size_t>(size * n, 1)];
  const nb::capsule owner(data, [](void* p) noexcept { delete[] static_cast<double*>(p); });
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = 0; const double x : columns.component(k)) data[n * i++ + k] = x;
  return nb::cast(nb::ndarray<nb::numpy, double>(data, {size, n}, owner));
}

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

}  // namespace

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

}  // namespace polhode::python
