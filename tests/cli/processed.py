# SPDX-License-Identifier: MIT
"""Runs and studies whose states are read through a postprocessor, on the command line."""

import json

import sandbox
from sandbox import SMALL, Sandbox, edited

RUN = edited(SMALL, ('scheme = "hoa2"\nstep = "2 fs"', 'scheme = "velocity-verlet"\nstep = "20 fs"'), ('length = "0.02 ps"', 'length = "2 ps"\nsample = "40 fs"'))
READ = edited(RUN, ('plot = "none"', 'plot = "none"\nprocessed = true'))
HYBRID = "[hybrid_monte_carlo]\nsteps = 5\n"
LANGEVIN = '[thermostat]\ntype = "langevin"\n'


class Processed(Sandbox):
    def test_the_energy_fluctuates_less_and_the_trajectory_is_the_same(self):
        plain = json.loads(self.done("run", RUN, "--json").out)
        end = (self.folder / "out-final.gro").read_bytes()
        read = json.loads(self.done("run", READ, "--json", "--force").out)
        self.assertEqual([plain["processed"], read["processed"]], [False, True])
        self.assertLess(read["R"], 0.5 * plain["R"])
        # 51 samples of three evaluations, besides the forces at the start, which the first step needs too.
        self.assertEqual(read["force_evaluations_for_energies"], 3 * 51)
        self.assertEqual(read["force_evaluations"], read["steps"] + 1)
        self.assertEqual((self.folder / "out-final.gro").read_bytes(), end)
        self.assertIn("states read", self.done("run", READ, "--force").out)

    def test_frames_are_those_that_are_read(self):
        frames = []
        for text in (RUN, READ):
            self.done("run", edited(text, ('prefix = "out"', 'prefix = "out"\ntrajectory_every = "40 fs"\nformats = ["gro"]')), "--force")
            frames.append((self.folder / "out-trajectory.gro").read_text(encoding="utf-8").splitlines())
        plain, read = frames
        self.assertEqual(len(plain), len(read))
        self.assertNotEqual(plain, read)
        x, y = ([float(line[20:28]) for line in part if len(line) > 60] for part in frames)
        self.assertEqual(len(x), 51 * 27)
        # Of order c h² f/m: below 1e-3 nm for argon at 20 fs, where f/m is below 2 nm/ps².
        self.assertLess(max(abs(a - b) for a, b in zip(x, y)), 0.0021)

    def test_a_resumed_run_has_the_same_files(self):
        for text in (READ, READ + LANGEVIN):
            self.done("run", text, "--force")
            energies, end = self.rows("out-energies.csv"), (self.folder / "out-final.gro").read_bytes()
            for length in ("1 ps", "1.02 ps"):  # at a sample, and between two samples
                self.done("run", text, "--force", "--length", length)
                self.done("run", text, "--resume")
                self.assertEqual(self.rows("out-energies.csv"), energies)
                self.assertEqual((self.folder / "out-final.gro").read_bytes(), end)
        self.write("run.toml", RUN + LANGEVIN)
        self.refused(("run", "run.toml", "--resume"), ["another run", "output.processed was true"])

    def test_what_has_no_postprocessor_is_refused(self):
        for text, options, words in (
                (READ, ("--scheme", "hoa2"), ["output.processed", "hoa2", "takahashi-imada"]),
                (READ, ("--scheme", "velocity-verlet / hoa2 x 1 within 0.6 nm"), ["output.processed", "no postprocessor"]),
                (READ + LANGEVIN, ("--scheme", "baoab"), ["no postprocessor", "at most at the ends of a step"]),
                (READ + HYBRID, (), ["hybrid Monte Carlo", "leave output.processed out"])):
            self.write("run.toml", text)
            self.refused(("run", "run.toml", *options), words)
        self.write("run.toml", READ)
        self.refused(("study", "run.toml", "--schemes", "velocity-verlet", "hoa2"), ["output.processed", "hoa2"])

    def test_a_study_reads_its_samples(self):
        ratios = []
        for text in (RUN, READ):
            text = edited(text, ('steps = ["2 fs"]', 'steps = ["20 fs"]'), ('length = "0.1 ps"', 'length = "2 ps"'))
            ratios.append(json.loads(self.done("study", text, "--json", "--force").out)["points"][0]["R"])
        self.assertLess(ratios[1], 0.5 * ratios[0])

    def test_schemes_show_their_postprocessors(self):
        self.assertIn("postprocessor", self.polhode("schemes", "takahashi-imada-fd").out)
        known = {name: json.loads(self.polhode("schemes", name, "--json").out)["postprocessor"] for name in ("gier4", "hoa2")}
        self.assertEqual(known["gier4"].count("A("), 5)
        self.assertEqual(known["hoa2"], "")


if __name__ == "__main__":
    sandbox.main()
