#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The messages that LAMMPS processes send in a step of rigid water, with pair_style polhode (atoms or one particle per molecule) and with
fix rigid/nve/small.

    bench/lammps/weak_scaling.py --polhode ./polhode --environment FOLDER --plugin polhodeplugin.so --output RESULT.json

It compiles messages.c, which counts messages and bytes. The counts per step are printed for the busiest process.
Systems are 1, 2, 4 and 8 processes with 512 waters each, and then 8 processes with more waters each. The bytes are also
printed per molecule of the shell of
ghosts around a domain. FOLDER is the folder that lammps/environment.py makes. Because only messages are counted, the computer may have
fewer cores than processes.
"""

import argparse
import datetime
import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "bench/lammps"), str(ROOT / "bench"), str(ROOT / "studies")]
import cost  # noqa: E402
from lib import study  # noqa: E402

HERE = Path(__file__).resolve().parent
FORMS = {
    "rigid/nve/small": "rigid/nve/small, lj/cut/coul/cut",
    "atoms": "pair_style polhode, double",
    "particles": "one particle a molecule, double",
}
RANKS = {1: (1, 1, 1), 2: (2, 1, 1), 4: (2, 2, 1), 8: (2, 2, 2)}


def replicated(data, copies):
    """A data file of particles, copied along the edges of its box."""
    head, _, rest = data.partition("\nAtoms # atomic\n\n")
    atoms, _, rest = rest.partition("\nVelocities\n\n")
    velocities, _, orientations = rest.partition("\nOrientations\n\n")
    edges = [float(line.split()[1]) for line in head.splitlines() if line.endswith("hi")]
    shifts = [(i * edges[0], j * edges[1], k * edges[2]) for i in range(copies[0]) for j in range(copies[1])
              for k in range(copies[2])]
    rows = [[line.split() for line in part.splitlines()] for part in (atoms, velocities, orientations)]
    count = len(rows[0])
    for d, letter in enumerate("xyz"):
        head = re.sub(rf"0 \S+ {letter}lo", f"0 {copies[d] * edges[d]!r} {letter}lo", head)
    text = head.replace(f"{count} atoms", f"{count * len(shifts)} atoms") + "\nAtoms # atomic\n\n"
    for n, shift in enumerate(shifts):
        for row in rows[0]:
            x = [repr(float(word) + s) for word, s in zip(row[2:], shift)]
            text += " ".join([str(int(row[0]) + n * count), row[1], *x]) + "\n"
    for title, part in (("Velocities", rows[1]), ("Orientations", rows[2])):
        text += f"\n{title}\n\n"
        for n in range(len(shifts)):
            text += "".join(" ".join([str(int(row[0]) + n * count), *row[1:]]) + "\n" for row in part)
    return text, edges[0] / 10


class Bench(cost.Bench):
    def __init__(self, options, folder):
        super().__init__(options, folder)
        subprocess.run(["cc", "-shared", "-fPIC", "-O1", f"-I{options.environment.resolve()}/include", "-o", folder / "messages.so",
                        HERE / "messages.c"], check=True)
        self.export(self.run_file(1, 1000, truncation="site-switch", prefix="water"))
        self.export(self.run_file(1, 1000, prefix="particles"), "polhode-particles")
        (folder / "particles.data").rename(folder / "one.data")

    def script(self, form, copies, steps):
        what = cost.STYLES[FORMS[form]]
        if what.fix == cost.PARTICLE:
            text, self.edge = replicated((self.folder / "one.data").read_text(), copies)
            self.write("particles.data", text)
        script = what.script(self.options.plugin.resolve(), 0, steps).replace("replicate 0 0 0", "replicate {} {} {}".format(*copies))
        return script.replace("thermo 100", "thermo 1000000")

    def sent(self, form, ranks, copies, steps):
        """(messages, bytes, collective operations) of the process that sends most, in a whole run."""
        output = self.output(self.script(form, copies, steps),
                             launcher=[self.mpiexec, "-n", str(ranks), "-env", "LD_PRELOAD", self.folder / "messages.so"])
        found = re.findall(r"sent rank \d+ messages (\d+) bytes (\d+) collectives (\d+)", output)
        if len(found) != ranks:
            sys.exit(output[-2000:])
        return [max(int(row[k]) for row in found) for k in range(3)]

    def per_step(self, form, ranks, waters):
        """Messages of a step, with a share of the exchanges of molecules; waters: number of copies of 512 waters per process along each edge."""
        copies = [waters * n for n in RANKS[ranks]]
        steps = self.options.steps
        short, long = (self.sent(form, ranks, copies, n) for n in (10, 10 + steps))
        return [(b - a) / steps for a, b in zip(short, long)]


def shell(size, edge, thickness):
    """Molecules in a shell around a domain of `size` copies of 512 waters along each edge; lengths in nm."""
    return 512 / edge**3 * ((size * edge + 2 * thickness)**3 - (size * edge)**3)


def main():
    p = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    cost.add_programs(p)
    p.add_argument("--steps", type=int, default=40, help="that are counted (40)")
    p.add_argument("--sizes", type=lambda text: [int(word) for word in text.split(",")], default=[1, 2, 3],
                   help="of the domains on 8 processes: copies of 512 waters along each edge (1,2,3)")
    p.add_argument("--output", type=Path)
    options = p.parse_args()
    result = {"date": str(datetime.date.today()), "processor": study.processor(), "steps": options.steps, "rows": []}
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(options, Path(folder))
        cases = [(ranks, 1) for ranks in RANKS] + [(8, size) for size in options.sizes if size > 1]
        print("| waters of a process | processes | molecules as | messages | kB | kB per ghost molecule | collective operations |\n"
              "| --- | --- | --- | --- | --- | --- | --- |")
        for form in ("particles", "atoms", "rigid/nve/small"):
            for ranks, size in cases:
                messages, sent, collectives = bench.per_step(form, ranks, size)
                ghosts = shell(size, bench.edge, 1.1)  # cutoff and skin
                result["rows"].append({"form": form, "processes": ranks, "waters": 512 * size**3, "messages": messages, "bytes": sent,
                                       "collectives": collectives, "shell": ghosts})
                per_ghost = f"{sent / ghosts / 1e3:.3f}" if ranks == 8 else ""
                print(f"| {512 * size**3} | {ranks} | {form} | {messages:.1f} | {sent / 1e3:.1f} | {per_ghost} | {collectives:.2f} |",
                      flush=True)
    if options.output:
        options.output.write_text(json.dumps(result, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
