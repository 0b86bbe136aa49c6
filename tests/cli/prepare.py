# SPDX-License-Identifier: MIT
"""`polhode minimise` and `polhode prepare`: from overlapping molecules, or a composition, to a run without warnings."""

import json
import re
import signal
import time
import unittest
from pathlib import Path

import sandbox
from sandbox import Sandbox, edited

BENZENE = """[system]
molecules = [{ model = "benzene", count = 40 }]
density = "0.876 g/cm3"
temperature = "300 K"

[forces]
cutoff = "0.8 nm"

[run]
length = "20 fs"

[output]
prefix = "out"
plot = "none"
"""
BOUNDS = ("--max-force", "1000 kJ/mol/nm", "--max-torque", "100 kJ/mol")

ARGON = """[system]
molecules = [{ model = "argon", count = 125 }]
temperature = "90 K"

[forces]
cutoff = "0.75 nm"

[prepare]
nvt = "1 ps"
npt = "2 ps"

[run]
length = "0.1 ps"

[output]
prefix = "out"
plot = "none"
"""
AT_PRESSURE = ("--pressure", "10 bar")


def handles(process, number):
    """Whether a process has its own handler of a signal; an assertion fails once it has ended."""
    status = Path(f"/proc/{process.pid}/status").read_text(encoding="utf-8")
    caught = re.search(r"^SigCgt:\s*(\w+)", status, re.M)
    if process.poll() is not None:
        raise AssertionError("it ended by itself")
    return caught is not None and int(caught[1], 16) >> (number - 1) & 1 == 1


class Prepare(Sandbox):
    def interrupted(self, *arguments, after=None):
        """The process, stopped by Ctrl-C when it has reported this, or as soon as it handles it."""
        process = self.start(*arguments)
        self.addCleanup(process.kill)
        if after:
            self.assertTrue(any(after in line for line in process.stderr), "it ended by itself")
        while not handles(process, signal.SIGINT):
            time.sleep(0.01)
        self.assertIsNone(process.poll(), "it ended by itself")
        process.send_signal(signal.SIGINT)
        process.out, process.err = process.communicate(timeout=sandbox.LONGEST)
        self.assertEqual(process.returncode, 130, process.err)
        return process

    def test_minimise_overlapping_molecules(self):
        self.write("run.toml", BENZENE)
        self.refused(("run", "run.toml"), ["overlap", "minimise = true in [run]", "'polhode minimise'"])
        report = json.loads(self.done("minimise", BENZENE, *BOUNDS, "--json").out)
        self.assertEqual(report["end"], "converged")
        self.assertLessEqual(report["after"]["force_kJ_per_mol_nm"], 1000)
        self.assertLessEqual(report["after"]["torque_kJ_per_mol"], 100)
        self.assertGreater(report["before"]["force_kJ_per_mol_nm"], 1000)
        self.assertLess(report["after"]["potential_kJ_per_mol"], report["before"]["potential_kJ_per_mol"])
        self.assertEqual(report["files"], ["out-minimised.gro"])
        # The file has these positions, and no velocities, so that a run draws them.
        start = edited(BENZENE, ('density = "0.876 g/cm3"', 'initial_configuration = "out-minimised.gro"'))
        energy = json.loads(self.done("energy", start, "--json").out)["potential_kJ_per_mol"]
        self.assertAlmostEqual(energy / 40, report["after"]["potential_kJ_per_mol"], places=5)
        self.assertNotIn("velocities come from", self.done("run", start).err)
        self.refused(("minimise", "run.toml", "--force"), ["'out-minimised.gro' is an input of this command", "another prefix"])
        self.write("run.toml", BENZENE)
        self.refused(("minimise", "run.toml"), ["out-minimised.gro", "--force"])
        text = self.done("minimise", BENZENE, "--max-steps", "3", "--force").out
        self.assertRegex(text, r"steps +3\nended +maximum number of steps\n")

    def test_minimise_in_a_run(self):
        process = self.done("run", edited(BENZENE, ("[run]", "[run]\nminimise = true")), "--json")
        self.assertIn("minimised in", process.err)
        self.assertLess(json.loads(process.out)["potential_kJ_per_mol"], 0)

    def test_interrupted_minimisation_is_written(self):
        self.write("run.toml", BENZENE)
        process = self.interrupted("minimise", "run.toml", "--max-force", "1e-300 kJ/mol/nm", "--max-steps", "100000000",
                                   "--json")
        self.assertEqual(json.loads(process.out)["end"], "interrupted")
        self.assertEqual((self.folder / "out-minimised.gro").read_text().count("benze"), 40 * 12)

    def test_prepare_from_a_pressure(self):
        process = self.done("prepare", ARGON, *AT_PRESSURE, "--json")
        self.assertIn("no density is given, so the lattice has", process.err)
        report = json.loads(process.out)
        self.assertTrue(report["density_estimated"])
        # Liquid argon at 90 K has 1.38 g/cm3; the volume changes little within 2 ps.
        self.assertTrue(1.1 < report["properties"]["density_g_per_cm3"] < 1.6, report)
        self.assertEqual(report["properties"]["pressure_of_barostat_bar"], 10)
        self.assertEqual(report["files"], ["out-prepared.gro", "out-prepared.bin", "out-prepared.toml"])
        first = self.contents()
        self.done("prepare", ARGON, *AT_PRESSURE, "--force", "--threads", "2")
        self.assertEqual(first["out-prepared.gro"], self.contents()["out-prepared.gro"])
        written = (self.folder / "out-prepared.toml").read_text()
        self.assertIn("out-prepared.gro", written)
        self.assertNotIn("prepare]", written)
        run = self.polhode("run", "out-prepared.toml")
        self.assertEqual(run.returncode, 0, run.err)
        self.assertNotIn("warning", (run.out + run.err).lower())

    def test_prepare_at_a_density(self):
        text = edited(ARGON, ('temperature', 'density = "1.3 g/cm3"\ntemperature'))
        out = self.done("prepare", text).out
        self.assertIn("1300 kg/m3, constant", out)
        self.assertIn("polhode run out-prepared.toml", out)
        self.refused(("prepare", "run.toml"), ["out-prepared.bin", "--resume", "--force"])

    def test_interrupted_minimisation_leaves_no_files(self):
        self.write("run.toml", edited(BENZENE, ("count = 40", "count = 4000")))
        before = self.contents()
        process = self.interrupted("prepare", "run.toml")
        if "no file was written" in process.err:  # otherwise it was minimised within the second
            self.assertEqual(self.contents(), before)

    def test_interrupted_preparation_resumes(self):
        """With the same files as the uninterrupted one; an ended one prints its summary again."""
        arguments = ("prepare", "run.toml", *AT_PRESSURE, "--npt", "200 ps")
        self.write("run.toml", ARGON)
        whole = self.polhode(*arguments, "--json")
        self.assertEqual(whole.returncode, 0, whole.err)
        results = self.contents()
        for path in self.folder.glob("out-*"):
            path.unlink()
        process = self.interrupted(*arguments, after="NPT for")
        self.assertIn("--resume continues the preparation from the checkpoint 'out-prepared.bin'", process.err)
        self.assertFalse((self.folder / "out-prepared.gro").exists())
        rest = self.polhode(*arguments, "--resume", "--json")
        self.assertEqual(rest.returncode, 0, rest.err)
        self.assertIn("resuming after", rest.err)
        self.assertEqual(json.loads(rest.out), json.loads(whole.out))
        for name in ("out-prepared.gro", "out-prepared.toml"):
            self.assertEqual(self.contents()[name], results[name])
        again = self.polhode(*arguments, "--resume", "--json")
        self.assertEqual(json.loads(again.out), json.loads(whole.out))
        self.refused(("prepare", "run.toml", *AT_PRESSURE, "--npt", "50 ps", "--resume"), ["prepare.npt was 200 ps and is now 50 ps"])
        # The run starts from the checkpoint, which another box does not fit.
        self.assertIn('checkpoint = "out-prepared.bin"', (self.folder / "out-prepared.toml").read_text().replace("'", '"'))
        lines = (self.folder / "out-prepared.gro").read_text().splitlines()
        self.write("out-prepared.gro", "\n".join(lines[:-1]) + "\n 3.0 3.0 3.0\n")
        self.refused(("run", "out-prepared.toml"), ["box of the checkpoint", "leave the checkpoint out", "system.checkpoint"])

    def test_solutes_in_water(self):
        """One benzene, and four pairs of ions, in 100 waters, at the density of water and with PME."""
        for water, solute in (("tip4p", '{ model = "benzene", count = 1 }'),
                              ("spce", '{ model = "na-spce", count = 4 }, { model = "cl-spce", count = 4 }')):
            with self.subTest(solute=solute):
                text = edited(BENZENE, ('{ model = "benzene", count = 40 }', f'{{ model = "{water}", count = 100 }}, {solute}'),
                              ('"0.876 g/cm3"', '"0.95 g/cm3"'), ('cutoff = "0.8 nm"', 'cutoff = "0.7 nm"\nelectrostatics = "pme"\nmixing = "geometric"'))
                report = json.loads(self.done("prepare", text, "--pressure", "1 bar", "--nvt", "0.4 ps", "--npt", "0.8 ps",
                                              "--force", "--json").out)
                self.assertEqual(report["minimisation"]["end"], "converged")
                # Away from overlaps and gas: the volume relaxes in 2 ps.
                self.assertTrue(0.8 < report["properties"]["density_g_per_cm3"] < 1.25, report)
                self.assertTrue(200 < report["properties"]["temperature_K"] < 400, report)
                run = self.polhode("run", "out-prepared.toml", "--force")
                self.assertEqual(run.returncode, 0, run.err)

    def test_wrong_inputs(self):
        self.write("run.toml", ARGON)
        dense = edited(ARGON, ('temperature', 'density = "1.3 g/cm3"\ntemperature'))
        self.write("dense.toml", dense)
        self.write("none.toml", edited(dense, ('"1 ps"', '"0 ps"')))
        self.write("negative.toml", edited(ARGON, ('"1 ps"', '"-1 ps"')))
        for arguments, words in [
                (("prepare", "run.toml"), ["there is no density", "run.toml"]),
                (("prepare", "run.toml", "--pressure", "1"), ["--pressure", "no unit"]),
                (("prepare", "run.toml", "--nvt", "-1 ps"), ["--nvt", "0 ps or longer"]),
                (("prepare", "none.toml"), ["no dynamics", "none.toml"]),
                (("prepare", "negative.toml"), ["prepare.nvt", "-1 ps", "negative.toml"]),
                (("minimise", "dense.toml", "--max-force", "10"), ["--max-force", "no unit", "kJ/mol/nm"]),
                (("minimise", "dense.toml", "--max-force", "10 kJ/mol"), ["--max-force", "an energy", "a force"]),
                (("minimise", "dense.toml", "--max-torque", "0 kJ/mol"), ["--max-torque", "above 0"]),
                (("minimise", "dense.toml", "--max-steps", "0"), ["--max-steps", "from 1"])]:
            self.refused(arguments, words)


if __name__ == "__main__":
    sandbox.main()
