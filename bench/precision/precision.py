# SPDX-License-Identifier: MIT
"""R in mixed and in double precision: against the step from the same initial configurations, and against the length of a run."""

import argparse
import csv
import json
import subprocess
import sys
import tempfile
from datetime import date
from math import sqrt
from pathlib import Path
from statistics import fmean, pvariance
from typing import NamedTuple

import figure  # to find the modules shared by the benchmarks
import machine
import records

RUN_FILE = """[system]
molecules = [{{ model = "tip4p" }}]
initial_configuration = "{start}"
[forces]
electrostatics = "{electrostatics}"
[integrator]
scheme = "{scheme}"
step = "{step:g} fs"
{lam}
[run]
length = "{length:g} ps"
sample = "{sample:g} fs"
[output]
prefix = "{prefix}"
trajectory_every = "0 ps"
plot = "none"
"""
SAMPLE = 2.0  # [fs]
LONG = (("gier4-fd", 1), ("hoa2", 3))  # the truncation error of the first is far below rounding


class Case(NamedTuple):
    """A curve: R against the step."""
    scheme: str
    precision: str
    lam: float | None = None  # the default of the program if None
    electrostatics: str = "coulomb"

    @property
    def name(self):
        parts = [self.scheme, self.precision]
        if self.lam:
            parts.append(f"lambda {self.lam:g}")
        if self.electrostatics != "coulomb":
            parts.append(self.electrostatics)
        return ", ".join(parts)


def run(program, folder, case, start, step, length):
    """The summary of one run, and the total energies of its samples [(ps, kJ/mol)]."""
    lam = f"lambda = {case.lam:g}" if case.lam else ""
    prefix = folder / "run"
    (folder / "run.toml").write_text(RUN_FILE.format(
        start=start, electrostatics=case.electrostatics, scheme=case.scheme, step=step, lam=lam,
        length=length, sample=max(SAMPLE, step), prefix=prefix), encoding="utf-8")
    command = [program, "run", str(folder / "run.toml"), "--precision", case.precision, "--threads", "1",
               "--force", "--json"]
    summary = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
    energies = []
    for line in Path(f"{prefix}-energies.csv").read_text(encoding="utf-8").splitlines():
        if line[:1].isdigit():
            time, total = line.split(",")[:2]
            energies.append((float(time), float(total)))
    return summary, energies


def prepared(program, folder, count):
    """Initial configurations from a run in double precision, 1 ps apart."""
    starts, last = [], "w512"
    for k in range(count):
        run(program, folder, Case("hoa2", "double"), last, 2, 1)
        last = folder / f"start{k}.gro"
        (folder / "run-final.gro").rename(last)
        starts.append(last)
    return starts


def windows(energies, length):
    """Mean variance of E about its mean in consecutive windows of a given length [ps]."""
    count = max(1, int(energies[-1][0] / length + 1e-6))
    return fmean(pvariance([e for t, e in energies if k * length <= t < (k + 1) * length]) for k in range(count))


def increments(energies, length):
    """Mean square change of the mean of E from one block to the next, and the number of samples in a block."""
    count = int(energies[-1][0] / length + 1e-6)
    parts = [[e for t, e in energies if k * length <= t < (k + 1) * length] for k in range(count)]
    means = [fmean(p) for p in parts]
    return fmean((y - x) ** 2 for x, y in zip(means, means[1:])), len(parts[0])


def fitted_reading(rows):
    """a of var E = a² + c² h t Σw²/6 [kJ/mol]: what mixed precision adds to double where rounding dominates, at λ = 1."""
    found = []
    for scheme, step in sorted({(r["scheme"], r["step_fs"]) for r in rows}):
        own = [r for r in rows if r["scheme"] == scheme and r["step_fs"] == step and r["lambda"] == ""
               and r["electrostatics"] == "coulomb" and r["kind"] == "short"]
        mixed, double = (fmean([r["rms_total"] ** 2 for r in own if r["precision"] == p] or [0])
                         for p in ("mixed", "double"))
        if mixed > 4 * double:
            found.append({"scheme": scheme, "step_fs": step, "a": sqrt(mixed - double)})
    return found


def fitted_walk(mixed, double, step, weights, reading, block):
    """c [kJ/mol/ps] from the means of E over blocks of a long run: a random walk of variance D t changes them by 2 D block/3
    from one to the next, sampling of n energies by 2 a²/n."""
    change, n = increments(mixed, block)
    left = change - increments(double, block)[0] - 2 * reading**2 / n
    return sqrt(max(0.0, left) * 1.5 / block / (step * 1e-3 * weights))


def row(kind, case, step, length, start, summary):
    return {"kind": kind, "electrostatics": case.electrostatics, "scheme": case.scheme,
            "lambda": case.lam or "", "precision": case.precision, "step_fs": step, "length_ps": length,
            "start": start, "R": summary["R"], "rms_total": summary["rms_total_kJ_per_mol"],
            "rms_potential": summary["rms_potential_kJ_per_mol"],
            "drift": summary["drift_kJ_per_mol_ps"], "R_rounding": summary.get("R_rounding", "")}


def measured(o, folder):
    """Short runs for the ladders of steps, and long ones with their energies."""
    starts = prepared(o.polhode, folder, 1 if o.quick else o.starts)
    length = 0.5 if o.quick else o.length
    ladders = [(Case(s, p), [1, 2, 4] if o.quick else [0.5, 1, 2, 3, 4] + [5] * (s == "gier4-fd"))
               for s in ("gier4-fd", "hoa2", "velocity-verlet") for p in ("mixed", "double")]
    others = [1, 4] if o.quick else [1, 2, 3, 4, 5]
    ladders += [(Case("gier4-fd", "mixed", 0.1), others), (Case("gier4-fd", "double", 1), others)]
    ladders += [(Case("gier4-fd", p, None, "reaction-field"), [1, 3]) for p in ("mixed", "double")]
    rows, growth = [], []
    for case, steps in ladders:
        own = starts if case.electrostatics == "coulomb" and not case.lam else starts[:1]
        for step in steps:
            for k, start in enumerate(own):
                summary, _ = run(o.polhode, folder, case, start, step, length)
                rows.append(row("short", case, step, length, k, summary))
            print(f"{case.name:40} {step:5g} fs  R {100 * fmean(r['R'] for r in rows[-len(own):]):.3g} %", flush=True)
    long = 2 if o.quick else o.long
    kept = {}
    for scheme, step in LONG:
        for precision in ("mixed", "double"):
            case = Case(scheme, precision)
            summary, energies = run(o.polhode, folder, case, starts[0], step, long)
            kept[scheme, step, precision] = energies
            rows.append(row("long", case, step, long, 0, summary))
            t = 0.25
            while t <= long:
                growth.append({"scheme": scheme, "precision": precision, "step_fs": step, "window_ps": t,
                               "rms_total": sqrt(windows(energies, t)),
                               "rms_potential": summary["rms_potential_kJ_per_mol"]})
                t *= 2
            print(f"{case.name:40} {step:5g} fs, {long:g} ps  R {100 * summary['R']:.3g} %", flush=True)
    return rows, growth, kept


def write_csv(path, rows, head):
    with open(path, "w", encoding="utf-8", newline="") as out:
        out.write("".join(f"# {line}\n" for line in head))
        table = csv.DictWriter(out, rows[0].keys(), lineterminator="\n")
        table.writeheader()
        table.writerows({k: f"{v:.6g}" if isinstance(v, float) else v for k, v in r.items()} for r in rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--polhode", default="polhode", help="path of polhode")
    parser.add_argument("--quick", action="store_true", help="one initial configuration, short runs, fewer steps: half a minute")
    parser.add_argument("--starts", type=int, default=2)
    parser.add_argument("--length", type=float, default=2, help="length of the short runs [ps]")
    parser.add_argument("--long", type=float, default=16, help="length of the long runs [ps]")
    parser.add_argument("--output", default="precision", help="prefix of the CSV and JSON files")
    parser.add_argument("--figure", help="SVG or PNG")
    o = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        rows, growth, kept = measured(o, Path(folder))
    found = fitted_reading(rows)
    for f in found:
        print(f"a from {f['scheme']} at {f['step_fs']:g} fs: {f['a']:.3g} kJ/mol")
    reading = sqrt(fmean(f["a"] ** 2 for f in found)) if found else 0.0
    scheme, step = LONG[0]
    c = fitted_walk(kept[scheme, step, "mixed"], kept[scheme, step, "double"], step, figure.WEIGHTS[scheme], reading,
                    0.25 if o.quick else 1)
    print(f"a {reading:.3g} kJ/mol, c {c:.3g} kJ/mol/ps" if c > 0 else
          f"a {reading:.3g} kJ/mol; the long runs are too short to see the walk")
    told = "bench/precision/precision.py " + (
        "--quick" if o.quick else f"--starts {o.starts} --length {o.length:g} --long {o.long:g}")
    head = [f"{date.today()}, {machine.processor()}, one thread", told]
    write_csv(f"{o.output}.csv", rows, head)
    write_csv(f"{o.output}-growth.csv", growth, [*head, f"a {reading:.4g} kJ/mol, c {c:.4g} kJ/mol/ps"])
    result = {"conditions": head, "runs": rows, "growth": growth, "weights": figure.WEIGHTS,
              "a_kJ_per_mol": reading, "a_of": found, "c_kJ_per_mol_ps": c}
    records.write(Path(f"{o.output}.json"), result)
    if o.figure:
        figure.draw(result, Path(o.figure))


if __name__ == "__main__":
    main()
