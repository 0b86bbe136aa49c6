# SPDX-License-Identifier: MIT
"""Standard streams that are full, closed or broken: losses are reported, no file gets their descriptors, and no run ends because of its log."""

import json
import os
import subprocess

import sandbox
from sandbox import SMALL, Sandbox, edited

PRINTING = (("--help",), ("--version",), ("run", "--help"), ("molecules",), ("molecules", "tip4p", "--json"), ("schemes",),
            ("schemes", "gier4", "--json"), ("top", "--J", "1,2,3", "--L", "0.1,0.2,1"), ("energy", "run.toml"),
            ("energy", "run.toml", "--forces"), ("run", "run.toml", "--force"), ("run", "run.toml", "--force", "--json"),
            ("study", "run.toml"), ("study", "run.toml", "--json"))


class Streams(Sandbox):
    def setUp(self):
        super().setUp()
        self.write("run.toml", SMALL)

    def run_with(self, arguments, stdout=subprocess.PIPE, stderr=subprocess.PIPE, closed=()):
        def close():
            for stream in closed:
                os.close(stream)
        return subprocess.run([sandbox.PROGRAM, *arguments], cwd=self.folder, text=True, stdin=subprocess.DEVNULL, stdout=stdout,
                              stderr=stderr, preexec_fn=close, timeout=sandbox.LONGEST)

    def outputs(self):
        """Files without the parts that differ between runs."""
        return {n: b for n, b in self.contents().items() if "checkpoint" not in n and not n.endswith((".png", ".svg"))}

    def test_standard_output_is_full(self):
        for arguments in PRINTING:
            with self.subTest(command=arguments), open("/dev/full", "w", encoding="utf-8") as full:
                process = self.run_with(arguments, stdout=full)
                self.assertEqual(process.returncode, 1, process.stderr)
                self.assertIn("standard output", process.stderr)

    def test_standard_output_is_closed(self):
        for arguments in PRINTING:
            with self.subTest(command=arguments):
                process = self.run_with(arguments, closed=[1])
                self.assertEqual(process.returncode, 1, process.stderr)
                self.assertIn("standard output", process.stderr)

    def test_nobody_reads_standard_output(self):
        for arguments in PRINTING:
            reader, writer = os.pipe()
            os.close(reader)
            with self.subTest(command=arguments):
                process = self.run_with(arguments, stdout=writer)
                self.assertEqual(process.returncode, 1, process.stderr)
                self.assertIn("standard output", process.stderr)
            os.close(writer)

    def test_other_codes_stay(self):
        with open("/dev/full", "w", encoding="utf-8") as full:
            self.assertEqual(self.run_with(["run", "nowhere.toml"], stdout=full).returncode, 2)

    def test_standard_error_is_lost(self):
        """Closed, full, or a pipe without reader: the same files and the same output as usual."""
        def files_and_output(arguments, **streams):
            process = self.run_with(arguments, **streams)
            self.assertEqual(process.returncode, 0, process.stderr)
            files = {n: b for n, b in self.outputs().items() if n != "study-runs.csv"}
            if (self.folder / "study-runs.csv").exists():
                files["study-runs.csv"] = sorted(self.rows("study-runs.csv"))  # runs of a study end in any order
            if not {"--force", "energy"} & set(arguments):
                for path in self.folder.glob("*.*"):  # so that the next one starts like this one
                    if path.name != "run.toml":
                        path.unlink()
            return files, bool(process.stdout)
        reader, writer = os.pipe()
        os.close(reader)
        with open("/dev/full", "w", encoding="utf-8") as full:
            for arguments in (("study", "run.toml"), ("energy", "run.toml"), ("energy", "run.toml", "--forces"), ("run", "run.toml", "--force")):
                whole = files_and_output(arguments)
                for streams in ({"closed": [2]}, {"closed": [0, 2]}, {"stderr": full}, {"stderr": writer}):
                    with self.subTest(command=arguments, streams=streams):
                        self.assertEqual(files_and_output(arguments, **streams), whole)
            self.assertEqual(self.run_with(["run", "nowhere.toml"], stderr=full).returncode, 2)
        os.close(writer)
        self.assertEqual(self.run_with(["run", "nowhere.toml"], closed=[2]).returncode, 2)

    def test_all_are_closed(self):
        self.assertEqual(self.run_with(["run", "run.toml"], closed=[0, 1, 2]).returncode, 1)
        whole = self.outputs()
        process = self.polhode("run", "run.toml", "--force", "--json")
        self.assertTrue(json.loads(process.out))
        self.assertEqual(self.outputs(), {**whole, "out-energies.csv": whole["out-energies.csv"]})

    def test_figures_without_streams(self):
        self.write("run.toml", edited(SMALL, ('"none"', '"svg"')))
        self.assertEqual(self.run_with(["run", "run.toml"], closed=[0, 2]).returncode, 0)


if __name__ == "__main__":
    sandbox.main()
