# SPDX-License-Identifier: MIT
"""Runs and studies whose states are read through a postprocessor, on the command line."""

import csv
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
            self.done("run", edited(text, ('prefix = "out"', 'prefix = "out"\ntrajectory_every = "40 fs"\nformats = ["pdb"]'), ("20 fs", "60 fs"), ("40 fs", "120 fs")), "--force")
            lines = (self.folder / "out-trajectory.pdb").read_text(encoding="utf-8").splitlines()
            frames.append([float(line[30 + 8 * k:38 + 8 * k]) for line in lines if line.startswith(("ATOM", "HETATM")) for k in range(3)])
        plain, read = frames
        self.assertEqual(len(plain), len(read))
        moved = max(abs(a - b) for a, b in zip(plain, read))  # in Å, with three decimals
        # c h² f/m is 2e-3 Å for f/m = 10 Å/ps², which the hardest contacts of 27 atoms of a gas at 100 K have.
        self.assertGreater(moved, 1.5e-3)
        self.assertLess(moved, 0.1)

    def test_a_resumed_run_has_the_same_files(self):
        self.done("run", READ)
        energies, end = self.rows("out-energies.csv"), (self.folder / "out-final.gro").read_bytes()
        for length in ("1 ps", "1.02 ps"):  # at a sample, and between two samples
            self.done("run", READ, "--force", "--length", length)
            self.done("run", READ, "--resume")
            self.assertEqual(self.rows("out-energies.csv"), energies)
            self.assertEqual((self.folder / "out-final.gro").read_bytes(), end)
        self.write("run.toml", RUN)
        self.refused(("run", "run.toml", "--resume"), ["another run", "output.processed was true"])

    def test_what_cannot_be_read_so_is_refused(self):
        for text, options, words in (
                (READ, ("--scheme", "hoa2"), ["output.processed", "hoa2", "takahashi-imada"]),
                (READ, ("--scheme", "velocity-verlet / hoa2 x 1 within 0.6 nm"), ["output.processed", "no postprocessor"]),
                (READ + LANGEVIN, (), ["not at constant energy", "another temperature"]),
                (READ + HYBRID, (), ["not at constant energy", "leave output.processed out"]),
                (edited(READ, ('step = "20 fs"', 'accuracy = "1 %"')), (), ["output.processed", "adviser"])):
            self.write("run.toml", text)
            self.refused(("run", "run.toml", *options), words)
        self.write("run.toml", READ)
        self.refused(("study", "run.toml", "--schemes", "velocity-verlet", "hoa2"), ["output.processed", "hoa2"])
        self.refused(("study", "run.toml", "--ensemble", "nvt"), ["output.processed", "canonical study"])
        self.refused(("advise", "run.toml", "--accuracy", "1 %"), ["output.processed", "adviser"])

    def test_mixed_precision_and_the_pressure_tensor(self):
        text = edited(READ, ('cutoff = "1.0 nm"', 'cutoff = "1.0 nm"\nprecision = "mixed"'), ("processed = true", "processed = true\npressure_tensor = true"))
        self.done("run", text)
        rows = list(csv.DictReader(self.rows("out-energies.csv")))
        self.assertEqual(len(rows), 51)
        for row in rows:
            diagonal = [float(row[f"pressure_{k}{k} [bar]"]) for k in "xyz"]
            self.assertLess(abs(sum(diagonal) - 3 * float(row["pressure [bar]"])), 1e-9 * (1 + sum(map(abs, diagonal))))

    def test_a_study_reads_its_samples(self):
        ratios = []
        for text in (RUN, READ):
            text = edited(text, ('steps = ["2 fs"]', 'steps = ["20 fs"]'), ('length = "0.1 ps"', 'length = "2 ps"'))
            ratios.append(json.loads(self.done("study", text, "--json", "--force").out)["points"][0]["R"])
            conditions = (self.folder / "study.json").read_text(encoding="utf-8")
            self.assertEqual("read through postprocessors" in conditions, text.count("processed = true") == 1)
        self.assertLess(ratios[1], 0.5 * ratios[0])

    def test_schemes_show_their_postprocessors(self):
        self.assertIn("postprocessor", self.polhode("schemes", "takahashi-imada-fd").out)
        known = {name: json.loads(self.polhode("schemes", name, "--json").out)["postprocessor"] for name in ("gier4", "hoa2")}
        self.assertEqual(known["gier4"].count("A("), 5)
        self.assertEqual(known["hoa2"], "")


if __name__ == "__main__":
    sandbox.main()
