#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compares polhode with GROMACS, LAMMPS and OpenMM for the same rigid water. The time per step and R are measured. Both
give the wall-clock seconds per nanosecond at a required R. README.md describes the method, and the remaining
differences."""

import argparse
import datetime
import os
import shlex
import shutil
import sys
import tempfile
from math import isfinite
from pathlib import Path

import curves
import engines
import gro

ROOT = Path(__file__).resolve().parents[2]
sys.path += [str(ROOT / "bench"), str(ROOT / "studies")]
from lib import study  # noqa: E402

TARGETS = (1.5, 0.4, 0.1)  # R [%]
SCANNED = 512  # molecules in the runs for R, which does not depend on the number of molecules
INTERVAL = 4.0  # [fs], largest interval between energies unless the step is longer


def arguments():
    numbers = lambda text: [int(word) for word in text.split(",")]
    words = lambda text: [word for word in text.split(",") if word]
    p = argparse.ArgumentParser(description=__doc__)
    p.add_argument("--sizes", type=numbers, default=[512, 4096], help="molecules, 512 n³ (512,4096)")
    p.add_argument("--threads", type=numbers, default=[1, 2], help="(1,2)")
    p.add_argument("--peers", type=words, default=["gromacs", "lammps", "openmm"],
                   help="of gromacs, gromacs-md, gromacs-double, gromacs-pme, lammps, lammps-pppm, openmm, "
                        "openmm-pme; the first of each three by default")
    p.add_argument("--quick", action="store_true",
                   help="shorter runs, every other step of the ladders, times at one step only")
    p.add_argument("--rounds", type=int, help="rounds of alternating timed runs (5, quick: 3)")
    p.add_argument("--seconds", type=float, help="length of a timed run [s] (3, quick: 1)")
    p.add_argument("--scan-length", type=float, help="length of a run for R [ps] (10, quick: 2)")
    p.add_argument("--cutoff", type=float, default=0.9, help="nm (0.9)")
    p.add_argument("--switch", type=float, default=0.765, help="nm, where switches begin (0.765)")
    p.add_argument("--json", type=Path, metavar="FILE", help="write all results to this file")
    p.add_argument("--figure", type=Path, metavar="FILE", help="draw FILE.svg, or .png")
    p.add_argument("--polhode", default="polhode", help="path of polhode")
    p.add_argument("--truncation", default="molecule-switch", help="truncation of polhode, as in run files (molecule-switch)")
    p.add_argument("--precision", default="", help="precision of polhode, double or mixed; default: that of run files")
    p.add_argument("--polhode-threads", action="store_true",
                   help="run polhode with --threads N; default: one thread")
    p.add_argument("--gmx", default="gmx", help="another GROMACS")
    p.add_argument("--gmx-double", default="gmx_d", help="another GROMACS in double precision")
    p.add_argument("--gromacs-tolerance", type=float, default=1e-4,
                   help="verlet-buffer-tolerance, kJ/mol/ps (1e-4); -1: 0.1 nm of buffer for 20 fs")
    p.add_argument("--lmp", default="lmp", help="another LAMMPS")
    p.add_argument("--openmm-python", help="a Python that has OpenMM (this one)")
    o = p.parse_args()
    o.rounds = o.rounds or (3 if o.quick else 5)
    o.seconds = o.seconds or (1.0 if o.quick else 3.0)
    o.scan_length = o.scan_length or (2.0 if o.quick else 10.0)
    if not shutil.which(o.polhode) and (ROOT / "polhode").exists():
        o.polhode = str(ROOT / "polhode")
    for key in ("polhode", "gmx", "gmx_double", "lmp", "openmm_python"):
        if "/" in (getattr(o, key) or ""):  # the programs run in their own folders
            setattr(o, key, os.path.abspath(getattr(o, key)))
    return o


def start_of(molecules):
    """W512 replicated to this number of molecules."""
    text = (ROOT / "data/start/w512.gro").read_text(encoding="utf-8")
    times = round((molecules / SCANNED) ** (1 / 3))
    if SCANNED * times**3 != molecules:
        sys.exit(f"{molecules} molecules are not 512 n³; write for example --sizes 512,4096,32768")
    return gro.replicated(gro.read(text), times)


def scan(programs, case, options):
    """R of each engine at its list of steps, with engines interleaved, and the potential energy of the initial configuration in each engine."""
    points, potential = {e.name: [] for e in programs}, {}
    skipped = options.scan_length / 10
    print(f"\nR of {case.molecules} molecules, {options.scan_length:g} ps after {skipped:g} ps; V: kJ/mol a "
          "molecule, of the start and its mean; drift: of the kinetic energy\n\n"
          f"{'':24}{'step':>7}{'R':>10}{'':>9}{'drift':>9}{'T':>8}{'V start':>10}{'mean':>9}\n"
          f"{'':24}{'fs':>7}{'%':>10}{'+-':>9}{'%/ns':>9}{'K':>8}")
    for rung in range(max(len(e.ladder) for e in programs)):
        for e in programs:
            if rung >= len(e.ladder) or (options.quick and rung % 2):
                continue
            step = e.ladder[rung]
            interval = step * engines.steps_between(INTERVAL, step)
            try:
                samples = e.samples(case, step, 1100 * options.scan_length, INTERVAL)
            except RuntimeError as error:
                print(f"{e.name:24}{step:7g}  {engines.complaint(error)}", flush=True)
                samples = []
            p = curves.point(step, samples[int(1000 * skipped / interval):], interval)
            points[e.name].append(p)
            if samples:
                first = potential.setdefault(e.name, samples[0].potential / case.molecules)
                print(f"{e.name:24}{step:7g}{100 * p.ratio:10.4f}{100 * p.error:9.4f}{100 * p.drift:9.2f}"
                      f"{p.temperature:8.1f}{first:10.3f}{p.potential / case.molecules:9.3f}"
                      f"{'' if p.usable else '  not usable'}", flush=True)
    return points, potential


def times(programs, case, threads, steps, options):
    """Microseconds per step of each engine at each of its steps, in interleaved rounds: median and spread."""
    runs = [(e, h) for e in programs for h in steps[e.name]]
    counts, found = {}, {(e.name, h): [] for e, h in runs}
    for turn in range(1 + options.rounds):
        for e, h in runs:
            key = e.name, h
            if key not in found:
                continue
            try:
                us = e.step_us(case, h, counts.get(key, 20), e.threads(threads))
            except RuntimeError as error:
                print(f"{e.name} at {h:.3g} fs is left out: {engines.complaint(error)}", flush=True)
                del found[key]
                continue
            if turn == 0:  # a short run determines how many steps fill the time
                counts[key] = max(20, round(options.seconds * 1e6 / us))
            else:
                found[key].append(us)
    return {key: curves.middle(values) for key, values in found.items()}


def report_times(programs, molecules, threads, measured):
    """Prints the table of times and returns its rows."""
    rows = []
    print(f"\nTime of {molecules} molecules, {threads} thread{'s' * (threads > 1)}\n\n"
          f"{'':24}{'step':>7}{'us/step':>11}{'+-':>7}{'us/force':>11}{'ns/day':>9}")
    for e in programs:
        for (name, h), (us, spread) in measured.items():
            if name != e.name:
                continue
            used = e.threads(threads)
            rows.append({"engine": name, "molecules": molecules, "threads": threads, "threads_used": used,
                         "step_fs": h, "step_us": us, "half_range": spread, "force_evaluation_us": us / e.evaluations,
                         "ns_per_day": curves.ns_per_day(us, h)})
            print(f"{name:24}{h:7.3g}{us:11.1f}{100 * spread:6.1f}%{us / e.evaluations:11.1f}"
                  f"{curves.ns_per_day(us, h):9.2f}{'' if used == threads else '  with one thread'}", flush=True)
    return rows


def costs(programs, reached, measured, molecules, threads):
    """Seconds per nanosecond at each R, and their ratio to the cheapest polhode scheme: rows, printed as a table."""
    rows = []
    print(f"\nSeconds a nanosecond at R, {molecules} molecules, {threads} thread{'s' * (threads > 1)}; in "
          "brackets over the cheapest of ours\n\n" + f"{'':24}" + "".join(f"{f'{t} %':>22}" for t in TARGETS))
    for e in programs:
        for target in TARGETS:
            step, mark = reached[e.name][target]
            seconds = None
            timed = [h for name, h in measured if name == e.name]
            if step is not None and timed:
                at = min(timed, key=lambda h: abs(h / step - 1))
                seconds = curves.seconds_per_ns(measured[e.name, at][0], step)
            rows.append({"engine": e.name, "molecules": molecules, "threads": threads, "R_percent": target,
                         "step_fs": step, "mark": mark or ("" if seconds else "not timed"), "seconds_per_ns": seconds})
    for row in rows:
        ours = [r["seconds_per_ns"] for r in rows
                if r["R_percent"] == row["R_percent"] and r["engine"].startswith("polhode") and r["seconds_per_ns"]]
        row["over_ours"] = row["seconds_per_ns"] / min(ours) if ours and row["seconds_per_ns"] else None
    for e in programs:
        cells = [(f"{r['seconds_per_ns']:.4g}{r['mark']} ({r['over_ours']:.2f})" if r["over_ours"]
                  else f"{r['seconds_per_ns']:.4g}{r['mark']}" if r["seconds_per_ns"] else r["mark"])
                 for r in rows if r["engine"] == e.name]
        print(f"{e.name:24}" + "".join(f"{c:>22}" for c in cells))
    return rows


def available(options):
    ours, peers = engines.engines(options)
    here = []
    for e in ours + peers:
        reason = e.missing()
        print(f"{e.name}: skipped, {reason}" if reason else f"{e.name}: {e.version()}")
        here += [] if reason else [e]
    return here


def main():
    options = arguments()
    programs = available(options)
    if not programs:
        sys.exit("none of the programs is here")
    load = os.getloadavg()[0]
    if load > 0.5:
        print(f"warning: the load average is {load:.1f}; other work makes these times too long, unevenly")
    versions = {e.name: e.version() for e in programs}
    result = {"date": str(datetime.date.today()), "command": shlex.join(["peers.py", *sys.argv[1:]]),
              "processor": study.processor(), "cores": os.cpu_count(), "load_average": load, "versions": versions,
              "options": {k: v for k, v in vars(options).items() if isinstance(v, (int, float, str, list))},
              "R": {}, "times": [], "costs": []}
    with tempfile.TemporaryDirectory() as scratch:
        case = lambda n: engines.Case(start_of(n), Path(scratch) / str(n), options.cutoff, options.switch)
        cases = {n: case(n) for n in dict.fromkeys([SCANNED, *options.sizes])}
        points, potential = scan(programs, cases[SCANNED], options)
        result["potential_of_start"] = potential
        result["R"] = {name: [{k: v if isfinite(v) else None for k, v in p._asdict().items()} for p in ps]
                       for name, ps in points.items()}
        result["gromacs_lists"] = {e.name: e.lists for e in programs if hasattr(e, "lists")}
        reached = {name: {t: curves.step_at(t / 100, ps) for t in TARGETS} for name, ps in points.items()}
        for n in options.sizes:
            for threads in options.threads:
                steps = {e.name: [e.start_step] for e in programs}
                if not options.quick:
                    for e in programs:
                        met = [h for h, _ in reached[e.name].values() if h]
                        steps[e.name] = list(dict.fromkeys([e.start_step, *met]))
                measured = times(programs, cases[n], threads, steps, options)
                result["times"] += report_times(programs, n, threads, measured)
                result["costs"] += costs(programs, reached, measured, n, threads)
    if options.json:
        study.write(options.json, result)
    if options.figure:
        import figures  # imported only here, because measurements need no matplotlib
        figures.peers(result, options.figure)


if __name__ == "__main__":
    main()
