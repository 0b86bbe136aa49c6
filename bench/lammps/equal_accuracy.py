#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Seconds per nanosecond of rigid water in LAMMPS at equal R. Schemes of fix polhode with pair_style polhode, with
atoms or with one particle per molecule, are compared with fix rigid/nve/small. R of the latter has a table of the same
potential. Its time is also measured with the fastest pair styles of LAMMPS. The schemes are also measured with polhode's default truncation by molecules, which LAMMPS pair styles do not
have.

    bench/lammps/equal_accuracy.py --polhode ./polhode --environment FOLDER --plugin polhodeplugin.so --output RESULT.json
    bench/lammps/equal_accuracy.py --stored RESULT.json
    bench/figures.py lammps RESULT.json FIGURE.svg

R is measured with 512 waters, with the same number of runs from different velocities at each step. It does not depend on the number of
molecules. The time of a step is measured with 4,096 waters on one and on two processes, as the minimum over several rounds. FOLDER is
the folder that lammps/environment.py makes.
"""

import argparse
import datetime
import json
import math
import re
import statistics
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tests/lammps"), str(ROOT / "bench/lammps"), str(ROOT / "bench"), str(ROOT / "studies")]
import cost  # noqa: E402
import engine  # noqa: E402
import water  # noqa: E402
from lib import study  # noqa: E402

OTHER = "rigid/nve/small"
FASTEST = f"{OTHER}, lj/cut/omp and coul/cut/omp"
# For each scheme: its force evaluations per step, and the time steps [fs] at which R is measured.
SCHEMES = {
    OTHER: (1, (1, 1.5, 2, 3, 4, 5)),
    "velocity-verlet": (1, (1, 1.5, 2, 3, 4, 5)),
    "hoa2": (2, (3, 4, 5, 6, 8, 10)),
    "bcss3": (3, (4, 5, 6, 7.5, 9, 12, 13.5)),
    "gier4-fd": (3, (4, 5, 6, 7.5, 9, 12)),
}
LENGTH = 2000.0  # of a run [fs]
SAMPLE = 12.0  # about the time between samples [fs]
WANTED = (1.5, 0.4)  # R [%]

LAWS = ("site-switch", "molecule-switch")
# The ways in which LAMMPS represents molecules, with the style of the export, the precision and the potential.
FORMS = {
    f"{OTHER}, table": ("table", "double", LAWS[0]),
    f"{OTHER}, lj/cut/coul/cut": ("table", "double", LAWS[0]),
    FASTEST: ("table", "double", LAWS[0]),
    **{f"{style}, {precision}, {law}": (export, precision, law) for law in LAWS
       for style, export in (("atoms", "polhode"), ("particles", "polhode-particles")) for precision in ("double", "mixed")},
}


class Bench(cost.Bench):
    def exported(self, style, precision, law, seed=1, copies=1):
        """The script up to its fix, and the arguments of fix polhode that the molecules need."""
        self.export(water.run_file(
            *water.start(copies, self.folder), "run", system={"temperature": "297 K", "velocities": "new", "seed": seed},
            forces={"truncation": law, "electrostatics": "reaction-field", "cutoff": "1 nm", "precision": precision},
            integrator={"scheme": "velocity-verlet", "step": "1 fs"}, run={"length": "1 fs"}), style)
        head, _, rest = (self.folder / "run.in").read_text().partition("fix rigid")
        return head, re.search(r'scheme "[^"]*"(.*)', rest)[1]

    def lammps(self, script, ranks=1, options=()):
        launcher = [self.mpiexec, "-n", str(ranks)] if ranks > 1 else []
        return self.output(script, "-var", "plugin", self.options.plugin.resolve(), *options, launcher=launcher)

    def ratio(self, scheme, law, step, seed):
        """R of one run [%]."""
        evaluations, _ = SCHEMES[scheme]
        other = scheme == OTHER
        head, more = self.exported("table" if other else "polhode-particles", "double", law, seed)
        fix = "rigid/nve/small molecule" if other else f"polhode scheme {scheme} lambda 1e-4{more}"
        every = evaluations * max(1, round(SAMPLE / step))
        steps = every * math.ceil(LENGTH / step * evaluations / every)
        output = self.lammps(f"""{head}fix rigid all {fix}
timestep {step / evaluations!r}
thermo_style custom step temp pe etotal {"" if other else "f_rigid[2]"}
thermo_modify norm no format float %.15g
thermo {every}
run {steps}
""")
        table = engine.tables(output)[0]
        rotation = table.get("f_rigid[2]", [0] * len(table["Step"]))  # LAMMPS does not know that particles rotate
        total = [a + b for a, b in zip(table["TotEng"], rotation)]
        return 100 * statistics.pstdev(total) / statistics.pstdev(table["PotEng"])

    def milliseconds(self, form, ranks, copies, steps):
        """Time of a step of LAMMPS."""
        style, precision, law = FORMS[form]
        head, more = self.exported(style, precision, law, copies=copies)
        if "cut" in form:
            of = cost.STYLES[form]
            head = re.sub(r"pair_style .*", f"pair_style {of.style}", head)
            head = re.sub(r"(pair_coeff .*\n)+", f"{of.coefficients}\n", head)
        fix = "rigid/nve/small molecule" if form.startswith(OTHER) else f"polhode{more}"
        script = f"{head}neighbor 1.0 bin\nfix rigid all {fix}\ntimestep 2\nthermo 1000000\nrun {max(5, steps // 5)}\nrun {steps}\n"
        options = cost.STYLES[form].options if form in cost.STYLES else ()
        loops = re.findall(r"Loop time of (\S+)", self.lammps(script, ranks, options))
        return 1e3 * float(loops[1]) / steps


def step_at(points, wanted):
    """The step at which log R, interpolated linearly in log h, has a value; None if it is outside the points."""
    for (h0, r0), (h1, r1) in zip(points, points[1:]):
        if r0 <= wanted <= r1:
            return h0 * (h1 / h0) ** (math.log(wanted / r0) / math.log(r1 / r0))
    return None


def measured_curves(bench, runs):
    curves = {}
    for scheme, (_, steps) in SCHEMES.items():
        for law in LAWS[:1] if scheme == OTHER else LAWS:
            curve = curves[f"{scheme}, {law}"] = []
            for h in steps:
                values = [bench.ratio(scheme, law, h, seed) for seed in range(1, runs + 1)]
                curve.append((h, values))
                print(f"{scheme}, {law}, {h} fs: R = {statistics.fmean(values):.3f} +- "
                      f"{statistics.stdev(values) / math.sqrt(len(values)):.3f} %", flush=True)
    return curves


def measure(options):
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(options, Path(folder))
        curves = json.loads(options.curves.read_text())["R_percent"] if options.curves else measured_curves(bench, options.runs)
        times = {f"{form}, {ranks}": [] for form in FORMS for ranks in (1, 2)}
        for _ in range(options.rounds):
            for form in FORMS:
                for ranks in (1, 2):
                    steps = 20 if form.startswith(OTHER) else 200
                    times[f"{form}, {ranks}"].append(bench.milliseconds(form, ranks, 2, steps))
        for name, values in times.items():
            print(f"{name}: {min(values):.3f} ms", flush=True)
        return {"date": str(datetime.date.today()), "processor": study.processor(), "R_percent": curves, "ms_per_step": times}


def seconds_per_ns(result, scheme, form, ranks, step):
    evaluations = SCHEMES[scheme][0]
    return min(result["ms_per_step"][f"{form}, {ranks}"]) * 1e-3 * evaluations * 1e6 / step


def curve_of(result, scheme, form):
    """(step, R) with the potential of a form."""
    return [(h, statistics.fmean(values)) for h, values in result["R_percent"][f"{scheme}, {FORMS[form][2]}"]]


def rows(result):
    """(ranks, R, scheme, form, step, s/ns) of all schemes and forms that reach R."""
    for ranks in (1, 2):
        for wanted in WANTED:
            for scheme in SCHEMES:
                for form in FORMS:
                    if form.startswith(OTHER) != (scheme == OTHER):
                        continue
                    step = step_at(curve_of(result, scheme, form), wanted)
                    if step is not None:
                        yield ranks, wanted, scheme, form, step, seconds_per_ns(result, scheme, form, ranks, step)


def report(result):
    found = list(rows(result))
    base = {}  # the fastest way of LAMMPS alone
    for ranks, wanted, scheme, _, _, seconds in found:
        if scheme == OTHER:
            base[ranks, wanted] = min(seconds, base.get((ranks, wanted), seconds))
    print("\n| ranks | R | scheme | molecules as | step | s per ns | times faster |\n| --- | --- | --- | --- | --- | --- | --- |")
    for ranks, wanted, scheme, form, step, seconds in found:
        faster = f"{base[ranks, wanted] / seconds:.1f}" if (ranks, wanted) in base else ""
        print(f"| {ranks} | {wanted:g} % | {scheme} | {form} | {step:.2f} fs | {seconds:.0f} | {faster} |")


def main():
    p = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    cost.add_programs(p, required=False)
    p.add_argument("--runs", type=int, default=4, help="of each scheme and step (4)")
    p.add_argument("--rounds", type=int, default=3, help="of timings (3)")
    p.add_argument("--curves", type=Path, help="measure times alone, with R of this result")
    p.add_argument("--output", type=Path)
    p.add_argument("--stored", type=Path, metavar="RESULT", help="only print the table of stored results; bench/figures.py draws them")
    options = p.parse_args()
    if options.stored:
        report(json.loads(options.stored.read_text(encoding="utf-8")))
        return
    result = measure(options)
    if options.output:
        options.output.write_text(json.dumps(result, indent=1) + "\n", encoding="utf-8")
    report(result)


if __name__ == "__main__":
    main()
