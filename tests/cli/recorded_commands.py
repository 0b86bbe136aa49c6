# SPDX-License-Identifier: MIT
"""Result files have the command that wrote them: every option that has an effect on them, quoted for a shell."""

import shlex

import sandbox
from sandbox import SMALL, Sandbox, edited

RUN = edited(SMALL, ('prefix = "out"', 'prefix = "out"\ntrajectory_every = "4 fs"\nformats = ["gro"]'), ('box = "2.5 nm"', 'box = "2 nm"'),
             ('"1.0 nm"', '"0.9 nm"'), ("[run]\n", '[run]\nequilibrate = "0.2 ps"\n'))
WITHOUT_EFFECT = ("--json", "--force", "--threads", "1", "--threads=1")
# (verb, options, a file that it writes)
COMMANDS = (
    ("run", ("--scheme", "B(1/2) A(1) B(1/2)", "--step", "1 fs", "--length", "0.02 ps", "--thermostat", "langevin", "--friction", "2 1/ps", "--seed",
             "4", "--output", "it's", "--threads=1", "--json", "--force"), "it's-energies.csv"),
    ("analyze", ("--run", "run.toml", "--what", "rdf, msd", "--window", "0.01 ps", "--cutoff", "0.8 nm", "--bin", "0.01 nm", "--start", "0.004 ps",
                 "--plot", "none", "--output", "$a", "--threads", "1", "--force"), "$a-rdf.csv"),
    ("advise", ("--accuracy", "50 %", "--schemes", "hoa2", "velocity-verlet", "--length", "50 ps", "--time", "2", "--precision", "double",
                "--output", "ad vice", "--threads", "1", "--json"), "ad vice.csv"),
    ("study", ("--schemes", "hoa2", "--steps", "1 fs", "2 fs", "--runs", "2", "--length", "0.1 ps", "--decorrelate", "0.02 ps", "--temperature", "90 K",
               "--seed", "2", "--output", "nve", "--threads", "1", "--force"), "nve.csv"),
    ("study", ("--ensemble", "nvt", "--schemes", "hoa2", "--steps", "1 fs", "2 fs", "--runs", "2", "--length", "0.4 ps", "--decorrelate", "0.02 ps",
               "--precision", "mixed", "--output", "nvt", "--threads", "1"), "nvt.csv"),
    ("top", ("--J", "1, 2, 2.5", "--L", "0.3,1.5,0.9", "--step", "0.1", "--output", "nut", "--force"), "nut.dat"),
)


class RecordedCommands(Sandbox):
    def command_in(self, name):
        lines = (self.folder / name).read_text(encoding="utf-8").splitlines()
        [command] = [line.removeprefix("# command: ") for line in lines if line.startswith("# command: ")]
        return shlex.split(command)

    def test_all_that_was_given(self):
        self.done("run", RUN)
        for verb, options, name in COMMANDS:
            with self.subTest(verb=verb, file=name):
                file = {"analyze": ["out-trajectory.gro"], "top": []}.get(verb, ["run.toml"])
                process = self.polhode(verb, *file, *options)
                self.assertEqual(process.returncode, 0, process.err)
                expected = ["polhode", verb, *file, *(word for word in options if word not in WITHOUT_EFFECT)]
                self.assertEqual(self.command_in(name), expected)

    def test_a_resumed_run_has_the_first_command(self):
        self.done("run", RUN, "--threads", "1")
        before = self.contents()["out-energies.csv"]
        self.assertEqual(self.polhode("run", "run.toml", "--resume", "--threads", "2").returncode, 0)
        self.assertEqual(self.contents()["out-energies.csv"], before)

    def test_old_names_of_options(self):
        """--continue, --from, --to, --time-constant and --nvt are what --resume, --start, --stop, --thermostat-time-constant and --ensemble nvt are."""
        self.done("run", RUN, "--thermostat", "rescaling", "--time-constant", "0.3 ps")
        old = self.contents()["out-energies.csv"]
        self.done("run", RUN, "--thermostat", "rescaling", "--thermostat-time-constant", "0.3 ps", "--force")
        self.assertEqual(self.contents()["out-energies.csv"].splitlines()[6:], old.splitlines()[6:])
        self.assertEqual(self.polhode("run", "run.toml", "--thermostat", "rescaling", "--time-constant", "0.3 ps", "--continue").returncode, 0)
        for name, options in (("old.gro", ("--from", "4 fs", "--to", "12 fs")), ("new.gro", ("--start", "4 fs", "--stop", "12 fs"))):
            self.assertEqual(self.polhode("convert", "out-trajectory.gro", name, *options).returncode, 0)
        self.assertEqual(self.contents()["old.gro"], self.contents()["new.gro"])
        for name, options in (("old.toml", ("--nvt",)), ("new.toml", ("--ensemble", "nvt"))):
            self.assertEqual(self.polhode("new", "water", name, *options).returncode, 0)
        self.assertEqual(self.contents()["old.toml"].replace(b"old.toml", b"new.toml"), self.contents()["new.toml"])


if __name__ == "__main__":
    sandbox.main()
