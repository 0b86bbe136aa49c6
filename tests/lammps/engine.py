# SPDX-License-Identifier: MIT
"""LAMMPS with the plugin: its environment, the build of the plugin, and runs of input scripts on some ranks."""

import argparse
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
LONGEST = 300  # seconds for one run of a program
SKIPPED = 77


class Engine:
    """Paths of the programs, from the command line of a test."""

    def __init__(self, program, build):
        self.program, self.build = program.resolve(), build.resolve()
        self.folder = self.build / "lammps-environment"

    def prepare(self):
        """Makes the environment and builds the plugin; ends the test as skipped if LAMMPS cannot be installed."""
        made = subprocess.run([sys.executable, ROOT / "lammps/environment.py", self.folder], text=True,
                              capture_output=True)
        if made.returncode == SKIPPED:
            print(f"skipped: {made.stderr.strip()}")
            sys.exit(SKIPPED)
        made.check_returncode()
        self.headers, self.mpi_headers, self.lmp, self.mpiexec = map(Path, made.stdout.split("\n")[:4])
        build = self.build / "lammps-plugin"
        options = {"CMAKE_BUILD_TYPE": "Release", "POLHODE_LIBRARY": "OFF", "POLHODE_EXAMPLES": "OFF",
                   "POLHODE_LAMMPS": "ON", "POLHODE_DEVELOPER": "ON", "POLHODE_INSTRUCTION_SETS": self.instruction_sets(),
                   "POLHODE_LAMMPS_LIBRARY": self.build / "libpolhode-core.a",
                   "POLHODE_LAMMPS_HEADERS": self.headers, "POLHODE_MPI_HEADERS": self.mpi_headers}
        for command in (["cmake", "-G", "Ninja", "-S", ROOT, "-B", build,
                         *(f"-D{name}={value}" for name, value in options.items())],
                        ["cmake", "--build", build, "--target", "polhodeplugin"]):
            done = subprocess.run(command, text=True, capture_output=True)
            if done.returncode != 0:
                sys.exit(done.stdout + done.stderr)
        self.plugin = build / "lammps/polhodeplugin.so"

    def instruction_sets(self):
        """Those of the library, which the plugin is linked with."""
        cache = (self.build / "CMakeCache.txt").read_text()
        return next(line.partition("=")[2] for line in cache.splitlines() if line.startswith("POLHODE_INSTRUCTION_SETS:"))

    def environment(self):
        return {**os.environ, "LD_LIBRARY_PATH": str(self.folder / "lib"), "OMP_NUM_THREADS": "1"}

    def run(self, folder, script, ranks=1, options=()):
        """The finished process of LAMMPS with a script."""
        command = [self.lmp, "-in", script, "-log", "none", "-var", "plugin", self.plugin, *options]
        if ranks > 1:
            command = [self.mpiexec, "-n", str(ranks), *command]
        return subprocess.run(command, cwd=folder, text=True, capture_output=True, timeout=LONGEST,
                              env=self.environment())


ENGINE = None


class LammpsTest(unittest.TestCase):
    """A test with its own folder."""

    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)

    def write(self, name, text):
        (self.folder / name).write_text(text, encoding="utf-8")

    def polhode(self, *arguments):
        done = subprocess.run([ENGINE.program, *arguments], cwd=self.folder, text=True, capture_output=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def lammps(self, text, ranks=1):
        """The thermodynamic output of a script: for each run, lists of numbers by their names."""
        self.write("test.in", text)
        done = ENGINE.run(self.folder, "test.in", ranks)
        self.assertEqual(done.returncode, 0, done.stdout[-3000:] + done.stderr[-2000:])
        return tables(done.stdout)

    def refused(self, text, words, ranks=1):
        """The script must end with an error that has these words."""
        self.write("test.in", text)
        done = ENGINE.run(self.folder, "test.in", ranks)
        message = " ".join(line for line in done.stdout.splitlines() if "ERROR" in line)
        self.assertNotEqual(done.returncode, 0)
        for word in words:
            self.assertIn(word, message, done.stdout[-2000:])

    def compare_ranks(self, script, names, **more):
        """The columns of a script that ends with `run 60` do not depend on how space is divided; `more` has further variants. Its
        lattice of molecules is moved, so that faces between domains, and of the box, are in the middle of some."""
        moved = "displace_atoms all move {0} {0} {0} units box\nfix rigid all".format(0.15 if "\nunits lj" in script else 1.5)

        def cut(text):
            return text.replace("fix rigid all", moved, 1)

        variants = {
            "2 ranks": (2, script),
            "4 ranks": (4, script),
            "divided along x": (2, script.replace("\natom_style", "\nprocessors 2 1 1\natom_style")),
            "newton off": (2, script.replace("\natom_style", "\nnewton off\natom_style")),
            "balanced": (2, script.replace("run 60", "balance 1.0 shift xyz 10 1.05\nrun 60")),
            "tiled": (4, script.replace("run 60", "comm_style tiled\nbalance 1.0 rcb\nrun 60")),
            **more,
        }
        one = self.lammps(cut(script))[0]
        for title, (ranks, text) in variants.items():
            if title != "2 ranks" and title != "4 ranks":
                self.assertNotEqual(text, script, title)
            other = self.lammps(cut(text), ranks)[0]
            for name in names:
                # Sums in another order, grown over 60 force evaluations.
                self.assert_close(one[name], other[name], 1e-11, f"{title}: {name}")

    def assert_close(self, a, b, relative, what=""):
        self.assertEqual(len(a), len(b), what)
        for x, y in zip(a, b):
            self.assertLessEqual(abs(x - y), relative * max(abs(x), abs(y)), f"{what}: {x} {y}")


def tables(output):
    found, names = [], None
    for line in output.splitlines():
        words = line.split()
        if words[:1] == ["Step"]:
            names = words
            found.append({name: [] for name in names})
        elif words[:2] == ["Loop", "time"]:
            names = None
        elif names and len(words) == len(names):
            try:
                numbers = [float(word) for word in words]
            except ValueError:
                continue
            for name, number in zip(names, numbers):
                found[-1][name].append(number)
    return found


def main(description):
    """Runs the tests of the script that calls it."""
    global ENGINE
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--program", type=Path, required=True)
    parser.add_argument("--build", type=Path, required=True)
    options, rest = parser.parse_known_args()
    ENGINE = Engine(options.program, options.build)
    ENGINE.prepare()
    unittest.main(argv=[sys.argv[0], *rest])
