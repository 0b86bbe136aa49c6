# SPDX-License-Identifier: MIT
"""pair_style polhode in LAMMPS: energies, pressures and trajectories of polhode for every law, any number of ranks, mixed
precision, the pairs of the Ewald sum, and what it refuses.

Systems of polhode are given to LAMMPS in its units lj, with nm, ps, u and kJ/mol: no constant of nature of LAMMPS, which
have 8 to 11 digits, takes part.
"""

import math
import subprocess

import engine
from runs import BAR, COULOMB, KCAL, MIXTURES, RUN, VOLUME, WATER, RunTest

LAWS = [("molecule-switch", "reaction-field"), ("molecule-switch", "coulomb"), ("site-switch", "reaction-field"),
        ("site-shift", "reaction-field"), ("site-switch", "damped-shifted-force")]


def in_nm(data):
    """A data file in units real as one in nm, ps and u; and the name, ε [kJ/mol] and σ [nm] of each type."""
    header, _, rest = data.partition("\nMasses\n\n")
    masses, _, rest = rest.partition("\nPair Coeffs # lj/cut\n\n")
    coefficients, _, rest = rest.partition("\nAtoms # full\n\n")
    atoms, _, rest = rest.partition("\nVelocities\n\n")
    velocities, _, bonds = rest.partition("\nBonds\n\n")
    lines = header.splitlines()
    lines = [f"0 {float(line.split()[1]) / 10!r} {' '.join(line.split()[2:])}" if "hi" in line else line for line in lines]
    lines += ["", "Masses", "", *masses.splitlines(), "", "Atoms # full", ""]
    for words in map(str.split, atoms.splitlines()):
        q, x = float(words[3]) * math.sqrt(COULOMB), [float(word) / 10 for word in words[4:7]]
        lines.append(" ".join([*words[:3], repr(q), *map(repr, x)]))
    lines += ["", "Velocities", ""]
    lines += [" ".join([words[0], *(repr(float(word) * 100) for word in words[1:4])])
              for words in map(str.split, velocities.splitlines())]
    lines += ["", "Bonds", "", *bonds.splitlines()]
    types = []
    for words in map(str.split, coefficients.splitlines()):
        types.append((words[4], float(words[1]) * KCAL, float(words[2]) / 10))
    return "\n".join(lines) + "\n", types


class Pair(RunTest):
    def system(self, **changes):
        """A run of polhode; its energies, and its system as a data file. Returns the settings and the atom types."""
        values = {**WATER, **changes}
        self.write("run.toml", RUN % values)
        self.polhode("run", "run.toml", "--force")
        # Only the data file is used, which does not depend on the law.
        self.write("export.toml", RUN % {**values, "truncation": "site-switch", "electrostatics": "reaction-field",
                                         "scheme": "velocity-verlet", "precision": "double"})
        self.polhode("export", "lammps", "export.toml", "--force")
        data, types = in_nm((self.folder / "run.data").read_text())
        self.write("lj.data", data)
        return values, types

    def script(self, values, types, every=1, more="", style="", coefficients=""):
        """The same run with pair_style polhode."""
        massless = " ".join(f"massless {k + 1}" for k, (name, _, _) in enumerate(types) if name.endswith(".MW"))
        evaluations = {"velocity-verlet": 1, "bcss3": 3, "gier4-fd": 3}[values["scheme"]]
        pairs = "\n".join(f"pair_coeff {k + 1} {k + 1} {epsilon!r} {sigma!r}" for k, (_, epsilon, sigma) in enumerate(types))
        return f"""plugin load ${{plugin}}
units lj
atom_style full
neighbor 0.1 bin
pair_style polhode 0.58 switch 0.45 truncation {values["truncation"]} electrostatics {values["electrostatics"]} &
  precision {values["precision"]} {style}
pair_modify mix arithmetic
bond_style zero
special_bonds lj/coul 0 0 0
read_data lj.data
bond_coeff *
{pairs}
{coefficients}
fix rigid all polhode scheme {values["scheme"]} {massless}
timestep {values["step"] * 1e-3 / evaluations!r}
thermo_style custom step temp evdwl ecoul pe ke etotal press pxx pyy pzz pxy
thermo_modify norm no format float %.16g
thermo {evaluations * every}
{more}
run {evaluations * round(values["length"] / values["step"])}
"""

    def test_export(self):
        self.check_export("polhode")

    def test_export_of_a_tabulated_potential(self):
        self.write("run.toml", RUN % {**WATER, "molecules": '[{ model = "argon-ab-initio", count = 64 }]', "density": "1.2 g/cm3"})
        done = subprocess.run([engine.ENGINE.program, "export", "lammps", "run.toml", "--pair-style", "polhode"], cwd=self.folder, text=True, capture_output=True)
        self.assertEqual(done.returncode, 2)
        self.assertIn("use --pair-style table", done.stderr)

    def test_export_of_the_ewald_sum(self):
        changes = {"electrostatics": "pme", "truncation": "site-switch", "more": ""}
        self.write("run.toml", (RUN % {**WATER, **changes}).replace("[integrator]", "pme_accuracy = 1e-7\n[integrator]"))
        ours = float(self.polhode("energy", "run.toml", "--json").partition('"potential_kJ_per_mol":')[2].split(",")[0])
        # From accuracy 1e-6 to the present ones the energy of pppm changes by 0.04 kJ/mol, and that of our mesh by 0.0014: a hundredth and
        # a tenth of these are left, and as much again for safety. coul/long has an erfc with errors up to 1.5e-7, of 1,200,000 kJ/mol of
        # pairs, without regard to sign.
        for style, tolerance in (("polhode", 1e-3), ("table", 0.18)):
            self.polhode("export", "lammps", "run.toml", "--pair-style", style, "--force")
            script = (self.folder / "run.in").read_text()
            self.assertIn("pppm 1e-06", script)
            energy = self.lammps(script.replace("pppm 1e-06", "pppm 1e-08"))[0]["E_pair"][0] * KCAL
            self.assertLess(abs(energy - ours), tolerance, f"{style}: {energy} {ours}")

    def compare(self, title, table, relative, pressure):
        """The table of LAMMPS against the energies of polhode, relative to the largest of them."""
        rows = self.energies_of_polhode()
        scale = max(abs(float(row[key])) for row in rows for key in ("van_der_waals [kJ/mol]", "coulomb [kJ/mol]",
                                                                    "potential [kJ/mol]"))
        names = {"E_vdwl": "van_der_waals [kJ/mol]", "E_coul": "coulomb [kJ/mol]", "PotEng": "potential [kJ/mol]",
                 "TotEng": "total [kJ/mol]"}
        for k, row in enumerate(rows):
            for theirs, ours in names.items():
                self.assertLess(abs(table[theirs][k] - float(row[ours])), relative * scale, f"{title}, sample {k}: {theirs}")
            p = float(row["pressure [bar]"])
            virial = scale / float(row["volume [nm3]"]) * BAR
            self.assertLess(abs(table["Press"][k] * BAR - p), pressure * max(abs(p), virial), f"{title}, sample {k}: pressure")

    def test_the_laws_of_polhode(self):
        for truncation, electrostatics in LAWS:
            values, types = self.system(truncation=truncation, electrostatics=electrostatics)
            table = self.lammps(self.script(values, types, every=20))[0]
            # Positions are rounded to 1e-16 of the box, the shape of the molecule to 1e-14 of its size; the sums of charges
            # cancel to a tenth, and 20 steps multiply by less than 10.
            self.compare(f"{truncation}, {electrostatics}", table, 1e-12, 1e-9)

    def test_schemes(self):
        for scheme, bound in (("bcss3", 1e-12), ("gier4-fd", 1e-11)):
            values, types = self.system(scheme=scheme, step=1.5, length=30)
            self.compare(scheme, self.lammps(self.script(values, types, every=20))[0], bound, 1e-9)

    def test_mixtures(self):
        for title, changes in MIXTURES.items():
            for truncation in ("molecule-switch", "site-switch"):
                values, types = self.system(**changes, truncation=truncation)
                numbers = {name: k + 1 for k, (name, _, _) in enumerate(types)}
                pair = f"pair_coeff {numbers['co2.C']} {numbers['argon.Ar']} 0.5 0.3" if "co2.C" in numbers else ""
                table = self.lammps(self.script(values, types, every=20, coefficients=pair), 2)[0]
                self.compare(f"{title}, {truncation}", table, 1e-12, 1e-9)

    def test_mixed_precision(self):
        values, types = self.system()
        exact = self.lammps(self.script(values, types, every=20))[0]
        mixed = self.lammps(self.script({**values, "precision": "mixed"}, types, every=20))[0]
        scale = max(map(abs, exact["E_coul"]))
        for name in ("E_vdwl", "E_coul", "TotEng"):
            for a, b in zip(exact[name], mixed[name]):
                # A few hundred thousand terms, each rounded to 2⁻²⁴ of up to 100 kJ/mol, of random signs.
                self.assertLess(abs(a - b), 3e-6 * scale, name)
        self.assertGreater(abs(exact["E_coul"][0] - mixed["E_coul"][0]), 1e-11 * scale)  # it is not double

    def test_ranks(self):
        values, types = self.system(scheme="gier4-fd", step=1.5, length=30)
        script = self.script(values, types, every=10)
        self.compare_ranks(script, ("E_vdwl", "E_coul", "KinEng", "Press"),
                           long_lists=(2, script.replace("neighbor 0.1", "neighbor 0.3")),
                           short_communication=(2, script.replace("run 60", "comm_modify cutoff 0.2\nrun 60")))

    def test_a_tilt_of_a_whole_edge_changes_nothing(self):
        values, types = self.system()
        script = self.script(values, types, every=10)
        one = self.lammps(script)[0]
        data = (self.folder / "lj.data").read_text()
        edge = data.partition(" xlo xhi")[0].split()[-1]
        self.write("lj.data", data.replace(" zlo zhi\n", f" zlo zhi\n{edge} 0 0 xy xz yz\n"))
        for grid in ("1 1 2", "2 1 1"):  # images before and after ghosts of another process
            twin = self.lammps(script.replace("read_data", f"processors {grid}\nbox tilt large\nread_data"), 2)[0]
            for name in ("E_vdwl", "E_coul", "KinEng", "Press"):
                self.assert_close(one[name], twin[name], 1e-11, name)

    def test_boundaries_that_are_not_periodic(self):
        # A droplet far from all walls has the energies of the same droplet in a periodic box.
        values, types = self.system(scheme="bcss3", length=20)
        script = self.script(values, types, every=10)
        data = (self.folder / "lj.data").read_text()
        for line in [line for line in data.splitlines() if line.endswith("hi")]:
            data = data.replace(line, f"-1.5 {float(line.split()[1]) + 1.5!r} {' '.join(line.split()[2:])}")
        self.write("lj.data", data)
        periodic = self.lammps(script)[0]
        for title, boundary, ranks in (("none", "f f f", 2), ("two", "p f p", 2), ("one", "f f p", 1)):
            other = self.lammps(script.replace("units lj", f"units lj\nboundary {boundary}"), ranks)[0]
            for name in ("E_vdwl", "E_coul", "KinEng"):
                self.assert_close(periodic[name], other[name], 1e-11, f"{title}: {name}")

    def test_a_box_smaller_than_two_cutoffs(self):
        # A molecule meets several images of another and of itself, which polhode refuses: a system of 2 × 2 × 2 copies has
        # 8 times the energy.
        values, types = self.system(length=1)
        script = self.script(values, types).replace("polhode 0.58 switch 0.45", "polhode 0.8 switch 0.7")
        one = self.lammps(script.replace("run 1", "run 0"))[0]
        eight = self.lammps(script.replace("fix rigid", "replicate 2 2 2\nfix rigid").replace("run 1", "run 0"))[0]
        for name in ("E_vdwl", "E_coul"):
            self.assert_close([8 * one[name][0]], eight[name], 1e-12, name)
        self.assert_close(one["Pxx"], eight["Pxx"], 1e-11)

    def test_restarts_and_rerun(self):
        values, types = self.system(scheme="gier4-fd", step=1.5, length=15)
        script = self.script(values, types, every=5)
        whole = self.lammps(script.replace("run 30", "restart 5 state.*\ndump all all custom 15 all.dump id x y z vx vy vz\n"
                                                     "dump_modify all sort id format float %.17g\nrun 30"))[0]
        style = script[script.index("pair_style"):script.index("read_data")]  # not in restart files
        resumed = script.replace(style, "").replace("read_data lj.data", "read_restart state.20\n" + style)
        resumed = resumed.replace("run 30", "run 10")
        self.compare_ends(whole, self.lammps(resumed, 2)[0], 1e-11)  # also within a step of the scheme
        again = self.lammps(script.replace("run 30", "rerun all.dump dump x y z vx vy vz"), 2)[0]
        for name in ("E_vdwl", "E_coul", "Press"):
            self.assert_close(whole[name], again[name], 1e-11, name)

    def compare_ends(self, whole, part, relative):
        for name in ("E_vdwl", "E_coul", "KinEng", "Press"):
            self.assert_close([whole[name][-1]], [part[name][-1]], relative, name)

    def test_pairs_of_the_ewald_sum(self):
        # Charges alone, at one configuration, with the same mesh: erfc of coul/long has an error of 1.5e-7.
        values, types = self.system()
        script = self.script({**values, "truncation": "site-switch", "electrostatics": "pme"}, types)
        script = script.replace("run 20", "kspace_style pppm 1e-6\nkspace_modify gewald 5.5 mesh 24 24 24 order 7\nrun 0")
        script = "\n".join("pair_coeff * * 0 0" if line.startswith("pair_coeff") else line for line in script.splitlines()) + "\n"
        ours = self.lammps(script, 2)[0]
        head, _, tail = script.partition("pair_style")
        plain = head + "pair_style coul/long 0.58\npair_modify table 0\n" + tail[tail.index("bond_style"):]
        theirs = self.lammps(plain.replace("pair_coeff * * 0 0", "pair_coeff * *"))[0]
        energy = abs(theirs["E_coul"][0])
        self.assertGreater(energy, 100 * abs(theirs["PotEng"][0]))  # within molecules, the mesh has most of it
        for name in ("E_coul", "PotEng"):
            self.assertLess(abs(ours[name][0] - theirs[name][0]), 1e-6 * energy, name)
        for name in ("Pxx", "Pyy", "Pzz", "Pxy"):
            self.assertLess(abs(ours[name][0] - theirs[name][0]), 1e-6 * energy / VOLUME, name)

    def test_energy_with_a_mesh(self):
        # The forces are minus the gradient of the energy: the error of the total energy falls with the square of the step.
        values, types = self.system(length=24)
        spreads = []
        for h in (1.0, 0.5):
            script = self.script({**values, "truncation": "site-switch", "electrostatics": "pme", "step": h}, types,
                                 every=round(2 / h), more="kspace_style pppm 1e-6\nkspace_modify gewald 5.5 mesh 24 24 24 order 7")
            energies = self.lammps(script)[0]["TotEng"]
            spreads.append(math.sqrt(sum((e - energies[0]) ** 2 for e in energies)))
        self.assertAlmostEqual(math.log2(spreads[0] / spreads[1]), 2, delta=0.2)

    def test_refusals(self):
        values, types = self.system(length=1)
        base = self.script(values, types)
        pme = base.replace("truncation molecule-switch electrostatics reaction-field", "electrostatics pme")
        cases = [
            (base.replace("fix rigid all", "#"), ["no such fix", "fix ID all polhode"]),
            (base.replace("fix rigid all", "group part molecule < 9\nfix rigid part"), ["some atoms are in no body"]),
            (base.replace("lj/coul 0 0 0", "lj/coul 0 0 0.5"), ["special_bonds"]),
            (base.replace("pair_modify mix", "pair_modify shift yes mix"), ["pair_modify shift"]),
            (base.replace("run 1", "neigh_modify exclude type 1 1\nrun 1"), ["neigh_modify exclude"]),
            (base.replace("run 1", "compute e all pe/atom\ncompute s all reduce sum c_e\n"
                                   "thermo_style custom step c_s\nrun 1"), ["pe/atom"]),
            (base.replace("run 1", "compute p all pair/local eng\ndump d all local 1 d.dump c_p\nrun 1"), ["does not support compute pair/local"]),
            (base.replace("run 1", "set atom 5 charge 0.1\nrun 1"), ["has charges from 0.0", "use other atom types"]),
            (base.replace("run 1", "kspace_style pppm 1e-4\nrun 1"), ["incompatible"]),
            (pme, ["add a kspace style"]),
            (pme.replace("run 1", "kspace_style msm 1e-3\nrun 1"), ["incompatible"]),
            (pme.replace("run 1", "kspace_style pppm 1e-4\nkspace_modify gewald 9 mesh 24 24 24\nrun 1"),
             ["times the cutoff of the charges is 5.22"]),
            (base.replace("truncation molecule", "truncaton molecule"), ["did you mean 'truncation'"]),
            (base.replace("molecule-switch", "molecule-swich"), ["truncation is 'molecule-swich'", "must be one of"]),
            (base.replace("switch 0.45", "switch 0.6"), ["switch = 0.6 nm"]),
            (base.replace("polhode 0.58", "polhode -0.58"), ["the cutoff = -0.58"]),
            (base.replace("switch 0.45", "switch 0.45 dielectric 80x"), ["dielectric is '80x'"]),
            (base.replace("switch 0.45", "switch 0.45 dielectric nan"), ["dielectric"]),
            (base.replace("switch 0.45", "switch 0.45 smoothness 2.5"), ["smoothness is 2.5"]),
            (base.replace("pair_coeff 1 1", "pair_coeff 1 1 0.5"), ["pair_coeff has 3 values", "mie EPSILON"]),
            (base.replace("pair_coeff 1 1", "pair_coeff 1 1 mie 0.6 0.3 6 12 #"), ["the exponents are 6 and 12"]),
            (base.replace("pair_coeff 1 1", "pair_coeff 1 1 buckingham 1e6 0 0 #"), ["Buckingham potential"]),
            (base.replace("pair_coeff 1 1", "pair_coeff 1 1 buckingham 1e6 0.03 1e-3 #").replace("pair_coeff 2 2", "pair_coeff 2 2 0.5 0.3 #"), ["mixes only Lennard-Jones", "pair_coeff 1 2"]),
            (base.replace("units lj", "units si"), ["use units real"]),
        ]
        for text, words in cases:
            with self.subTest(words=words):
                self.refused(text, words)


if __name__ == "__main__":
    engine.main(__doc__)
