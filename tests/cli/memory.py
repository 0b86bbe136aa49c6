# SPDX-License-Identifier: MIT
"""Requests beyond the memory are refused before allocation, with their amount; large, nearly empty systems fit."""

import os
import pathlib
import resource
import subprocess

import sandbox
from sandbox import SMALL, Sandbox, edited

MB = 1 << 20


def argon(count, box, more=""):
    return edited(SMALL, ("count = 27", f"count = {count}"), ('box = "2.5 nm"', f'box = "{box}"')) + more


class Memory(Sandbox):
    def within(self, limit, *arguments):
        """The finished process of `polhode ARGUMENTS` with a limit of its address space in bytes, on one thread."""
        def bound():
            resource.setrlimit(resource.RLIMIT_AS, (limit, limit))
        return subprocess.run([sandbox.PROGRAM, *arguments], cwd=self.folder, text=True, capture_output=True,
                              preexec_fn=bound, env={"POLHODE_THREADS": "1"}, timeout=sandbox.LONGEST)

    def test_counts_beyond_all_bounds_are_refused(self):
        for count in (10**8, 10**10, 2**62, 2**63 - 1):
            self.write("many.toml", argon(count, "500 nm"))
            for verb in ("energy", "run", "study"):
                self.refused([verb, "many.toml"], [f"{count} molecules" if count < 2**53 else "molecules are more",
                                                   "than the neighbour list can index", "use fewer"], verb)

    def test_too_large_systems_are_refused_with_the_amount_of_memory(self):
        self.write("many.toml", argon(5_000_000, "80 nm"))
        process = self.within(2000 * MB, "energy", "many.toml")
        self.assertEqual(process.returncode, 2, process.stderr)
        for word in ("5000000 molecules need at least 2.6", "GB of memory", "may use only 2.1", "use fewer of them",
                     "many.toml"):
            self.assertIn(word, process.stderr)

    def test_the_limit_of_the_control_group_of_the_process(self):
        """Groups with a limit of 1 GB, in a mount namespace of the process. The group of all processes has none."""
        self.write("many.toml", argon(5_000_000, "80 nm"))
        (self.folder / "groups").mkdir()
        for line in pathlib.Path("/proc/self/cgroup").read_text(encoding="utf-8").splitlines():
            _, controllers, group = line.split(":", 2)
            if group != "/" and (not controllers or "memory" in controllers.split(",")):
                folder = self.folder / "groups" / ("memory" if controllers else "") / group.lstrip("/")
                folder.mkdir(parents=True, exist_ok=True)
                (folder / ("memory.limit_in_bytes" if controllers else "memory.max")).write_text("1000000000\n", encoding="utf-8")
        if not any((self.folder / "groups").iterdir()):
            self.skipTest("the process is in no control group of its own")
        process = subprocess.run(["unshare", "--mount", "--map-root-user", "sh", "-c", 'mount --bind groups /sys/fs/cgroup || exit 77; exec "$@"', "sh",
                                  sandbox.PROGRAM, "energy", "many.toml"], cwd=self.folder, text=True, capture_output=True, timeout=sandbox.LONGEST)
        if process.returncode == 77 or "unshare" in process.stderr:
            self.skipTest(process.stderr)
        self.assertEqual(process.returncode, 2, process.stderr)
        self.assertIn("may use only 1 GB", process.stderr)

    def test_frames_of_h5md_need_no_memory(self):
        """The caches of the library, 6 MB of chunks and more of their index, once grew by 200 bytes a frame here."""
        self.write("run.toml", edited(argon(8, "2.2 nm"), ('prefix = "out"', 'prefix = "out"\ntrajectory_every = "2 fs"\nformats = ["h5md"]')))
        peaks = []
        for length in ("4 ps", "40 ps"):
            process = subprocess.Popen([sandbox.PROGRAM, "run", "run.toml", "--force", "--length", length], cwd=self.folder,
                                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env={"POLHODE_THREADS": "1"})
            status, usage = os.wait4(process.pid, 0)[1:]
            process.returncode = os.waitstatus_to_exitcode(status)
            self.assertEqual(process.returncode, 0)
            peaks.append(usage.ru_maxrss * 1024)
        # 18,000 frames more: the caches are full after 2000, and a megabyte is what the peaks of equal runs differ by
        self.assertLess(peaks[1] - peaks[0], 2 * MB)

    def test_what_was_not_foreseen_is_said_too(self):
        """A limit above the estimate, which is a lower bound."""
        self.write("many.toml", argon(1_000_000, "40 nm"))
        process = self.within(620 * MB, "energy", "many.toml")
        self.assertEqual(process.returncode, 1, process.stderr)
        self.assertIn("memory is exhausted: this process may use 0.65 GB", process.stderr)
        self.assertNotIn("bad_alloc", process.stderr)

    def test_boxes_beyond_all_bounds_are_refused(self):
        for edge in ("1e5 nm", "1e9 nm", "1e300 nm"):
            self.write("wide.toml", argon(27, edge))
            self.refused(["energy", "wide.toml"], ["a box edge is", "at most 8192 nm", "the resolution of positions"], edge)

    def test_a_large_box_that_holds_little_is_small(self):
        """Cells of half the range in 400 nm would need 1.7 GB."""
        self.write("dilute.toml", argon(8, "400 nm"))
        process = self.within(1000 * MB, "energy", "dilute.toml", "--json")
        self.assertEqual(process.returncode, 0, process.stderr)

    def test_the_radial_distribution_of_a_large_box_is_small(self):
        """Cells of the range in 100 nm would need 728 MB."""
        self.write("dilute.toml", argon(8, "100 nm"))
        self.assertEqual(self.polhode("run", "dilute.toml").returncode, 0)
        frames = [name for name in self.contents() if "trajectory" in name]
        process = self.within(500 * MB, "analyze", frames[0], "--run", "dilute.toml")
        self.assertEqual(process.returncode, 0, process.stderr)

    def test_two_ions_in_a_large_box_have_a_long_cutoff(self):
        ions = edited(SMALL, ('{ model = "argon", count = 27 }',
                              '{ model = "na-spce", count = 1 }, { model = "cl-spce", count = 1 }'),
                      ('box = "2.5 nm"', 'box = "60 nm"'), ('cutoff = "1.0 nm"', 'cutoff = "1.0 nm"\nelectrostatics = "pme"'))
        self.assertIn("PME: pairs of charges up to", self.done("energy", ions, "--json").err)
        short = edited(ions, ('"pme"', '"pme"\ncoulomb_cutoff = "1.0 nm"'))
        self.write("ions.toml", short)
        self.refused(["energy", "ions.toml"], ["mesh points for 2 charges", "use a coulomb_cutoff of"])
        cutoff = self.polhode("energy", "ions.toml").err.split("use a coulomb_cutoff of ")[1].split(" nm")[0]
        process = self.done("energy", edited(short, ('coulomb_cutoff = "1.0 nm"', f'coulomb_cutoff = "{cutoff} nm"')), "--json")
        self.assertIn("PME: pairs of charges up to", process.err)


if __name__ == "__main__":
    sandbox.main()
