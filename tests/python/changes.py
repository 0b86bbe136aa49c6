# SPDX-License-Identifier: MIT
"""Assignments: each works, or is refused with what to do; settings that change between steps begin a segment."""

import math
import os
import pickle
import tempfile
import unittest

import numpy as np
import polhode

import package
from package import WATER
from simulation import bits

LANGEVIN = dict(thermostat="langevin", friction="2 1/ps")


class Refused(unittest.TestCase):
    """Nothing that is assigned is without effect."""

    def refused(self, thing, name, value, *words):
        with self.assertRaises(AttributeError) as caught:
            setattr(thing, name, value)
        for word in words:
            self.assertIn(word, str(caught.exception))

    def test_a_simulation(self):
        s = polhode.Simulation(WATER)
        method = s.step
        self.refused(s, "step", "1 fs", "time_step")
        self.refused(s, "run", 1, "method")
        self.refused(s, "temprature", "400 K", "did you mean 'temperature'")
        self.refused(s, "cutoff", "0.5 nm", "polhode.Simulation(simulation.settings, cutoff=...)")
        self.refused(s, "friction", "1 1/ps", "simulation.change(friction=...)")
        self.refused(s, "state", s.state, "change()")
        self.refused(s, "masses", np.ones(64))
        self.refused(s, "last_run", None)
        self.assertEqual(s.step, method)

    def test_a_state(self):
        s = polhode.Simulation(WATER)
        self.refused(s.state, "positions", s.state.positions + 1, "change()")
        self.refused(s.state, "momentum", 0, "did you mean 'momenta'")
        before = bits(s)
        for name in ("momentum", "velocities", "box", "time"):
            with self.assertRaises(AttributeError):
                with s.state.change() as state:
                    setattr(state, name, 0)
        self.assertEqual(bits(s), before)

    def test_what_tells(self):
        s = polhode.Simulation(WATER)
        run = s.run("20 fs")
        settings = s.settings
        self.refused(settings, "step", "1 fs", "polhode.settings(these")
        self.refused(settings, "tables", {})
        with self.assertRaises(TypeError):
            settings.tables["integrator"]["step"] = "1 fs"
        for thing, name in ((run, "frames"), (run, "R"), (run.energies, "array"), (run.energies, "total"),
                            (s.summary, "R"), (s.summary, "data"), (polhode.Scheme("hoa2"), "order"),
                            (polhode.molecules("tip4p"), "mass"), (polhode.molecules("tip4p"), "moments"),
                            (polhode.ExternalForces(lambda q, a: None), "virial")):
            self.refused(thing, name, 1)
        self.refused(polhode.Frame(np.zeros((2, 3))), "velocity", 1, "did you mean 'velocities'")

    def test_names_of_energies(self):
        s = polhode.Simulation(WATER)
        for where in (s.energies, s.run("20 fs").energies):
            with self.assertRaisesRegex(KeyError, "did you mean 'total'"):
                where["totl"]
        with self.assertRaisesRegex(KeyError, "did you mean"):
            s.summary["step"]


class OfTheState(unittest.TestCase):
    def test_an_assignment_copies(self):
        s, other = polhode.Simulation(WATER), polhode.Simulation(WATER)
        new = s.state.positions + [0.1, 0, 0]
        with s.state.change() as state:
            state.positions = new
            state.momenta *= 0.5
        self.assertTrue((s.state.positions == new).all())
        with other.state.change() as state:
            state.positions[...] = new
            state.momenta[...] *= 0.5
        self.assertEqual(bits(s), bits(other))
        new[...] = 7  # a copy was made
        self.assertLess(np.abs(s.state.positions).max(), 7)

    def test_a_wrong_shape_is_refused_and_leaves_the_state(self):
        s = polhode.Simulation(WATER)
        before = bits(s)
        for name, shape in (("positions", (5, 3)), ("positions", (3,)), ("momenta", ()), ("orientations", (64, 3))):
            with self.assertRaisesRegex(polhode.Error, "has the shape"):
                with s.state.change() as state:
                    setattr(state, name, np.zeros(shape))
        self.assertEqual(bits(s), before)


    def test_an_old_name_tells_the_new_one(self):
        s = polhode.Simulation(WATER)
        with self.assertRaisesRegex(AttributeError, "State.attitudes is called orientations"):
            s.state.attitudes
        with self.assertRaisesRegex(AttributeError, "is called orientations"):
            with s.state.change() as state:
                state.attitudes = np.zeros((64, 4))


class OfSettings(unittest.TestCase):
    def test_before_the_first_step_it_is_the_same_simulation(self):
        s, made = polhode.Simulation(WATER), polhode.Simulation(WATER, scheme="velocity-verlet", step="1 fs")
        s.scheme, s.time_step = "velocity-verlet", "1 fs"
        s.step(5), made.step(5)
        self.assertEqual(bits(s), bits(made))
        self.assertEqual(s.summary.segment["number"], 1)

    def test_steps_after_a_change_are_those_of_the_new_settings(self):
        """Against a new simulation with this state: the same bits at constant energy, where nothing else is remembered."""
        for change in ({"step": "1 fs"}, {"scheme": "gier4-fd"}, {"scheme": "velocity-verlet", "step": "0.5 fs"},
                       {"scheme": "velocity-verlet / hoa2 x 2 within 0.35 to 0.5 nm"}):
            s = polhode.Simulation(WATER)
            s.step(7)
            try:
                s.change(**change)
            except polhode.Error as e:
                self.fail(f"{change}: {e}")
            other = polhode.Simulation(WATER, **change)
            with other.state.change() as state:
                for name in ("positions", "momenta", "orientations", "angular_momenta"):
                    setattr(state, name, getattr(s.state, name))
            # The list of neighbours is older in one of them, so sums of forces are in another order: rounding.
            s.step(3), other.step(3)
            self.assertLess(np.abs(s.state.positions - other.state.positions).max(), 1e-12, change)

    def test_time_and_length_count_on(self):
        s = polhode.Simulation(WATER, length="40 fs")
        s.step(10)
        s.time_step = "1 fs"
        s.step(4)
        self.assertAlmostEqual(s.time, 0.024, 12)
        segment = s.summary.segment
        self.assertEqual((segment["number"], segment["first_step"]), (2, 10))
        self.assertAlmostEqual(segment["earlier_ps"], 0.02, 12)
        self.assertEqual(segment["changes"], "integrator.step was 2 fs and is now 1 fs")
        self.assertEqual(s.summary.steps, 4)
        self.assertAlmostEqual(s.summary.length_ps, 0.004, 12)
        self.assertEqual(s.summary.step_fs, 1)
        s.run()  # what remains of 40 fs
        self.assertAlmostEqual(s.time, 0.04, 12)
        self.assertEqual(s.steps, 30)
        with self.assertRaisesRegex(polhode.Error, "give the length"):
            s.run()

    def test_statistics_are_those_of_the_segment(self):
        s = polhode.Simulation(WATER, scheme="velocity-verlet", step="4 fs", sample="4 fs")
        s.run("0.4 ps")
        s.time_step = "1 fs"
        run = s.run("0.4 ps")
        self.assertAlmostEqual(s.summary.R, run.ratio, delta=1e-9)
        self.assertEqual(s.summary.samples, len(run.energies))
        # R is of order h²: a sixteenth. R over both parts would be above a half of the first.
        s.change(step="4 fs")
        self.assertLess(run.ratio, s.run("0.4 ps").ratio / 8)

    def test_a_thermostat_is_set_changed_and_left_out(self):
        s = polhode.Simulation(WATER)
        self.assertEqual((s.thermostat, s.temperature, s.barostat, s.pressure), (None, None, None, None))
        s.step(2)
        with self.assertRaisesRegex(polhode.Error, "constant energy"):
            s.temperature = "400 K"
        s.thermostat = {"type": "langevin", "friction": "50 1/ps"}
        s.temperature = "400 K"
        self.assertEqual((s.thermostat, s.temperature), ("langevin", 400))
        s.step(1)
        self.assertIn("thermostat.type was none and is now langevin", s.summary.segment["changes"])
        self.assertIn("system.temperature was 297 K and is now 400 K", s.summary.segment["changes"])
        self.assertEqual(s.settings.tables["system"]["temperature"], "400 K")
        s.thermostat = "rescaling"  # without the friction of the other
        s.step(1)
        s.thermostat = None
        before = s.energies["total"]
        s.step(20)
        self.assertLess(abs(s.energies["total"] - before), abs(0.01 * before))  # it is conserved again
        self.assertIsNone(s.temperature)

    def test_the_temperature_is_reached(self):
        """Strong friction for 1 ps: the momenta are those of the new temperature, T sqrt(2/n) for n = 6 · 64 − 3 degrees
        of freedom at one time; means of 20 samples at least 5 velocity correlation times apart, within 5 errors."""
        s = polhode.Simulation(WATER, step="2 fs", thermostat={"type": "langevin", "friction": "50 1/ps"}, precision="mixed")
        s.step(5)
        s.temperature = "400 K"
        s.step(500)
        T = []
        for _ in range(20):
            s.step(50)
            T.append(s.energies["temperature"])
        error = 400 * math.sqrt(2 / 381) / math.sqrt(20)
        self.assertLess(abs(np.mean(T) - 400), 5 * error)

    def test_a_pressure_and_a_barostat(self):
        s = polhode.Simulation(WATER, **LANGEVIN)
        s.step(2)
        s.pressure = "10 bar"
        self.assertEqual((s.barostat, s.thermostat), ("cell-rescaling", "langevin"))
        self.assertAlmostEqual(s.pressure, 10, 9)
        s.barostat = "monte-carlo"
        self.assertAlmostEqual(s.pressure, 10, 9)
        s.change(barostat={"type": "monte-carlo", "pressure": "1 bar", "every": "4 fs"})
        edge = s.state.box[0]
        s.step(40)
        self.assertNotEqual(s.state.box[0], edge)
        self.assertEqual(s.summary.ensemble["barostat"]["moves"], 20)

    def test_a_change_that_does_not_fit_changes_nothing(self):
        s = polhode.Simulation(WATER, **LANGEVIN)
        s.step(3)
        for change in ({"cutoff": "0.5 nm"}, {"step": "-1 fs"}, {"step": "1 nm"}, {"scheme": "giere4"}, {"temperature": "-1 K"},
                       {"thermostat": "none", "temperature": "400 K"}, {"hybrid_steps": 4}, {"seed": 4}, {"nonsense": 1},
                       {"scheme": "hoa2", "step": 2}):
            with self.assertRaises(polhode.Error, msg=change):
                s.change(**change)
        self.assertEqual((s.scheme, s.time_step, s.temperature), ("hoa2", 0.002, 297))
        other = polhode.Simulation(WATER, **LANGEVIN)
        other.step(3)
        s.step(3), other.step(3)
        self.assertEqual(bits(s), bits(other))
        self.assertEqual(s.summary.segment["number"], 1)

    def test_hybrid_monte_carlo_keeps_whole_trajectories(self):
        s = polhode.Simulation(WATER, hybrid_steps=4, sample="8 fs")
        s.run("18 fs")  # rounded up to whole trajectories
        self.assertEqual(s.steps, 12)
        s.temperature, s.time_step = "310 K", "1 fs"
        run = s.run("10 fs", observe=lambda s: None, every="3 fs")
        self.assertEqual(s.steps, 24)
        self.assertEqual(s.summary.ensemble["hybrid_monte_carlo"]["trajectories"], 3)
        self.assertEqual(len(run.energies), 2)

    def test_checkpoints_of_a_changed_simulation(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "a.bin")
            s = polhode.Simulation(WATER, **LANGEVIN)
            s.step(5)
            s.change(temperature="350 K", step="1 fs", scheme="velocity-verlet")
            s.step(3)
            s.save(path)
            made = polhode.Simulation(pickle.loads(pickle.dumps(s.settings)))
            made.resume(path)
            s.step(6), made.step(6)
            self.assertEqual(bits(s), bits(made))
            self.assertEqual(made.time, s.time)
            self.assertEqual(made.summary.segment, s.summary.segment)
            with self.assertRaisesRegex(polhode.Error, "integrator.step was 1 fs and is now 2 fs"):
                polhode.Simulation(WATER, **LANGEVIN).resume(path)

    def test_changes_while_it_runs_are_refused_and_between_observations_work(self):
        s = polhode.Simulation(WATER, **LANGEVIN)
        temperatures = iter(("310 K", "320 K", "330 K"))
        s.run("8 fs", observe=lambda s: setattr(s, "temperature", next(temperatures)), every="4 fs")
        self.assertEqual(s.temperature, 330)
        with self.assertRaisesRegex(polhode.Error, "in use"):
            s.run("4 ps", progress=lambda *_: s.change(temperature="300 K"))


if __name__ == "__main__":
    package.main()
