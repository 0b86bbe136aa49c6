# SPDX-License-Identifier: MIT
"""The statistics of studies/npt.py are right for a process with a known law, its inputs for GROMACS have the
molecules of polhode, and it reads the files of both programs."""

import random
import tempfile
import unittest
from argparse import Namespace
from math import cos, hypot, radians, sqrt
from pathlib import Path

import study_path  # first: it says where the others are
import built_program
import npt
import npt_liquids
import numpy


class Statistics(unittest.TestCase):
    def process(self, seed, length, memory=0.8):
        """x' = a x + sqrt(1 - a²) ξ: variance 1, autocorrelation a^k, whose time is (1 + a)/(1 - a)/2."""
        source, x, found = random.Random(seed), 0.0, []
        x = source.gauss(0, 1)
        for _ in range(length):
            found.append(x)
            x = memory * x + sqrt(1 - memory**2) * source.gauss(0, 1)
        return numpy.array(found)

    def test_the_errors_are_those_of_the_scatter(self):
        """Of 200 series the squared deviation from the law, in units of the error, has the mean 1 with an error of
        sqrt(2/200) = 0.1; four of them. For the variance the distribution is skew, and its tails add 0.1."""
        means = [npt.estimate(self.process(seed, 2000)) for seed in range(200)]
        squares = [npt.variance(self.process(seed, 2000)) for seed in range(200)]
        self.assertAlmostEqual(sum((e.value / e.error) ** 2 for e in means) / 200, 1, delta=0.4)
        self.assertAlmostEqual(sum(((e.value - 1) / e.error) ** 2 for e in squares) / 200, 1, delta=0.5)
        # Without the correction the mean variance is low by 2 tau / n = 0.0045; the error of the mean of 200 is
        # sqrt(2 (1 + a²)/(1 - a²) / 400 000) = 0.0048.
        self.assertAlmostEqual(sum(e.value for e in squares) / 200, 1, delta=4 * 0.0048)


class Inputs(unittest.TestCase):
    def test_two_masses_of_a_linear_molecule(self):
        """Mass, centre and moment of inertia are those of the sites: 2 · 15.9994 · 0.116² of TraPPE carbon dioxide."""
        liquid = npt_liquids.LIQUIDS["co2"]
        a, b = npt_liquids.mass_points(liquid.sites)
        self.assertAlmostEqual(a + b, 0, 12)
        self.assertAlmostEqual(liquid.mass / 2 * (a**2 + b**2), 2 * 15.9994 * 0.116**2, 12)
        share = [float(line.split()[-1]) for line in npt_liquids.rigid(liquid).splitlines()[-3:]]
        for x, s in zip((0, -0.116, 0.116), share):
            self.assertAlmostEqual((1 - s) * a + s * b, x, 12)

    def test_the_fourth_site_of_water(self):
        """M is at 0.01546 nm on the bisector: a (r_H1 + r_H2) with a = 0.01546 / (2 · 0.09572 cos 52.26°)."""
        lines = npt_liquids.rigid(npt_liquids.LIQUIDS["tip4p-2005"]).splitlines()
        self.assertAlmostEqual(float(lines[1].split()[2]), 0.09572, 10)
        self.assertAlmostEqual(float(lines[-1].split()[-1]), 0.01546 / (2 * 0.09572 * cos(radians(104.52 / 2))), 10)

    def test_coordinates_with_the_mass_points(self):
        liquid = npt_liquids.LIQUIDS["co2"]._replace(count=1)
        sites = ((0, 1, 1, 1), (1, 1, 1, 0.884), (2, 1, 1, 1.116))
        lines = ["one", "3", *(f"{1:5d}  co2{'X':>5}{k + 1:5d}" + "".join(f"{x:15.10f}" for x in r) for k, *r in sites),
                 "".join(f"{3:15.10f}" for _ in range(3))]
        found = npt_liquids.gro.read(npt_liquids.coordinates(liquid, "\n".join(lines)))
        self.assertEqual([name for _, name in found.labels], ["D1", "D2", "C", "O1", "O2"])
        radius = npt_liquids.mass_points(liquid.sites)[1]
        for k, sign in ((0, -1), (1, 1)):
            self.assertAlmostEqual(hypot(*(x - y for x, y in zip(found.positions[k], (1, 1, 1 + sign * radius)))), 0, 9)

    def test_expanded(self):
        """Centres of mass and edges are scaled; the sites keep their places about the centre."""
        liquid = npt_liquids.LIQUIDS["spce"]._replace(count=2)
        places = [[c + x for c, x in zip(centre, npt_liquids.position(s))] for centre in ((1, 1, 1), (2, 0.5, 1.5))
                  for s in liquid.sites]
        labels = [("spce", s["name"]) for s in liquid.sites] * 2
        text = npt_liquids.gro_text("two", labels, 3, places, (3, 3, 4))
        found = npt_liquids.gro.read(npt_liquids.expanded(liquid, text, 1.1))
        for edge, expected in zip(found.box, (3.3, 3.3, 4.4)):
            self.assertAlmostEqual(edge, expected, 9)
        above = 2 * 1.008 * 0.057735896651553043 / liquid.mass  # the centre of mass above the oxygen, along y
        for r, before in zip(found.positions, places):
            centre = (1, 1 + above, 1) if before[0] < 1.5 else (2, 0.5 + above, 1.5)
            for k in range(3):
                self.assertAlmostEqual(r[k], before[k] + 0.1 * centre[k], 9)


class Results(unittest.TestCase):
    def test_from_the_energies_of_polhode(self):
        """The density of the mean volume, and var V / (<V> k T) with volumes of ±1 % and ±3 % around 16 nm³."""
        liquid, size = npt_liquids.LIQUIDS["spce"], 2000
        factor = lambda k: 1 + (0.01, -0.03, 0.03, -0.01)[k % 4]
        with tempfile.TemporaryDirectory() as folder:
            rows = [f"{0.1 * k},{-47 * 512},298,1,{16 * factor(k)}" for k in range(size + 100)]
            (Path(folder) / "spce-x-energies.csv").write_text(
                "\n".join(["time [ps],potential [kJ/mol],temperature [K],pressure [bar],volume [nm^3]", *rows]), encoding="utf-8")
            series = npt.series_of(liquid, "x", Namespace(folder=Path(folder), skip=10))
            self.assertIsNone(npt.series_of(liquid, "y", Namespace(folder=Path(folder), skip=10)))
        self.assertEqual(len(series.volume), size)
        found = npt.results(liquid, series)
        self.assertAlmostEqual(found["density [kg/m³]"].value, 512 * 18.0154 * 1.66053906717 / 16, 4)
        self.assertAlmostEqual(found["potential energy [kJ/mol]"].value, -47, 9)
        # (0.01² + 0.03²) / 2 · V / kT [1/bar]; k_B T = 1.380649e-23 · 298.15 J, 1 bar nm³ = 1e-22 J
        exact = 1e5 * 5e-4 * 16 / (1.380649e-23 * 298.15 / 1e-22)
        self.assertAlmostEqual(found["compressibility [1e-5/bar]"].value, exact, delta=exact * 2 / size)

    def test_shift(self):
        """exp(-d/kT) with d = c x turns a normal x of variance 1 into one about -c/kT; with 40 000 of them the error of the
        covariance is sqrt(2/40 000) c/kT, and its own estimate is that to a few per cent."""
        source = numpy.random.default_rng(1)
        x = source.normal(size=40000)
        found = npt.shift(x, 0.5 * x + 7, 2.0)
        self.assertAlmostEqual(found.value, -0.25, delta=4 * 0.25 * sqrt(2 / 40000))
        self.assertAlmostEqual(found.error, 0.25 * sqrt(2 / 40000), delta=0.1 * 0.25 * sqrt(2 / 40000))

    def test_frames(self):
        """Whole frames from a time on: one that is being written is left out."""
        frame = lambda t: f"polhode t= {t:.6f}\n1\n    1ar      Ar    1   0.0   0.0   0.0\n   1.0   1.0   1.0\n"
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "x.gro"
            path.write_text(frame(0) + frame(5) + frame(10) + frame(15)[:-20], encoding="utf-8")
            self.assertEqual([t for t, _ in npt.frames(path, 5)], [5, 10])


if __name__ == "__main__":
    built_program.main()
