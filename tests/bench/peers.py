# SPDX-License-Identifier: MIT
"""bench/peers computes and reads correctly; no other program needs to be installed."""

import json
import re
import sys
import tempfile
import unittest
from math import cos, nan, pi, sqrt
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SAMPLES = Path(__file__).resolve().parent / "peers"
sys.path.insert(0, str(ROOT / "bench/peers"))

import curves
import engines
import gro
import logs


def said(name):
    return (SAMPLES / name).read_text(encoding="utf-8")


def points(law, steps):
    return [curves.Point(h, law(h), 0.0, 0.0, False, 297.0, -21000.0) for h in steps]


class Steps(unittest.TestCase):
    """The step at a required R: exact where R is a power of the step."""

    def test_between_points(self):
        step, mark = curves.step_at(0.004, points(lambda h: 0.0025 * h * h, [4.0, 0.5, 1.0, 2.0]))
        self.assertAlmostEqual(step, sqrt(0.004 / 0.0025), 12)
        self.assertEqual(mark, "")

    def test_beyond_points(self):
        curve = points(lambda h: 0.001 * h * h, [1.0, 2.0])
        self.assertEqual(curves.step_at(0.0005, curve), (None, "not reached"))
        self.assertEqual(curves.step_at(0.015, curve), (2.0, "+"))
        self.assertEqual(curves.step_at(0.015, []), (None, "not reached"))

    def test_floor_of_rounding(self):
        """A program whose R no longer falls at short steps is read on its rising branch."""
        step, _ = curves.step_at(0.004, points(lambda h: max(0.002, 0.001 * h * h), [0.5, 1.0, 2.0, 4.0]))
        self.assertAlmostEqual(step, 2.0, 12)

    def test_end_of_a_curve(self):
        """Steps above the first one with a drift or without finite energies do not count."""
        curve = points(lambda h: 0.001 * h * h, [1.0, 2.0, 3.0, 4.0])
        for bad in (curve[2]._replace(drift=-0.06, drift_significant=True), curve[2]._replace(ratio=nan)):
            self.assertEqual(curves.step_at(0.015, [*curve[:2], bad, curve[3]]), (2.0, "+"))
        small = curve[2]._replace(drift=0.04, drift_significant=True)
        self.assertEqual(curves.step_at(0.1, [*curve[:2], small])[0], 3.0)


class Energies(unittest.TestCase):
    """R, its error and the drift of energies made by a formula."""

    def made(self, rate):
        wave = lambda k: cos(2 * pi * k / 10)  # whole periods in every block
        return [logs.Sample(0.25 * wave(k) + rate * k, 50.0 * wave(k) - 100, 300.0) for k in range(4000)]

    def test_ratio(self):
        p = curves.point(2.0, self.made(0.0), 4.0)
        self.assertAlmostEqual(p.ratio, 0.005, 12)
        self.assertAlmostEqual(p.error, 0.0, 12)
        self.assertAlmostEqual(p.potential, -100, 9)
        self.assertTrue(p.usable)

    def test_drift(self):
        p = curves.point(2.0, self.made(1e-3), 4.0)  # 1e-3 per sample of 4 fs, of a kinetic energy of about 102
        self.assertAlmostEqual(p.drift * (100 + 1e-3 * 1999.5), 1e-3 / 4e-6, 6)
        self.assertTrue(p.drift_significant)
        self.assertFalse(p.usable)
        self.assertTrue(curves.point(2.0, self.made(1e-3)[:1000], 4.0).usable)  # too short to detect a drift

    def test_blown_up(self):
        self.assertFalse(curves.point(2.0, [], 4.0).usable)
        self.assertFalse(curves.point(2.0, [logs.Sample(nan, 0.0, 0.0)] * 100, 4.0).usable)

    def test_cost(self):
        self.assertAlmostEqual(curves.seconds_per_ns(1000.0, 2.0), 500.0)  # 500 000 steps of 1 ms
        self.assertAlmostEqual(curves.ns_per_day(1000.0, 2.0), 172.8)
        self.assertEqual(curves.middle([1.0, 3.0, 2.0]), (2.0, 0.5))

    def test_interval(self):
        self.assertEqual([engines.steps_between(4.0, h) for h in (0.5, 1.5, 0.8, 4.0, 6.0)], [8, 2, 5, 1, 1])


class Starts(unittest.TestCase):
    """W512 replicated keeps its waters, its density and its neighbours."""

    def setUp(self):
        self.start = gro.read((ROOT / "data/start/w512.gro").read_text(encoding="utf-8"))

    def test_read(self):
        self.assertEqual(self.start.molecules, 512)
        self.assertEqual(self.start.labels[3], ("tip4p", "MW"))
        self.assertEqual(self.start.positions[0], (1.1060873429, 0.0176238096, 0.4279266929))
        self.assertEqual(self.start.velocities[0], (-0.01483061788, -0.23248860531, 0.27047798407))
        self.assertEqual(self.start.box, (2.4834399223,) * 3)

    def test_replicated(self):
        big = gro.replicated(self.start, 2)
        self.assertEqual(big.molecules, 4096)
        self.assertEqual(big.box, tuple(2 * edge for edge in self.start.box))
        images = {tuple(round((b - a) / edge, 9) for a, b, edge in
                        zip(self.start.positions[5], big.positions[2048 * k + 5], self.start.box)) for k in range(8)}
        self.assertEqual(images, {(i, j, k) for i in (0, 1) for j in (0, 1) for k in (0, 1)})
        self.assertEqual(big.velocities[2048 * 7 + 5], self.start.velocities[5])
        self.assertEqual(gro.replicated(self.start, 1), self.start)

    def test_written(self):
        self.assertEqual(gro.read(gro.written(self.start, "waters")), self.start)
        last = gro.written(gro.replicated(self.start, 4), "waters").splitlines()[-2]
        self.assertEqual(last[:20], "32768tip4p   MW31072")

    def test_lammps(self):
        lines = gro.lammps_data(self.start, engines.CHARGES, engines.MASSES).splitlines()
        self.assertIn("0 24.834399223 xlo xhi", lines)
        first = lines[lines.index("Atoms # full") + 2 :][:4]
        self.assertEqual(first[0], "1 1 1 0 11.0608734290 0.1762380960 4.2792669290")
        self.assertEqual([line.split()[2] for line in first], ["1", "2", "2", "3"])
        self.assertEqual(lines[lines.index("Velocities") + 2], "1 -0.0001483061788 -0.0023248860531 0.0027047798407")

    def test_tables(self):
        """Force and energy vanish at the cutoff, and the force is minus the slope of the energy."""
        text = gro.lammps_tables(1001, 0.05, 0.9, engines.CHARGES)
        self.assertEqual(re.findall(r"^[HM]+$", text, re.M), ["HH", "HM", "MM"])
        rows = [[float(x) for x in line.split()] for line in text.partition("MM")[2].splitlines()[3:1004]]
        self.assertAlmostEqual(rows[-1][2], 0.0, 10)
        self.assertAlmostEqual(rows[-1][3], 0.0, 10)
        before, here, after = rows[499:502]
        u, gap = here[1] ** 2, here[1] ** 2 - before[1] ** 2  # r², in which rows are evenly spaced
        force = 2 * here[1] * (before[2] - after[2]) / (2 * gap)
        # The third derivative of u^(-1/2) is -15/8 u^(-7/2); the reaction field, linear in u, has none.
        excess = gro.COULOMB * engines.CHARGES[2] ** 2 * 2 * here[1] * 15 / 8 * u**-3.5 * gap**2 / 6
        self.assertAlmostEqual((force - here[3]) / excess, 1.0, 2)


class Logs(unittest.TestCase):
    """The output of the programs, from stored samples."""

    def test_gromacs(self):
        samples = logs.gromacs_energies(said("gromacs.xvg"))
        self.assertEqual(len(samples), 3)
        self.assertEqual(samples[1], (-17431.185547, -21139.648438, 290.381287))
        self.assertAlmostEqual(logs.gromacs_step_us(said("gromacs.log"), 2.0), 2082.6, 1)
        self.assertIsNone(logs.gromacs_step_us("", 2.0))
        self.assertEqual(logs.gromacs_lists(said("gromacs.log")), [(10, 1.009)])

    def test_lammps(self):
        samples = logs.lammps_energies(said("lammps.log"))
        self.assertEqual(len(samples), 3)  # of the second run alone
        self.assertAlmostEqual(samples[1].total, -4120.7485944 * 4.184, 9)
        self.assertAlmostEqual(samples[1].potential, -5005.25830364 * 4.184, 9)
        self.assertEqual(samples[1].temperature, 290.063223481)
        self.assertAlmostEqual(logs.lammps_step_us(said("lammps.log")), 0.0272663e6 / 4, 6)

    def test_polhode(self):
        samples = logs.polhode_energies(said("polhode-energies.csv"))
        self.assertEqual(len(samples), 5)
        self.assertEqual(samples[0], (-17552.323870456625, -21282.247684578615, 292.34716275946505))
        step_us, evaluations = logs.polhode_summary(said("polhode.json"))
        self.assertAlmostEqual(step_us, 0.008738259e6 / 4, 6)
        self.assertGreater(evaluations, 0)

    def test_openmm(self):
        text = "a warning\n" + json.dumps({"samples": [[-1.0, -2.0, 297.0]], "step_us": None})
        self.assertEqual(logs.openmm_report(text), ([logs.Sample(-1.0, -2.0, 297.0)], None))


class Inputs(unittest.TestCase):
    """All placeholders of the templates are filled in."""

    def test_templates(self):
        start = gro.read((ROOT / "data/start/w512.gro").read_text(encoding="utf-8"))
        with tempfile.TemporaryDirectory() as folder:
            case = engines.Case(start, Path(folder), 0.9, 0.765)
            case.write("topology", "gromacs.top")
            self.assertTrue((case.folder / "topology").read_text().endswith("SOL 512\n"))
            self.assertRaises(RuntimeError, case.run, sys.executable, "-c", "raise SystemExit(3)")
            self.assertEqual(case.run(sys.executable, "-c", "print(input())", given="4 fs\n"), "4 fs\n")


if __name__ == "__main__":
    unittest.main()
