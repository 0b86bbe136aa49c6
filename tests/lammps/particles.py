# SPDX-License-Identifier: MIT
"""One particle a molecule in LAMMPS: energies and trajectories of polhode, any number of ranks, restart and data files, dumps as
frames of atoms, and what is refused."""

import re

import engine
from runs import KCAL, MIXTURES, RUN, WATER, RunTest

TURNED_BACK = (0.5, -0.5, -0.5, -0.5)  # z to y to x to z


def times(a, b):
    """The product of two quaternions."""
    (w, x, y, z), (W, X, Y, Z) = a, b
    return [w * W - x * X - y * Y - z * Z, w * X + x * W + y * Z - z * Y, w * Y - x * Z + y * W + z * X, w * Z + x * Y - y * X + z * W]


class Particles(RunTest):
    def test_export(self):
        self.check_export("polhode-particles")

    def particles(self, every=1, **changes):
        """The script of a run with one particle a molecule."""
        values = {**WATER, **changes}
        self.write("run.toml", RUN % values)
        self.polhode("export", "lammps", "run.toml", "--pair-style", "polhode-particles", "--force")
        script = (self.folder / "run.in").read_text()
        before, _, after = script.partition("\nthermo ")
        evaluations = {"velocity-verlet": 1, "bcss3": 3, "gier4-fd": 3}[values["scheme"]]
        return before + f"\nthermo {every * evaluations}\n" + after.partition("\n")[2]

    PARTICLE_COLUMNS = ("E_pair", "KinEng", "f_rigid[2]", "v_total", "Press")

    def test_particles_on_ranks(self):
        script = self.particles(every=10, scheme="gier4-fd", step=1.5, length=30)
        self.compare_ranks(script, self.PARTICLE_COLUMNS)
        self.compare_ranks(self.particles(every=10, **{**MIXTURES["CO2 and argon"], "step": 0.5, "length": 30}),
                           self.PARTICLE_COLUMNS)

    def test_particles_that_move_without_rotation(self):
        script = self.particles(every=20)
        still = script.replace("fix rigid all", "set group all d2_angular_momentum[1] 0\nset group all d2_angular_momentum[2] 0\n"
                                                "set group all d2_angular_momentum[3] 0\nfix rigid all", 1)
        for text, is_warned in ((script, False), (still, True)):
            self.write("test.in", text)
            done = engine.ENGINE.run(self.folder, "test.in", 2)
            self.assertEqual(done.returncode, 0, done.stdout[-2000:])
            self.assertEqual("all their angular momenta are 0" in done.stdout, is_warned)

    def test_particles_in_restart_and_data_files(self):
        # Centres begin on the faces of the box, which they cross.
        script = self.particles(every=5, scheme="gier4-fd", step=1.5, length=30)
        moved = script.replace("fix rigid all", f"displace_atoms all move {3 * ' -1.5521523'} units box\nfix rigid all")
        whole = self.lammps(moved.replace("run 60", "restart 10 state.*\nrun 30\nwrite_data middle.data\nrun 30"))[1]
        style = script[script.index("pair_style"):script.index("atom_modify")]  # not in restart files
        head, _, tail = script.partition("read_data")
        resumed = head.replace(style, "").replace("atom_style atomic\n", "").replace("fix orientations", "read_restart state.20\nfix orientations")
        resumed = resumed.replace("atom_modify map yes\n", "") + style.rstrip() + "\n" + tail.partition("\n")[2].replace("run 60", "run 40")
        for ranks in (1, 2):
            again = self.lammps(resumed, ranks)[0]  # from the middle of a step of the scheme
            for name in self.PARTICLE_COLUMNS:
                self.assert_close([whole[name][-1]], [again[name][-1]], 1e-11, name)
        again = self.lammps(script.replace("run.data", "middle.data").replace("Orientations", "orientations").replace("run 60", "run 30"), 2)[0]
        for name in self.PARTICLE_COLUMNS:
            self.assert_close(whole[name], again[name], 1e-10, name)  # write_data has 15 digits

    def test_particles_and_molecules_of_atoms(self):
        """Water of which the first half are particles and the others atoms, which have the same energies and trajectory."""
        script = self.particles(every=5, scheme="bcss3", step=1, length=10)
        particles = (self.folder / "run.data").read_text()
        self.polhode("export", "lammps", "run.toml", "--pair-style", "polhode", "--output", "atoms", "--force")
        atoms = (self.folder / "atoms.data").read_text()

        def section(text, title):
            rows = text.partition(f"\n{title}\n\n")[2].partition("\n\n")[0].splitlines()
            return [line.split() for line in rows]

        kept = [row for row in section(atoms, "Atoms # full") if int(row[1]) > 32]
        ids = [row[0] for row in kept]
        lines = [f"{n} {n} 4 0 {' '.join(row[2:])}" for n, row in enumerate(section(particles, "Atoms # atomic")[:32], 1)]
        lines += [" ".join([str(33 + k), *row[1:]]) for k, row in enumerate(kept)]
        velocities = [" ".join(row) for row in section(particles, "Velocities")[:32]]
        of_atoms = {row[0]: row[1:] for row in section(atoms, "Velocities")}
        velocities += [" ".join([str(33 + k), *of_atoms[i]]) for k, i in enumerate(ids)]
        orientations = [" ".join(row) for row in section(particles, "Orientations")[:32]]
        orientations += [f"{33 + k} 1 0 0 0 0 0 0" for k in range(len(ids))]
        head = particles.partition("\nAtoms # atomic")[0].replace("64 atoms", f"{len(lines)} atoms")
        self.write("run.data", "\n".join([head, "Atoms # full", "", *lines, "", "Velocities", "", *velocities, "", "Orientations", "", *orientations, ""]))
        script = script.replace("atom_style atomic", "atom_style full").replace("fix orientations all", "special_bonds lj/coul 0 0 0\nfix orientations all")
        plain = self.lammps(re.sub(r"\nthermo \d+", "\nthermo 15", (self.folder / "atoms.in").read_text()))[0]
        for ranks in (1, 2):
            both = self.lammps(script, ranks)[0]
            self.assert_close(both["E_pair"], plain["E_pair"], 1e-11)

    def test_the_axes_of_a_molecule_file(self):
        """Orientations are those of the file, also where its axes are not principal ones: the same molecules with turned axes."""
        script = self.particles(every=10).replace("run 20", "run 20\nwrite_data end.data")
        plain = self.lammps(script)[0]
        end = self.orientations("end.data", "orientations")
        molecule = (self.folder / "run-1.molecule").read_text()
        head, _, rest = molecule.partition("Coords\n\n")
        coordinates, _, rest = rest.partition("\n\n")
        turned = "\n".join("{0} {3} {1} {2}".format(*line.split()) for line in coordinates.splitlines())  # x to y to z to x
        self.write("run-1.molecule", f"{head}Coords\n\n{turned}\n\n{rest}")
        data = (self.folder / "run.data").read_text()
        head = data[:data.index("\nOrientations")]
        lines = [" ".join(map(repr, [number, *times(a, TURNED_BACK), *ell]))
                 for number, (a, ell) in self.orientations("run.data", "Orientations").items()]
        self.write("run.data", head + "\nOrientations\n\n" + "\n".join(lines) + "\n")
        other = self.lammps(script)[0]
        for name in self.PARTICLE_COLUMNS:
            self.assert_close(plain[name], other[name], 1e-11, name)
        for number, (a, _) in self.orientations("end.data", "orientations").items():
            expected = times(end[number][0], TURNED_BACK)
            self.assertAlmostEqual(abs(sum(x * y for x, y in zip(a, expected))), 1, delta=1e-12)

    def test_a_molecule_file_with_two_numbers_of_atoms(self):
        script = self.particles()
        molecule = (self.folder / "run-1.molecule").read_text()
        self.write("run-1.molecule", molecule.replace("Types", "5 atoms\n\nTypes", 1))
        self.refused(script, ["the number of atoms is given twice"])

    def test_orientations_that_are_set(self):
        turned = "set atom 7 d2_orientation[1] 0.5\nset atom 7 d2_orientation[2] 0.5\nset atom 7 d2_orientation[3] 0.5\nset atom 7 d2_orientation[4] 0.5\n"
        script = self.particles().replace("run 20", "run 0")
        before, after = self.lammps(script + turned + "run 0\n", 2)
        first = self.lammps(script.replace("fix rigid all", turned + "fix rigid all"))[0]
        self.assert_close(after["E_pair"], first["E_pair"], 1e-12)
        self.assertGreater(abs(after["E_pair"][0] - before["E_pair"][0]), 1e-3)

    def orientations(self, name, section):
        """Quaternion and angular momentum of each particle in a data file."""
        text = (self.folder / name).read_text().partition(f"\n{section}")[2]  # and perhaps a comment
        lines = text.partition("\n\n")[2].partition("\n\n")[0].splitlines()
        rows = [[float(word) for word in line.split()] for line in lines]
        self.assertEqual(len(rows), 64)
        return {int(row[0]): (row[1:5], row[5:8]) for row in rows}

    def test_particles_as_atoms_for_analysis(self):
        script = self.particles(every=5, scheme="bcss3", step=2, length=20)
        dump = ("dump all all custom 15 run.dump id type xu yu zu vx vy vz d2_orientation[1] d2_orientation[2] d2_orientation[3] d2_orientation[4] "
                "d2_angular_momentum[1] d2_angular_momentum[2] d2_angular_momentum[3]\ndump_modify all time yes units yes format float %.17g\n")
        table = self.lammps(script.replace("run 30", dump + "run 30"), 2)[0]
        self.polhode("convert", "run.dump", "all.xyz", "--particles", "run.toml", "--force")
        frames = (self.folder / "all.xyz").read_text().splitlines()
        self.assertEqual(frames.count("256"), len(table["E_pair"]))
        self.assertIn("Time=0.020000", frames[-257])
        # The last of them as an initial configuration, rounded to 1e-9 nm, which is where forces of 2e4 kJ/mol/nm on 200 sites have it.
        self.polhode("convert", "run.dump", "last.xyz", "--particles", "run.toml", "--from", "0.02 ps", "--force")
        self.write("last.toml", (self.folder / "run.toml").read_text().replace('density = "1 g/cm3"', 'initial_configuration = "last.xyz"'))
        energy = self.polhode("energy", "last.toml", "--json").partition('"potential_kJ_per_mol":')[2].split(",")[0]
        self.assertLess(abs(float(energy) - KCAL * table["E_pair"][-1]), 3e-4)

    def test_refusals_of_particles(self):
        base = self.particles(length=1)
        molecule = (self.folder / "run-1.molecule").read_text()
        for name, old, new in (("short", "4 atoms", "5 atoms"), ("flat", "Coords", "Coordinates"), ("untyped", "\nTypes", "\nMolecules"),
                               ("labels", "1 1 # OW", "1 OW"), ("many", "1 1 # OW", "1 9"), ("heavy", "2 2 # HW1", "2 1")):
            self.assertIn(old, molecule)
            self.write(f"{name}.molecule", molecule.replace(old, new))
        properties = "fix orientations all property/atom d2_orientation 4 d2_angular_momentum 3\n"
        cases = [
            (base.replace("particle 4", "particle 9"), ["number from 1 to 4"]),
            (base.replace("particle 4", 'particle 4 "run-1.molecule" particle 4'), ["given twice"]),
            (base.replace("run-1.molecule", "none.molecule"), ["cannot be read"]),
            (base.replace("run-1.molecule", "short.molecule"), ["short.molecule:", "ends after 4 of 5"]),
            (base.replace("run-1.molecule", "flat.molecule"), ["flat.molecule:", "'Coordinates' is not a section"]),
            (base.replace("run-1.molecule", "untyped.molecule"), ["no section Types"]),
            (base.replace("run-1.molecule", "labels.molecule"), ["labels.molecule:", "type labels are not supported"]),
            (base.replace("run-1.molecule", "many.molecule"), ["has sites of type 9"]),
            (base.replace("run-1.molecule", "heavy.molecule"), ["both masses must be equal"]),
            (base.replace("fix rigid all", "set atom 7 d2_orientation[2] 3\nfix rigid all"), ["particle 7 has an orientation of length"]),
            (base.replace(properties, "").replace(" fix orientations NULL Orientations", "").replace("run.data", "plain.data"),
             ["define 'fix ID all property/atom"]),
            (base.replace("orientation", "attitude").replace("Orientation", "Attitude").replace("run.data", "old.data"),
             ["d2_attitude has been renamed to d2_orientation"]),
            (base.replace("pair_style polhode", "pair_style lj/cut 5.8 #").replace("pair_coeff", "pair_coeff * * 0 1 #"),
             ["use pair_style polhode"]),
            (base.replace("electrostatics reaction-field", "electrostatics pme").replace("molecule-switch", "site-switch").replace("dielectric 78.5", ""),
             ["does not support charges within particles"]),
        ]
        data = (self.folder / "run.data").read_text()
        self.write("plain.data", data[:data.index("\nOrientations")])
        self.write("old.data", data.replace("Orientations", "Attitudes"))
        for text, words in cases:
            with self.subTest(words=words):
                self.refused(text, words)


if __name__ == "__main__":
    engine.main(__doc__)
