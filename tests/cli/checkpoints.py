# SPDX-License-Identifier: MIT
"""A run that was killed, interrupted or out of disk space is resumed with identical results; damaged checkpoints are refused."""

import json
import os
import random
import resource
import signal
import time

import sandbox
from sandbox import SMALL, Sandbox, edited

# A few hundred steps of 64 waters in about a second, with equilibration, and a checkpoint every few steps.
WATER = edited(SMALL, ('"argon", count = 27', '"tip4p", count = 64'), ('"100 K"', '"297 K"'),
               ("[run]\n", '[run]\nequilibrate = "0.1 ps"\nsample = "6 fs"\n'), ('length = "0.02 ps"\n', 'length = "0.602 ps"\n'),
               ('"hoa2"', '"gier4"'),
               ('prefix = "out"', 'prefix = "out"\ntrajectory_every = "20 fs"\ncheckpoint_every = "0.01 s"'))
GROWING = ("energies.csv", "trajectory.xyz", "trajectory.gro")
# At constant temperature and pressure: moves of the box every 10 steps, which are neither samples nor frames.
BAROSTAT = '[barostat]\ntype = "{}"\npressure = "200 bar"\ncompressibility = "2e-5 1/bar"\nevery = "20 fs"\n'
ENSEMBLES = {
    "Langevin, cell rescaling": "[thermostat]\n" + BAROSTAT.format("cell-rescaling"),
    "rescaling, Monte Carlo moves": '[thermostat]\ntype = "rescaling"\n' + BAROSTAT.format("monte-carlo"),
    "hybrid Monte Carlo, cell rescaling": "[hybrid_monte_carlo]\nsteps = 3\n" + BAROSTAT.format("cell-rescaling"),
    "hybrid Monte Carlo, Monte Carlo moves": "[hybrid_monte_carlo]\nsteps = 3\n" + BAROSTAT.format("monte-carlo"),
}
TIMES = ("seconds", "ns_per_day", "threads")  # of the summary: differ between runs


class Checkpoints(Sandbox):
    def setUp(self):
        super().setUp()
        self.write("run.toml", WATER)

    def summary(self, *options):
        process = self.polhode("run", "run.toml", "--json", *options)
        self.assertEqual(process.returncode, 0, process.err)
        return {k: v for k, v in json.loads(process.out).items() if k not in TIMES}

    def outputs(self):
        """The files of a run, without its checkpoints, which contain times."""
        return {n: b for n, b in self.contents().items() if n.startswith("out") and "checkpoint" not in n and not n.endswith(".lock")}

    def whole(self):
        """Summary and files of an uninterrupted run; the folder is empty again afterwards."""
        summary = self.summary()
        files = self.outputs()
        self.assertEqual(len(files), 4)
        self.clear()
        return summary, files

    def clear(self):
        for path in self.folder.glob("out*"):
            path.unlink()

    def refused(self, *words, options=("--resume",), **environment):
        super().refused(("run", "run.toml", *options), words, **environment)

    def killed(self, signal_number, ready):
        """A run that gets a signal as soon as `ready()` is true."""
        process = self.start("run", "run.toml")
        end = time.monotonic() + sandbox.LONGEST
        while process.poll() is None and time.monotonic() < end and not ready():
            time.sleep(0.002)
        process.send_signal(signal_number)
        process.communicate(timeout=sandbox.LONGEST)
        return process.returncode

    def interrupt(self, signal_number=signal.SIGTERM):
        """A run that is stopped after it has written a few energies."""
        path = self.folder / "out-energies.csv"
        code = self.killed(signal_number, lambda: path.exists() and path.read_bytes().count(b"\n") > 15)
        self.assertEqual(code, 130)

    def test_kill_at_random_moments(self):
        start = time.monotonic()
        summary, files = self.whole()
        took = time.monotonic() - start
        for _ in range(sandbox.KILLS):
            threads = str(random.randint(1, len(os.sched_getaffinity(0))))
            self.kill_at_random_moments(1, took / 3, "run", "run.toml", "--resume", "--threads", threads)
        self.assertEqual(self.summary("--resume"), summary)
        self.assertEqual(self.outputs(), files)
        self.assertEqual([n for n in self.contents() if "unfinished" in n], [])
        # A finished run reports its results again.
        self.assertEqual(self.summary("--resume"), summary)
        self.assertEqual(self.outputs(), files)

    def test_constant_pressure(self):
        """Interrupted by a signal and killed while it resumes, a run at constant pressure has the bits of an uninterrupted one."""
        for name, tables in ENSEMBLES.items():
            with self.subTest(ensemble=name):
                self.write("run.toml", WATER + tables)
                start = time.monotonic()
                summary, files = self.whole()
                took = time.monotonic() - start
                moves = summary["ensemble"]["barostat"]
                steps = 9 if "hybrid" in name else 10  # whole trajectories of 3
                self.assertEqual((moves["moves"], round(moves["interval_fs"], 9)), (300 // steps, 2 * steps))
                self.assertTrue(0 < moves["accepted"] <= moves["moves"])
                for threads in ("1", "2"):
                    self.interrupt()
                    self.kill_at_random_moments(1, took / 3, "run", "run.toml", "--resume", "--threads", threads)
                    self.assertEqual(self.summary("--resume"), summary)
                    self.assertEqual(self.outputs(), files)
                    self.clear()

    def test_signals(self):
        summary, files = self.whole()
        signal.signal(signal.SIGHUP, signal.SIG_DFL)  # the caller of the tests may ignore it, which processes inherit
        for signal_number in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP, signal.SIGXCPU):
            self.interrupt(signal_number)
            for name in GROWING:
                left, whole = (self.folder / f"out-{name}").read_bytes(), files[f"out-{name}"]
                self.assertLess(len(left), len(whole))
            self.assertEqual(self.summary("--resume"), summary)
            self.assertEqual(self.outputs(), files)
            self.clear()

    def test_longer(self):
        summary, files = self.whole()
        self.summary("--length", "0.31 ps")
        self.refused("0.2 ps", "0.31 ps", options=("--resume", "--length", "0.2 ps"))
        self.assertEqual(self.summary("--resume"), summary)
        extended = self.outputs()
        self.assertEqual(extended["out-energies.csv"].replace(b' --length "0.31 ps"', b""), files["out-energies.csv"])
        del extended["out-energies.csv"], files["out-energies.csv"]
        self.assertEqual(extended, files)

    def test_no_room(self):
        summary, files = self.whole()
        max_bytes = len(files["out-trajectory.gro"]) // 2

        process = self.limited(resource.RLIMIT_FSIZE, max_bytes, "run", "run.toml")
        self.assertEqual(process.returncode, 1, process.err)
        for word in ("out-trajectory.gro", "disk full", "out-checkpoint.bin", "--resume"):
            self.assertIn(word, process.err)
        self.assertEqual(self.summary("--resume"), summary)
        self.assertEqual(self.outputs(), files)

    def test_no_time(self):
        self.write("run.toml", edited(WATER, ('"0.602 ps"', '"1000 ps"')))
        process = self.limited(resource.RLIMIT_CPU, 1, "run", "run.toml")
        self.assertEqual(process.returncode, 130, process.err)
        self.assertIn("--resume", process.err)

    def test_damage(self):
        summary, files = self.whole()
        self.interrupt()
        newest, previous = (self.folder / f"out-checkpoint{k}.bin" for k in ("", "-previous"))
        bytes_of = {path: path.read_bytes() for path in (newest, previous)}
        state = {path: path.read_bytes() for path in self.folder.glob("out*")}

        def flipped(path):
            at = random.randrange(len(bytes_of[path]))
            damaged = bytearray(bytes_of[path])
            damaged[at] ^= 1 << random.randrange(8)
            path.write_bytes(damaged)

        def restored():
            self.clear()
            for path, data in state.items():
                path.write_bytes(data)

        # One is damaged: the previous one is used.
        def with_another_version():
            newest.write_bytes(bytes_of[newest][:16] + b"\xff" + bytes_of[newest][17:])
        flips = [lambda: flipped(newest)] * sandbox.FLIPS
        for damage in (lambda: newest.write_bytes(bytes_of[newest][:-1]), newest.unlink, with_another_version, *flips):
            restored()
            damage()
            process = self.polhode("run", "run.toml", "--resume")
            self.assertEqual(process.returncode, 0, process.err)
            for word in ("note: ", "'out-checkpoint.bin'", "'out-checkpoint-previous.bin'", "intact"):
                self.assertIn(word, process.err)
            self.assertEqual(self.outputs(), files)
        # Both are damaged.
        restored()
        flipped(previous)
        newest.write_bytes(b"")
        self.refused("out-checkpoint.bin", "out-checkpoint-previous.bin")

        # Outputs that are missing, shorter, or from another run.
        for name in GROWING:
            path = self.folder / f"out-{name}"
            for spoil, words in ((path.unlink, ["cannot be opened for appending"]),
                                 (lambda: path.write_bytes(path.read_bytes()[:100]), ["100 bytes"])):
                restored()
                spoil()
                self.refused(f"'out-{name}'", *words, "--force")
        restored()
        (self.folder / "out-energies.csv").write_bytes(b"0" * 10 + state[self.folder / "out-energies.csv"][10:])
        self.refused("out-energies.csv")

        # Checkpoints of other runs.
        restored()
        self.write("run.toml", edited(WATER, ('"297 K"', '"298 K"')))
        self.refused("another run", "polhode run run.toml", "temperature was 297 K and is now 298 K", "another output", "--force")
        self.write("run.toml", WATER)
        self.refused("another run", "integrator.step was 2 fs and is now 1 fs;", options=("--resume", "--step", "1 fs"))
        self.refused("another run", "forces.precision was double and is now mixed", options=("--resume", "--precision", "mixed"))
        if summary["instruction_set"] != "scalar":
            self.refused("scalar", "POLHODE_INSTRUCTION_SET", POLHODE_INSTRUCTION_SET="scalar")
        # Without --resume nothing is overwritten, and --force starts over.
        self.refused("out-checkpoint.bin", "--resume", "--force", options=())
        self.assertEqual(self.summary("--force"), summary)
        self.assertEqual(self.outputs(), files)

    def test_another_initial_configuration(self):
        self.summary("--output", "start")
        start = (self.folder / "start-final.gro").read_text()
        water = edited(WATER, ('box = "2.5 nm"', 'initial_configuration = "start-final.gro"'), ('equilibrate = "0.1 ps"\n', ""))
        self.write("run.toml", water)
        self.interrupt()
        def edit(change):
            """The initial configuration with its atoms changed: a list of [names, position, velocity], numbers as text."""
            lines = start.splitlines()
            atoms = [[line[:20], *(line[at:at + 15] for at in range(20, 110, 15))] for line in lines[2:-1]]
            change(atoms)
            return "\n".join([*lines[:2], *map("".join, atoms), lines[-1], ""])
        self.assertEqual(edit(lambda atoms: None), start)

        def swap_hydrogens(atoms):
            atoms[1][1:4], atoms[2][1:4] = atoms[2][1:4], atoms[1][1:4]

        def add_velocity(atoms):
            for atom in atoms[:4]:
                atom[4] = f"{float(atom[4]) + 0.0001:15.11f}"

        def stop(atoms):
            for atom in atoms:
                del atom[4:]
        turned, moved, still = map(edit, (swap_hydrogens, add_velocity, stop))
        for text in (turned, moved, still):
            self.assertNotEqual(text, start)
            self.write("start-final.gro", text)
            self.refused("another run", "velocities")
        self.write("start-final.gro", start)
        for key in ("massless_sites", "velocities"):
            self.write("run.toml", edited(water, ('prefix = "out"', f'prefix = "out"\n{key} = false')))
            self.refused("another run", f"output.{key} was true and is now false")
        self.write("run.toml", water)
        self.summary("--resume")

    def test_outputs_of_another_run(self):
        formats = ("xyz", "gro", "pdb", "xtc", "trr", "dcd", "h5md")
        water = edited(WATER, ('prefix = "out"', f'prefix = "out"\nformats = {json.dumps(formats)}'))
        self.write("run.toml", edited(water, ("[system]\n", "[system]\nseed = 2\n")))
        self.summary()
        names = ["out-energies.csv", *(f"out-trajectory.{f}" for f in formats)]
        others = {name: (self.folder / name).read_bytes() for name in names}
        self.clear()
        self.write("run.toml", water)
        self.interrupt()
        for name in names:
            path = self.folder / name
            mine = path.read_bytes()
            path.write_bytes(others[name] if name.endswith("h5md") else others[name][:len(mine)])
            self.refused(f"'{name}'", "was changed: its checksum differs", "--force")
            if not name.endswith("h5md"):
                # One bit before the checkpoint; the first 92 bytes of a DCD file change with each frame.
                at = random.randrange(92, len(mine) // 2)
                path.write_bytes(mine[:at] + bytes([mine[at] ^ 1 << random.randrange(8)]) + mine[at + 1:])
                self.refused(f"'{name}'", "was changed: its checksum differs", "--force")
            path.write_bytes(mine)
        self.summary("--resume")

    def test_nothing_to_resume_from(self):
        summary, files = self.whole()
        self.assertEqual(self.summary("--resume"), summary)
        self.assertEqual(self.outputs(), files)
        for path in self.folder.glob("out-checkpoint*"):
            path.unlink()
        self.refused("out-")
        self.refused("--force", "--resume", options=("--resume", "--force"))

    def test_equilibration(self):
        self.write("run.toml", edited(WATER, ('"0.1 ps"', '"20 ps"'), ('"0.602 ps"', '"0.05 ps"')))
        summary, files = self.whole()
        checkpoint = self.folder / "out-checkpoint.bin"
        for signal_number, code in ((signal.SIGINT, 130), (signal.SIGKILL, -signal.SIGKILL)):
            self.assertEqual(self.killed(signal_number, checkpoint.exists), code)
            self.assertEqual(self.outputs(), {})
            self.assertEqual(self.summary("--resume"), summary)
            self.assertEqual(self.outputs(), files)
            self.clear()


if __name__ == "__main__":
    random.seed()
    Sandbox.maxDiff = None
    sandbox.main()
