# SPDX-License-Identifier: MIT
"""The statistics and evaluations of the studies are right where the result is known."""

import random
import unittest
from math import sqrt

import study_path  # first: it says where the others are
import built_program
import acceptance_ratios
import adviser
import agreement
import all_schemes
import analysis_errors
import drift
import half_femtosecond as hf
import half_femtosecond_compared as compared
import half_femtosecond_tables as tables
import liquids
import multiple_time_steps
import numpy as np
import pandas
import quick_study
import shadow
from lib import curves, figures, runs, slopes, statistics


def curve(scheme, evaluations, factor, order, steps, max_step=99, stable=True):
    """Points of a scheme with R = factor hⁿ at evaluations per step; above the longest step the energy is lost."""
    return [{"scheme": scheme, "step_fs": h, curves.COST: 1000 * evaluations / h, "stable": stable, "R": factor * h**order if h <= max_step else 1.2}
            for h in steps]


def correlated(generator, n, centre, phi):
    """Normal values of variance 1 with the autocorrelation phi^|k|."""
    x, noise = np.empty(n), np.sqrt(1 - phi * phi) * generator.normal(size=n)
    x[0] = generator.normal()
    for k in range(1, n):
        x[k] = phi * x[k - 1] + noise[k]
    return centre + x


class Statistics(unittest.TestCase):
    def test_means(self):
        value, error = statistics.mean([1, 2, 3])
        self.assertAlmostEqual(value, 2)
        self.assertAlmostEqual(error, 1 / 3**0.5)
        self.assertEqual(statistics.text((1.23456, 0.012), 3), "1.235 ± 0.012")
        self.assertEqual(statistics.text(statistics.mean([1.5]), 1), "1.5")
        # Blocks of 100 with the means 1, 3 and 5: variance 4. The 301st value is left out.
        value, error = statistics.block_mean(np.repeat([1.0, 3.0, 5.0], [100, 100, 101]), 3)
        self.assertAlmostEqual(value, 3)
        self.assertAlmostEqual(error, sqrt(4 / 3))

    def test_jackknife_of_a_mean(self):
        value, error = statistics.jackknife([1.0, 2.0, 4.0, 7.0], lambda own: {"mean": sum(own) / len(own)})
        self.assertAlmostEqual(value["mean"], 3.5, 12)
        self.assertAlmostEqual(error["mean"], sqrt(21 / 3 / 4), 12)

    def test_intervals_of_shares(self):
        low, high = statistics.share_interval(20, 20, "exact")  # the lower end is where p^n = 0.025
        self.assertAlmostEqual(low, 0.025 ** (1 / 20), 9)
        self.assertEqual(high, 1)
        self.assertAlmostEqual(sum(statistics.share_interval(5, 10, "exact")), 1, 9)
        low, high = statistics.share_interval(5, 10)  # Wilson: centre 1/2, half width z/2/sqrt(n + z²)
        self.assertAlmostEqual(high - 0.5, 1.959964 / 2 / sqrt(10 + 1.959964**2), 6)

    def test_errors_over_scatter(self):
        self.assertEqual(statistics.over_scatter([(1, 1), (3, 1)]), None)
        stated, scatter, ratio = statistics.over_scatter([(1, 1), (2, 2), (3, 2), (9, None)])
        self.assertAlmostEqual(stated, sqrt(3))
        self.assertAlmostEqual(scatter, 1)
        self.assertAlmostEqual(ratio, sqrt(3))

    def test_inefficiency_of_a_known_correlation(self):
        generator = np.random.default_rng(1)
        for phi in (0.0, 0.5, 0.9):
            # g = (1 + phi)/(1 - phi), known to sqrt(4 (2 W + 1)/n) of itself with a window W of 2.5 g: 7 % for g = 19
            g = statistics.inefficiency(correlated(generator, 80000, 0, phi))
            self.assertLess(abs(g / ((1 + phi) / (1 - phi)) - 1), 4 * 0.07)

    def test_slope_and_its_error_are_those_of_normal_densities(self):
        # Normal densities of variance 1 at 0 and at d have ln p2/p1 = const + d x.
        generator, d, deviations = np.random.default_rng(2), 1.5, []
        for _ in range(60):
            s, error = slopes.slope(*(slopes.independent(correlated(generator, 4000, centre, 0.8)) for centre in (0, d)))
            deviations.append((s - d) / error)
        # The rms of 60 standard normal deviates is 1 +- 1/sqrt(120), and their mean 0 +- 1/sqrt(60); subsampled values keep
        # a correlation below 0.8^9 = 0.13, which makes errors too small by 10 % at most.
        self.assertLess(abs(np.sqrt(np.mean(np.square(deviations))) - 1), 4 / np.sqrt(120) + 0.1)
        self.assertLess(abs(np.mean(deviations)), 4 / np.sqrt(60))

    def test_the_slopes_of_theory(self):
        at = [{"temperature": 300, "pressure": 1}, {"temperature": 300, "pressure": 1001}]
        self.assertAlmostEqual(slopes.expected("volume", *at), -60.2214076 / (0.00831446261815324 * 300))  # 1000 bar
        at[1]["temperature"] = 330
        self.assertAlmostEqual(slopes.expected("potential", *at), (1 / 300 - 1 / 330) / 0.00831446261815324)

    def test_acceptance_ratios_and_mbar(self):
        """Two harmonic wells, of which the second is four times as stiff: ln 2. For two stages both methods are the same equation."""
        random = np.random.default_rng(1)
        first, second = random.standard_normal(40000), random.standard_normal(40000) / 2
        u = lambda x: np.array([0.5 * x**2, 2 * x**2])
        ratio = acceptance_ratios.acceptance_ratio(np.diff(u(first), axis=0)[0], -np.diff(u(second), axis=0)[0])
        self.assertAlmostEqual(ratio, np.log(2), delta=0.013)  # four standard errors, from 60 other seeds
        self.assertAlmostEqual(acceptance_ratios.mbar(u(np.concatenate([first, second])), 40000)[1], ratio, delta=1e-6)


class Curves(unittest.TestCase):
    def test_a_power_law_is_met_between_its_points_and_nothing_beyond(self):
        cost, step = curves.at_ratio(curve("hoa2", 2, 2e-4, 2, (2, 4, 8)), 5e-3)
        self.assertAlmostEqual(step, sqrt(5e-3 / 2e-4), 9)
        self.assertAlmostEqual(cost, 2000 / step, 6)
        own = curve("hoa2", 2, 2e-4, 2, (2, 4)) + curve("hoa2", 2, 2e-4, 2, (8,), stable=False)
        self.assertIsNone(curves.at_ratio(own, 2e-4 * 3.9))  # below the smallest R
        self.assertEqual(curves.at_ratio(own, 5e-3), (500, 4))  # at 8 fs it blew up: the longest step before
        self.assertIsNone(curves.at_ratio(curve("hoa2", 2, 2e-4, 2, (2, 4), stable=False), 1e-2))

    def test_a_curve_ends_where_its_energy_is_lost(self):
        own = curve("hoa2", 2, 2e-4, 2, (2, 4, 8))
        own[1].update(R=1.2, drift_p_value=0.0034)  # two runs with a drift of 185 times its error
        self.assertEqual(len(curves.usable(own)), 1)
        own[1].update(R=3e-3)
        self.assertEqual(len(curves.usable(own)), 3)

    def test_costs_of_all_schemes(self):
        for cheap, dear in zip(all_schemes.steps("pme", 1), all_schemes.steps("pme", 4)):
            self.assertAlmostEqual(4 * cheap / dear, 1, 2)  # three digits
        self.assertAlmostEqual(all_schemes.steps("pme", 2)[0], 1)  # 2,000 evaluations per ps
        own = curve("hoa2", 2, 2e-4, 2, (2, 4, 8), max_step=4)
        self.assertEqual(all_schemes.cost_at(own, 2e-4 * 9, 2)[2], "")
        cost, _, how = all_schemes.cost_at(own, 2e-4 * 1, 2)
        self.assertAlmostEqual(cost, 2000, 6)
        self.assertEqual(how, "*")
        self.assertEqual(all_schemes.cost_at(own, 1, 2), (500, 4, "+"))
        self.assertIsNone(all_schemes.cost_at(curve("hoa2", 2, 2e-4, 2, (2, 4), max_step=1), 1, 2))

    def test_tables(self):
        ranking = [{"R": 0.01, "schemes": [{"scheme": "bcss3", "cost": 300, "step_fs": 4, "how": ""},
                                           {"scheme": "hoa2", "cost": 500, "step_fs": 4, "how": "+", "seconds_per_ps": 0.2}]}]
        table = all_schemes.report({"systems": {"pme": {"points": [], "ranking": ranking}}})
        self.assertIn("| bcss3 | **300** |", table)
        self.assertIn("| hoa2 | 500+ (200 s) |", table)
        row = {"R": 0.005, "single": {"scheme": "a", "step_fs": 4, "cost": 500, "seconds_per_ps": 0.2},
               "nested": {"scheme": "b / c", "step_fs": 6, "cost": 400, "seconds_per_ps": 0.1}}
        table = multiple_time_steps.report({"laws": {"pme": {"guideline": [row, {"R": 0.01}]}}})
        self.assertIn("| 1.25 | 2.00 |", table)
        self.assertEqual(len(table.splitlines()), 3)

    def test_the_best_of_each_pair_is_drawn(self):
        pair = "hoa2 / hoa2 x {} within 0.35 to 0.5 nm"
        drawn = multiple_time_steps.drawn(curve("hoa2", 2, 2e-4, 2, (4, 5)) + curve(pair.format(1), 3, 1e-4, 2, (6, 8))
                                          + curve(pair.format(2), 9, 1e-4, 2, (6, 8)))
        self.assertEqual(list(drawn), ["hoa2", pair.format(1)])

    def test_styles(self):
        table = figures.styles(["hoa2", "a / b", "gier4-fd", "B(1/2) A(1) B(1/2)"])
        self.assertEqual(table["hoa2"], ("#D55E00", "s"))
        self.assertEqual(table["a / b"], figures.styles(["other"])["other"])
        self.assertEqual(len(set(table.values())), 5 - 1)

    def test_points_that_a_quick_study_lacks(self):
        point = lambda scheme, step, usable, p=0.5: {"scheme": scheme, "step_fs": step, "usable": usable, "drift_p_value": p}
        points = [point("hoa2", 4, True, 0.001), point("hoa2", 7, False), point("hoa2", 9, False), point("gier4-fd", 3, True)]
        self.assertEqual(quick_study.last_steps(), {"velocity-verlet": 6, "hoa2": 7, "gier4-fd": 8})  # the ends of the paper
        table = quick_study.report({"studies": [{"instruction_set": "avx2", "seed": 1, "best": "gier4-fd", "points": points}]})
        self.assertIn("| avx2 | 1 | hoa2 7 fs | hoa2 4 fs | gier4-fd |", table)
        self.assertIn("1 of 2 curves lack points", table)


class HalfFemtosecond(unittest.TestCase):
    def test_cost_at_a_bias(self):
        law = lambda *costs: [(cost, 8e6 / cost**2) for cost in costs]  # second order
        for of in (law(250, 500, 1000), law(1000, 500, 250), law(2000, 4000)[::-1], law(100, 200), [(c, -b) for c, b in law(250, 500, 1000)]):
            longest = min(c for c, _ in of)
            self.assertAlmostEqual(tables.cost_at(of, 20), max(longest, 632.455532), places=5)
        self.assertIsNone(tables.cost_at(law(500), 20))

    def test_no_cost_is_continued_beyond_the_longest_step(self):
        """The bias at the longest step is 80. A bound of 80 or more gives the cost of this step, and any power law would give a lower one.
        Bounds below the bias of the shortest step are continued to shorter steps. Noise that reverses the two longest steps changes
        nothing: the longest step decides."""
        law = [(cost, 2e7 / cost**2, 0.0) for cost in (500, 1000, 2000)]
        self.assertEqual(tables.cost_text(law, 81), "below 500 (longest step measured)")
        self.assertEqual(tables.cost_text(law, 80), "below 500 (longest step measured)")
        self.assertEqual(tables.cost_text(law, 79), "503 ± 0")
        self.assertEqual(tables.cost_text(law, 0.05), "20000 ± 0")
        self.assertEqual(tables.cost_text([(500, 60, 0.0), (1000, 70, 0.0), (2000, 5, 0.0)], 65), "below 500 (longest step measured)")
        self.assertEqual(tables.cost_text([(500, 80, 0.0)], 20), "")

    def test_maximum_of_a_curve_that_falls_faster_on_the_cold_side(self):
        T = [257, 267, 277, 287, 298, 308, 318]
        self.assertAlmostEqual(tables.maximum(tables.density_fit(T, [1000 - 0.01 * (t - 277) ** 2 + 1e-4 * (t - 277) ** 3 for t in T])), 277)
        self.assertEqual(tables.maximum(tables.density_fit(T, [1000 + t for t in T])), 318)

    def test_bias_of_a_density(self):
        run = {"density_kg_per_m3": {"value": 1000}, "volume_nm3": {"value": 6.0}, "step_bias": {"volume_nm3": {"value": 0.003}}}
        self.assertAlmostEqual(tables.density_bias(run), -0.5)

    def test_measured_biases_from_common_starts(self):
        """Two schemes and three starts whose energies differ by 10: the predicted bias of the second is 0.5, the measured one 0.5 as well, and
        without noise the error is 0. At the same kinetic energy biases are larger by dU/dK = 3."""
        point = lambda scheme: hf.Point("energy", "spce", 298.15, 0.998, "constant energy", scheme, 4, 100)
        runs = {}
        for scheme, bias in (("gier4-fd", 0.0), ("hoa2", 0.5)):
            runs[point(scheme)] = []
            for start in range(3):
                K = 7 + 0.1 * start
                run = {"potential_kJ_per_mol": 3 * K + bias, "pressure_bar": 100 * K + 40 * bias, "degrees_of_freedom_rotation": [216],
                       "step_bias": {"potential_kJ_per_mol": {"value": bias}, "pressure_bar": {"value": 40 * bias}}}
                runs[point(scheme)].append(run | {"temperature_K": (K - bias) / (1293 / 432 * compared.GAS)})
        value, error = compared.from_common_starts(runs, compared.potential, "potential")[point("hoa2")]
        self.assertAlmostEqual(value, 0.5, 9)
        self.assertAlmostEqual(error, 0, 9)
        (heat, _), (stress, _) = compared.responses(runs)
        self.assertAlmostEqual(heat, 3, 9)
        self.assertAlmostEqual(stress, 100, 7)
        bias = compared.at_same_kinetic_energy(runs)
        self.assertAlmostEqual(bias(runs[point("hoa2")], "potential")[0], 2, 9)
        self.assertAlmostEqual(bias(runs[point("hoa2")], "pressure")[0], 70, 6)
        self.assertAlmostEqual(bias(runs[point("hoa2")], "density")[0], -7000 * tables.KAPPA, 6)

    def test_third_order_temperature(self):
        """Full steps deviate by -2 and half steps by 1: the third-order estimate has no deviation."""
        run = {"temperature_K": 298.15, "temperature_translation_K": 296.15, "temperature_rotation_K": [278.15] * 3,
               "half_steps": {"temperature_translation_K": 299.15, "temperature_rotation_K": [308.15] * 3},
               "temperature_configurational_K": [{"value": T} for T in (299, 308, 308, 308)]}
        point = hf.Point("half-steps", "spce", 298.15, 0.998, hf.HALF, "baoab", 4, 100)
        found = compared.estimators({point: [run, run]})
        self.assertIn("| 4 | rotation minus translation | -18.00 ± 0.00 | 9.00 ± 0.00 | 0.00 ± 0.00 | 9.00 ± 0.00 | 18.000 ± 0.000 |  |", found)
        self.assertIn("| 2.000 ± 0.000 | 13.82 ± 0.00 |", found)  # 3 K times 4.606 bar/K of 33.36 molecules per nm³

    def test_slope_of_a_weighted_line(self):
        value, error = tables.slope([(0.98, 3 - 0.04, 0.1), (1, 3, 0.1), (1.02, 3 + 0.04, 0.1)])
        self.assertAlmostEqual(value, 2)
        self.assertAlmostEqual(error, 0.1 / (2 * 0.02**2) ** 0.5)
        self.assertAlmostEqual(tables.slope([(0, 0, 1), (1, 5, 1), (2, 100, 1e9)])[0], 5)


class Liquids(unittest.TestCase):
    def made(self, temperature, noise):
        """Samples of a run at constant energy: V = E - kinetic, P linear in T plus noise."""
        sign = np.where(np.arange(101) % 2, 1, -1)
        T = temperature + noise * sign
        return pandas.DataFrame({"total": 30.0 * temperature, "potential": 30 * temperature - 9 * T, "temperature": T,
                                 "pressure": 5 * (temperature - 300) + 8 * sign})

    def test_at_temperature(self):
        """Exact where T(E), V(E) and P(E) are lines; errors vanish where all blocks lie on them."""
        found = liquids.blocks([self.made(t, 2.0) for t in (290, 297, 309)], 5)
        self.assertEqual(len(found), 15)
        value, error = statistics.jackknife(found, lambda own: liquids.at_temperature(own, 300))
        for name, expected in (("potential", 21 * 300), ("pressure", 0), ("heat_capacity", 30)):
            self.assertAlmostEqual(value[name], expected, 7)
            self.assertAlmostEqual(error[name], 0, 7)

    def test_first_peak(self):
        """Exact where place and height are lines in the temperature; the mean where all runs have the same."""
        value, error = liquids.first_peak([(t, 0.27 + 1e-4 * (t - 298), 3 - 0.01 * (t - 298)) for t in (290, 297, 306)], 298)
        self.assertAlmostEqual(value["place"], 0.27, 12)
        self.assertAlmostEqual(value["height"], 3, 12)
        self.assertAlmostEqual(error["height"], 0, 12)
        self.assertAlmostEqual(liquids.first_peak([(298, 0.27, 3), (298, 0.28, 3.2)], 300)[0]["height"], 3.1, 12)

    def test_deviations_from_all_others(self):
        # The mean of the others is 0 with an error of sqrt(3² + 0²)/2 = 1.5; sqrt(2² + 1.5²) = 2.5.
        self.assertAlmostEqual(agreement.deviations([(5, 2), (-1, 3), (1, 0)])[0], 2)
        self.assertEqual(agreement.deviations([(1, 1)] * 3), [0, 0, 0])

    def test_scaled_velocities(self):
        numbers = lambda r, v: "".join(f"{x:15.10f}" for x in r) + "".join(f"{x:15.11f}" for x in v)
        gro = lambda v: "\n".join(["polhode", "1", "    1spce    OW    1" + numbers((1, 2, 3), v), numbers((3, 3, 3), ()), ""])
        self.assertEqual(agreement.with_scaled_velocities(gro((0.5, -1, 2)), 1.5), gro((0.75, -1.5, 3)))



class Calibration(unittest.TestCase):
    # 1600 degrees of freedom know a scatter to 1/√3200 = 1.8 %; three times that is allowed.
    def test_stated_errors_over_the_scatter_within_runs(self):
        for error in (0.5, 1.0, 2.0):
            draw = random.Random(5)
            made = [[{"x": (centre + draw.gauss(0, 1), error)} for _ in range(5)] for centre in (draw.gauss(0, 10) for _ in range(400))]
            every, told, scatter, rms, mean = analysis_errors.compared(made, "x")
            self.assertEqual((every, told), (2000, 1))
            self.assertAlmostEqual(scatter, 1, delta=0.054)
            self.assertAlmostEqual(rms / error, 1, delta=0.054)
            self.assertAlmostEqual(mean / error, 1, delta=0.054)
        for run in made:
            run[0]["x"] = (run[0]["x"][0], None)
        self.assertEqual(analysis_errors.compared(made, "x")[:2], (2000, 0.8))

    def test_runs_with_a_drift(self):
        reports = [{"drift_p_value": p} for p in (0.001, 0.02, 0.04, 0.5, None, 0.7, 0.8, 0.9, 0.95, 0.99)]
        self.assertEqual((drift.fired(reports, 0.05), drift.fired(reports)), (3, 1))
        self.assertEqual([len(cells) for _, cells in drift.DESIGNS.values()], [17, 6])

    def test_samples_of_the_shadow_energy_are_whole_steps_near_4_fs(self):
        self.assertEqual([shadow.sample(h) for h in (1, 2, 3, 4, 6)], [4, 4, 3, 4, 6])

    def test_answers_of_the_adviser(self):
        none = {"system": "co2-125", "accuracy": 0.02, "answer": None, "why": "too slow"}
        case = {"system": "argon-108", "accuracy": 0.01, "answer": {"scheme": "hoa2", "step_fs": 20}, "length_ps": 8, "refused": 1, "surpassed": 2,
                "R_expected": 0.006, "R_expected_error": 0.0002, "bound": 0.0085, "reached": 0.85, "R_fresh": [0.006, 0.009], "kept": 2,
                "below_bound": 1, "runs": 2}
        self.assertIn("| co2-125 | 2 | none: too slow |", adviser.report({"cases": [none]}))
        table = adviser.report({"cases": [case, {**case, "reached": 0.55}]})
        self.assertIn("| 0.85 | 0.75 | 0.90 | 2 of 2 | 1 of 2 |", table)
        self.assertIn("4 of 4 new runs met the required R: 100.0 %", table)
        self.assertIn("Bounds are 0.55 to 0.85 of the requirement, 0.70 on average; 1 of 2 are from 0.8 to 1.", table)


class RunFiles(unittest.TestCase):
    def test_tables(self):
        self.assertEqual(runs.run_file(system={"molecules": runs.molecules("spce", 2), "seed": 3, "none": None}, output={"formats": ["gro"], "velocities": False}),
                         '[system]\nmolecules = [{ model = "spce", count = 2 }]\nseed = 3\n\n[output]\nformats = ["gro"]\nvelocities = false\n')


if __name__ == "__main__":
    built_program.main()
