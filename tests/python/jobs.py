# SPDX-License-Identifier: MIT
"""The verbs as functions: the reports of the program, from the same library calls."""

import json
import os
import re
import tempfile
import unittest
import unittest.mock
from pathlib import Path

import numpy as np
import polhode

import package
from package import WATER, optional, program

STUDY = {"runs": 2, "length": "40 fs", "decorrelate": "10 fs"}


def same(a, b, but=()):
    """Whether two JSON values are equal, apart from these keys."""
    if isinstance(a, dict) and isinstance(b, dict):
        return all(same(a[k], b[k], but) for k in a.keys() | b.keys() if k not in but)
    return a == b


class InFolder(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.before = os.getcwd()
        os.chdir(self.folder.name)
        self.addCleanup(os.chdir, self.before)
        Path("w.toml").write_text(polhode.settings(WATER).text, encoding="utf-8")


class Verbs(InFolder):
    """Each verb against the program: the same JSON and the same bytes of tables."""

    def check(self, report, *command, but=()):
        theirs = json.loads(program(*command, "--json"))
        self.assertTrue(same(dict(report), theirs, but), (dict(report), theirs))

    def test_run(self):
        report = polhode.run("w.toml", output="a", threads=1)
        self.check(report, "run", "w.toml", "--output", "b", "--threads", "1",
                   but=("seconds", "ns_per_day", "files", "prefix"))
        rows = [[line for line in Path(f"{p}-energies.csv").read_text().splitlines()
                 if not line.startswith("#")] for p in "ab"]
        self.assertEqual(*rows)
        self.assertIn("a-final.gro", report.files)

    def command_in(self, name):
        [command] = [line.removeprefix("# command: ") for line in Path(name).read_text().splitlines() if line.startswith("# command: ")]
        return command

    def test_records_have_the_call(self):
        """With every keyword that has an effect on the file, so that the call can be made again."""
        polhode.run("w.toml", output="a", threads=1, length="40 fs", **{"system.seed": 3}, progress=False)
        self.assertEqual(self.command_in("a-energies.csv"),
                         "polhode.run('w.toml', output='a', length='40 fs', **{'system.seed': 3})")
        eval(self.command_in("a-energies.csv").replace("'a'", "'b'"))
        rows = [[line for line in Path(f"{p}-energies.csv").read_text().splitlines() if not line.startswith("#")] for p in "ab"]
        self.assertEqual(*rows)
        polhode.run(polhode.settings(WATER, scheme="B(1/2) A(1) B(1/2)"), output="c", forces=None, force=True)
        self.assertIn("scheme='B(1/2) A(1) B(1/2)'), output='c')", self.command_in("c-energies.csv"))
        polhode.study("w.toml", schemes=["hoa2"], steps=["1 fs", "2 fs"], **STUDY, output="s", threads=2)
        self.assertEqual(self.command_in("s.csv"),
                         "polhode.study('w.toml', schemes=['hoa2'], steps=['1 fs', '2 fs'], runs=2, length='40 fs', "
                         "decorrelate='10 fs', output='s')")
        polhode.run("w.toml", output="t", length="40 fs", trajectory_every="4 fs", formats=["gro"])
        polhode.analyze("t-trajectory.gro", run="w.toml", what=["density"], bin="0.02 nm", output="d", force=True)
        [name] = [f for f in os.listdir() if f.startswith("d") and f.endswith(".csv")][:1]
        self.assertEqual(self.command_in(name), "polhode.analyze('t-trajectory.gro', run='w.toml', what=['density'], bin='0.02 nm', output='d')")

    def test_energy(self):
        self.check(polhode.energy("w.toml"), "energy", "w.toml")

    def test_minimise(self):
        report = polhode.minimise("w.toml", output="a", max_steps=20)
        self.check(report, "minimise", "w.toml", "--output", "b", "--max-steps", "20",
                   but=("file", "files"))
        self.assertEqual(Path("a-minimised.gro").read_text(), Path("b-minimised.gro").read_text())

    def test_prepare(self):
        report = polhode.prepare("w.toml", nvt="20 fs", output="a")
        self.assertEqual(Path("a-prepared.gro").exists(), True)
        program("prepare", "w.toml", "--nvt", "20 fs", "--output", "b")
        self.assertEqual(Path("a-prepared.gro").read_text(), Path("b-prepared.gro").read_text())
        self.assertIn("a-prepared.toml", report.files)

    def test_analyze(self):
        program("run", "w.toml", "--output", "t")
        polhode.run(WATER, output="u", length="0.4 ps", trajectory_every="4 fs")
        options = ("--run", "w.toml", "--what", "rdf,density")
        report = polhode.analyze("u-trajectory.gro", run="w.toml", what=["rdf", "density"],
                                 output="a", pairs=["OW-OW"])
        self.check(report, "analyze", "u-trajectory.gro", *options, "--pairs", "OW-OW", "--output",
                   "b", "--plot", "none", but=("files", "prefix"))
        by_counts = polhode.analyze("u-trajectory.gro", molecules={"tip4p": 64}, what=["density"],
                                    output="c")
        self.assertEqual(by_counts["frames"], report["frames"])

    def test_convert(self):
        polhode.run(WATER, output="a")
        self.assertEqual(polhode.convert("a-final.gro", "a.xyz"), 1)
        program("convert", "a-final.gro", "b.xyz")
        self.assertEqual(Path("a.xyz").read_text(), Path("b.xyz").read_text())

    def test_convert_particles(self):
        """A dump of one particle has the sites of a molecule around its centre."""
        run = dict(system={"molecules": [{"model": "spce", "count": 1}], "density": "1e-3 g/cm3"})
        Path("a.dump").write_text("ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS pp pp pp\n0 30\n0 30\n0 30\n"
                                  "ITEM: ATOMS id xu yu zu d2_orientation[1] d2_orientation[2] d2_orientation[3] d2_orientation[4]\n"
                                  "1 15 15 15 0.7071067811865476 0 0 0.7071067811865476\n", encoding="utf-8")
        self.assertEqual(polhode.convert("a.dump", "a.xyz", particles=run), 1)
        sites = [[float(word) for word in line.split()[1:4]] for line in Path("a.xyz").read_text().splitlines()[2:]]
        self.assertEqual(len(sites), 3)
        masses = (15.9994, 1.008, 1.008)
        for k in range(3):
            self.assertAlmostEqual(sum(m * r[k] for m, r in zip(masses, sites)) / sum(masses), 15, delta=1e-4)
        with self.assertRaisesRegex(polhode.Error, "1 particles, but the run file has 2"):
            polhode.convert("a.dump", "b.xyz", particles=dict(system={"molecules": [{"model": "spce", "count": 2}],
                                                                     "density": "1e-3 g/cm3"}))

    def test_bias_of_the_step(self):
        polhode.run(WATER, output="e", length="0.4 ps", trajectory_every="4 fs", sample="4 fs")
        report = polhode.analyze("e-trajectory.gro", run=polhode.settings(WATER), what=["rdf"],
                                 energies="e-energies.csv", output="f")
        self.assertIn("step_bias", json.dumps(report.data))
        with self.assertRaisesRegex(polhode.Error, "also give run water.toml"):
            polhode.analyze("e-trajectory.gro", molecules={"tip4p": 64}, energies="e-energies.csv",
                            output="g")

    def test_export(self):
        files = polhode.export("lammps", WATER, truncation="site-switch", output="a")
        Path("w.toml").write_text(polhode.settings(WATER, truncation="site-switch").text, encoding="utf-8")
        program("export", "lammps", "w.toml", "--output", "b")
        self.assertEqual([file.suffix for file in files], [".data", ".table", ".in"])
        self.assertEqual(Path("a.data").read_text(), Path("b.data").read_text())
        files = polhode.export("lammps", WATER, pair_style="polhode", output="c")
        self.assertEqual([file.suffix for file in files], [".data", ".in"])
        files = polhode.export("lammps", WATER, pair_style="polhode-particles", output="d")
        self.assertEqual([file.name for file in files], ["d.data", "d-1.molecule", "d.in"])
        with self.assertRaisesRegex(polhode.Error, "pair_style"):
            polhode.export("lammps", WATER, pair_style="lj/cut")
        with self.assertRaisesRegex(polhode.Error, "export to 'gromacs' is not supported"):
            polhode.export("gromacs", WATER)

    def test_study(self):
        report = polhode.study(WATER, schemes=["velocity-verlet", "hoa2"], steps=["2 fs", "1 fs"],
                               study=STUDY, output="a", threads=1)
        self.assertTrue(report.complete)
        self.assertEqual(len(report["points"]), 4)
        Path("s.toml").write_text(polhode.settings(WATER, study=STUDY).text, encoding="utf-8")
        program("study", "s.toml", "--schemes", "velocity-verlet", "hoa2", "--steps", "2 fs", "1 fs",
                "--output", "b", "--threads", "1")
        rows = [sorted(line for line in Path(f"{p}-runs.csv").read_text().splitlines()
                       if not line.startswith("#")) for p in "ab"]
        self.assertEqual(*rows)
        again = polhode.study(WATER, study=STUDY, from_record="a-runs.csv", output="c",
                              schemes=["velocity-verlet", "hoa2"], steps=["2 fs", "1 fs"])
        self.assertEqual(len(again["points"]), 4)

    def test_advise(self):
        report = polhode.advise(WATER, accuracy="5 %", schemes=["hoa2"], time=2, length="0.2 ps",
                                output="a")
        self.assertIn("hoa2", report["answer"])
        with self.assertRaises(polhode.Error):
            polhode.advise(WATER)

    def test_tune_scheme(self):
        report = polhode.tune_scheme(WATER, step="2 fs", runs=2, length="0.2 ps",
                                     decorrelate="0.02 ps", sample="10 fs")
        self.assertEqual(len(report["families"]), 2)

    def test_verify(self):
        self.check(polhode.verify("hoa2"), "verify", "hoa2")

    def test_molecules(self):
        theirs = json.loads(program("molecules", "tip4p", "--json"))
        self.assertEqual(polhode.molecules("tip4p").data, theirs)
        self.assertEqual([m.data for m in polhode.molecules().values()],
                         json.loads(program("molecules", "--json")))

    def test_schemes(self):
        self.assertEqual([s.data for s in polhode.schemes().values()],
                         json.loads(program("schemes", "--json")))

    def test_new(self):
        polhode.new("water", "a.toml")
        program("new", "water", "b.toml")
        self.assertEqual(Path("a.toml").read_text().replace("a.toml", "b.toml"), Path("b.toml").read_text())
        with self.assertRaises(polhode.Error):
            polhode.new("water", "a.toml")
        polhode.new("gromacs", "c.toml", ensemble="npt")
        self.assertIn("[barostat]", Path("c.toml").read_text())
        Path("md.mdp").write_text("nsteps = 10\nfreezegrps = A\n")
        said = []
        polhode.new("gromacs", "d.toml", mdp="md.mdp", messages=said.append)
        self.assertIn("note: freezegrps = A: not available", said)
        program("new", "gromacs", "e.toml", "--mdp", "md.mdp")
        self.assertEqual(Path("d.toml").read_text(), Path("e.toml").read_text().replace('"e"', '"d"').replace("'e'", "'d'"))
        for keywords in ({"ensemble": "npt"}, {}):
            with self.assertRaises(polhode.Error):
                polhode.new("lammps", "f.toml", mdp="md.mdp", **keywords)

    def test_bench(self):
        report = polhode.bench(quick=True, sizes=[512], precision="double", threads=1)
        self.assertEqual(report["systems"][0]["molecules"], 512)

    def test_top(self):
        table = polhode.top([1, 2, 3], [0.1, 0.2, 1])
        text = program("top", "--J", "1,2,3", "--L", "0.1,0.2,1")
        self.assertGreater(len(table), 10)
        self.assertLess(np.abs(table["series_energy_error"]).max(), 1e-13)
        self.assertIn(f"{table['t'][-1]:.4g}"[:4], text)

    def test_every_verb_is_a_function(self):
        overview = program("help")
        verbs = [line.split()[0] for line in overview.splitlines()
                 if line.startswith("  ") and not line.startswith("  polhode")]
        self.assertGreater(len(verbs), 10)
        for verb in verbs:
            self.assertTrue(callable(getattr(polhode, verb.replace("-", "_"))), verb)


class FreeRotation(unittest.TestCase):
    def test_rotations_of_arrays(self):
        random = np.random.default_rng(1)
        J = np.sort(random.uniform(1, 1.9, (50, 3)))
        L, t = random.normal(size=(50, 3)), random.uniform(-5, 5, (3, 50))
        q, after = polhode.free_rotation(J, L, t)
        self.assertEqual((q.shape, after.shape), ((3, 50, 4), (3, 50, 3)))
        # |L| and the energy are constant, and L in the lab frame is.
        norm = lambda v: np.sqrt((v**2).sum(-1))
        self.assertLess(np.abs(norm(after) - norm(L)).max(), 1e-13)
        energy = lambda v: (v**2 / J).sum(-1)
        self.assertLess(np.abs(energy(after) / energy(L) - 1).max(), 1e-13)
        lab = np.einsum("...ij,...j", polhode.rotation_matrix(q), after)
        self.assertLess(np.abs(lab - L).max(), 1e-13)
        closed, _ = polhode.free_rotation(J, L, t, method="closed")
        self.assertLess(np.minimum(norm(closed - q), norm(closed + q)).max(), 1e-13)

    def test_the_table_of_the_program(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder, "tops.csv")
            path.write_text("I1,I2,I3,L1,L2,L3,t\n1,2,3,0.1,0.2,1,0.7\n")
            self.assertEqual(polhode.rotate_table(path), program("top", "--table", str(path)))

    def test_wrong_arguments(self):
        for J, L, t in (([1, 2], [0, 0, 1], 1), ([1, 2, 3], [[0, 0]], 1), ([1, 2, np.nan], [0, 0, 1], 1),
                        ([1, 2, 3], [0, 0, 1], np.inf), ([-1, 2, 3], [0, 0, 1], 1),
                        (np.ones((4, 3)), np.ones((5, 3)), 1), ("abc", [0, 0, 1], 1)):
            with self.assertRaises(polhode.Error):
                polhode.free_rotation(J, L, t)
        with self.assertRaises(polhode.Error):
            polhode.free_rotation([1, 2, 3], [0, 0, 1], 1, method="serious")
        q, _ = polhode.free_rotation([1, 2, 3], [0, 0, 1], np.zeros((0,)))
        self.assertEqual(q.shape, (0, 4))


class Files(InFolder):
    def test_write_and_read_in_every_format(self):
        s = polhode.Simulation(WATER)
        s.step(2)
        r, v = s.sites()
        s.write("names.gro")
        for name in ("gro", "pdb", "xyz", "xtc", "trr", "dcd"):
            path = f"a.{name}"
            s.write(path)
            names = "names.gro" if name in ("xtc", "trr", "dcd") else None
            frame = polhode.read(path, names=names)
            self.assertEqual(len(frame), 256, name)
            # PDB and XTC have three decimals, of Å and nm; DCD and TRR single precision.
            self.assertLess(np.abs(frame.positions - r).max(), 6e-4, name)
            polhode.write(f"b.{name}", [frame, frame])
            self.assertEqual(len(list(polhode.read_frames(f"b.{name}"))), 2, name)
            with self.assertRaises(polhode.OutputError):
                polhode.write(f"b.{name}", frame)
        self.assertLess(np.abs(polhode.read("a.trr").velocities - v).max(), 1e-5)
        self.assertEqual(polhode.read("names.gro").names[:4], ["OW", "HW1", "HW2", "MW"])

    def test_wrong_files_and_arrays(self):
        Path("bad.gro").write_text("x\n3\n1 2\n")
        for call in (lambda: polhode.read("bad.gro"), lambda: polhode.read("none.gro"),
                     lambda: polhode.read("w.nothing"),
                     lambda: polhode.write("a.nothing", polhode.Frame(np.zeros((2, 3)))),
                     lambda: polhode.write("a.gro", polhode.Frame(np.full((2, 3), np.nan))),
                     lambda: polhode.write("a.gro", polhode.Frame(np.zeros((2, 4)))),
                     lambda: polhode.write("a.gro", polhode.Frame(np.zeros((3, 3)), names=["A"])),
                     lambda: polhode.write("a.gro", polhode.Frame(np.zeros((1, 3)), molecules=[2**40])),
                     lambda: polhode.write("a.gro", [])):
            with self.assertRaises(polhode.Error):
                call()


class Results(unittest.TestCase):
    def test_tables_and_displays(self):
        s = polhode.Simulation(WATER)
        run = s.run("40 fs", frames="20 fs")
        self.assertEqual(run.energies.array.dtype.names[:3], ("time", "total", "potential"))
        self.assertEqual(len(run.energies), 11)
        self.assertAlmostEqual(run.ratio, s.summary["R"], delta=1e-9)
        self.assertEqual(s.summary.steps, 20)
        for thing in (s, run, s.summary, polhode.Scheme("gier4"), polhode.molecules("tip4p")):
            html = thing._repr_html_()
            self.assertIn("<table", html)
            self.assertEqual(html.count("<tr>"), html.count("</tr>"))
        volume = run._repr_html_().rpartition("volume")[2]  # constant but for rounding
        self.assertIn(">0</td>", volume)
        self.assertIn("nm³", volume)
        self.assertIn("vanzon2008", s.cite())
        self.assertIn("jorgensen1983", s.cite())
        with self.assertRaises(AttributeError) as caught:
            s.summary.setps
        self.assertIn("steps", str(caught.exception))

    def test_hybrid_monte_carlo_has_no_ratio(self):
        run = polhode.Simulation(WATER, hybrid_steps=5).run("40 fs")
        self.assertIsNone(run.ratio)
        self.assertIsNone(run.summary.R)
        self.assertEqual(run.summary.drift_verdict, "not defined")
        self.assertNotIn("R =", run._repr_html_())
        self.assertNotIn("conserved", run._repr_html_())
        self.assertIn("too few samples", run._repr_html_())

    def test_errors_of_means_in_tables(self):
        run = polhode.Simulation(WATER, step="2 fs", sample="2 fs").run("200 fs")
        self.assertIn("standard error", run._repr_html_())
        value, error, reason = polhode._core.series_mean([1.0, 2.0] * 200)
        self.assertEqual(value, 1.5)
        self.assertLess(error, 0.5 / 400**0.5)  # no two neighbours are alike
        self.assertIsNone(reason)
        self.assertEqual(polhode._core.series_mean([1.0, 2.0])[1:], (None, "too few samples"))

    def test_names_in_displays_are_not_markup(self):
        m = polhode.Molecule({"name": "<script>", "source": "&", "site": [
            {"name": "<b>", "element": "Ar", "position": "0 0 0 nm", "mass": "1 u"}]})
        self.assertNotIn("<script>", m._repr_html_())
        self.assertNotIn("<b>", m._repr_html_())

    def test_pandas(self):
        optional("pandas")
        frame = polhode.Simulation(WATER).run("8 fs").to_pandas()
        self.assertEqual(frame.index.name, "time")
        self.assertEqual(len(frame), 3)

    def test_mdanalysis(self):
        optional("MDAnalysis")
        s = polhode.Simulation(WATER)
        u = s.run("20 fs", frames="10 fs").to_mdanalysis()
        self.assertEqual((len(u.trajectory), len(u.atoms), len(u.residues)), (3, 256, 64))
        u.trajectory[-1]
        self.assertLess(np.abs(u.atoms.positions / 10 - s.sites()[0]).max(), 1e-6)
        self.assertAlmostEqual(u.atoms.total_charge(), 0, 9)
        self.assertAlmostEqual(u.trajectory.dt, 0.01, 9)

    def test_mdtraj(self):
        optional("mdtraj")
        s = polhode.Simulation(WATER)
        t = s.run("20 fs", frames="10 fs").to_mdtraj()
        self.assertEqual((t.n_frames, t.n_atoms, t.n_residues), (3, 256, 64))
        self.assertLess(np.abs(t.xyz[-1] - s.sites()[0]).max(), 1e-6)

    def atoms_of(self, html, call):
        """The frames of a view: (elements, positions [Å]) of the text in format XYZ that its HTML passes to 3Dmol."""
        text = json.loads(re.search(rf'{call}\(("(?:[^"\\]|\\.)*"),"xyz"\)', html)[1])
        lines, frames = text.split("\n"), []
        while lines[0]:
            n = int(lines[0])
            rows = [line.split() for line in lines[2:2 + n]]
            frames.append(([r[0] for r in rows], np.array([[float(x) for x in r[1:]] for r in rows])))
            lines = lines[2 + n:]
        return frames

    def test_a_view_has_the_atoms_and_the_box(self):
        optional("py3Dmol")
        s = polhode.Simulation(WATER)
        html = s.view_3d(width=300).write_html()
        (elements, positions), = self.atoms_of(html, "addModel")
        self.assertEqual(elements, 64 * ["O", "H", "H"])  # without the massless site of TIP4P
        self.assertLess(np.abs(positions / 10 - s.sites(False)[0]).max(), 0.00006)
        box = {round(float(x) / 10, 6) for x in re.findall(r'"[xyz]": ([0-9.]+)', html)} - {0}
        self.assertEqual((html.count("addLine("), box), (12, {round(float(s.state.box[0]), 6)}))
        self.assertIn("width: 300px", html)

    def test_a_view_of_a_run_has_its_frames(self):
        optional("py3Dmol")
        s = polhode.Simulation(WATER)
        run = s.run("20 fs", frames="10 fs")
        frames = self.atoms_of(run.view_3d(js="copy.js").write_html(), "addModelsAsFrames")
        self.assertEqual(len(frames), 3)
        self.assertLess(np.abs(frames[-1][1] / 10 - s.sites(False)[0]).max(), 0.00006)
        with self.assertRaises(polhode.Error) as caught:
            s.run("4 fs").view_3d()
        self.assertIn("kept no frames", str(caught.exception))

    def test_a_view_without_py3dmol(self):
        with unittest.mock.patch.dict("sys.modules", {"py3Dmol": None}), self.assertRaises(polhode.Error) as caught:
            polhode.Simulation(WATER).view_3d()
        self.assertIn("pip install py3Dmol", str(caught.exception))

    def test_a_view_that_is_too_large(self):
        optional("py3Dmol")
        with unittest.mock.patch("polhode._viewer.MAX_ATOMS", 191), self.assertRaises(polhode.Error) as caught:
            polhode.Simulation(WATER).view_3d()
        self.assertIn("192 atoms are too many", str(caught.exception))

    def test_names_of_elements_in_a_view_are_not_markup(self):
        with self.assertRaisesRegex(polhode.Error, "not a chemical element"):
            polhode.Simulation(molecules={"name": "a", "source": "-", "site": [
                {"name": "A", "element": "</", "position": "0 0 0 nm", "mass": "1 u"}]}, count=2, box="3 nm", cutoff="1 nm")

    def test_figures(self):
        optional("matplotlib").use("Agg")
        axes = polhode.Simulation(WATER).run("20 fs").plot()
        self.assertEqual(len(axes), 2)
        with self.assertRaises(polhode.Error):
            polhode.energy(WATER).plot()


if __name__ == "__main__":
    package.main()
