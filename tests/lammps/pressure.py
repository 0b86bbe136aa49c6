# SPDX-License-Identifier: MIT
"""The barostat of fix polhode: its moves, its distribution, and what moves with the box."""

import math
import re

import engine
from runs import LAMMPS_PRESSURE, RUN, WATER, RunTest

SPCE = {**WATER, "molecules": '[{ model = "spce", count = 64 }]', "truncation": "site-switch"}
PME = {**SPCE, "electrostatics": "pme"}
FORMS = (("", SPCE), ("polhode", SPCE), ("polhode-particles", SPCE), ("", PME), ("polhode", PME))
SAMPLE = "thermo_style custom step temp pe ke etotal press vol\nthermo_modify format float %.16g\nthermo {every}\nrun {steps}\n"
COLD = "rescale 0 1e15 7"  # a bath without noise and without effect
BOLTZMANN = 0.0019872067  # of LAMMPS in units real


class Pressure(RunTest):
    def setUp(self):
        super().setUp()
        self.heads = {}

    def script(self, fix, form="polhode", values=SPCE, scheme="velocity-verlet", every=1, steps=30, h=1.0):
        key = form, *values.values()
        if key not in self.heads:
            self.write("run.toml", RUN % values)
            name = f"system{len(self.heads)}"
            self.polhode("export", "lammps", "run.toml", "--force", "--output", name, *(["--pair-style", form] if form else []))
            head, _, rest = (self.folder / f"{name}.in").read_text().partition("fix rigid all polhode")
            head = head.replace("kspace_style pppm 1e-06", "kspace_style pppm 1e-06\nkspace_modify gewald 0.5 mesh 24 24 24 order 7")  # for each box
            self.heads[key] = head, re.match(r' scheme (?:".*?"|\S+)(.*)', rest)[1]  # the keywords behind the scheme
        head, more = self.heads[key]
        return f"{head}fix rigid all polhode scheme {scheme}{more} {fix}\ntimestep {h}\n" + SAMPLE.format(every=every, steps=steps)

    def test_a_move_is_that_of_the_stochastic_equation(self):
        """Without noise, the change of the volume follows from the pressure at the end of the step before."""
        P0, tau, kappa, every = 500.0, 200.0, 4.5e-5, 3
        for scheme, evaluations in (("velocity-verlet", 1), ("gier4-fd", 3)):
            script = self.script(f"{COLD} pressure {P0} {tau} {kappa} every {every}", scheme=scheme, every=evaluations, steps=30)
            table = self.lammps(script)[0]
            V, P = table["Volume"], table["Press"]
            self.assertEqual(len(V), 30 // evaluations + 1)
            for k in range(len(V) - 1):
                root = math.sqrt(V[k])
                if k % every == 0:
                    root -= kappa * root / (2 * tau) * (P0 - P[k]) * every * evaluations
                self.assert_close([V[k + 1]], [root**2], 1e-13, f"{scheme}, step {k}")
            self.assertNotEqual(V[0], V[-1])

    def test_moves_of_groups_of_edges(self):
        """Each move scales the edges of one group by the pressure along them, and the groups alternate."""
        P0, tau, kappa, every = 500.0, 200.0, 4.5e-5, 2
        for groups in ("xy,z", "x,y,z", "z"):
            with self.subTest(groups=groups):
                script = self.script(f"{COLD} pressure {P0} {tau} {kappa} every {every} edges {groups}", steps=20)
                table = self.lammps(script.replace(" press vol", " vol lx ly lz pxx pyy pzz"))[0]
                of_edges = groups.split(",")
                for k in range(20):
                    edges = of_edges[k // every % len(of_edges)] if k % every == 0 else ""
                    P = sum(table[f"P{e}{e}"][k] for e in edges) / max(1, len(edges))
                    moved = 1 - kappa / (2 * tau) * (P0 - P) * every
                    factor = moved ** (2 / max(1, len(edges)))
                    for e in "xyz":
                        before, after = table[f"L{e}"][k:k + 2]
                        self.assert_close([after], [before * (factor if e in edges else 1)], 1e-13, f"edge {e}, step {k}")
                for e in "xyz":
                    self.assertEqual(table[f"L{e}"][0] != table[f"L{e}"][-1], e in groups)

    def test_all_parts_of_a_system_follow_the_box(self):
        """A second setup, which finds everything again from the positions of atoms, has the energy and the pressure of the last step. The
        box shrinks by 3 % in a run, so that the nearest images change their roles."""
        for form, values in FORMS:
            with self.subTest(form=form, electrostatics=values["electrostatics"]):
                script = self.script(f"{COLD} pressure 9000 30 4.5e-5 every 2 edges xy,z", form, values, steps=40, every=10) + "run 0\n"
                tables = [self.lammps(script, ranks) for ranks in (1, 2)]
                for table in tables:
                    self.assertLess(table[0]["Volume"][-1], 0.98 * table[0]["Volume"][0])
                    for name in ("PotEng", "Volume"):
                        self.assert_close(table[0][name][-1:], table[1][name], 1e-11, name)
                    self.assertAlmostEqual(table[0]["Press"][-1], table[1]["Press"][0], delta=1e-5)
                for name in ("PotEng", "KinEng", "Volume"):
                    self.assert_close(tables[0][0][name], tables[1][0][name], 1e-9, f"{name} on 1 and 2 ranks")

    def test_a_tilted_box_keeps_its_shape(self):
        """Its tilt is a whole edge, so it is the same system; images of the second are in other places."""
        for edges, tilt in (("xyz", "xy"), ("x,y,z", "xy"), ("x,y,z", "xz"), ("x,y,z", "yz")):
            fix = f"{COLD} pressure 9000 30 4.5e-5 every 2 edges {edges}"
            plain = self.script(fix, every=10, steps=40)
            box = f"change_box all triclinic\nchange_box all {tilt} final $(l{tilt[0]}) units box\n"
            tilted = plain.replace("fix rigid all", box + "fix rigid all", 1)
            self.assertNotEqual(plain, tilted)
            one, two = self.lammps(plain)[0], self.lammps(tilted)[0]
            for name in ("PotEng", "Volume"):
                self.assert_close(one[name], two[name], 1e-9, f"{name}, {edges}, {tilt}")

    def ideal_gas(self, fix, steps, argon="", every=10):
        """64 molecules without interactions: water, or water and argon, which then has a fix of its own."""
        models = '[{ model = "spce", count = 40 }, { model = "argon", count = 24 }]' if argon else SPCE["molecules"]
        script = self.script(fix, "" if argon else "polhode", {**SPCE, "density": "0.7 g/cm3", "molecules": models}, every=every, steps=steps, h=4.0)
        script = re.sub(r"(pair_coeff \d+ \d+) \d.*", r"\1 0 0", script)
        script = re.sub(r"^pair_style hybrid.*((?:\n.*)*?)(?:\npair_coeff .*)+", r"pair_style zero 5\1\npair_coeff * *", script, flags=re.M)
        groups = f"group argon type 3\ngroup water subtract all argon\nfix free argon nve\n{argon}fix rigid water" if argon else "fix rigid all"
        return script.replace("fix rigid all", "set group all charge 0\n" + groups, 1)

    def check_ideal_gas(self, argon="", edges="xyz"):
        """The distribution of the volume is Gamma(N, kT/P), with the mean N kT/P and the variance N (kT/P)². Volumes lose their memory in
        about τ = 50 moves, so 60,000 moves are 600 independent values; the mean is known to 1/√(600 N), and the variance to √(2/600) = 6 %.
        A move of 1/50 of τ adds 1 % to the variance."""
        N, T, P, tau = 64, 300.0, 1000.0, 200.0
        script = self.ideal_gas(f"langevin {T} 100 7 pressure {P} {tau} {1 / P} every 1 edges {edges}", 60000, argon)
        table = self.lammps(script.replace(" press vol", " vol lx ly lz"))[0]
        V = table["Volume"][500:]
        expected = N * BOLTZMANN * T / P * LAMMPS_PRESSURE
        mean = sum(V) / len(V)
        self.assertAlmostEqual(mean / expected, 1, delta=4 / math.sqrt(600 * N))
        variance = sum((v - mean)**2 for v in V) / len(V) / (expected**2 / N)
        self.assertAlmostEqual(variance, 1.01, delta=4 * 0.06)
        return table

    def test_the_volume_of_an_ideal_gas(self):
        self.check_ideal_gas()

    def test_the_volume_and_the_shape_of_an_ideal_gas(self):
        """Nothing resists a change of shape, so the ratios of edges reach their bound, and stay within it, also after a restart."""
        table = self.check_ideal_gas(edges="x,y,z")
        first = [table[f"L{e}"][0] for e in "xyz"]
        script = self.ideal_gas("langevin 300 100 7 pressure 1000 200 1e-3 every 1 edges x,y,z", 3000).replace(" press vol", " press vol lx ly lz")
        self.lammps(script + "write_restart gas.restart\n")
        again = self.lammps(self.restarted(script, "gas.restart"))[0]
        for lengths in (table, again):
            changes = [[x / edge for x in lengths[f"L{e}"]] for e, edge in zip("xyz", first)]
            ratios = [max(edges) / min(edges) for edges in zip(*changes)]
            self.assertLessEqual(max(ratios), 1.2 * (1 + 1e-12))
            self.assertGreater(max(ratios), 1.18)

    def test_the_volume_of_an_ideal_gas_with_atoms_of_another_fix(self):
        self.check_ideal_gas("fix bath argon langevin 300 300 100 9\n")

    def test_momenta_are_scaled_by_the_inverse_factor(self):
        """Without forces, nothing else changes kinetic energies of translation."""
        script = self.ideal_gas(f"{COLD} pressure 5000 30 4.5e-5 every 2", 20, "compute atoms argon ke\n", every=1)
        table = self.lammps(script.replace(" press vol", " press vol f_rigid[1] c_atoms"))[0]
        squares = [V ** (2 / 3) for V in table["Volume"]]
        self.assertGreater(squares[0] / squares[-1], 1.001)
        for name in ("f_rigid[1]", "c_atoms"):
            values = [E * square for E, square in zip(table[name], squares)]
            self.assert_close(values, [values[0]] * len(values), 1e-12, name)

    def restarted(self, script, path):
        """The same script, which begins with a restart file."""
        style, = re.findall(r"^pair_style .*\n", script, re.M)
        return re.sub(r"read_data .*\n", f"read_restart {path}\n{style}", script.replace(style, ""))

    def test_restart_files(self):
        fix = "rescale 300 50 7 pressure 1 200 4.5e-5 every 4 edges x,yz"
        whole = self.script(fix, steps=60)
        self.lammps(whole.replace("run 60", "run 22\nwrite_restart half.restart"))
        read = self.restarted(whole, "half.restart").replace("run 60", "run 38")
        one = self.lammps(whole)[0]
        for ranks in (1, 2):
            other = self.lammps(read, ranks)[0]
            for name in ("PotEng", "Volume"):
                self.assert_close(one[name][-1:], other[name][-1:], 1e-9, name)
        parts = self.lammps(whole.replace("run 60", "run 22\nrun 38"))[1]
        self.assert_close(one["Volume"][-1:], parts["Volume"][-1:], 1e-9)

    def test_export_writes_the_barostat(self):
        ensemble = '[thermostat]\ntype = "rescaling"\n[barostat]\npressure = "100 bar"\nevery = "5 fs"\ncompressibility = "4.5e-5 1/bar"\n'
        self.write("npt.toml", RUN % {**SPCE, "more": ensemble})
        self.polhode("export", "lammps", "npt.toml", "--pair-style", "polhode", "--force")
        script = (self.folder / "run.in").read_text()
        P, tau, kappa, every = map(float, re.search(r" pressure (\S+) (\S+) (\S+) every (\S+)", script).groups())
        self.assert_close([P, tau, kappa, every], [100 / 1.01325, 2000, 4.5e-5 * 1.01325, 5], 1e-12)
        self.assertNotIn("edges", script)
        self.assertEqual(len(self.lammps(script)[0]["Volume"]), 2)
        self.write("npt.toml", RUN % {**SPCE, "more": ensemble + 'edges = ["xy", "z"]\n'})
        self.polhode("export", "lammps", "npt.toml", "--pair-style", "polhode", "--force")
        script = (self.folder / "run.in").read_text()
        self.assertIn(" edges xy,z\n", script)
        self.assertEqual(len(self.lammps(script)[0]["Volume"]), 2)

    def test_a_wall_between_two_boundaries(self):
        """Only edges with periodic boundaries can be scaled."""
        fix = "rescale 300 50 7 pressure 1 500 4.5e-5 every 1"
        wall = "units real\nboundary p p f"
        script = self.script(f"{fix} edges xy", steps=5).replace("units real", wall)
        table = self.lammps(script.replace(" press vol", " press vol lx lz"))[0]
        self.assertNotEqual(table["Lx"][0], table["Lx"][-1])
        self.assertEqual(table["Lz"][0], table["Lz"][-1])
        self.refused(self.script(f"{fix} edges xy,z").replace("units real", wall), ["scales the edge z", "boundary p p p"])

    def test_what_is_refused(self):
        bath, pressure = "rescale 300 50 7", "pressure 1 500 4.5e-5"
        for words, script in ((["add the keyword langevin or rescale"], self.script(pressure)),
                              (["add the keyword pressure"], self.script(f"{bath} every 3")),
                              (["the number of steps of every must be a whole number from 1"], self.script(f"{bath} {pressure} every 0.5")),
                              (["the compressibility of pressure"], self.script(f"{bath} pressure 1 500 0")),
                              (["edges names the edges that a barostat scales", "add the keyword pressure"], self.script(f"{bath} edges xy")),
                              (["has the group 'xq' in 'xq,z'", "xyz, or xy,z"], self.script(f"{bath} {pressure} edges xq,z")),
                              (["has the group '' in 'x,'"], self.script(f"{bath} {pressure} edges x,")),
                              (["an edge in two groups of 'xy,yz'"], self.script(f"{bath} {pressure} edges xy,yz")),
                              (["'fix_modify rigid temp' has no effect"],
                               self.script(bath).replace("timestep", "compute t all temp\nfix_modify rigid temp t\ntimestep", 1)),
                              (["set 'boundary p p p'"], self.script(f"{bath} {pressure}").replace("units real", "units real\nboundary p p f")),
                              (["fix box (press/berendsen) changes the box"],
                               self.script(bath).replace("fix rigid all", "fix box all press/berendsen iso 1 1 1000\nfix rigid all", 1)),
                              (["forces within molecules"], self.script(f"{bath} {pressure}").replace("timestep", "fix_modify rigid virial no\ntimestep", 1)),
                              (["in one move", "larger time constant"], self.script(f"{bath} pressure 1e6 10 4.5e-5"))):
            with self.subTest(words=words):
                self.refused(script, words)


if __name__ == "__main__":
    engine.main(__doc__)
