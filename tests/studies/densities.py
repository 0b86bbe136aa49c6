# SPDX-License-Identifier: MIT
"""The density maximum: curves whose maxima are known give these maxima, for each step."""

import unittest

import study_path  # noqa: F401  first: it says where the others are
import built_program
import density_maximum_tables as tables
import half_femtosecond as hf
import numpy as np

KAPPA = 4.6e-5  # [1/bar]
T = (257, 267, 277, 287, 298, 308, 318)


def limit(t):
    """A density with its maximum at 277 K."""
    return 1000 - 0.006 * (t - 277) ** 2 + 2e-5 * (t - 277) ** 3


def bias(t):
    """The bias of the density at 2 fs."""
    return 0.1 - 0.018 * (t - 277)


def run(t, pressure=1.0, deviation=0.0, biased=True):
    density = (limit(t) + bias(t) + deviation) * (1 + KAPPA * (pressure - 1)) if biased else limit(t)
    of = lambda value: {"value": value, "error": 0.1}
    step_bias = {"volume_nm3": of(-bias(t) * 6 / density), "compressibility_per_bar": of(-0.02 * KAPPA)} if biased else None
    return {"temperature": t, "pressure_bar": pressure, "density_kg_per_m3": of(density), "volume_nm3": of(6.0), "step_bias": step_bias,
            "compressibility_per_bar": of(KAPPA), "dielectric": {"constant": of(49), "mean_over_rms_dipole": 0.2**0.5, "step_bias": {"constant": of(0.6)}}}


def runs(**more):
    return tables.by_temperature([run(t, deviation=d, **more) for t in T for d in (-0.1, 0.1)])


class DensityMaximum(unittest.TestCase):
    def test_densities_without_bias_at_one_bar(self):
        """A run at 41 bar is denser by 40 κ; corrected, it is the limit of short steps."""
        for t, of in runs(pressure=41.0).items():
            x, b = tables.limits(of)
            self.assertAlmostEqual(x.mean(), (limit(t) + bias(t)) * (1 - (40 * KAPPA) ** 2) - bias(t), delta=1e-3)  # a linear correction
            self.assertAlmostEqual(b.mean(), bias(t), delta=1e-3)

    def test_maxima(self):
        """At 4 fs the bias is four times its value at 2 fs. Maxima are zeros of a slope that is quadratic in T."""
        curves = tables.resampled(runs(), draws=20)
        for step in (0, 0.5, 1, 2, 4):
            slope = -0.018 * (step / 2) ** 2
            shift = (0.012 - (0.012**2 - 4 * 6e-5 * slope) ** 0.5) / (2 * 6e-5)  # -0.012 x + 6e-5 x² + slope = 0
            top, error, moved, of_moved, (low, high) = curves.maximum(step)
            self.assertAlmostEqual(top, 277 + shift, delta=0.01)
            self.assertAlmostEqual(moved, shift, delta=0.01)
            self.assertTrue(low - 0.01 <= shift <= high + 0.01)
            self.assertLess(of_moved, error + 1e-9)  # the noise of the limit is in both

    def test_error_of_the_maximum(self):
        """The scatter of runs gives the error: over many sets of runs, the maxima scatter as stated."""
        random = np.random.default_rng(3)
        tops, errors = [], []
        for _ in range(60):
            of = tables.by_temperature([run(t, deviation=d) for t in T for d in random.standard_normal(12)])
            top, error, *_ = tables.resampled(of, draws=60).maximum(0)
            tops.append(top)
            errors.append(error)
        ratio = np.std(tops, ddof=1) / np.sqrt(np.mean(np.square(errors)))
        # The scatter of 60 maxima is known within 9 %; 11 degrees of freedom make drawn errors 4 % too small. Three standard errors.
        self.assertTrue(0.75 < ratio < 1.35, ratio)

    def test_earlier_runs_that_agree(self):
        """Earlier runs with and without a predicted bias, which have the same limit."""
        points = {hf.Point("density", "tip4p-2005", t, 1, "constant pressure", scheme, 4, 500): [run(t, biased=biased)] * 3
                  for t in T for scheme, biased in (("hoa2", True), ("gier4-fd", False))}
        for row in tables.earlier(runs(), points).splitlines()[2:]:
            self.assertRegex(row, r"^\| \S+, 4 fs \| -?0\.000 ± 0\.\d+ \| 0\.0 \|$")

    def test_all_tables(self):
        lines = [line for of in runs().values() for line in of]
        said = tables.report(lines)
        self.assertIn("| limit of short steps | 277.0", said)
        self.assertIn("| 298 | 4.60 ± 0.00 | -2.00 ± 0.00 | 61.0 ± 0.0 | 1.23 ± 0.00 |", said)  # 1 + 48 / 0.8, and 0.6 / 0.8
        self.assertIn("at least two runs", tables.report(lines[:1]))


if __name__ == "__main__":
    built_program.main()
