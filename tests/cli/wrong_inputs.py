# SPDX-License-Identifier: MIT
"""What people type wrong in their first hour, and the messages: each names the place, the value, the bound, and what to do.

`wrong_inputs.py --program polhode --write FILE` writes all commands with their messages, to be read."""

import sys

import sandbox
from sandbox import SMALL, Sandbox, edited

WRITE = None  # a file for the messages, from the command line

WATER = """[system]
molecules = [{ model = "tip4p", count = 27 }]
density = "0.9 g/cm3"
"""
BOX = """two argon atoms
    2
    1argon   AR    1   0.500   0.500   0.500
    2argon   AR    2   1.500   1.500   1.500
   2.50000   2.50000   2.50000 0 0 0.5 0 0 0
"""
TILTED = """LAMMPS data file

2 atoms
0 5 xlo xhi
0 5 ylo yhi
0 5 zlo zhi
1 0 0 xy xz yz
"""
OWN = """name = "own"
source = "user"
[[site]]
name = "C1"
element = "C"
position = "0 0 0 nm"
LINE
[[site]]
name = "C2"
element = "C"
position = "0.152 0 0 nm"
mass = "12 u"
"""
RUN = ("run", "run.toml")


def system(*changes):
    return edited(SMALL, *changes)


def own(line):
    """The small run file with a molecule of its own, of two atoms, the first with this line."""
    return system(('model = "argon"', 'model = "own.toml"')) + "### own.toml\n" + OWN.replace("LINE", line)


def scheme(text):
    return system(('scheme = "hoa2"', f'scheme = "{text}"'))


# What was meant, the run file, the command, and what the message must contain.
CASES = [
    # the command line
    ("a verb with a typing error", "", ("rn", "run.toml"), ["rn", "'run'"]),
    ("a verb without its argument", "", ("verify",), ["SCHEME is required", "polhode help verify"]),
    ("a conversion without files", "", ("convert",), ["IN is required", "polhode help convert"]),
    ("an export without a run file", "", ("export", "lammps"), ["FILE is required", "polhode help export"]),
    ("an export of a law that no pair style has", SMALL, ("export", "lammps", "run.toml"),
     ["run.toml", "molecule-switch", "no pair style of LAMMPS", "--pair-style polhode", "site-switch"]),
    ("an export for a pair style that does not exist", SMALL, ("export", "lammps", "run.toml", "--pair-style", "lj/cut"),
     ["--pair-style", "lj/cut", "table"]),
    ("an export of the dispersion of a slab", SMALL.replace('cutoff = "1.0 nm"', 'cutoff = "1.0 nm"\nslab_dispersion = true'),
     ("export", "lammps", "run.toml"), ["run.toml", "slab_dispersion has no counterpart", "pppm/disp"]),
    ("an export of a nested scheme", SMALL, ("export", "lammps", "run.toml", "--scheme", "velocity-verlet / hoa2 x 2 within 0.35 to 0.5 nm"),
     ["only single schemes are supported"]),
    ("a format twice", SMALL.replace("[output]", '[output]\nformats = ["gro", "gro"]'), RUN, ["the format 'gro' twice", "output.formats"]),
    ("an export of particles with a mesh", '[system]\nmolecules = [{ model = "spce", count = 64 }]\ndensity = "1 g/cm3"\n[forces]\n'
     'electrostatics = "pme"\ncutoff = "0.6 nm"\n[integrator]\nscheme = "velocity-verlet"\nstep = "2 fs"\n[run]\nlength = "2 fs"\n',
     ("export", "lammps", "run.toml", "--pair-style", "polhode-particles"), ["run.toml", "does not support charges within particles", "--pair-style polhode"]),
    ("particles of a file that is no dump", SMALL, ("convert", "run.xtc", "run.gro", "--particles", "run.toml"),
     ["run.xtc", "not a LAMMPS dump file", ".lammpstrj"]),
    ("an analysis without a trajectory", "", ("analyze",), ["TRAJECTORY", "required", "polhode help analyze"]),
    ("an option that does not exist", SMALL, (*RUN, "--steps", "2"), ["--steps", "--length", "polhode help run"]),
    ("a run file that does not exist", "", ("run", "nowhere.toml"), ["nowhere.toml"]),
    ("a time without a unit on the command line", SMALL, ("tune-scheme", "run.toml", "--step", "2"),
     ["--step", "2", "no unit", '"2 fs"']),
    ("a viscosity without a unit", SMALL, ("analyze", "out.xtc", "--run", "run.toml", "--viscosity", "0.855"),
     ["--viscosity", '"0.855"', "no unit", '"0.855 mPa s"']),
    ("an option before the verb", SMALL, ("--threads", "1", *RUN), ["write the verb first", "'--threads'", "polhode help"]),
    ("an option that needs a verb", "", ("-v",), ["write the verb first", "'-v'"]),
    ("an option without its value", SMALL, (*RUN, "--length"), ["--length needs a value", "polhode help run"]),
    ("a number out of its range", SMALL, ("study", "run.toml", "--runs", "1"), ["--runs", 'runs = "1" must be 2 or more']),
    ("a word where a number is due", SMALL, ("study", "run.toml", "--runs", "two"), ["--runs", 'runs = "two" must be a whole number']),
    ("a list of numbers with a letter", "", ("top", "--J", "1,a,3"), ["--J = \"1,a,3\"", "must be 3 numbers"]),
    ("a top of its own beside a table", "", ("top", "--table", "tops.csv", "--J", "1,2,3"), ["--J", "has no meaning with --table"]),
    ("a method without a table", "", ("top", "--J", "1,2,3", "--L", "0.1,0.2,1", "--method", "series"), ["--method", "has no meaning without --table"]),
    ("an empty list of sizes", "", ("bench", "--quick", "--sizes", ","), ["--sizes", "has no number of waters"]),
    ("a method that does not exist", "", ("top", "--table", "tops.csv", "--method", "serie"), ["--method", '"serie"', "did you mean 'series'"]),
    ("a variable of the shell that is not set", SMALL, (*RUN, "--output", ""), ["the value of --output is empty", "polhode help run"]),
    ("a run file whose name is not set", "", ("run", ""), ["the value of FILE is empty", "default"]),
    ("no threads", SMALL, (*RUN, "--threads", "0"), ["threads = '0'", "from 1 to", "the number of cores"]),
    ("a coordinate file as run file", "", ("run", "start.gro"), ["input file of another program", "polhode new gromacs", "start.gro"]),
    ("a LAMMPS data file as run file", "", ("energy", "w.data"), ["input file of another program", "polhode new lammps", "w.data"]),
    ("a prefix that is a folder", SMALL, (*RUN, "--output", "results/"), ["'results/'", "must not be empty or end in '/'", "'results/run'"]),
    ("a prefix of a run file that is a folder", system(('"out"', '"results/"')), RUN, ["'results/'", "'results/run'"]),
    ("a prefix of a study that is a folder", SMALL, ("study", "run.toml", "--output", "results/"), ["'results/run'"]),
    ("a prefix of advice that is a folder", SMALL, ("advise", "run.toml", "--accuracy", "1 %", "--output", "results/"), ["'results/run'"]),
    ("a prefix of an analysis that is a folder", SMALL, ("analyze", "start.gro", "--run", "run.toml", "--output", "results/"), ["'results/run'"]),
    ("a prefix of a figure that is a folder", "", ("top", "--J", "1,2,3", "--L", "1,2,3", "--output", "results/"), ["'results/run'"]),
    ("lambda of a scheme with exact gradients", "", ("verify", "gier4", "--lambda", "0.1"),
     ["gier4 has no finite-difference gradient", "leave lambda out", "gier4-fd", "--lambda"]),
    ("a scheme to be tuned with a typing error", SMALL, ("tune-scheme", "run.toml", "--scheme", "gier5"),
     ["'gier5'", "did you mean 'gier4'", "--scheme"]),
    # names
    ("a model in capitals", WATER.replace("tip4p", "TIP4P"), RUN, ["'TIP4P'", "did you mean 'tip4p'", "polhode molecules", "run.toml:2"]),
    ("a model with a slash", WATER.replace("tip4p", "SPC/E"), RUN, ["'SPC/E'", "did you mean 'spce'", "run.toml:2"]),
    ("a model with a year", WATER.replace("tip4p", "TIP4P/2005"), RUN, ["'TIP4P/2005'", "did you mean 'tip4p-2005'"]),
    ("a scheme in capitals", scheme("GIER4"), RUN, ["'GIER4'", "did you mean 'gier4'", "integrator.scheme"]),
    ("a key with a typing error", system(("cutoff =", "cutof =")), RUN, ["'cutof'", "did you mean 'cutoff'", "run.toml:7"]),
    ("a key of another program", system(("[run]", "[run]\nnsteps = 1000")), RUN, ["'nsteps'", "run.toml:14"]),
    ("a pressure in a table that has none", system(('"100 K"', '"100 K"\npressure = "1 bar"')), RUN,
     ["'pressure'", "there are: ", "temperature", "run.toml:5"]),
    ("a key that occurs twice", system(('step = "2 fs"', 'step = "2 fs"\nstep = "4 fs"')), RUN,
     ["'step' occurs twice", "delete one", "run.toml:12"]),
    ("a name of version 0.1", system(('box = "2.5 nm"', 'start = "w512"')), RUN, ["'initial_configuration' since version 0.2"]),
    # values
    ("a number without a unit", system(('"1.0 nm"', "1.0")), RUN, ["cutoff = 1", "no unit", "nm", "forces.cutoff"]),
    ("a mistyped setting", "", ("settings", "cutof"), ["no setting 'cutof'", "did you mean 'cutoff'"]),
    ("a setting of several tables", "", ("settings", "length"), ["several tables", "run.length, study.length"]),
    ("an accuracy as a fraction", system(('step = "2 fs"', "accuracy = 0.005")), RUN,
     ["accuracy = 0.005", "no unit", '"0.5 %"', "integrator.accuracy"]),
    ("a time where a length is due", system(('"1.0 nm"', '"1.0 fs"')), RUN, ["1.0 fs", "is a time", "must be a length"]),
    ("a unit in capitals", system(('"1.0 nm"', '"1.0 NM"')), RUN, ["'NM'", "'nm'", "forces.cutoff"]),
    ("a temperature in Celsius", system(('"100 K"', '"25 C"')), RUN, ["25 C", "there is no unit 'C' of temperature; the units are: K"]),
    ("a decimal comma", system(('"1.0 nm"', '"1,0 nm"')), RUN, ["1,0 nm", "decimal point"]),
    ("a no-break space", system(('"2 fs"\n\n', '"2\u00a0fs"\n\n')), RUN, ["no-break space (U+00A0)", "ordinary space", '"2 fs"', "run.toml:11"]),
    ("a no-break space on the command line", SMALL, (*RUN, "--step", "2\u00a0fs"), ["no-break space (U+00A0)", "--step"]),
    ("an accuracy above 100 %", system(('step = "2 fs"', 'accuracy = "200 %"')), RUN,
     ["above 0 % and below 100 %", "it bounds R", "integrator.accuracy"]),
    ("an accuracy above 100 % on the command line", SMALL, ("advise", "run.toml", "--accuracy", "200 %"),
     ["--accuracy", "above 0 % and below 100 %"]),
    ("velocities from a file that has none",
     system(('box = "2.5 nm"', 'initial_configuration = "cuboid.gro"\nvelocities = "from file"'), ("count = 27", "count = 2")), RUN,
     ["cuboid.gro' has no velocities", "\"new\"", "system.velocities"]),
    ("a negative step", system(('step = "2 fs"', 'step = "-2 fs"')), RUN, ["-2 fs", "longer than 0 fs", "run.toml:11"]),
    ("a text without quotes", system(('"2 fs"\n\n', "2 fs\n\n")), RUN, ["not TOML", 'step = "2 fs"', "run.toml:11"]),
    # physics
    ("a cutoff above half the box", system(('"1.0 nm"', '"1.4 nm"')), RUN, ["1.400 nm", "1.250 nm", "forces.cutoff"]),
    ("more molecules than the box holds", system(("count = 27", "count = 40000")), RUN, ["overlap", "minimise = true", "polhode minimise", "lower density"]),
    ("a density beside a box", system(('"2.5 nm"\n', '"2.5 nm"\ndensity = "1 g/cm3"\n')), RUN, ["leave one of the two out", "system.density"]),
    # files
    ("a triclinic box", system(('box = "2.5 nm"', 'initial_configuration = "start.gro"'), ("count = 27", "count = 2")), RUN,
     ["triclinic", "orthorhombic", "gmx solvate -box", "start.gro:5"]),
    ("a LAMMPS data file under another name", system(('box = "2.5 nm"', 'initial_configuration = "w.dat"')), RUN,
     ["'w.dat'", "LAMMPS", ".data", "system.initial_configuration"]),
    ("an initial configuration that does not exist", system(('box = "2.5 nm"', 'initial_configuration = "none.gro"')), RUN,
     ["none.gro", "w512", "run.toml:3"]),
    ("a tilted box of LAMMPS", system(('box = "2.5 nm"', 'initial_configuration = "tilted.data"'), ("count = 27", "count = 2")), RUN,
     ["triclinic", "orthorhombic", "'region box block'", "tilted.data:7"]),
    ("an empty initial configuration", system(('box = "2.5 nm"', 'initial_configuration = "empty.gro"')), RUN, ["is empty", "at least one frame", "empty.gro:1"]),
    # units and molecules
    ("a quotation mark that is missing", system(('"1.0 nm"', '"1.0 nm')), RUN, ["no end on this line", "quotation mark", "run.toml:7"]),
    ("a density in another unit", system(('box = "2.5 nm"', 'density = "1000 g/cm3"')), RUN, ["1000 g/cm3", "22.6 g/cm3", "kg/m3", "system.density"]),
    ("a step longer than the run", SMALL, (*RUN, "--step", "1e30 fs"), ["the step of 1e+30 fs is longer than the length of 20 fs", "shorter step"]),
    ("a diameter without a depth", own('sigma = "0.34 nm"'), RUN, ["sigma", "no effect without epsilon", "site[0].sigma"]),
    ("a depth without a diameter", own('epsilon = "1 kJ/mol"'), RUN, ["epsilon", "no effect without sigma", "site[0].epsilon"]),
    ("an element that does not exist", own('mass = "2 u"').replace('element = "C"', 'element = "Xx"'), RUN, ['"Xx"', "not a chemical element", "site[0].element"]),
    ("two atoms at one place", own('mass = "2 u"').replace("0.152 0", "0 0"), RUN, ["'C1' and 'C2'", "the same position"]),
    ("molecules in angstrom that overlap", own('mass = "2 u"').replace("0.152 0", "1.52 0").replace("count = 27", "count = 4000"), RUN,
     ["overlap", "'C1' is 1.52 nm from", "at most 0.6 nm", "write A instead of nm"]),
    ("the order of a scheme with a bath", "", ("verify", "B(1/2) A(1/2) O(1) A(1/2) B(1/2)"), ["has a bath O", "without its stages O"]),
    ("a negative count", SMALL, ("analyze", "start.gro", "--molecules", "argon -32"), ["'argon -32'", "a model and its count"]),
    # schemes
    ("a scheme with a missing bracket", scheme("B(1/2) A(1 B(1/2)"), RUN, ["'B(1/2)'", "character 12", "')'"]),
    ("a scheme whose kicks do not sum to one", scheme("B(1/2) A(1) B(1/3)"), RUN, ["0.8333", "sum to 1"]),
    ("a scheme with an unknown name", scheme("B(x) A(1/2) B(1-2*x) A(1/2) B(x)"), RUN, ["character 3", "defined", "x = 1/6;"]),
    ("an own scheme under the name of another", scheme("hoa2: B(1/2) A(1) B(1/2)"), RUN, ["'hoa2'", "built-in", "another name"]),
    ("two schemes of the same name in a study",
     system(('["velocity-verlet"]', '["mine: B(1/2) A(1) B(1/2)", "mine: A(1/2) B(1) A(1/2)"]')),
     ("study", "run.toml"), ["two schemes with the name 'mine'"]),
]


def ensemble(*lines):
    """The small run file with tables of an ensemble at its end."""
    return SMALL + "\n" + "\n".join(lines) + "\n"


LANGEVIN = ("[thermostat]",)
RESCALING = ("[thermostat]", 'type = "rescaling"')
BAROSTAT = ("[barostat]", 'pressure = "1 bar"')
HYBRID = ("[hybrid_monte_carlo]",)

CASES += [
    # temperature and pressure
    ("a barostat without a pressure", ensemble(*LANGEVIN, "[barostat]"), RUN, ["no pressure for the barostat", 'pressure = "1 bar"', "barostat"]),
    ("a barostat without a thermostat", ensemble(*BAROSTAT), RUN, ["a barostat", "needs a thermostat", "[thermostat]", "run.toml"]),
    ("a pressure without a unit", ensemble(*LANGEVIN, "[barostat]", "pressure = 1"), RUN, ["pressure = 1", "no unit", '"1 bar"']),
    ("a time constant below the step", ensemble(*RESCALING, 'time_constant = "1 fs"'), RUN,
     ["time_constant of 1 fs", "step of 2 fs", "100 to 1000 fs", "run.toml"]),
    ("a time constant of a barostat below its interval", ensemble(*LANGEVIN, *BAROSTAT, 'time_constant = "10 fs"'), RUN,
     ["time_constant of 10 fs", "interval of its moves, 100 fs", "run.toml"]),
    ("a time constant of a Langevin thermostat", ensemble(*LANGEVIN, 'time_constant = "1 ps"'), RUN,
     ['without type = "rescaling"', "leave it out", "thermostat.time_constant"]),
    ("an unphysical compressibility", ensemble(*LANGEVIN, *BAROSTAT, 'compressibility = "1e-12 1/bar"'), RUN,
     ["1e-12 1/bar", "1e-7 1/bar", "water 4.5e-5", "barostat.compressibility"]),
    ("a thermostat of another program", ensemble("[thermostat]", 'type = "nose-hoover"'), RUN, ['type = "nose-hoover"', "langevin", "rescaling", "thermostat.type"]),
    ("hybrid Monte Carlo with a thermostat", ensemble(*LANGEVIN, *HYBRID), RUN,
     ["controls the temperature without a thermostat", "leave the thermostat out", "run.toml"]),
    ("hybrid Monte Carlo without a palindrome", ensemble(*HYBRID), (*RUN, "--scheme", "B(1) A(1)"), ["reversible", "palindrome", '"hoa2"']),
    ("stages of a bath without a thermostat", scheme("B(1/2) A(1/2) O(1) A(1/2) B(1/2)"), RUN, ["needs a thermostat", "O(...)", "run.toml"]),
    ("a scheme with a bath without a thermostat", SMALL, (*RUN, "--scheme", "baoab"), ["needs a thermostat", "[thermostat]", "O(...)"]),
    ("an export of a scheme with a thermostat", ensemble(*LANGEVIN), ("export", "lammps", "run.toml", "--scheme", "baoab"),
     ["'baoab' has a thermostat within its steps", "velocity-verlet, hoa2 or bcss3", "run.toml"]),
    ("an export of a barostat without friction", ensemble(*LANGEVIN, 'friction = "0 1/ps"', *BAROSTAT), ("export", "lammps", "run.toml"),
     ["needs a thermostat, but the friction is 0"]),
    ("0 K at constant energy", system(('"100 K"', '"0 K"')), RUN, ["above 0 K", "which then cools", "system.temperature"]),
    ("hybrid Monte Carlo at 0 K", ensemble(*HYBRID).replace('"100 K"', '"0 K"'), RUN, ["above 0 K", "only accepts moves to lower energies", "system.temperature"]),
    ("0 K of a barostat on the command line", ensemble(*LANGEVIN, *BAROSTAT), (*RUN, "--temperature", "0 K"), ["--temperature", "above 0 K", "barostat"]),
    ("a shadow energy with a thermostat", ensemble(*LANGEVIN).replace("[run]", '[run]\nshadow_sample = "100 fs"'), RUN,
     ["shadow_sample", "has no shadow energy", "leave shadow_sample out", "run.toml"]),
    ("an edge in two groups", ensemble(*LANGEVIN, *BAROSTAT, 'edges = ["xy", "yz"]'), RUN, ["edge in two groups", "barostat.edges"]),
    ("a barostat without a pressure on the command line", SMALL, (*RUN, "--barostat", "monte-carlo"),
     ["in   --barostat", "no pressure", 'pressure = "1 bar"']),
    ("a pressure without a barostat", SMALL, (*RUN, "--barostat", "none", "--pressure", "1 bar"), ["contradicts", "give only one of the two"]),
    ("a friction without a thermostat", SMALL, (*RUN, "--friction", "1 1/ps"), ["--friction", "has no thermostat", "thermostat langevin"]),
    ("a friction of a rescaling thermostat", SMALL, (*RUN, "--thermostat", "rescaling", "--friction", "1 1/ps"),
     ["in   --friction", 'has no meaning without type = "langevin"', "leave it out"]),
    ("a friction in ps", SMALL, (*RUN, "--thermostat", "langevin", "--friction", "1 ps"), ["--friction", "1 ps", "is a time"]),
    ("a thermostat with a typing error", SMALL, (*RUN, "--thermostat", "langvin"), ["--thermostat", "did you mean 'langevin'"]),
    ("half a step of hybrid Monte Carlo", SMALL, (*RUN, "--hybrid-steps", "2.5"), ["--hybrid-steps", "2.5", "whole number"]),
]


class WrongInputs(Sandbox):
    def prepare(self, text):
        self.write("start.gro", BOX)
        self.write("cuboid.gro", BOX.replace(" 0 0 0.5 0 0 0", ""))
        self.write("tilted.data", TILTED)
        for name in ("w.dat", "w.data"):
            self.write(name, "LAMMPS data file\n\n2 atoms\n")
        self.write("empty.gro", "")
        run, _, own_molecule = text.partition("### own.toml\n")
        self.write("own.toml", own_molecule)
        self.write("run.toml", run)

    def test_messages(self):
        for title, text, command, words in CASES:
            self.prepare(text)
            self.refused(command, words, title)

    def test_form(self):
        """One line, a place where there is a file, no capital and no full stop, and no word that does not help."""
        for title, text, command, _ in CASES:
            self.prepare(text)
            message = self.polhode(*command).err
            with self.subTest(case=title, message=message):
                first, *rest = message.splitlines()
                self.assertTrue(first.startswith("error: "), first)
                self.assertFalse(first.endswith("."), first)
                self.assertTrue(len(rest) == 0 or rest[0].startswith("  in   "), rest)
                names = first.partition("there are: ")[2].split(", ")
                self.assertEqual(len(names), len(set(names)), "a name is listed twice")
                for word in ("invalid", "illegal", "failed", "please", "00000000"):
                    self.assertNotIn(word, message.lower())

    def test_listing(self):
        """Writes all commands with their messages where --write says."""
        for title, text, command, _ in CASES if WRITE else []:
            self.prepare(text)
            WRITE.write(f"{title}:\n$ polhode {' '.join(command)}\n{self.polhode(*command).err}\n")


if __name__ == "__main__":
    if "--write" in sys.argv:
        at = sys.argv.index("--write")
        WRITE = open(sys.argv[at + 1], "w", encoding="utf-8")
        del sys.argv[at:at + 2]
    sandbox.main()
