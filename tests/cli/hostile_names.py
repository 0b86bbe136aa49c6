# SPDX-License-Identifier: MIT
"""Names are never evaluated by gnuplot, a shell or a terminal; control characters are refused."""

import os
import shutil
import unittest

import sandbox
from sandbox import SMALL, Sandbox, edited

# Each creates a file "c" if a shell or gnuplot evaluates it, or ends a quoted text.
HOSTILE = ("`>c`", "$(>c)", "a;>c;", "<>c;", "|>c;", "a'`>c`", 'a"`>c`', "a\\", "a' b", "~", "-e", "a@b", "{a}^_&", "$c", "'", '"')
# Forbidden names: a newline, an escape sequence, DEL, C1, bytes that are not UTF-8.
REFUSED = ("a\nb", "a\tb", "a\x1b[31mb", "a\x7fb", "a\u009bb", "a\udcffb", "a\udcc3")
DRAWN = edited(SMALL, ('plot = "none"', 'plot = "svg"\ntrajectory_every = "2 fs"\nformats = ["xyz"]'))
BALL = """name = "ball"
source = "user"
[[site]]
name = '''NAME'''
element = "Ar"
position = "0 0 0 nm"
mass = "40 u"
sigma = "0.34 nm"
epsilon = "1 kJ/mol"
"""
# Site names with at most the five letters of GRO files.
SITES = ("`>c`", "$(>c)", "<>c", "|>c", "a'b", 'a"b', "a,b", "a\\", "@a", "{a}_b")


class HostileNames(Sandbox):
    def succeeds(self, *arguments):
        process = self.polhode(*arguments)
        with self.subTest(command=arguments, message=process.err):
            self.assertEqual(process.returncode, 0)
            self.assertNotIn("warning", process.err.replace("warning: gnuplot is not installed", ""))
            self.assertEqual([str(p) for p in self.folder.rglob("c")], [], "something was evaluated")
        return process

    def is_drawn(self, path):
        if shutil.which("gnuplot") is None:
            return
        with self.subTest(figure=path):
            self.assertIn("</svg>", (self.folder / path).read_text(encoding="utf-8"))

    def test_prefixes(self):
        self.write("run.toml", DRAWN)
        for name in HOSTILE:
            self.succeeds("run", "run.toml", f"--output={name}")
            self.is_drawn(f"{name}-energies.svg")
            self.succeeds("run", "run.toml", f"--output={name}", "--resume")
            self.succeeds("top", "--J", "1,2,3", "--L", "0.1,0.2,1", f"--output={name}")
            self.is_drawn(f"{name}.svg")

    def test_long_prefixes(self):
        """The longest name is that of the previous checkpoint, and its unfinished file has 20 letters more."""
        self.write("run.toml", SMALL)
        longest = 255 - 20 - len("-checkpoint-previous.bin")
        self.succeeds("run", "run.toml", "--output=" + longest * "a")
        self.succeeds("run", "run.toml", "--output=" + longest * "a", "--resume")
        for length in (longest + 1, 232, 246, 247, 300):
            for verb in ("run", "prepare", "minimise", "study"):
                if verb != "run" and length < 246:
                    continue  # their names are shorter
                self.refused((verb, "run.toml", "--output=" + length * "b"), ["bytes; the maximum is 235 bytes, since the temporary file"], verb)

    def test_folders_run_files_and_prefixes_in_them(self):
        for name in HOSTILE:
            (self.folder / name).mkdir()
            prefix = "'''" + name + "'''" if "'" not in name else '"' + name.replace("\\", "\\\\") + '"'
            self.write(f"{name}/{name}.toml", edited(DRAWN, ('"out"', prefix)))
            self.succeeds("run", f"./{name}/{name}.toml", f"--output={name}/{name}")
            self.is_drawn(f"{name}/{name}-energies.svg")
            self.succeeds("run", f"./{name}/{name}.toml")
            self.is_drawn(f"{name}-energies.svg")

    def test_sites(self):
        self.write("run.toml", edited(DRAWN, ('"argon"', '"ball.toml"')))
        for name in SITES:
            self.write("ball.toml", BALL.replace("NAME", name))
            self.succeeds("run", "run.toml", "--force")
            self.succeeds("analyze", "out-trajectory.xyz", "--run", "run.toml", "--what", "rdf,msd", "--force")
            self.is_drawn("polhode-analysis-rdf.svg")
            self.succeeds("molecules", "./ball.toml")

    def test_studies(self):
        scheme = "B(1/2)\n  A(1)\tB(1/2)"  # white space is allowed in the text of a scheme
        self.write("run.toml", edited(SMALL, ("runs = 2", "runs = 3")))
        for name in ("`>c`", "<>c;", "|>c;"):
            for _ in range(2):  # the second one reads the record of the first
                process = self.succeeds("study", "run.toml", f"--output={name}", "--schemes", scheme)
            self.assertIn("3 runs were read", process.err)
            self.is_drawn(f"{name}.svg")

    def test_control_characters_are_refused(self):
        self.write("run.toml", SMALL)
        for name in REFUSED:
            words = ["0x", "another name"]
            for verb in (("run", "run.toml"), ("study", "run.toml"), ("advise", "run.toml", "--accuracy", "1 %"),
                         ("top", "--J", "1,2,3", "--L", "0.1,0.2,1")):
                self.refused((*verb, f"--output={name}"), ["the output", *words], "prefix")
            (self.folder / name).mkdir()
            self.refused(("run", "run.toml", f"--output={name}/out"), ["the output", *words], "folder")
            (self.folder / name).rmdir()
            self.write(name, SMALL)
            self.refused(("run", name), ["the run file", *words], "run file")
            (self.folder / name).unlink()

    def test_control_characters_in_run_files(self):
        for name in ("a\\nb", "a\\tb", "a\\u001b[31mb", "a\\u009bb", "a\\u007f"):
            self.write("run.toml", edited(SMALL, ('"out"', f'"{name}"')))
            self.refused(("run", "run.toml"), ["the output", "0x"], "prefix")
            self.write("run.toml", edited(SMALL, ('"argon"', '"ball.toml"')))
            for key in ("'''NAME'''", '"Ar"', '"ball"'):
                self.write("ball.toml", edited(BALL, (key, f'"{name}"')))
                for verb in ("run", "energy", "study"):
                    self.refused((verb, "run.toml"), ["ball", "0x", "another name"], "site")

    def test_terminals_show_control_characters_escaped(self):
        name = "a\x1b]0;title\x07\x1b[2J\u009b1m\udcff"
        self.write("ball.toml", edited(BALL, ("NAME", "X"), ('"user"', '"user"\ndescription = "a\\u001b[31mb"')))
        for arguments in (("run", name), ("convert", f"{name}.gro", "out.xyz"), ("analyze", f"{name}.xtc", "--molecules", "argon 27"),
                          ("molecules", f"./{name}.toml"), ("run", f"--{name}"), (name,), ("molecules", "./ball.toml"),
                          ("run", "--scheme", name), ("run", "--step", name)):
            process = self.polhode(*arguments)
            for text in (process.out, process.err):
                odd = [c for c in text if c != "\n" and (ord(c) < 32 or 127 <= ord(c) < 160)]
                self.assertEqual(odd, [], f"{arguments}: {text!r}")
            self.assertIn("\\x1b", process.out + process.err)


if __name__ == "__main__":
    sandbox.main()
