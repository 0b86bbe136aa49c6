# SPDX-License-Identifier: MIT
"""A simulation from Python: the bits of the program, views without copies, changes, checkpoints."""

import csv
import gc
import os
import signal
import tempfile
import threading
import time
import unittest
from pathlib import Path

import numpy as np
import polhode

import package
from package import WATER, program, python


def bits(simulation):
    state = simulation.state
    return b"".join(np.ascontiguousarray(a).tobytes() for a in
                    (state.positions, state.momenta, state.orientations, state.angular_momenta))


class SameBits(unittest.TestCase):
    """The same seed gives the bits of the program."""

    def test_energies_are_those_of_the_program(self):
        with tempfile.TemporaryDirectory() as folder:
            settings = polhode.settings(WATER)
            Path(folder, "w.toml").write_text(settings.text, encoding="utf-8")
            program("run", "w.toml", "--output", "cli", cwd=folder)
            with open(Path(folder, "cli-energies.csv"), encoding="utf-8") as file:
                rows = list(csv.reader(line for line in file if not line.startswith("#")))
            of_program = np.array([[float(x) for x in row] for row in rows[1:]])
            energies = polhode.Simulation(WATER).run().energies
            names = [n.partition(" ")[0] for n in rows[0]]
            self.assertEqual(len(energies), len(of_program))
            # The file has 12 digits or more; what it says is compared as it is written there.
            for k, name in enumerate(names):
                ours = [float(f"{x:.9g}") for x in energies[name]]
                theirs = [float(f"{x:.9g}") for x in of_program[:, k]]
                self.assertEqual(ours, theirs, name)

    def test_checkpoints_of_run_resume_here_and_are_the_same_to_the_last_bit(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, "w.toml")
            path.write_text(polhode.settings(WATER).text, encoding="utf-8")
            program("run", str(path), "--output", "cli", cwd=folder)
            resumed, own = polhode.Simulation(path), polhode.Simulation(path)
            resumed.resume(Path(folder, "cli-checkpoint.bin"))
            own.step(20)
            self.assertEqual(resumed.steps, 20)
            self.assertEqual(bits(resumed), bits(own))

    def test_steps_runs_and_threads_make_no_difference(self):
        one, other = polhode.Simulation(WATER, threads=1), polhode.Simulation(WATER)
        for _ in range(10):
            one.step()
        other.run("20 fs", observe=lambda s: s.state.positions.sum(), every="2 fs")
        self.assertEqual(bits(one), bits(other))

    def test_save_and_resume(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "a.bin")
            first = polhode.Simulation(WATER)
            first.step(3)
            first.save(path)
            first.step(7)
            second = polhode.Simulation(WATER)
            second.resume(path)
            second.step(7)
            self.assertEqual(bits(first), bits(second))
            other = polhode.Simulation(WATER, seed=6)
            with self.assertRaises(polhode.Error):
                other.resume(path)


class Views(unittest.TestCase):
    """Views of the state cost no copy, stay valid, and are changed only where that is noticed."""

    def test_a_view_is_the_memory_in_use(self):
        s = polhode.Simulation(WATER)
        q = s.state.positions
        self.assertEqual(q.shape, (64, 3))
        self.assertEqual(s.state.orientations.shape, (64, 4))
        self.assertFalse(q.flags.owndata)
        before = q.copy()
        s.step(5)
        self.assertTrue((q != before).any())
        self.assertTrue(np.shares_memory(q, s.state.positions))

    def test_a_view_is_read_only(self):
        q = polhode.Simulation(WATER).state.positions
        with self.assertRaises(ValueError):
            q[0] = 0

    def test_a_view_outlives_the_simulation(self):
        s = polhode.Simulation(WATER)
        views = [s.state.positions, s.masses, s.moments, s.state.angular_momenta]
        copies = [v.copy() for v in views]
        del s
        gc.collect()
        polhode.Simulation(WATER, seed=9)
        for view, copy in zip(views, copies):
            self.assertTrue((view == copy).all())

    def test_no_step_or_checkpoint_moves_the_memory(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "a.bin")
            for ensemble in ({}, {"thermostat": "langevin", "barostat": {
                    "type": "monte-carlo", "pressure": "1 bar", "every": "2 fs"}},
                             {"hybrid_monte_carlo": {"steps": 2}}):
                s = polhode.Simulation(WATER, **ensemble)
                q = s.state.positions
                s.step(10)
                s.save(path)
                s.step(4)
                s.resume(path)
                self.assertTrue(np.shares_memory(q, s.state.positions), ensemble)
                self.assertTrue((q == s.state.positions).all())

    def test_a_change_is_seen_by_the_next_step(self):
        s = polhode.Simulation(WATER)
        s.step(2)
        before, forces = s.energies["potential"], s.forces[0].copy()
        with s.state.change() as state:
            state.positions[0] += [0.05, 0, 0]
        self.assertNotEqual(s.energies["potential"], before)
        self.assertTrue((s.forces[0] != forces).any())
        # Against a simulation that never had other forces: the kick that begins the step uses the
        # forces at the changed positions, not those of the last kick.
        p, f, h = s.state.momenta.copy(), s.forces[0], 0.002
        s.step(1)
        eta = 0.1931833275037836  # of hoa2: B(eta) A(1/2) B(1 - 2 eta) A(1/2) B(eta)
        self.assertLess(np.abs(s.state.momenta - p).max(), 3 * np.abs(f).max() * h)
        again = polhode.Simulation(WATER)
        with again.state.change() as state:
            for name in ("positions", "momenta", "orientations", "angular_momenta"):
                getattr(state, name)[...] = getattr(s.state, name)
        s_twin = polhode.Simulation(WATER)
        s_twin.step(2)
        with s_twin.state.change() as state:
            state.positions[0] += [0.05, 0, 0]
        s_twin.step(1)
        self.assertEqual(bits(s), bits(s_twin))
        self.assertGreater(eta, 0)

    def test_forces_after_a_change_are_used_by_the_first_kick(self):
        s = polhode.Simulation(WATER, scheme="velocity-verlet")
        s.step(2)
        with s.state.change() as state:
            state.positions[0] += [0.02, 0, 0]
        p, q, f, h = s.state.momenta.copy(), s.state.positions.copy(), s.forces[0], 0.002
        s.step(1)
        # Velocity Verlet: q(h) = q + h (p + h f/2)/m, to rounding.
        expected = q + h * (p + h / 2 * f) / s.masses[:, None]
        self.assertLess(np.abs(s.state.positions - expected).max(), 1e-13)

    def test_a_wrong_change_leaves_the_state(self):
        s = polhode.Simulation(WATER)
        s.step(1)
        before = bits(s)
        for name, value in (("positions", np.nan), ("momenta", np.inf), ("orientations", 0.0),
                            ("positions", 1e300)):
            with self.assertRaises(polhode.Error) as caught:
                with s.state.change() as state:
                    getattr(state, name)[3] = value
            self.assertIn("molecule 4", str(caught.exception))
            self.assertEqual(bits(s), before)
        with self.assertRaises(ZeroDivisionError):
            with s.state.change() as state:
                state.positions[0] = 7
                1 / 0
        self.assertEqual(bits(s), before)
        s.step(1)

    def test_orientations_are_normalized(self):
        s = polhode.Simulation(WATER)
        with s.state.change() as state:
            state.orientations[...] *= 2
        # Rounding of the root and the division, and of four squares and their sum: below 9 halves of an ulp.
        self.assertLess(np.abs((s.state.orientations**2).sum(1) - 1).max(), 9 * 2**-53)

    def test_arrays_of_a_change_cannot_be_written_later(self):
        s = polhode.Simulation(WATER)
        with s.state.change() as state:
            kept = state.positions
        with self.assertRaises(ValueError):
            kept[0] = 1

    def test_a_million_molecules_are_not_copied(self):
        s = polhode.Simulation(molecules="argon", count=1_000_000, density="1.4 g/cm3")
        seconds = []
        for _ in range(20):
            begin = time.perf_counter()
            view = s.state.positions
            seconds.append(time.perf_counter() - begin)
        self.assertEqual(view.shape, (1_000_000, 3))
        self.assertFalse(view.flags.owndata)
        print(f"a view of 10^6 molecules takes {1e6 * min(seconds):.1f} µs")


class Manners(unittest.TestCase):
    """Ctrl-C, threads, errors."""

    def test_ctrl_c_ends_between_steps_and_the_simulation_goes_on(self):
        code = """
import os, signal, threading, polhode
s = polhode.Simulation()
timer = threading.Timer(1.0, lambda: os.kill(os.getpid(), signal.SIGINT))
timer.start()
try:
    s.run("100 ns")
    print("not interrupted")
except KeyboardInterrupt:
    done, energies = s.steps, s.last_run.energies
    assert done > 0 and abs(energies["time"][-1] - s.time) < 1e-9, (done, energies)
    s.step(2)
    assert s.steps == done + 2
    print("usable")
"""
        result = python(code, timeout=300)
        self.assertEqual(result.stdout.strip(), "usable", result.stderr)

    def test_ctrl_c_ends_a_study_in_many_threads(self):
        with tempfile.TemporaryDirectory() as folder:
            code = """
import os, signal, threading, polhode
threading.Timer(2.0, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
try:
    polhode.study(steps=["2 fs"], study={"runs": 50})
    print("not interrupted")
except KeyboardInterrupt:
    print("ended")
"""
            result = python(code, cwd=folder, timeout=300)
            self.assertEqual(result.stdout.strip(), "ended", result.stderr)

    def test_two_simulations_in_two_threads(self):
        results = {}

        def work(seed):
            s = polhode.Simulation(WATER, seed=seed, threads=1)
            s.run("100 fs")
            results[seed] = bits(s)

        threads = [threading.Thread(target=work, args=(seed,)) for seed in (1, 2)]
        for t in threads:
            t.start()
        for t in threads:
            t.join()
        for seed in (1, 2):
            s = polhode.Simulation(WATER, seed=seed, threads=1)
            s.run("100 fs")
            self.assertEqual(results[seed], bits(s))

    def test_other_threads_of_python_run_meanwhile(self):
        s, counted = polhode.Simulation(threads=1), []
        stop = threading.Event()

        def count():
            while not stop.is_set():
                counted.append(1)
                time.sleep(0.001)

        thread = threading.Thread(target=count)
        thread.start()
        before = len(counted)
        s.step(50)
        during = len(counted) - before
        stop.set()
        thread.join()
        self.assertGreater(during, 0)

    def test_one_simulation_in_two_threads_is_an_error(self):
        s, errors = polhode.Simulation(threads=1), []
        running = threading.Event()

        def progress(*_):
            running.set()

        def work():
            s.run("2 ps", progress=progress)

        thread = threading.Thread(target=work)
        thread.start()
        running.wait(60)
        try:
            s.step(1)
        except polhode.Error as e:
            errors.append(str(e))
        thread.join()
        # The run may have ended before the step began.
        self.assertTrue(errors == [] or "in use" in errors[0])

    def test_a_function_that_is_called_cannot_use_the_simulation_that_runs(self):
        s = polhode.Simulation(threads=1)
        with self.assertRaises(polhode.Error) as caught:
            s.run("4 ps", progress=lambda *_: s.step(1))
        self.assertIn("in use", str(caught.exception))
        s.step(1)

    def test_a_run_that_blows_up(self):
        s = polhode.Simulation(WATER, step="50 fs", length="1 ns")
        with self.assertRaises(polhode.RunError) as caught:
            s.run()
        self.assertIn("blew up", str(caught.exception))


if __name__ == "__main__":
    package.main()
