#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""How many times faster LAMMPS is on two processes than on one, with pair_style polhode and fix polhode.

    bench/lammps/ranks.py --polhode ./polhode --environment FOLDER --plugin polhodeplugin.so --output RESULT.json

The molecules are water, as atoms or as one particle each. Times are the loop times of LAMMPS, of runs that alternate
between one and two processes. It prints the median and the range of the ratios over all rounds, and the parts of a step
that LAMMPS measures. FOLDER is the folder that lammps/environment.py makes.
"""

import argparse
import datetime
import re
import statistics
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "bench/lammps"), str(ROOT / "bench"), str(ROOT / "studies")]
import cost  # noqa: E402
from lib import study  # noqa: E402

FORMS = {
    "atoms, mixed": "pair_style polhode, mixed",
    "atoms, double": "pair_style polhode, double",
    "particles, mixed": "one particle a molecule, mixed",
    "particles, double": "one particle a molecule, double",
}
PARTS = ("Pair", "Neigh", "Comm", "Modify", "Other")


class Bench(cost.Bench):
    def loop(self, ranks, script):
        """Milliseconds of a step, and of each of its parts."""
        output = self.output(script, launcher=[self.mpiexec, "-n", str(ranks)])
        found = re.search(r"Loop time of (\S+) on \d+ procs for (\d+) steps", output)
        if not found:
            sys.exit(output[-2000:])
        per_step = 1e3 / int(found[2])
        average = lambda part: float(re.search(rf"^{part}\s*\|[^|]*\|\s*(\S+)", output, re.M)[1])
        parts = {part: average(part) for part in PARTS}
        return float(found[1]) * per_step, {part: time * per_step for part, time in parts.items()}

    def compare(self, form, copies, steps, rounds):
        """The times of one and of two processes, of each round."""
        what = cost.STYLES[FORMS[form]]
        script = what.script(self.options.plugin.resolve(), copies, steps).replace("thermo 100", "thermo 1000000")
        return [[self.loop(ranks, script) for ranks in (1, 2)] for _ in range(rounds)]


def arguments():
    p = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    cost.add_programs(p)
    p.add_argument("--copies", type=int, default=4, help="of 512 waters along each edge (4: 32,768 waters)")
    p.add_argument("--forms", type=lambda text: text.split(";"), default=list(FORMS), help=";".join(FORMS))
    p.add_argument("--rounds", type=int, default=7)
    p.add_argument("--steps", type=int, default=60)
    p.add_argument("--output", type=Path)
    return p.parse_args()


def main():
    options = arguments()
    waters = 512 * options.copies**3
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(options, Path(folder))
        bench.export(bench.run_file(1, 1000, truncation="site-switch", prefix="water"))
        bench.export(bench.run_file(options.copies, 1000, prefix="particles"), "polhode-particles")
        print("| molecules as | one process [ms] | two | times faster (range) | parts of a step on one and two processes [ms] |\n"
              "| --- | --- | --- | --- | --- |")
        for form in options.forms:
            rounds = bench.compare(form, options.copies, options.steps, options.rounds)
            ratios = [one[0] / two[0] for one, two in rounds]
            times = [statistics.median(r[k][0] for r in rounds) for k in (0, 1)]
            parts = {part: [statistics.median(r[k][1][part] for r in rounds) for k in (0, 1)] for part in PARTS}
            text = ", ".join(f"{part} {one:.2f} {two:.2f}" for part, (one, two) in parts.items())
            rows.append({"form": form, "waters": waters, "one": times[0], "two": times[1], "ratios": ratios, "parts": parts})
            print(f"| {form} | {times[0]:.2f} | {times[1]:.2f} | {statistics.median(ratios):.2f} ({min(ratios):.2f} to {max(ratios):.2f}) | {text} |",
                  flush=True)
    if options.output:
        study.write(options.output, {"date": str(datetime.date.today()), "processor": study.processor(), "steps": options.steps, "rows": rows})


if __name__ == "__main__":
    main()
