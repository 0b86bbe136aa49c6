# SPDX-License-Identifier: MIT
"""Full disk, few file handles and existing names: the user's files are kept, exit code 2 changes nothing, other runs can be resumed."""

import resource

import sandbox
from sandbox import SMALL, Sandbox, edited

RUN = edited(SMALL, ('plot = "none"', 'plot = "none"\ntrajectory_every = "4 fs"\nformats = ["xyz", "gro", "xtc", "h5md"]'))
TAKEN = ("out-checkpoint.bin.part", "out-energies.csv.part", "out-final.gro.part", "out-trajectory.h5md.part", "unfinished-out.xyz",
         "unfinished-out-final.gro", "out.csv.part", "out.json.part", "out-runs.csv.part", "out.xyz.part", "polhode-analysis-rdf.csv.part")


class Room(Sandbox):
    def setUp(self):
        super().setUp()
        self.write("run.toml", RUN)

    def outputs(self):
        """H5MD files may contain creation times; checkpoints contain computing times."""
        return {n: b for n, b in self.contents().items() if n.startswith("out") and "checkpoint" not in n and "h5md" not in n}

    def clear(self):
        for path in self.folder.glob("out*"):
            path.unlink()

    def each_verb(self):
        """All verbs that write files, one after another, resumed if possible."""
        for arguments in (("run", "run.toml", "--length", "0.01 ps"), ("run", "run.toml", "--resume"),
                          ("convert", "out-trajectory.xtc", "out.xyz", "--names", "out-final.gro"),
                          ("analyze", "out-trajectory.h5md", "--run", "run.toml", "--what", "rdf", "--plot", "none"),
                          ("study", "run.toml", "--output", "out"), ("study", "run.toml", "--output", "out")):
            process = self.polhode(*arguments)
            self.assertEqual(process.returncode, 0, process.err)

    def test_existing_names(self):
        for name in TAKEN:
            self.write(name, f"mine: {name}\n")
        self.each_verb()
        for name in TAKEN:
            self.assertEqual((self.folder / name).read_text(), f"mine: {name}\n")

    def test_names_that_are_folders(self):
        for name in TAKEN:
            (self.folder / name).mkdir()
        self.each_verb()
        for name in TAKEN:
            self.assertTrue((self.folder / name).is_dir())

    def short_of(self, what, amounts):
        """A run under tighter and tighter limits: code 2 changes nothing; after code 1 it resumes with identical results."""
        self.assertEqual(self.polhode("run", "run.toml").returncode, 0)
        whole = self.outputs()
        codes = set()
        for amount in amounts:
            self.clear()
            before = self.contents()
            process = self.limited(what, amount, "run", "run.toml")
            with self.subTest(amount=amount, message=process.err):
                codes.add(process.returncode)
                self.assertIn(process.returncode, (0, 1, 2))
                self.assertEqual([n for n in self.contents() if "unfinished" in n or n.endswith(".lock")], [])
                if process.returncode == 2:
                    self.assertEqual(self.contents(), before, "a file was made or changed")
                process = self.polhode("run", "run.toml", "--resume")
                self.assertEqual(process.returncode, 0, process.err)
                self.assertEqual(self.outputs(), whole)
        return codes

    def test_file_handles(self):
        codes = self.short_of(resource.RLIMIT_NOFILE, range(4, 20))
        self.assertIn(0, codes, "the limits never sufficed")
        self.assertIn(1, codes)

    def test_too_few_file_handles_are_named(self):
        for amount in range(6, 14):
            self.clear()
            process = self.limited(resource.RLIMIT_NOFILE, amount, "run", "run.toml")
            if process.returncode != 0:
                self.assertIn(f"this process may have at most {amount} files open: raise this limit", process.err)
                self.assertNotIn("check", process.err.split("error:")[-1].replace("checkpoint", ""))

    def test_drafts_of_killed_processes_are_removed(self):
        """Of the run's own files; not other names like them."""
        stale = ("unfinished-0123abcd-out-trajectory.h5md", "unfinished-89abcdef-out-checkpoint.bin")
        others = ("unfinished-0123abcd-out2-trajectory.h5md", "unfinished-0123abcx-out-final.gro", "unfinished-0123abcd-out")
        for options in ((), ("--resume",), ("--force",)):
            for name in stale + others:
                self.write(name, f"mine: {name}\n")
            process = self.polhode("run", "run.toml", *options)
            self.assertEqual(process.returncode, 0, process.err)
            self.assertEqual([name for name in stale if (self.folder / name).exists()], [])
            for name in others:
                self.assertEqual((self.folder / name).read_text(), f"mine: {name}\n")

    def test_a_run_that_ends_with_an_error_has_no_final_state(self):
        """That of a shorter run, or of the one that --force replaced, is not a state of its trajectory."""
        self.assertEqual(self.polhode("run", "run.toml").returncode, 0)
        for options in (("--resume", "--length", "1000 ps"), ("--force", "--length", "1000 ps")):
            self.assertTrue((self.folder / "out-final.gro").exists())
            process = self.limited(resource.RLIMIT_FSIZE, 100_000, "run", "run.toml", *options)
            self.assertEqual(process.returncode, 1, process.err)
            self.assertFalse((self.folder / "out-final.gro").exists())
            process = self.polhode("run", "run.toml", "--force")
            self.assertEqual(process.returncode, 0, process.err)

    def test_a_run_may_start_from_the_final_state_that_it_replaces(self):
        self.assertEqual(self.polhode("run", "run.toml").returncode, 0)
        self.write("next.toml", edited(RUN, ('box = "2.5 nm"', 'initial_configuration = "out-final.gro"')))
        process = self.limited(resource.RLIMIT_FSIZE, 30_000, "run", "next.toml", "--force", "--length", "1000 ps")
        self.assertEqual(process.returncode, 1, process.err)
        process = self.polhode("run", "next.toml", "--resume", "--length", "1 ps")
        self.assertEqual(process.returncode, 0, process.err)

    def test_sizes_of_files(self):
        self.assertIn(1, self.short_of(resource.RLIMIT_FSIZE, (0, 1, 100, 1000, 3000, 5000, 10_000, 20_000, 40_000)))

    def test_conversions_without_room(self):
        self.assertEqual(self.polhode("run", "run.toml").returncode, 0)
        before = self.contents()
        for name in ("out.gro", "out.trr", "out.h5md"):
            for max_bytes in (0, 1, 1000, 3000):
                process = self.limited(resource.RLIMIT_FSIZE, max_bytes, "convert", "out-trajectory.gro", name)
                self.assertIn(process.returncode, (1, 2), process.err)
                self.assertIn(f"'{name}'", process.err)
                self.assertNotIn("unfinished", process.err)
                self.assertEqual(self.contents(), before)

    def test_studies_without_room(self):
        for max_bytes in (0, 1, 100, 500):
            process = self.limited(resource.RLIMIT_FSIZE, max_bytes, "study", "run.toml", "--output", "out")
            self.assertEqual(process.returncode, 1, process.err)
            process = self.polhode("study", "run.toml", "--output", "out")
            self.assertEqual(process.returncode, 0, process.err)
            self.assertEqual(len(self.rows("out-runs.csv")), 3)
            self.clear()

    def test_a_study_of_the_same_twice(self):
        for options, words in ((("--schemes", "hoa2", "hoa2"), ["hoa2", "twice"]),
                               (("--schemes", "B(1/2) A(1) B(1/2)", "B(1/2)  A(1)\tB(1/2)"), ["twice"]),
                               (("--steps", "2 fs", "4 fs", "0.002 ps"), ["2 fs", "twice"])):
            self.refused(("study", "run.toml", *options), words, "study")
        self.write("run.toml", edited(RUN, ('["velocity-verlet"]', '["hoa2", "hoa2"]')))
        self.refused(("study", "run.toml"), ["hoa2", "twice"], "study")


if __name__ == "__main__":
    sandbox.main()
