# SPDX-License-Identifier: MIT
"""Own schemes, forces, observers and molecules."""

import threading
import unittest

import numpy as np
import polhode

import package
from package import WATER, python

# A molecule without interactions: all forces are the function's.
TOP = {"name": "top", "source": "-", "site": [
    {"name": "A", "element": "C", "position": "0 0 0 nm", "mass": "12 u"},
    {"name": "B", "element": "O", "position": "0.12 0 0 nm", "mass": "16 u"},
    {"name": "C", "element": "H", "position": "0 0.1 0.02 nm", "mass": "1 u"}]}
FEW = {"molecules": [{"model": TOP, "count": 4}], "box": "6 nm", "temperature": "300 K", "seed": 2}


def field(q, orientation):
    """A periodic field on the centres, and one that turns the first body axis: U = k (1 - cos),
    U = g e·z. They act on the dynamics with a time scale of a tenth of a ps."""
    k, wave, g = 40.0, 2 * np.pi / 6, 25.0
    energy = k * (1 - np.cos(wave * q)).sum()
    force = -k * wave * np.sin(wave * q)
    w, x, y, z = orientation.T
    axis = np.stack([w*w + x*x - y*y - z*z, 2*(x*y + w*z), 2*(x*z - w*y)], axis=-1)
    pull = np.array([0, 0, -g])  # minus the gradient with respect to the axis
    return force, np.cross(axis, pull), energy + g * axis[:, 2].sum()


def system(**keywords):
    return polhode.Simulation({"system": FEW, "run": {"sample": keywords.get("step", "1 fs"),
                                                      "shadow_sample": "0 fs"}},
                              cutoff="1 nm", forces=field, threads=1, **keywords)


def energy_error(scheme, step, length="1 ps"):
    """The largest deviation of the total energy from its first value."""
    total = system(scheme=scheme, step=step).run(length).energies["total"]
    return np.abs(total - total[0]).max()


class Forces(unittest.TestCase):
    def test_the_order_of_schemes_under_ones_own_forces(self):
        # The error of a symmetric scheme is C h^k + O(h^(k+2)): halving h divides it by 2^k, up to
        # the next order, below a tenth here.
        for scheme, order, steps in (("velocity-verlet", 2, ("4 fs", "2 fs")),
                                     ("hoa2", 2, ("4 fs", "2 fs")),
                                     ("gier4-fd", 4, ("8 fs", "4 fs")),
                                     ("gier4", 4, ("8 fs", "4 fs"))):
            ratio = energy_error(scheme, steps[0]) / energy_error(scheme, steps[1])
            self.assertAlmostEqual(np.log2(ratio), order, delta=0.15, msg=scheme)

    def test_a_wrong_sign_of_the_torque_is_seen(self):
        def wrong(q, orientation):
            force, torque, energy = field(q, orientation)
            return force, -torque, energy

        s = polhode.Simulation({"system": FEW}, cutoff="1 nm", forces=wrong, scheme="hoa2",
                               step="2 fs", sample="2 fs", shadow_sample="0 fs")
        with self.assertRaises(polhode.RunError) as caught:
            s.run("0.5 ps")
        self.assertIn("the total energy changed from", str(caught.exception))

    def test_forces_are_added_to_the_force_field(self):
        plain = polhode.Simulation(WATER)
        pulled = polhode.Simulation(WATER, forces=lambda q, a: (np.full(q.shape, 2.0), None, 5.0))
        self.assertLess(np.abs(pulled.forces[0] - plain.forces[0] - 2).max(), 1e-9)
        self.assertEqual(pulled.energies["external"], 5.0)
        self.assertAlmostEqual(pulled.energies["potential"] - plain.energies["potential"], 5, 9)

    def test_two_waters_by_a_function_are_those_of_the_program(self):
        # The same Lennard-Jones argon by NumPy, with the minimum image and no cutoff to cross.
        sigma, epsilon = 0.34, 0.9977

        def lennard_jones(q, orientation, box):
            d = q[:, None] - q[None]
            d -= box * np.round(d / box)
            r2 = (d**2).sum(-1) + np.eye(len(q))
            s6 = (sigma**2 / r2) ** 3 * (1 - np.eye(len(q)))
            force = (24 * epsilon * (2 * s6**2 - s6) / r2)[..., None] * d
            virial = 0.5 * np.einsum("ijk,ijl->kl", d, force)
            return force.sum(1), None, 2 * epsilon * (s6**2 - s6).sum(), virial

        atom = {"name": "bare", "source": "-",
                "site": [{"name": "Ar", "element": "Ar", "position": "0 0 0 nm", "mass": "39.948 u"}]}
        like = {**atom, "site": [{**atom["site"][0], "sigma": "0.34 nm", "epsilon": "0.9977 kJ/mol"}]}
        box, common = "3 nm", {"cutoff": "1.49 nm", "switch": "1.48 nm"}
        of = {name: polhode.Simulation({"system": {
            "molecules": [{"model": table, "count": 8}], "box": box, "temperature": "90 K"}}, **more)
            for name, table, more in (
                ("library", like, common),
                ("function", atom, {**common, "forces": polhode.ExternalForces(
                    lennard_jones, virial=True)}))}
        # 8 atoms on a lattice of 1.5 nm: neighbours at 1.5 nm are outside the cutoff of the library.
        with of["library"].state.change() as state:
            state.positions[...] = 0.4 * state.positions
        with of["function"].state.change() as state:
            state.positions[...] = of["library"].state.positions
        f, g = of["library"].forces[0], of["function"].forces[0]
        self.assertGreater(np.abs(f).max(), 1e-3)
        self.assertLess(np.abs(f - g).max(), 1e-9 * np.abs(f).max())
        a, b = of["library"].energies, of["function"].energies
        for name in ("potential", "pressure"):
            self.assertAlmostEqual(a[name] / b[name], 1, delta=1e-9, msg=name)

    def test_what_is_returned_is_checked(self):
        zeros = np.zeros((64, 3))
        for result, text in (((zeros, zeros), "2 values"), (7, "type int"),
                             ((zeros[:5], zeros, 0), "shape (5, 3)"),
                             ((zeros, zeros.T, 0), "shape (3, 64)"),
                             ((zeros, zeros, [1, 2]), "energy"),
                             (("x", zeros, 0), "not an array of real numbers"),
                             ((zeros * 1j, zeros, 0), "complex128")):
            s = polhode.Simulation(WATER, forces=lambda q, a, r=result: r)
            with self.assertRaises(polhode.Error) as caught:
                s.step(1)
            self.assertIn(text, str(caught.exception))
        s = polhode.Simulation(WATER, forces=lambda q, a: (zeros + np.nan, zeros, 0))
        with self.assertRaises(polhode.RunError):
            s.step(1)

    def test_exceptions_of_a_function_arrive_as_they_are(self):
        def broken(q, orientation):
            raise KeyError("mine")

        s = polhode.Simulation(WATER, forces=broken)
        for _ in range(3):
            with self.assertRaises(KeyError):
                s.step(1)

    def test_arrays_are_the_functions_own(self):
        kept = []

        def keep(q, orientation):
            kept.append((q, orientation))
            return np.zeros(q.shape), None, 0.0

        s = polhode.Simulation(WATER, forces=keep)
        s.step(2)
        copies = [(q.copy(), a.copy()) for q, a in kept]
        s.step(5)
        del s
        for (q, a), (p, b) in zip(kept, copies):
            self.assertTrue((q == p).all() and (a == b).all())
            q[0] = 0  # writable

    def test_a_barostat_that_needs_a_virial_says_so(self):
        with self.assertRaises(polhode.Error) as caught:
            polhode.Simulation(WATER, forces=lambda q, a: (0 * q, None, 0), thermostat="langevin",
                               pressure="1 bar")
        self.assertIn("virial", str(caught.exception))

    def test_a_study_with_ones_own_forces_in_several_threads(self):
        import tempfile

        threads = set()

        def soft(q, orientation):
            threads.add(threading.get_ident())
            return np.zeros(q.shape), None, 0.0

        with tempfile.TemporaryDirectory() as folder:
            report = polhode.study(WATER, forces=soft, schemes=["hoa2"], steps=["2 fs"], threads=2,
                                   output=f"{folder}/s",
                                   study={"runs": 2, "length": "20 fs", "decorrelate": "10 fs"})
            self.assertEqual(len(report["points"]), 1)
        self.assertGreaterEqual(len(threads), 1)


class Schemes(unittest.TestCase):
    def test_a_scheme_as_text(self):
        mine = "B(1/6) A(1/2) B(2/3, 1/48, fd) A(1/2) B(1/6)"
        self.assertEqual(polhode.Scheme(mine).cost, 3)
        self.assertAlmostEqual(polhode.verify(mine)["measured_order"], 4, delta=0.1)
        a, b = (polhode.Simulation(WATER, scheme=s) for s in (mine, "gier4-fd"))
        a.step(3)
        b.step(3)
        self.assertTrue((a.state.positions == b.state.positions).all())
        self.assertIn("hoa2", polhode.schemes())

    def test_no_order_is_claimed_that_is_not_measured(self):
        self.assertFalse(polhode.verify("hoa2", order=4)["holds"])


class Observers(unittest.TestCase):
    def test_they_are_called_at_the_start_and_at_each_interval(self):
        s, times = polhode.Simulation(WATER), []
        run = s.run("20 fs", observe=[lambda s: times.append(s.steps), lambda s: None], every="4 fs",
                    frames="10 fs")
        self.assertEqual(times, [0, 2, 4, 6, 8, 10])
        self.assertEqual(len(run.frames), 3)
        self.assertEqual(len(run.energies), 6)

    def test_intervals_are_rounded_down_to_whole_steps_as_in_run_files(self):
        s, steps = polhode.Simulation(WATER), []
        s.run("20 fs", observe=lambda s: steps.append(s.steps), every="7 fs")
        self.assertEqual(steps, [0, 3, 6, 9])

    def test_an_exception_ends_the_run_and_leaves_a_usable_simulation(self):
        s = polhode.Simulation(WATER)

        def stop(s):
            if s.steps == 4:
                raise StopIteration("enough")

        with self.assertRaises(StopIteration):
            s.run("40 fs", observe=stop)
        self.assertEqual((s.steps, len(s.last_run.energies)), (4, 3))
        s.step(1)


class Molecules(unittest.TestCase):
    def test_a_molecule_as_a_dict(self):
        m = polhode.Molecule(TOP)
        self.assertEqual((m.top, m.mass, len(m.sites)), ("asymmetric", 29, 3))
        s = polhode.Simulation(molecules=m, count=4, box="6 nm", cutoff="1 nm")
        self.assertEqual(s.molecules, [("top", 4)])
        with self.assertRaises(polhode.Error) as caught:
            polhode.Molecule({"name": "a", "source": "b", "site": [{"name": "A", "position": "0 nm"}]})
        self.assertIn("dict", str(caught.exception))

    def test_a_model_as_a_dict_is_the_model(self):
        one = polhode.Simulation(WATER)
        water = polhode.molecules("tip4p").as_dict()
        other = polhode.Simulation({**WATER, "system": {**WATER["system"], "molecules": [
            {"model": water, "count": 64}]}})
        a, b = one.energies, other.energies
        # Its sites have been turned to the principal frame: rounding remains.
        self.assertAlmostEqual(a["potential"] / b["potential"], 1, delta=1e-9)
        self.assertEqual(len(polhode.molecules()), len(polhode.molecules().keys()))
        # The mixing rule of the model changes the energy.
        box = {"count": 27, "box": "2.4 nm", "cutoff": "1 nm"}
        named, given, other = (polhode.Simulation(molecules=m, **box).energies["potential"] for m in (
            "ch4", polhode.molecules("ch4"), {**polhode.molecules("ch4").as_dict(), "mixing": "lorentz-berthelot"}))
        self.assertAlmostEqual(named / given, 1, delta=1e-9)
        self.assertNotAlmostEqual(named / other, 1, delta=1e-4)


class Leaks(unittest.TestCase):
    def test_functions_are_dropped_with_their_simulation(self):
        code = """
import gc, weakref, numpy as np, polhode
class F:
    def __call__(self, q, orientation): return np.zeros(q.shape), None, 0.0
f = F()
watch = weakref.ref(f)
s = polhode.Simulation(molecules="argon", count=8, box="3 nm", cutoff="1 nm", forces=f)
s.step(2)
del s, f
gc.collect()
assert watch() is None
print("dropped")
"""
        result = python(code)
        self.assertEqual(result.stdout.strip(), "dropped", result.stderr)

    def test_functions_that_refer_to_their_simulation_are_dropped_with_it(self):
        # As in every script, whose functions refer to its global names.
        code = """
import gc, weakref, numpy as np, polhode
settings = {"molecules": "argon", "count": 8, "box": "3 nm", "cutoff": "1 nm"}
def make():
    def f(q, orientation):
        return np.zeros(q.shape), None, float(s.steps if s else 0)
    s = None
    s = polhode.Simulation(polhode.settings(forces=f, **settings), step="2 fs")
    s.step(2)
    polhode.energy(s.settings)
    return weakref.ref(f), weakref.ref(s)
watched = make()
gc.collect()
print([w() for w in watched])

def f(q, orientation):
    return np.zeros(q.shape), None, 0.0
s = polhode.Simulation(forces=f, **settings)
state, settings = s.state, s.settings
del s
gc.collect()
with state.change() as change:
    change.momenta[0] += 1
momenta = state.momenta
"""
        result = python(code)
        self.assertEqual((result.stdout.strip(), result.stderr), ("[None, None]", ""))


if __name__ == "__main__":
    package.main()
