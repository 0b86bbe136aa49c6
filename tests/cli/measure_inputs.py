# SPDX-License-Identifier: MIT
"""polhode measure on files of GROMACS and LAMMPS: the same bits as with the run file that 'polhode new' writes."""

import itertools
import json

import sandbox
from sandbox import Sandbox

TOPOLOGY = """[ defaults ]
1 2
[ atomtypes ]
Ar 18 39.948 0 A 0.3405 0.99607
[ moleculetype ]
AR 1
[ atoms ]
1 Ar 1 AR Ar 1 0 39.948
[ system ]
argon
[ molecules ]
AR {}
"""
PARAMETERS = """dt = 0.002
rvdw = 0.65
rcoulomb = 0.65
vdw-modifier = Potential-switch
rvdw-switch = 0.55
DispCorr = EnerPres
tcoupl = V-rescale
tc-grps = System
tau-t = 0.5
ref-t = 160
"""
DATA = """argon

125 atoms
1 atom types
0 20 xlo xhi
0 20 ylo yhi
0 20 zlo zhi

Masses

1 39.948

Pair Coeffs # lj/cut

1 0.238 3.405

Atoms # full

"""
ARGUMENTS = ("density", "5 %", "second-virial-coefficient", "2 %", "--replicas", "2", "--at", "160 K, 500 bar", "--json")


def lattice(n, edge):
    return [[(i + 0.5) * edge / n for i in place] for place in itertools.product(range(n), repeat=3)]


class Inputs(Sandbox):
    def gromacs(self, n, edge):
        atoms = [f"{k:5d}AR      Ar{k:5d}" + "".join(f"{x:8.3f}" for x in place)
                 for k, place in enumerate(lattice(n, edge), 1)]
        self.write("topol.top", TOPOLOGY.format(n**3))
        self.write("conf.gro", "\n".join(["argon", str(n**3), *atoms, 3 * f"{edge:10.5f}"]) + "\n")
        self.write("run.mdp", PARAMETERS)

    def points(self, *arguments):
        process = self.polhode("measure", *arguments)
        self.assertEqual(process.returncode, 0, process.err)
        return json.loads(process.out)["points"], process.err

    def test_gromacs_files_are_measured_as_their_run_file(self):
        self.gromacs(4, 1.6)
        self.assertEqual(self.polhode("new", "gromacs", "run.toml", "--mdp", "run.mdp").returncode, 0)
        expected, _ = self.points("run.toml", *ARGUMENTS, "--output", "file")
        found, _ = self.points("topol.top", "conf.gro", "run.mdp", *ARGUMENTS, "--output", "input")
        self.assertEqual(found, expected)
        # A dense fluid of 1.3 g/cm3; the switching from 0.55 nm on weakens the attraction.
        value = found[0]["properties"][0]["value"]["value"]
        self.assertLess(abs(value / 1300 - 1), 0.15)

    def test_lammps_data_files_are_measured_as_their_run_file(self):
        atoms = [f"{k} {k} 1 0 " + " ".join(f"{10 * x:.4f}" for x in place)
                 for k, place in enumerate(lattice(5, 2), 1)]
        self.write("system.data", DATA + "\n".join(atoms) + "\n")
        self.assertEqual(self.polhode("new", "lammps", "run.toml").returncode, 0)
        text = (self.folder / "run.toml").read_text(encoding="utf-8")
        self.write("run.toml", text.replace('electrostatics = "pme"', "# no charges"))
        # The cutoff of 1 nm fits into a box of 125 atoms up to 1036 kg/m3.
        arguments = ("pressure", "100 bar", "--replicas", "2", "--at", "200 K, 1 g/cm3", "--json")
        expected, _ = self.points("run.toml", *arguments, "--output", "file")
        found, messages = self.points("system.data", *arguments, "--output", "input")
        self.assertEqual(found, expected)
        self.assertIn("'polhode new lammps': cutoff 1 nm, with dispersion correction, geometric mixing", messages)

    def test_parameters_of_forces_without_counterpart_are_told(self):
        self.gromacs(4, 1.6)
        self.write("run.mdp", PARAMETERS.replace("Potential-switch", "Potential-shift") + "nstcalclr = 7\n")
        _, messages = self.points("topol.top", "conf.gro", "run.mdp", "second-virial-coefficient", "--json")
        self.assertIn("note: vdw-modifier = Potential-shift: discontinuous or shifted forces", messages)
        self.assertNotIn("nstcalclr", messages)

    def test_steps_that_are_too_short_for_a_decision_are_said(self):
        """30,000 steps, in which the atoms of a liquid do not yet leave their places."""
        process = self.polhode("measure", "argon", "density", "--molecules", "64", "--at", "160 K, 500 bar", "--step", "0.01 fs", "--output", "out")
        self.assertEqual(process.returncode, 1, process.err)
        self.assertRegex(process.err, r"the molecules have moved by only \S+ nm \(rms\) in 0\.\d+ ps, which is too short to distinguish a liquid from a solid")
        self.assertNotIn("is a solid", process.err)
        self.assertRegex(process.err, r"plan at .*; first 0\.\d+ ps of each at constant pressure")

    def test_what_cannot_be_measured_is_refused(self):
        self.gromacs(4, 2.1)
        pair = "1 Ar 1 AR Ar 1 0 39.948\n2 Ar 1 AR Ar2 1 0 39.948\n[ bonds ]\n1 2 1 0.2 1000"
        self.write("flexible.top", TOPOLOGY.replace("1 Ar 1 AR Ar 1 0 39.948", pair).format(32))
        for arguments, words in (
                (("topol.top", "density"), ["needs a file with positions", "topol.top conf.gro"]),
                (("topol.top", "run.mdp", "density"), ["needs a file with positions"]),
                (("topol.top", "conf.gro", "conf.gro", "density"), ["'conf.gro'", "must be .mdp"]),
                (("topol.top", "none.gro", "density"), ["none.gro"]),
                (("topol.top", "conf.gro", "none.mdp", "density"), ["none.mdp"]),
                (("topol.top", "conf.gro", "density", "--molecules", "64"), ["--molecules", "an input file"]),
                (("system.data", "conf.gro", "density"), ["'conf.gro' has no meaning with a LAMMPS data file"]),
                (("topol.top", "conf.gro", "densty"), ["no property 'densty'"]),
                (("flexible.top", "conf.gro", "density"), ["flexible.top", "rigid"])):
            self.refused(("measure", *arguments), words)


if __name__ == "__main__":
    sandbox.main()
