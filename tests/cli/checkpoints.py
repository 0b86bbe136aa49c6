# SPDX-License-Identifier: MIT
"""A run that was killed, stopped or left without room goes on as if nothing had happened; damaged checkpoints are refused."""

import json
import os
import random
import resource
import signal
import subprocess
import time

import sandbox
from sandbox import SMALL, Sandbox, edited

# Some hundred steps of 64 waters in about a second, with equilibration, and a checkpoint every few steps.
WATER = edited(SMALL, ('"argon", count = 27', '"tip4p", count = 64'), ('"100 K"', '"297 K"'),
               ("[run]\n", '[run]\nequilibrate = "0.1 ps"\nsample = "6 fs"\n'), ('length = "0.02 ps"\n', 'length = "0.602 ps"\n'),
               ('"hoa2"', '"gier4"'),
               ('prefix = "out"', 'prefix = "out"\ntrajectory_every = "20 fs"\ncheckpoint_every = "0.01 s"'))
GROWING = ("energies.csv", "trajectory.xyz", "trajectory.gro")
TIMES = ("seconds", "ns_per_day", "threads")  # of the summary: not the same twice


class Checkpoints(Sandbox):
    def setUp(self):
        super().setUp()
        self.write("run.toml", WATER)

    def summary(self, *options):
        process = self.polhode("run", "run.toml", "--json", *options)
        self.assertEqual(process.returncode, 0, process.err)
        return {k: v for k, v in json.loads(process.out).items() if k not in TIMES}

    def outputs(self):
        """What a run leaves behind, without its checkpoints, which hold times."""
        return {n: b for n, b in self.contents().items() if n.startswith("out") and "checkpoint" not in n}

    def whole(self):
        """Summary and files of a run that nothing happens to; the folder is empty again afterwards."""
        summary = self.summary()
        files = self.outputs()
        self.assertEqual(len(files), 4)
        self.clear()
        return summary, files

    def clear(self):
        for path in self.folder.glob("out*"):
            path.unlink()

    def refused(self, *words, options=("--continue",), **environment):
        super().refused(("run", "run.toml", *options), words, **environment)

    def killed(self, signal_number, ready):
        """A run that gets a signal as soon as `ready()` holds."""
        process = self.start("run", "run.toml")
        end = time.monotonic() + sandbox.LONGEST
        while process.poll() is None and time.monotonic() < end and not ready():
            time.sleep(0.002)
        process.send_signal(signal_number)
        process.communicate(timeout=sandbox.LONGEST)
        return process.returncode

    def interrupt(self, signal_number=signal.SIGTERM):
        """A run that is stopped when it has written some energies."""
        path = self.folder / "out-energies.csv"
        code = self.killed(signal_number, lambda: path.exists() and path.read_bytes().count(b"\n") > 15)
        self.assertEqual(code, 130)

    def test_kill_at_random_moments(self):
        start = time.monotonic()
        summary, files = self.whole()
        took = time.monotonic() - start
        for _ in range(8):
            threads = str(random.randint(1, len(os.sched_getaffinity(0))))
            self.kill_at_random_moments(1, took / 3, "run", "run.toml", "--continue", "--threads", threads)
        self.assertEqual(self.summary("--continue"), summary)
        self.assertEqual(self.outputs(), files)
        self.assertEqual(list(self.folder.glob("*.part")), [])
        # What is done already is told again.
        self.assertEqual(self.summary("--continue"), summary)
        self.assertEqual(self.outputs(), files)

    def test_signals(self):
        summary, files = self.whole()
        for signal_number in (signal.SIGTERM, signal.SIGINT):
            self.interrupt(signal_number)
            for name in GROWING:
                left, whole = (self.folder / f"out-{name}").read_bytes(), files[f"out-{name}"]
                self.assertLess(len(left), len(whole))
            self.assertEqual(self.summary("--continue"), summary)
            self.assertEqual(self.outputs(), files)
            self.clear()

    def test_longer(self):
        summary, files = self.whole()
        self.summary("--length", "0.31 ps")
        self.refused("0.2 ps", "0.31 ps", options=("--continue", "--length", "0.2 ps"))
        self.assertEqual(self.summary("--continue"), summary)
        extended = self.outputs()
        self.assertEqual(extended["out-energies.csv"].replace(b' --length "0.31 ps"', b""), files["out-energies.csv"])
        del extended["out-energies.csv"], files["out-energies.csv"]
        self.assertEqual(extended, files)

    def test_no_room(self):
        summary, files = self.whole()
        most = len(files["out-trajectory.gro"]) // 2

        def limited():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (most, most))
        process = subprocess.run([sandbox.PROGRAM, "run", "run.toml"], cwd=self.folder, text=True, capture_output=True,
                                 timeout=sandbox.LONGEST, preexec_fn=limited, restore_signals=False)
        self.assertEqual(process.returncode, 1, process.stderr)
        for word in ("out-trajectory.gro", "disk full", "out-checkpoint.bin", "--continue"):
            self.assertIn(word, process.stderr)
        self.assertEqual(self.summary("--continue"), summary)
        self.assertEqual(self.outputs(), files)

    def test_damage(self):
        summary, files = self.whole()
        self.interrupt()
        newest, previous = (self.folder / f"out-checkpoint{k}.bin" for k in ("", "-previous"))
        bytes_of = {path: path.read_bytes() for path in (newest, previous)}
        state = {path: path.read_bytes() for path in self.folder.glob("out*")}

        def flipped(path):
            at = random.randrange(24, len(bytes_of[path]))  # before it stands which format it is
            damaged = bytearray(bytes_of[path])
            damaged[at] ^= 1 << random.randrange(8)
            path.write_bytes(damaged)

        def restored():
            self.clear()
            for path, data in state.items():
                path.write_bytes(data)

        # One is damaged: the one before it serves.
        for damage in (lambda: newest.write_bytes(bytes_of[newest][:-1]), newest.unlink, lambda: flipped(newest)):
            restored()
            damage()
            process = self.polhode("run", "run.toml", "--continue")
            self.assertEqual(process.returncode, 0, process.err)
            for word in ("note: ", "'out-checkpoint.bin'", "'out-checkpoint-previous.bin'", "intact"):
                self.assertIn(word, process.err)
            self.assertEqual(self.outputs(), files)
        # Both are.
        restored()
        flipped(previous)
        newest.write_bytes(b"")
        self.refused("out-checkpoint.bin", "out-checkpoint-previous.bin")

        # Outputs that are missing, shorter, or of someone else.
        for name in GROWING:
            path = self.folder / f"out-{name}"
            for spoil, words in ((path.unlink, ["cannot be gone on with"]),
                                 (lambda: path.write_bytes(path.read_bytes()[:100]), ["100 bytes"])):
                restored()
                spoil()
                self.refused(f"'out-{name}'", *words, "--force")
        restored()
        (self.folder / "out-energies.csv").write_bytes(b"0" * 10 + state[self.folder / "out-energies.csv"][10:])
        self.refused("out-energies.csv")

        # Checkpoints of others.
        restored()
        self.write("run.toml", edited(WATER, ('"297 K"', '"298 K"')))
        self.refused("another run", "polhode run run.toml", "--output", "--force")
        self.write("run.toml", WATER)
        self.refused("another run", options=("--continue", "--step", "1 fs"))
        self.refused("another run", options=("--continue", "--precision", "mixed"))
        if summary["target"] != "scalar":
            self.refused("scalar", "POLHODE_TARGET", POLHODE_TARGET="scalar")
        # Without --continue nothing is overwritten, and --force begins anew.
        self.refused("out-checkpoint.bin", "--continue", "--force", options=())
        self.assertEqual(self.summary("--force"), summary)
        self.assertEqual(self.outputs(), files)

    def test_nothing_to_go_on_from(self):
        summary, files = self.whole()
        self.assertEqual(self.summary("--continue"), summary)
        self.assertEqual(self.outputs(), files)
        for path in self.folder.glob("out-checkpoint*"):
            path.unlink()
        self.refused("out-")
        self.refused("--force", "--continue", options=("--continue", "--force"))

    def test_equilibration(self):
        self.write("run.toml", edited(WATER, ('"0.1 ps"', '"1 ps"'), ('"0.602 ps"', '"0.05 ps"')))
        summary, files = self.whole()
        checkpoint = self.folder / "out-checkpoint.bin"
        for signal_number, code in ((signal.SIGINT, 130), (signal.SIGKILL, -signal.SIGKILL)):
            self.assertEqual(self.killed(signal_number, checkpoint.exists), code)
            self.assertEqual(self.outputs(), {})
            self.assertEqual(self.summary("--continue"), summary)
            self.assertEqual(self.outputs(), files)
            self.clear()


if __name__ == "__main__":
    random.seed()
    Sandbox.maxDiff = None
    sandbox.main()
