// SPDX-License-Identifier: MIT
// Python functions for a simulation in memory: steps, views of its state, energies, checkpoints.
#include "polhode/run/simulation/simulation.hpp"

#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <atomic>
#include <mutex>

#include "arrays.hpp"
#include "bind.hpp"
#include "io/settings/output_units.hpp"
#include "job.hpp"
#include "polhode/run/simulation/files/energy_file.hpp"
#include "run/listing/lists.hpp"
#include "run/quantity_lists.hpp"

namespace polhode::python {
namespace {

namespace nb = nanobind;
using namespace nb::literals;

/// Marks a simulation as being used by one thread.
class InUse {
 public:
  explicit InUse(std::atomic<bool>& flag) : flag_(flag) {
    if (flag_.exchange(true))
      throw Error(
          "the simulation is in use by another thread or by a callback of this simulation; wait "
          "until its current call has returned, or use another simulation");
  }
  ~InUse() { flag_ = false; }
  InUse(const InUse&) = delete;
  InUse& operator=(const InUse&) = delete;

 private:
  std::atomic<bool>& flag_;
};

struct OwnedSimulation {
  OwnedSimulation(const Config& config, int threads)
      : workers(threads), simulation(config, workers) {}

  Workers workers;
  Simulation simulation;
  std::atomic<bool> in_use = false;
  std::vector<double> samples;         // rows of energies since the last call of take_energies()
  std::optional<State> before_change;  // state before a change, while the state may be changed

  DegreesOfFreedom degrees_of_freedom() const {
    return polhode::degrees_of_freedom(simulation.system().topology);
  }
};

/// A row of numbers for an energy sample; the last number is the energy of external forces.
std::vector<double> row_of(const Energies& energies, const DegreesOfFreedom& n) {
  const auto row = energy_row(energies, n);
  std::vector<double> all(row.begin(), row.end() - 1);  // the row without the time-step error
  all.push_back(energies.external);
  return all;
}

/// Advances a simulation.
/// @return  false if the simulation was interrupted
bool advance(OwnedSimulation& s, std::size_t steps, bool keep_energies, nb::object progress,
             nb::object message) {
  const InUse use(s.in_use);
  const DegreesOfFreedom n = s.degrees_of_freedom();
  return Job(std::move(progress), std::move(message)).run([&](Callbacks callbacks) {
    if (keep_energies)
      callbacks.sample = [&](std::size_t, const State&, const Energies& energies) {
        const std::vector<double> row = row_of(energies, n);
        s.samples.insert(s.samples.end(), row.begin(), row.end());
      };
    return s.simulation.step(steps, callbacks);
  });
}

template <std::size_t n, class Value>
nb::object view(Value* data, const Components<n>& columns, const nb::object& owner) {
  return nb::cast(nb::ndarray<nb::numpy, Value, nb::ndim<2>>(
      data, {columns.size(), n}, owner, {1, static_cast<std::int64_t>(columns.stride())}));
}

template <std::size_t n>
nb::object view(const Components<n>& columns, const nb::object& owner) {
  return view(columns.component(0).data(), columns, owner);
}

template <std::size_t n>
nb::object writable(Components<n>& columns, const nb::object& owner) {
  return view(columns.component(0).data(), columns, owner);
}

using SimulationPointer = nb::pointer_and_handle<OwnedSimulation>;

template <class Member>
auto view_of(Member State::*member) {
  return [member](SimulationPointer s) {
    return view(s.p->simulation.state().*member, nb::borrow(s.h));
  };
}

/// Begins a change of the state, and returns writable views of positions, momenta, orientations and
/// angular momenta.
nb::tuple begin_change(SimulationPointer s) {
  const InUse use(s.p->in_use);
  if (s.p->before_change)
    throw Error(
        "the state is already being changed in another 'with' block; leave that block first");
  s.p->before_change = s.p->simulation.state();
  State& state = s.p->simulation.state_to_change();
  const nb::object owner = nb::borrow(s.h);
  return nb::make_tuple(writable(state.q, owner), writable(state.p, owner),
                        writable(state.orientation, owner), writable(state.ell, owner));
}

/// Ends a change of the state.
/// @param keep  false to restore the state before the change
void end_change(OwnedSimulation& s, bool keep) {
  const InUse use(s.in_use);
  if (!s.before_change)
    throw Error("no change of the state is in progress; use 'with state.change()'");
  const State before = *std::exchange(s.before_change, std::nullopt);
  if (!keep) return void(s.simulation.state_to_change() = before);
  try {
    s.simulation.state_changed();
  } catch (...) {
    s.simulation.state_to_change() = before;
    throw;
  }
}

/// Returns the forces (n, 3) and torques (n, 3) at the current positions.
nb::tuple forces(OwnedSimulation& s) {
  const InUse use(s.in_use);
  const System& system = s.simulation.system();
  Load load;
  {
    const nb::gil_scoped_release released;
    ForceField field(system.topology, system.forces, system.state.box, s.workers);
    field(system.state, load);
  }
  return nb::make_tuple(rows_of(load.f), rows_of(load.tau));
}

/// Returns positions and velocities of all sites, with whole molecules.
nb::tuple sites(const OwnedSimulation& s, bool massless) {
  const System& system = s.simulation.system();
  std::vector<double> r, v;
  each_atom(system.state, system.topology, massless ? MasslessSites::keep : MasslessSites::omit,
            [&](const Atom& atom) {
              r.insert(r.end(), {atom.r.x, atom.r.y, atom.r.z});
              v.insert(v.end(), {atom.v.x, atom.v.y, atom.v.z});
            });
  const std::size_t n = r.size() / 3;
  return nb::make_tuple(array_of(std::move(r), {n, 3}), array_of(std::move(v), {n, 3}));
}

/// The molecules of all parts of the topology, as JSON.
std::string kinds_json(const OwnedSimulation& s) {
  std::vector<Molecule> molecules;
  for (const auto& part : s.simulation.system().topology.parts) molecules.push_back(part.molecule);
  return json_text(records(molecules));
}

/// Returns (molecule, count) for each part of the topology.
nb::list parts(const OwnedSimulation& s) {
  nb::list list;
  for (const auto& [molecule, count] : s.simulation.system().topology.parts)
    list.append(nb::make_tuple(molecule.name, count));
  return list;
}

void write_state(const OwnedSimulation& s, const std::string& path, bool massless,
                 bool velocities) {
  const System& system = s.simulation.system();
  const FrameChoice choice{massless ? MasslessSites::keep : MasslessSites::omit, velocities};
  check_fit(path, system.state, system.topology, choice);
  create_frames(path, system.topology, choice)->write(system.state);
}

void bind_state(nb::class_<OwnedSimulation>& c) {
  c.def_prop_ro("positions", view_of(&State::q))
      .def_prop_ro("momenta", view_of(&State::p))
      .def_prop_ro("orientations", view_of(&State::orientation))
      .def_prop_ro("angular_momenta", view_of(&State::ell))
      .def_prop_ro("box",
                   [](const OwnedSimulation& s) {
                     const Vec3<double>& edge = s.simulation.state().box.edge;
                     return array_of<double>({edge.x, edge.y, edge.z}, {3});
                   })
      .def_prop_ro("time", [](const OwnedSimulation& s) { return s.simulation.state().time; })
      .def_prop_ro("molecules",
                   [](const OwnedSimulation& s) { return s.simulation.state().size(); })
      .def_prop_ro("masses",
                   [](SimulationPointer s) {
                     const Bodies& bodies = s.p->simulation.system().bodies;
                     return nb::cast(nb::ndarray<nb::numpy, const double, nb::ndim<1>>(
                         bodies.m.data(), {bodies.size()}, nb::borrow(s.h)));
                   })
      .def_prop_ro("moments",
                   [](SimulationPointer s) {
                     return view(s.p->simulation.system().bodies.J, nb::borrow(s.h));
                   })
      .def("begin_change", &begin_change)
      .def("end_change", &end_change)
      .def("sites", &sites)
      .def("parts", &parts)
      .def("kinds_json", &kinds_json)
      .def("write", &write_state);
}

void bind_steps(nb::class_<OwnedSimulation>& c) {
  c.def_prop_ro("steps", [](const OwnedSimulation& s) { return s.simulation.steps(); })
      .def("steps_in", [](const OwnedSimulation& s, double t) { return s.simulation.steps_in(t); })
      .def("steps_left", [](const OwnedSimulation& s) { return s.simulation.steps_left(); })
      .def("change",
           [](OwnedSimulation& s, const Config& config) {
             const InUse use(s.in_use);
             s.simulation.change(config.integrator, config.ensemble);
           })
      .def_prop_ro("config", [](const OwnedSimulation& s) { return s.simulation.config(); })
      .def("save",
           [](OwnedSimulation& s, const std::string& path, const std::string& command) {
             const InUse use(s.in_use);
             const nb::gil_scoped_release released;
             s.simulation.save(path, command);
           })
      .def("resume", [](OwnedSimulation& s, const std::string& path) {
        const InUse use(s.in_use);
        const nb::gil_scoped_release released;
        s.simulation.resume(path);
      });
}

}  // namespace

void bind_simulation(nb::module_& m) {
  nb::class_<OwnedSimulation> c(m, "Simulation", nb::is_weak_referenceable());
  c.def(nb::init<const Config&, int>(), nb::call_guard<nb::gil_scoped_release>())
      .def("step", &advance, "steps"_a, "keep_energies"_a, "progress"_a.none(), "message"_a.none())
      .def(
          "choose_step",
          [](OwnedSimulation& s, nb::object progress, nb::object message) {
            const InUse use(s.in_use);
            return Job(std::move(progress), std::move(message))
                .run([&](const Callbacks& callbacks) {
                  return s.simulation.choose_step(callbacks);
                });
          },
          "progress"_a.none(), "message"_a.none())
      .def("take_energies",
           [](OwnedSimulation& s) {
             const InUse use(s.in_use);
             std::vector<double> rows = std::exchange(s.samples, {});
             const std::size_t columns = energy_columns().size() + 1, n = rows.size() / columns;
             return array_of(std::move(rows), {n, columns});
           })
      .def("energies",
           [](OwnedSimulation& s) {
             const InUse use(s.in_use);
             const nb::gil_scoped_release released;
             return row_of(s.simulation.energies(), s.degrees_of_freedom());
           })
      .def("report",
           [](OwnedSimulation& s) {
             const InUse use(s.in_use);
             const nb::gil_scoped_release released;
             const Quantities results = run_quantities(s.simulation.report());
             return json_text(flattened(results), text_rows(results));
           })
      .def("forces", &forces);
  bind_state(c);
  bind_steps(c);
  m.def("energy_columns", [] {
    std::vector<std::pair<std::string, std::string>> names;
    for (const Table::Column& column : energy_columns())
      names.emplace_back(column.name, column.unit);
    return names;
  });
}

}  // namespace polhode::python
