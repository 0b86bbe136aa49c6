# SPDX-License-Identifier: MIT
"""Whatever is passed to the module, the answer is an exception never the end of the interpreter."""

import itertools
import os
import tempfile
import unittest

import numpy as np
import polhode
from polhode import _core

import package
from package import WATER, python

VALUES = (None, True, -1, 0, 2**64, -2**63, 1e308, float("nan"), float("inf"), "", "\0", "x" * 5000,
          b"x", "2 fs", [], [[]], {}, {"a": 1}, (), object(), np.zeros(0), np.zeros((3, 3)),
          np.zeros((2, 3), dtype=complex), np.array(["a"]), np.zeros((0, 3)), lambda *a: a,
          "\ud800", 1j, np.float32(3), np.arange(6).reshape(2, 3)[:, ::-1])


class Functions(unittest.TestCase):
    def test_every_function_with_every_value(self):
        functions = [polhode.quantity, polhode.Scheme, polhode.schemes, polhode.verify,
                     polhode.Molecule, polhode.molecules, polhode.free_rotation, polhode.top,
                     polhode.read, polhode.write, polhode.settings, polhode.rotate_table,
                     polhode.convert, polhode.analyze, polhode.energy, polhode.minimise,
                     polhode.new, polhode.ExternalForces]
        raised = 0
        with tempfile.TemporaryDirectory() as folder:
            before = os.getcwd()
            os.chdir(folder)
            try:
                for function, first in itertools.product(functions, VALUES):
                    for more in ((), (first,), (first, first)):
                        try:
                            function(first, *more)
                        except Exception:  # any exception is right; a signal is not
                            raised += 1
            finally:
                os.chdir(before)
        self.assertGreater(raised, 1000)

    def test_every_setting_with_every_value(self):
        from polhode._keywords import PATH_OF

        for word, value in itertools.product(PATH_OF, VALUES):
            try:
                polhode.settings(WATER, **{word: value})
            except (polhode.Error, TypeError, AttributeError, ValueError):
                pass

    def test_every_method_with_every_value(self):
        s = polhode.Simulation(WATER)
        methods = (s.step, s.run, s.save, s.resume, s.write, s.sites, s.choose_step)
        with tempfile.TemporaryDirectory() as folder:
            before = os.getcwd()
            os.chdir(folder)
            try:
                for method, value in itertools.product(methods, VALUES):
                    try:
                        method(value)
                    except Exception:
                        pass
            finally:
                os.chdir(before)
        s.step(1)

    def test_the_module_itself(self):
        names = [n for n in dir(_core) if not n.startswith("__")]
        for name, value in itertools.product(names, VALUES):
            thing = getattr(_core, name)
            if callable(thing) and name not in ("bench",):
                for arguments in ((), (value,), (value, value), (value,) * 3, (value,) * 8):
                    try:
                        thing(*arguments)
                    except Exception:
                        pass


class Arrays(unittest.TestCase):
    def test_changes_with_wrong_arrays(self):
        s = polhode.Simulation(WATER)
        for value in (np.zeros((5, 3)), "x", None, np.zeros((64, 4)), 1j):
            with self.assertRaises((TypeError, ValueError)):
                with s.state.change() as state:
                    state.positions[...] = value
        s.step(1)

    def test_changes_within_changes_and_after_the_end(self):
        s = polhode.Simulation(WATER)
        with s.state.change():
            with self.assertRaises(polhode.Error):
                with s.state.change():
                    pass
        with self.assertRaises(polhode.Error):
            s._core.end_change(True)
        s.step(1)

    def test_strided_and_other_types_of_arrays(self):
        J = np.asfortranarray(np.tile([1.0, 2, 3], (4, 1)))
        L = np.ones((8, 3), dtype=np.float32)[::2]
        q, _ = polhode.free_rotation(J, L, np.arange(4))
        p, _ = polhode.free_rotation([1, 2, 3], [1, 1, 1], np.arange(4.0))
        self.assertTrue((q == p).all())

    def test_a_deleted_owner(self):
        code = """
import gc, numpy as np, polhode
views = []
for k in range(20):
    s = polhode.Simulation(molecules="argon", count=500, density="1 g/cm3", seed=k)
    with s.state.change() as state:
        views += [state.positions[::2], state.momenta]
    views += [s.state.positions, s.masses[::3], s.state.orientations[1:]]
    s.step(1)
    del s, state
gc.collect()
print(np.isfinite(sum(float(v.sum()) for v in views)))
"""
        result = python(code)
        self.assertEqual(result.stdout.strip(), "True", result.stderr)


@unittest.skipIf("ASAN_OPTIONS" in os.environ, "the address sanitizer keeps freed memory for a while")
class Memory(unittest.TestCase):
    def test_simulations_are_freed(self):
        # The memory after a hundred more simulations is that before, up to two pages for each
        # hundred; a state of 1000 atoms alone has 100 kB.
        code = """
import gc, polhode
def resident():
    gc.collect()
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * 4096
def make(n):
    for k in range(n):
        s = polhode.Simulation(molecules="argon", count=1000, density="1 g/cm3", seed=k, threads=1)
        v = s.state.positions
        s.step(1)
make(100)
before = resident()
make(100)
print(resident() - before)
"""
        result = python(code)
        self.assertLess(int(result.stdout), 100 * 100_000 // 20, result.stderr)


if __name__ == "__main__":
    package.main()
