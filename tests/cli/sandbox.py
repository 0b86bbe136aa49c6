# SPDX-License-Identifier: MIT
"""An empty folder in which the built program is run as by a user."""

import argparse
import fcntl
import os
import pty
import random
import resource
import struct
import subprocess
import tempfile
import termios
import threading
import unittest
from pathlib import Path

PROGRAM = None  # the built program, from the command line
END = b"\x03"  # ends what is read from a terminal; the program prints none
LONGEST = 120  # seconds for one run of the program
KILLS = 8  # number of kills at random moments, and of bits flipped in checkpoints; long campaigns use more
FLIPS = 3

# 27 argon atoms in a box just large enough for the default cutoff: every verb takes a fraction of a second.
SMALL = """[system]
molecules = [{ model = "argon", count = 27 }]
box = "2.5 nm"
temperature = "100 K"

[forces]
cutoff = "1.0 nm"

[integrator]
scheme = "hoa2"
step = "2 fs"

[run]
length = "0.02 ps"

[output]
prefix = "out"
plot = "none"

[study]
schemes = ["velocity-verlet"]
steps = ["2 fs"]
runs = 2
length = "0.1 ps"
decorrelate = "0.02 ps"
"""


class Sandbox(unittest.TestCase):
    """A test with its own folder."""

    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)

    def write(self, name, text):
        path = self.folder / name
        path.write_bytes(text) if isinstance(text, bytes) else path.write_text(text, encoding="utf-8")

    def start(self, *arguments, limit=None, **environment):
        def prepare():
            resource.setrlimit(limit[0], (limit[1], resource.getrlimit(limit[0])[1]))
        return subprocess.Popen([PROGRAM, *arguments], cwd=self.folder, text=True, stdin=subprocess.DEVNULL,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                env={**os.environ, **environment}, preexec_fn=prepare if limit else None)

    def polhode(self, *arguments, limit=None, **environment):
        """The finished process of `polhode ARGUMENTS`."""
        with self.start(*arguments, limit=limit, **environment) as process:
            try:
                process.out, process.err = process.communicate(timeout=LONGEST)
            except subprocess.TimeoutExpired:
                process.kill()
                raise
        return process

    def on_terminal(self, columns, *arguments, error=None):
        """What `polhode ARGUMENTS` prints on a terminal of this width; with error=subprocess.DEVNULL without notes."""
        ours, its = pty.openpty()
        fcntl.ioctl(its, termios.TIOCSWINSZ, struct.pack("HHHH", 40, columns, 0, 0))
        environment = {name: value for name, value in os.environ.items() if name != "COLUMNS"}
        text = bytearray()

        def read():
            while not text.endswith(END):
                text.extend(os.read(ours, 4096))

        # A terminal whose last writer has gone may lose what nobody has read yet: it stays open, and a mark says where the text ends.
        reader = threading.Thread(target=read)
        reader.start()
        subprocess.run([PROGRAM, *arguments], cwd=self.folder, stdin=its, stdout=its, stderr=error or its, env=environment)
        os.write(its, END)
        reader.join()
        os.close(its)
        os.close(ours)
        return text.removesuffix(END).decode().replace("\r\n", "\n")

    def limited(self, what, maximum, *arguments):
        """The finished process of `polhode ARGUMENTS` under a soft limit of the system."""
        return self.polhode(*arguments, limit=(what, maximum))

    def kill_at_random_moments(self, times, within, *arguments):
        """Kills `polhode ARGUMENTS` after up to `within` seconds, `times` times; a run that ends before is started again."""
        for _ in range(50 * times):
            process = self.start(*arguments)
            try:
                process.communicate(timeout=random.uniform(0, within))
            except subprocess.TimeoutExpired:
                process.kill()
                process.communicate()
                times -= 1
                if times == 0:
                    return
            else:
                self.assertEqual(process.returncode, 0)
                for path in self.folder.glob("out*"):
                    path.unlink()
        self.fail("it always ended before it was killed")

    def done(self, verb, text, *options):
        """`polhode VERB run.toml OPTIONS` with this text as run file, which must succeed."""
        self.write("run.toml", text)
        process = self.polhode(verb, "run.toml", *options)
        self.assertEqual(process.returncode, 0, process.err)
        return process

    def refused(self, arguments, words, title="", **environment):
        """`polhode ARGUMENTS` must be refused as wrong input: with these words, and no file created or changed."""
        before = self.contents()
        process = self.polhode(*arguments, **environment)
        with self.subTest(case=title, command=" ".join(arguments), message=process.err):
            self.assertEqual(process.returncode, 2)
            self.assertEqual(process.out, "")
            for word in words:
                self.assertIn(word, process.err)
            self.assertEqual(self.contents(), before, "a file was made or changed")

    def contents(self):
        """Every file of the folder with its contents."""
        return {str(p.relative_to(self.folder)): p.read_bytes()
                for p in sorted(self.folder.rglob("*")) if p.is_file()}

    def rows(self, name):
        """The lines of a CSV file below its comments, the column names first."""
        text = (self.folder / name).read_text(encoding="utf-8")
        self.assertTrue(text.endswith("\n"), f"{name} ends within a line")
        return [line for line in text.splitlines() if not line.startswith("#")]


def edited(text, *changes):
    """The text with each (old, new) replaced; a missing old one is an error of the test."""
    for old, new in changes:
        if old not in text:
            raise ValueError(f"'{old}' is not in the run file")
        text = text.replace(old, new)
    return text


def main():
    global PROGRAM, KILLS, FLIPS
    parser = argparse.ArgumentParser()
    parser.add_argument("--program", type=Path, required=True)
    parser.add_argument("--kills", type=int, default=KILLS)
    parser.add_argument("--flips", type=int, default=FLIPS)
    options, rest = parser.parse_known_args()
    PROGRAM, KILLS, FLIPS = options.program.resolve(), options.kills, options.flips
    unittest.main(module="__main__", argv=["polhode", *rest], verbosity=1)
