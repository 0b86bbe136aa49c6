# SPDX-License-Identifier: MIT
"""Two processes with one run or study: the second is refused with the owner of the lock; no file is damaged."""

import os
import re
import signal
import socket
import time

import sandbox
from sandbox import SMALL, Sandbox, edited

# A few hundred steps with samples, frames and checkpoints.
RUN = edited(SMALL, ('length = "0.02 ps"\n', 'length = "1 ps"\nsample = "2 fs"\n'),
             ('prefix = "out"', 'prefix = "out"\ntrajectory_every = "4 fs"\ncheckpoint_every = "0.01 s"'))
LONG = edited(RUN, ('"1 ps"', '"1000 ps"'))
STUDY = edited(SMALL, ('["2 fs"]', '["2 fs", "4 fs"]'), ("runs = 2", "runs = 12"))
HELD = re.compile(r"error: '(\S+)' is locked by process (\d+) on host (\S+) since \d{4}-\d\d-\d\d \d\d:\d\d:\d\d UTC: ")


class Locks(Sandbox):
    tries = 20

    def outputs(self):
        return {n: b for n, b in self.contents().items() if n.startswith("out") and "checkpoint" not in n}

    def clear(self):
        for path in self.folder.glob("out*"):
            path.unlink()

    def two_at_once(self, *arguments):
        """Exit codes of two processes of the same command; the refused one names the other."""
        pair = [self.start(*arguments) for _ in range(2)]
        for process in pair:
            process.out, process.err = process.communicate(timeout=sandbox.LONGEST)
        for process, other in (pair, pair[::-1]):
            if process.returncode == 0:
                continue
            self.assertEqual(process.returncode, 2, process.err)
            self.assertIn("overwrite each other's files", process.err)
            held = HELD.search(process.err)
            # Immediately after locking, the owner has not written its name yet.
            if held:
                self.assertEqual((int(held[2]), held[3]), (other.pid, socket.gethostname()))
            else:
                self.assertIn("is locked by another process", process.err)
        return sorted(process.returncode for process in pair)

    def test_runs_at_once(self):
        self.write("run.toml", RUN)
        self.assertEqual(self.polhode("run", "run.toml").returncode, 0)
        whole = self.outputs()
        self.assertNotIn("out-run.lock", whole)
        refused = 0
        for _ in range(self.tries):
            self.clear()
            codes = self.two_at_once("run", "run.toml", "--resume")
            self.assertEqual(codes[0], 0)
            refused += codes[1] == 2
            self.assertEqual(self.outputs(), whole)
        self.assertGreater(refused, 0, "they never met")

    def test_studies_at_once(self):
        self.write("run.toml", STUDY)
        self.assertEqual(self.polhode("study", "run.toml", "--output", "whole").returncode, 0)
        whole, runs = self.rows("whole.csv"), sorted(self.rows("whole-runs.csv"))
        refused = 0
        for _ in range(self.tries):
            self.clear()
            codes = self.two_at_once("study", "run.toml", "--output", "out")
            self.assertEqual(codes[0], 0)
            refused += codes[1] == 2
            self.assertEqual((self.rows("out.csv"), sorted(self.rows("out-runs.csv"))), (whole, runs))
        self.assertGreater(refused, 0, "they never met")

    def holding(self):
        """A run that has a checkpoint and does not end by itself."""
        process = self.start("run", "run.toml")
        self.addCleanup(process.communicate)
        self.addCleanup(process.kill)
        end = time.monotonic() + sandbox.LONGEST
        while not (self.folder / "out-checkpoint.bin").exists():
            self.assertIsNone(process.poll(), "it ended by itself")
            self.assertLess(time.monotonic(), end, "it never came so far")
            time.sleep(0.002)
        return process

    def holding_frames(self):
        """The same after some checkpoints: the first is that of step 0, before the files."""
        process = self.holding()
        end = time.monotonic() + sandbox.LONGEST
        previous, seen = self.folder / "out-checkpoint-previous.bin", set()
        while len(seen) < 3:
            self.assertLess(time.monotonic(), end, "it never came so far")
            time.sleep(0.002)
            seen |= {previous.stat().st_mtime_ns} if previous.exists() else set()
        return process

    def test_owner_of_a_lock(self):
        self.write("run.toml", LONG)
        holder = self.holding()
        for options in (("--resume",), ("--force",), ()):
            process = self.polhode("run", "run.toml", *options)
            self.assertEqual(process.returncode, 2)
            held = HELD.search(process.err)
            self.assertEqual(held.groups(), ("out-run.lock", str(holder.pid), socket.gethostname()))
        holder.send_signal(signal.SIGTERM)
        holder.communicate(timeout=sandbox.LONGEST)
        self.assertEqual(holder.returncode, 130)
        self.assertFalse((self.folder / "out-run.lock").exists())

    def test_a_killed_process_holds_no_lock(self):
        self.write("run.toml", LONG)
        holder = self.holding()
        holder.kill()
        holder.communicate()
        self.assertTrue((self.folder / "out-run.lock").exists())
        self.assertEqual(self.polhode("run", "run.toml", "--resume", "--length", "0.002 ps", "--force").returncode, 2)
        self.write("run.toml", edited(LONG, ('"1000 ps"', '"2000 ps"')))  # the length is not part of the identity of a run
        process = self.start("run", "run.toml", "--resume")
        end = time.monotonic() + sandbox.LONGEST
        while f"process {process.pid} " not in (self.folder / "out-run.lock").read_text():
            self.assertIsNone(process.poll(), "it ended by itself")
            self.assertLess(time.monotonic(), end, "it never took the lock")
            time.sleep(0.002)
        process.kill()
        process.communicate()

    def test_outputs_that_are_links(self):
        """Links to the files of a running process, and one to nothing: they exist, --force replaces them, and their targets stay."""
        self.write("run.toml", LONG)
        self.write("linked.toml", edited(RUN, ('prefix = "out"', 'prefix = "linked"\nformats = ["xyz", "gro", "h5md"]'),
                                         ('plot = "none"', 'plot = "svg"')))
        holder = self.holding_frames()
        names = [path.name for path in self.folder.glob("out-*") if not path.name.endswith(".lock")]
        targets = {name: (self.folder / name).stat().st_ino for name in names if "checkpoint" not in name}
        self.assertIn("out-energies.csv", targets)
        self.write("mine.h5md", "mine")
        self.write("mine.svg", "mine")
        links = {name: name for name in targets} | {"out-final.gro": "nowhere.gro", "out-trajectory.h5md": "mine.h5md",
                                                   "out-energies.svg": "mine.svg"}
        for name, target in links.items():
            os.symlink(target, self.folder / name.replace("out-", "linked-"))
        self.refused_as_link("run", "linked.toml")
        process = self.polhode("run", "linked.toml", "--force")
        self.assertEqual(process.returncode, 0, process.err)
        self.assertEqual([p.name for p in self.folder.iterdir() if p.is_symlink()], [])
        self.assertEqual(((self.folder / "mine.h5md").read_text(), (self.folder / "mine.svg").read_text()), ("mine", "mine"))
        self.assertFalse((self.folder / "nowhere.gro").exists())
        self.assertEqual({name: (self.folder / name).stat().st_ino for name in targets}, targets)
        self.assertIsNone(holder.poll())
        holder.send_signal(signal.SIGTERM)
        holder.communicate(timeout=sandbox.LONGEST)
        self.write("run.toml", edited(LONG, ('"1000 ps"', '"1e6 ps"')))
        process = self.start("run", "run.toml", "--resume")  # reads the checksums of its files
        self.addCleanup(process.communicate)
        self.addCleanup(process.kill)
        self.assertIn("resuming after", process.stderr.readline())
        process.send_signal(signal.SIGTERM)
        self.assertEqual(process.wait(timeout=sandbox.LONGEST), 130)

    def refused_as_link(self, *arguments):
        process = self.polhode(*arguments)
        self.assertEqual(process.returncode, 2)
        self.assertIn("is a symbolic link to", process.err)

    def test_growing_files_by_another_name(self):
        """Links to the files of a running process next to a copy of its checkpoint: they are not resumed."""
        self.write("run.toml", LONG)
        holder = self.holding_frames()
        self.write("again.toml", edited(LONG, ('prefix = "out"', 'prefix = "again"')))
        self.write("again-checkpoint.bin", (self.folder / "out-checkpoint-previous.bin").read_bytes())
        for link in (os.symlink, os.link):
            for name in ("energies.csv", "trajectory.xyz", "trajectory.gro"):
                if (self.folder / f"out-{name}").exists():
                    link(self.folder / f"out-{name}", self.folder / f"again-{name}")
            process = self.polhode("run", "again.toml", "--resume")
            self.assertIn(process.returncode, (1, 2))
            self.assertIn("another process is writing to", process.err)
            self.assertIsNone(holder.poll())
            for path in self.folder.glob("again-[et]*"):
                path.unlink()

    def test_a_file_of_the_user_is_not_a_lock(self):
        self.write("run.toml", SMALL)
        for verb, name in (("run", "out-run.lock"), ("study", "study-study.lock")):
            self.write(name, "mine\n")
            self.refused((verb, "run.toml"), [f"'{name}'", "not a lock file of polhode"], verb)
            os.unlink(self.folder / name)
            (self.folder / name).mkdir()
            self.refused((verb, "run.toml"), [f"'{name}'"], verb)
            (self.folder / name).rmdir()


if __name__ == "__main__":
    sandbox.main()
