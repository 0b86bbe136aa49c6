# SPDX-License-Identifier: MIT
"""fix polhode and pair_style polhode together with other commands of LAMMPS: what combines gives right results, and what does not is
refused with the reason. Without the checks, each of these inputs ran to its end with wrong results.

Systems are small: LAMMPS takes longer to start than to run them.
"""

import re

import engine
from runs import KCAL, RUN, WATER, RunTest

BASE = {**WATER, "molecules": '[{ model = "spce", count = 64 }]', "truncation": "site-switch"}
SAMPLE = "thermo_style custom step temp pe ke etotal press econserve\nthermo_modify format float %.16g\nthermo {every}\nrun {steps}\n"


class Commands(RunTest):
    def setUp(self):
        super().setUp()
        self.heads = {}

    def script(self, form="", scheme="velocity-verlet", h=1.0, every=10, steps=60, fix="", before="", after=""):
        """Water with a form of the plugin: "" for pair styles of LAMMPS, "polhode", or "polhode-particles"."""
        if form not in self.heads:
            self.write("run.toml", RUN % BASE)
            name = form or "sites"
            self.polhode("export", "lammps", "run.toml", "--force", "--output", name, *(["--pair-style", form] if form else []))
            head, _, rest = (self.folder / f"{name}.in").read_text().partition("fix rigid all polhode")
            self.heads[form] = head, re.match(r' scheme (?:".*?"|\S+)(.*)', rest)[1]  # the keywords behind the scheme
        head, more = self.heads[form]
        return (f"{head}{before}fix rigid all polhode scheme {scheme}{more} {fix}\n{after}timestep {h}\n"
                + SAMPLE.format(every=every, steps=steps))

    def refuses(self, words, form="", **changes):
        with self.subTest(words=words, form=form):
            self.refused(self.script(form, **changes), words)

    def last(self, text, name, ranks=1):
        return self.lammps(text, ranks)[-1][name][-1]

    def test_a_second_computation_of_forces_is_no_second_force(self):
        """Computes of free energies perturb charges, which the bodies have not."""
        fep = "variable dq equal 0\ncompute fep all fep 300 atom charge 1 v_dq\nfix av all ave/time 10 1 10 c_fep[1]\n"
        self.refuses(["compute fep (fep) changes charges"], "polhode", before=fep)
        self.refuses(["fix n (numdiff) changes charges or positions"], "polhode", before="fix n all numdiff 10 1e-4\n")
        plain, beside = self.script(), self.script(before=fep)
        self.assert_close([self.last(plain, "TotEng")], [self.last(beside, "TotEng")], 1e-12)

    def test_friction_has_the_velocities_of_half_steps(self):
        """The thermostat moves the centre of mass, whose three degrees of freedom LAMMPS does not count: 384 are counted as 381. Blocks of
        1.5 ps give a standard error of 0.7 K. The bias of the step adds less than 1 K. Velocities of the last step would give 322 K."""
        langevin = "fix bath all langevin 300 300 20 7\n"
        for form in ("", "polhode"):
            table = self.lammps(self.script(form, h=2, before=langevin, every=5, steps=20000))[0]
            kept = table["Temp"][1000:]
            self.assertAlmostEqual(sum(kept) / len(kept), 300 * 384 / 381, delta=4 * 0.7 + 1, msg=form)
        one, two = (self.lammps(self.script(before="fix drag all viscous 100\n"), ranks)[0]["TotEng"] for ranks in (1, 2))
        self.assert_close(one, two, 1e-11)
        self.assertLess(one[-1], one[0] - 10)
        self.refuses(["fix bath (langevin) needs velocities at each of the 3 force evaluations"], scheme="gier4-fd", every=30, before=langevin)

    def frames(self, name):
        """The lines of a dump of each step, by number."""
        text = (self.folder / name).read_text()
        found = re.findall(r"TIMESTEP\n(\d+)\n.*?ITEM: ATOMS[^\n]*\n(.*?)(?=ITEM: TIMESTEP|\Z)", text, re.S)
        return {int(step): [list(map(float, line.split())) for line in lines.splitlines()] for step, lines in found}

    def test_velocities_are_of_their_step(self):
        """Velocities of atoms are set when something reads them. Differences of positions have an error of (ωh)²/6 of the fastest
        libration, 0.2 per fs: below 1 %. Friction by a variable is the same, whether each step is dumped or not."""
        dump = "dump {0} all custom {1} {0} id xu yu zu vx vy vz\ndump_modify {0} sort id format float %.15g\n"
        for form in ("", "polhode"):
            some = dump.format("some", 7)
            self.lammps(self.script(form, after=some + dump.format("each", 1), every=60))
            each = self.frames("each")
            for step in (1, 7, 30, 59):
                squares = [0.0, 0.0]
                for before, now, behind in zip(each[step - 1], each[step], each[step + 1]):
                    for k in (1, 2, 3):
                        squares[0] += (now[k + 3] - (behind[k] - before[k]) / 2)**2
                        squares[1] += now[k + 3]**2
                self.assertLess(squares[0], 0.01**2 * squares[1], f"{form}, step {step}")
            self.lammps(self.script(form, after=some, every=60))
            self.assertEqual(self.frames("some"), {step: each[step] for step in range(0, 61, 7)})
            # A time limit can end a run between two outputs.
            self.lammps(self.script(form, before="timer timeout 1 every 7\n", every=10**8, steps=10**8)
                        + "write_dump all custom end id vx vy vz modify sort id format float %.15g\ntimer timeout off\nrun 0\n"
                          "write_dump all custom again id vx vy vz modify sort id format float %.15g\n")
            end, again = ([x for row in next(iter(self.frames(name).values())) for x in row] for name in ("end", "again"))
            self.assert_close(end, again, 1e-9, form)
            drag = "variable back atom -500*vx\nfix drag all addforce v_back 0 0\n"
            alone, dumped = (self.lammps(self.script(form, before=drag, after=after, every=30), ranks)[0]["TotEng"]
                             for after, ranks in (("", 1), (dump.format("each", 1), 2)))
            self.assert_close(alone, dumped, 1e-9, form)
            self.assertLess(alone[-1], alone[0] - 1)

    def test_velocity_rescaling_has_the_trajectory_of_polhode(self):
        bath = '[thermostat]\ntype = "rescaling"\ntime_constant = "50 fs"\n'
        self.write("run.toml", RUN % {**BASE, "more": bath})
        self.polhode("run", "run.toml", "--force")
        ours = [float(row["potential [kJ/mol]"]) for row in self.energies_of_polhode()]
        for form in ((), ("--pair-style", "polhode"), ("--pair-style", "polhode-particles")):
            self.polhode("export", "lammps", "run.toml", "--force", *form)
            for ranks in (1, 2):
                theirs = self.lammps((self.folder / "run.in").read_text(), ranks)[0]["E_pair"]
                # kT of LAMMPS has a Boltzmann constant of 8 digits; the trajectory amplifies that tenfold.
                self.assert_close([KCAL * u for u in theirs], ours, 1e-6, f"{form}, {ranks} ranks")

    def test_velocity_rescaling_samples_the_canonical_distribution(self):
        """Blocks of 1.5 ps give a standard error of 0.7 K; the bias of the step adds less than 1 K. The variance of a kinetic energy of n degrees of
        freedom is 2/n of its squared mean; 600 independent values determine it to 6 %."""
        table = self.lammps(self.script("polhode", h=2, every=5, steps=20000, fix="rescale 300 20 7"))[0]
        kept = table["Temp"][1000:]
        mean = sum(kept) / len(kept)
        self.assertAlmostEqual(mean, 300, delta=4 * 0.7 + 1)
        variance = sum((T - mean)**2 for T in kept) / len(kept) / mean**2
        self.assertAlmostEqual(variance / (2 / 381), 1, delta=4 * 0.06)
        # The heat is counted: what remains is the error of the step, less than the kinetic energy of a few molecules.
        self.assertAlmostEqual(table["Econserve"][-1], table["Econserve"][200], delta=3)

    def test_baths_and_their_ramps(self):
        fix = "rescale 300 50 7 ramp 400"
        whole = self.script("polhode", h=2, every=5, steps=5000, fix=fix)
        last = self.lammps(whole)[0]["Temp"][-100:]  # 0.5 of 10 ps, in which the bath has 397.5 K; blocks of 0.5 ps scatter by 4 K
        self.assertAlmostEqual(sum(last) / len(last), 397.5, delta=4 * 4)
        for form in ("", "polhode"):
            one, two = (self.lammps(self.script(form, fix=fix), ranks)[0] for ranks in (1, 2))
            self.assert_close(one["TotEng"], two["TotEng"], 1e-9, form)
        whole = self.script("", fix="rescale 300 50 7")
        self.lammps(whole.replace("run 60", "run 20\nwrite_restart half.restart"))
        read = re.sub(r"read_data .*", "read_restart half.restart", whole).replace("run 60", "run 40")
        self.assert_close([self.last(whole, "TotEng")], [self.last(read, "TotEng", 2)], 1e-9)
        self.refuses(["only one bath can act"], fix="rescale 300 50 7 langevin 300 50 7")
        self.refuses(["add the keyword langevin or rescale"], fix="ramp 300")
        self.refuses(["the temperature of rescale is -1"], fix="rescale -1 50 7")

    def test_friction_without_noise_minimises(self):
        """At 0 K only friction remains, and the energy ends at a minimum: the kinetic energy is gone, and the last 500 steps change nothing.
        From there, a run at 1 K stays: 378 degrees of freedom have kT/2 each, of 0.4 kcal/mol in all."""
        cold = self.script("polhode", h=2, every=500, steps=6000, fix="langevin 0 50 1")
        table = self.lammps(cold)[0]
        self.assertLess(table["Temp"][-1], 1e-6)
        self.assert_close(table["PotEng"][-2:-1], table["PotEng"][-1:], 1e-8)
        self.assertLess(table["PotEng"][-1], table["PotEng"][1] - 10)
        warm = self.lammps(cold + "unfix rigid\nfix rigid all polhode langevin 1 50 1\nrun 1000\n")[1]
        self.assertAlmostEqual(warm["PotEng"][-1], table["PotEng"][-1], delta=1)

    def test_a_run_that_becomes_unstable(self):
        for form, h in (("polhode", 25), ("polhode-particles", 25)):
            for ranks in (1, 2):
                with self.subTest(form=form, ranks=ranks):
                    self.refused(self.script(form, h=h, steps=3000), ["the run has become unstable at step", "use a smaller timestep"], ranks)

    def test_small_differences_of_forces(self):
        field = "variable E equal 0.1*sin(step*0.3)\nfix field all efield v_E 0 0\n"
        for form in ("", "polhode"):
            self.refuses(["fix field (efield) adds forces that may depend on time", "small lambda"], form, scheme="gier4-fd", fix="lambda 1e-4",
                         every=30, before=field)
        mixed = self.script("polhode", "gier4-fd", every=30, fix="lambda 1e-4").replace("precision double", "precision mixed")
        self.refused(mixed, ["lambda = 0.0001", "below 0.1, the minimum in mixed precision"])

    def test_charges_that_change_during_a_run(self):
        """Pair style polhode has read the charges before; pair styles of LAMMPS see the present ones."""
        self.write("qeq.txt", "1 8 14 1 0 0\n2 4 14 1 0 0\n")
        equilibrate = "fix q all qeq/point 1 8 1e-6 50 qeq.txt\n"
        self.refuses(["fix q (qeq/point) changes them during a run", "change them between runs with 'set'"], "polhode", before=equilibrate)
        charges = "compute qa all property/atom q\ncompute q all reduce sumsq c_qa\nthermo_style custom step pe c_q\n"
        table = self.lammps(self.script(before=equilibrate).replace("run 60", charges + "run 60"))[0]
        self.assertNotEqual(table["c_q"][0], table["c_q"][-1])

    def test_atoms_that_come_and_go_during_a_run(self):
        self.write("one.txt", "water\n\n3 atoms\n\nCoords\n\n1 0 0 0\n2 1 0 0\n3 -0.3333 0.9428 0\n\nTypes\n\n1 1\n2 2\n3 2\n\n"
                              "Charges\n\n1 -0.8476\n2 0.4238\n3 0.4238\n")
        for words, before in ((["fix swap (atom/swap) creates, deletes, moves or exchanges"], "fix swap all atom/swap 5 5 7 300 types 1 2\n"),
                              (["fix gone (evaporate) creates, deletes"], "region all block INF INF INF INF INF INF\nfix gone all evaporate 5 3 all 7\n"),
                              (["fix mc (gcmc) creates, deletes"], "molecule one one.txt\nfix mc all gcmc 5 5 0 0 7 300 -1 0.1 mol one\n")):
            self.refuses(words, before=before)
        self.refuses(["was created during a run"], after="region all block 0 12 0 12 0 12\nfix new all deposit 3 1 20 7 region all near 0.01\n")
        gone = self.script(every=20, after="neigh_modify every 5 delay 0 check no\n", steps="20\ngroup one id 5\ndelete_atoms group one compress no\nrun 40 pre no")
        self.refused(gone.replace("thermo_modify", "thermo_modify lost ignore"), ["1 atoms of rigid molecules were deleted"])

    def test_kinds_whose_molecules_are_all_deleted(self):
        """The remaining molecules have the forces that another pair style computes for them alone."""
        salt = {**BASE, "molecules": '[{ model = "spce", count = 60 }, { model = "na-spce", count = 2 }, { model = "cl-spce", count = 2 }]'}
        self.write("run.toml", RUN % salt)
        for name, more in (("sites", ()), ("bodies", ("--pair-style", "polhode"))):
            self.polhode("export", "lammps", "run.toml", "--force", "--output", name, *more)
        energies = []
        for name in ("sites", "bodies"):
            head = (self.folder / f"{name}.in").read_text().partition("thermo_style")[0]
            energies.append(self.lammps(f"{head}run 10\ngroup ions type 3 4\ndelete_atoms group ions\n" + SAMPLE.format(every=10, steps=10))[-1]["PotEng"])
        self.assert_close(*energies, 1e-6)  # the tables of the first differ by 1e-8, and so do its trajectories

    def test_output_within_a_step_of_a_scheme(self):
        for words, every, after in ((["the interval of thermo is a variable"], "30\nvariable s equal stride(0,1000,5)\nthermo v_s", ""),
                                    (["the interval of fix p (print) is 4"], 30, "fix p all print 4 x\n"),
                                    (["the interval of fix v (vector) is 5"], 30, "variable u equal pe\nfix v all vector 5 v_u\n"),
                                    (["the interval of fix h (halt) is 10"], 30, "variable u equal step\nfix h all halt 10 v_u > 1e9\n"),
                                    (["the interval of fix d (dt/reset) is 4"], 30, "fix d all dt/reset 4 0.1 1 0.01 units box\n"),
                                    (["the interval of a dump is a variable"], 30, "variable s equal stride(0,1000,5)\ndump d all atom 3 d.dump\ndump_modify d every v_s\n")):
            self.refuses(words, scheme="gier4-fd", every=every, after=after)
        self.write("test.in", self.script("polhode", "gier4-fd", every=30, steps=30000000, after="timer timeout 0:00:01 every 1\n"))
        done = engine.ENGINE.run(self.folder, "test.in")
        self.assertEqual(done.returncode, 0, done.stdout[-2000:])
        steps, = re.findall(r"^Loop time of .* for (\d+) steps", done.stdout, re.M)
        self.assertEqual("the run ended after" in done.stdout, int(steps) % 3 != 0)

    def test_forces_of_atoms_are_those_of_their_molecules(self):
        """Total forces and torques of a molecule, by the forces of its atoms, equal the result of a pair style of LAMMPS."""
        more = "group one molecule 7\ncompute x all property/atom xu yu zu\n" + "".join(
            f"variable t{k} atom {a}\n" for k, a in enumerate(("c_x[2]*fz-c_x[3]*fy", "c_x[3]*fx-c_x[1]*fz", "c_x[1]*fy-c_x[2]*fx")))
        more += "compute F one reduce sum fx fy fz v_t0 v_t1 v_t2\n"
        names = [f"c_F[{k}]" for k in range(1, 7)]
        columns = "10\nthermo_style custom step " + " ".join(names)
        sites, bodies = (self.script(form, after=more, every=columns) for form in ("", "polhode"))
        exact = self.lammps(sites)[0]
        for ranks in (1, 2):
            found = self.lammps(bodies, ranks)[0]
            for name in names:
                scale = max(abs(x) for x in exact[name])
                for a, b in zip(exact[name], found[name]):  # the table of the pair style differs by 1e-8, and so does the trajectory
                    self.assertLess(abs(a - b), 1e-5 * scale + 1e-7, name)
        self.refuses(["fix s (setforce) has no forces to replace"], "polhode", before="fix s all setforce 0 0 0\n")

    def test_changes_that_the_pair_style_does_not_see(self):
        self.refuses(["fix a (adapt) changes them during a run"], "polhode", before="variable q equal 0.5\nfix a all adapt 1 atom charge v_q\n")

    def test_a_rerun_of_particles(self):
        dump = self.script("polhode-particles", steps=20, after="dump d all custom 10 x.dump id x y z vx vy vz\n")
        self.refused(dump + "rerun x.dump dump x y z vx vy vz\n", ["rerun reads no orientations"])

    def test_constraints_and_late_forces(self):
        self.refuses(["fix s (shake) changes velocities or positions"], after="fix s all shake 1e-6 100 0 b 1\n")
        self.refuses(["fix e (efield) is defined after fix polhode"], after="fix e all efield 1 0 0\n")

    def test_stresses_of_atoms_sum_to_the_pressure(self):
        stress = ("compute s all stress/atom NULL\ncompute p all reduce sum c_s[1] c_s[2] c_s[3]\n"
                  "variable P equal -(c_p[1]+c_p[2]+c_p[3])/(3*vol)\n")
        for ranks in (1, 2):
            table = self.lammps(self.script(after=stress, every="10\nthermo_style custom step press v_P\nthermo_modify format float %.16g"), ranks)[0]
            self.assert_close(table["Press"], table["v_P"], 1e-9)

    def test_the_molecules_that_were_found_are_printed(self):
        for form, words in (("", "fix polhode: 64 rigid molecules of 3 atoms (types 1, 2, 2)"), ("polhode-particles", "fix polhode: 64 particles of type 3 (3 sites)")):
            self.write("test.in", self.script(form))
            self.assertIn(words, engine.ENGINE.run(self.folder, "test.in").stdout)
        lines = self.script(steps=0, before="pair_style zero 5\nPAIRS * *\nset group all mol 0\n").splitlines()
        single = "\n".join(line for line in lines if not line.startswith(("pair_style h", "pair_style t", "pair_coeff"))).replace("PAIRS", "pair_coeff")
        self.write("test.in", single + "\n")
        self.assertIn("fix polhode: 128 single atoms of type 2, 64 single atoms of type 1", engine.ENGINE.run(self.folder, "test.in").stdout)

    def test_the_temperature_of_parts_of_molecules(self):
        """Of oxygens alone, as if they were free, with a warning, as for other rigid molecules of LAMMPS."""
        parts = self.script(before="group O type 1\ncompute tO O temp\n", every="10\nthermo_style custom step temp c_tO")
        one, two = self.lammps(parts)[0], self.lammps(parts, 2)[0]
        self.assert_close(one["c_tO"], two["c_tO"], 1e-5)
        self.assertGreater(min(one["c_tO"]), 0)
        self.write("test.in", parts)
        self.assertIn("a temperature is computed of parts of 64 rigid molecules", engine.ENGINE.run(self.folder, "test.in").stdout)


if __name__ == "__main__":
    engine.main(__doc__)
