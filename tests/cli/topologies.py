# SPDX-License-Identifier: MIT
"""Systems from GROMACS and LAMMPS files: the files of the manual, and errors."""

import json
import re
from pathlib import Path

import sandbox
from sandbox import SMALL, Sandbox, edited

MANUAL = Path(__file__).resolve().parents[2] / "docs/manual"
GROMACS = '[system]\ntopology = "topol.top"\ninitial_configuration = "conf.gro"\n[forces]\nelectrostatics = "pme"\ncutoff = "0.9 nm"\n'


def manual_file(page, name):
    """The file of that name in a page of the manual."""
    text = (MANUAL / page).read_text(encoding="utf-8")
    return re.search(rf"<!-- file: {re.escape(name)} -->\n```\w*\n(.*?)```", text, re.S)[1]


class Topologies(Sandbox):
    def setUp(self):
        super().setUp()
        for page, name in (("gromacs.md", "topol.top"), ("gromacs.md", "conf.gro"), ("lammps-exchange.md", "water.data")):
            self.write(name, manual_file(page, name))

    def refused(self, text, *parts):
        self.write("run.toml", text)
        process = self.polhode("energy", "run.toml")
        self.assertEqual(process.returncode, 2, process.err)
        for part in parts:
            self.assertIn(part, process.err)

    def test_the_log_describes_the_topology(self):
        log = self.done("energy", GROMACS).err
        self.assertIn("SOL: 2 of 3 sites, rigid by settles\n", log)
        self.assertIn("NA: 1 of 1 sites, one atom\n", log)

    def test_both_formats_give_the_same_energy(self):
        water = edited(manual_file("gromacs.md", "topol.top"), ("NA  1\n", ""),
                       ("0.316557  0.650629", f"0.3166 {0.1553 * 4.184}"), ("0.16330", "0.163299"))
        self.write("topol.top", water)
        atoms = manual_file("gromacs.md", "conf.gro").splitlines()
        rows = ((5, 5, 5), (6, 5, 5), (4.66667, 5.94281, 5), (9, 5, 5), (10, 5, 5), (8.66667, 5.94281, 5))
        lines = [line[:20] + "".join(f"{x / 10:12.7f}" for x in row) for line, row in zip(atoms[2:8], rows)]
        self.write("conf.gro", "\n".join(["water", "6", *lines, atoms[-1]]) + "\n")
        gromacs = json.loads(self.done("energy", GROMACS, "--json").out)
        lammps = edited(GROMACS, ('topology = "topol.top"\n', ""), ("conf.gro", "water.data"))
        lammps = json.loads(self.done("energy", lammps, "--json").out)
        # Both shapes are rounded to 5e-7 nm: nine pairs of charges, of at most 250 kJ/mol each and 0.3 nm or more
        # apart, change by up to 250 * 1e-6 / 0.3 kJ/mol.
        bound = 9 * 250 * 1e-6 / 0.3
        self.assertAlmostEqual(gromacs["potential_kJ_per_mol"], lammps["potential_kJ_per_mol"], delta=bound)
        self.assertGreater(abs(gromacs["potential_kJ_per_mol"]), 100 * bound)

    def test_a_model_with_a_massless_site_uses_atoms_of_a_data_file(self):
        text = '[system]\nmolecules = [{ model = "tip4p" }]\ninitial_configuration = "water.data"\n[forces]\ncutoff = "0.9 nm"\n'
        self.assertIn("molecules             2\n", self.done("energy", text).out)

    def test_molecules_of_a_topology_are_shown(self):
        shown = self.polhode("molecules", "topol.top").out
        self.assertIn("SOL\n", shown)
        self.assertIn("NA\n", shown)

    def test_run_files_that_do_not_fit(self):
        self.refused(edited(GROMACS, ('initial_configuration = "conf.gro"\n', "")), "needs an initial configuration", "run.toml:2")
        self.refused(edited(GROMACS, ("topol.top", "gone.top")), "is not a file", "system.topology")
        self.refused(edited(GROMACS, ("[system]\n", '[system]\nmolecules = [{ model = "tip4p" }]\n')), "cannot be combined with molecules")
        self.refused(edited(GROMACS, ("[forces]\n", '[forces]\nmixing = "geometric"\n')), "cannot be combined with a GROMACS topology")
        self.refused(edited(GROMACS, ("[forces]\n", 'rigid = ["BEN"]\n[forces]\n')), "'BEN' is declared rigid", "topol.top")
        self.refused(edited(GROMACS, ("[forces]\n", 'define = ["FLEXIBLE"]\n[forces]\n')), "molecule type 'SOL' is not held rigid")
        self.write("topol.top", edited(manual_file("gromacs.md", "topol.top"), ("SOL 2\nNA", "SOL 1000000000\nNA")))
        self.refused(GROMACS, "too few for 1000000001 molecules")

    def test_a_missing_mixing_rule(self):
        data = edited(manual_file("lammps-exchange.md", "water.data"), ("2 0 0\n", "2 0.01 1\n"))
        self.write("water.data", data)
        text = edited(GROMACS, ('topology = "topol.top"\n', ""), ("conf.gro", "water.data"))
        self.refused(text, "does not give the mixing rule for unlike sites", "water.data")
        log = self.done("energy", text + 'mixing = "geometric"\n').err
        self.assertIn("Lennard-Jones: geometric mixing\n", log)

    def test_exports_of_united_atoms_are_read_back(self):
        """Their masses are those of no element, or of another one; the exported file names the sites."""
        for model, name in (("methylhydrazine", "CH3NHNH2"), ("cf4-mie", "CF4")):
            run = edited(SMALL, ('"argon"', f'"{model}"'), ('box = "2.5 nm"', 'box = "4 nm"'),
                         ('cutoff = "1.0 nm"', 'cutoff = "1.0 nm"\ntruncation = "site-switch"\nmixing = "lorentz-berthelot"'))
            self.write("run.toml", run)
            process = self.polhode("export", "lammps", "run.toml", "--force")
            self.assertEqual(process.returncode, 0, process.err)
            exported = (self.folder / "out.data").read_text()
            whole = json.loads(self.done("energy", run, "--json").out)
            start = edited(run, ('box = "4 nm"', 'initial_configuration = "out.data"'))
            without_names = "\n".join(line.partition("#")[0] if "Coeffs" not in line else line for line in exported.splitlines())
            own_topology = re.sub("molecules = .*\n", "", start)
            for data, text in ((exported, start), (exported, own_topology), (without_names, start), (without_names, own_topology)):
                self.write("out.data", data)
                process = self.done("energy", text, "--json")
                self.assertAlmostEqual(json.loads(process.out)["potential_kJ_per_mol"], whole["potential_kJ_per_mol"], delta=1e-7 * abs(whole["potential_kJ_per_mol"]) + 1e-12)
                if (data, text) == (exported, own_topology):
                    self.assertIn(f"{name}: 27 of", process.err)
            self.write("out.data", exported)
            self.assertEqual(self.polhode("convert", "out.data", f"{model}.xyz").returncode, 0)
            self.assertNotIn("\nX ", (self.folder / f"{model}.xyz").read_text())


if __name__ == "__main__":
    sandbox.main()
