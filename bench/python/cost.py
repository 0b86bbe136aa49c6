#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The cost of the Python package compared with the program: the time of a step, of a view and of the import, and memory that is not freed.

    bench/python/cost.py --polhode ./polhode     # by a Python in which the package is installed

The system is 512 TIP4P waters in mixed and double precision on one thread, in alternating runs of program and package. Times of steps are
processor times. For the program they are the difference of two runs of different lengths. The ratio of the two times in
a round hardly depends on other load of the computer. Medians over the rounds are printed, with minimum and maximum.
"""

import argparse
import datetime
import gc
import platform
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np
import polhode

sys.path.append(str(Path(__file__).resolve().parents[2] / "studies"))
from lib import study  # noqa: E402

SHORT = 20  # steps of the shorter run of the program
STEP = 2  # [fs]


def settings(precision, steps):
    return polhode.settings(molecules="tip4p", count=512, initial_configuration="w512", temperature="297 K",
                            scheme="velocity-verlet", step=f"{STEP} fs", precision=precision,
                            run={"length": f"{STEP * steps} fs", "sample": "200 fs", "shadow_sample": "0 fs"},
                            output={"prefix": "out", "trajectory_every": "0 ps", "plot": "none"})


def program_time(program, precision, steps, folder):
    """Processor time of a run by the program [s]."""
    Path(folder, "run.toml").write_text(settings(precision, steps).text, encoding="utf-8")
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([program, "run", "run.toml", "--force", "--threads", "1"], cwd=folder, check=True, capture_output=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def package_time(work):
    begin = time.process_time()
    work()
    return time.process_time() - begin


def whole_run(simulation, steps):
    simulation.run(f"{STEP * steps} fs")


def observed(simulation, steps):
    simulation.run(f"{STEP * steps} fs", observe=lambda s: s.state.positions.mean(axis=0), every=f"{STEP} fs")


def loop(simulation, steps):
    for _ in range(steps):
        simulation.step()
        simulation.state.positions.mean(axis=0)


WAYS = {".run(length)": whole_run, ".run, observer at each step": observed, "loop of .step(), positions read": loop}


def steps_table(options, folder):
    program = study.program(options.polhode)
    print("| precision | | µs per step | time of the program / this time |\n| --- | --- | --- | --- |")
    for precision in ("mixed", "double"):
        simulations = [polhode.Simulation(settings(precision, options.steps), threads=1) for _ in WAYS]
        for simulation in simulations:
            simulation.step(SHORT)
        times = {way: [] for way in ("program", *WAYS)}
        for _ in range(options.rounds):
            both = [program_time(program, precision, n, folder) for n in (SHORT, SHORT + options.steps)]
            times["program"].append(both[1] - both[0])
            for simulation, (way, work) in zip(simulations, WAYS.items()):
                times[way].append(package_time(lambda s=simulation, w=work: w(s, options.steps)))
        for way, measured in times.items():
            ratios = sorted(p / t for p, t in zip(times["program"], measured))
            print(f"| {precision} | {way} | {1e6 * statistics.median(measured) / options.steps:.1f} | "
                  f"{statistics.median(ratios):.3f} ({ratios[0]:.3f} to {ratios[-1]:.3f}) |", flush=True)


def view_times():
    print("\n| molecules | µs per view | the array has memory of its own |\n| --- | --- | --- |")
    for molecules in (1000, 1_000_000):
        simulation = polhode.Simulation(molecules="argon", count=molecules, density="1.4 g/cm3")
        measured = []
        for _ in range(1000):
            begin = time.perf_counter()
            view = simulation.state.positions
            measured.append(time.perf_counter() - begin)
        print(f"| {molecules} | {1e6 * statistics.median(measured):.2f} | {'yes' if view.flags.owndata else 'no'} |", flush=True)


def import_times(rounds):
    def seconds(code):
        begin = time.perf_counter()
        subprocess.run([sys.executable, "-c", code], check=True)
        return time.perf_counter() - begin

    print("\n| Python that | s, median | longest |\n| --- | --- | --- |")
    rows = {"does nothing": "pass", "imports numpy": "import numpy", "imports polhode": "import polhode"}
    measured = {name: [] for name in rows}
    for _ in range(rounds):
        for name, code in rows.items():
            measured[name].append(seconds(code))
    for name, times in measured.items():
        print(f"| {name} | {statistics.median(times):.3f} | {max(times):.3f} |", flush=True)


def resident():
    gc.collect()
    return int(Path("/proc/self/statm").read_text().split()[1]) * resource.getpagesize()


def memory(simulations):
    """Memory growth of simulations that are created, advanced and dropped: kB after all of them minus kB after the first hundred."""
    state = 0
    for k in range(100 + simulations):
        if k == 100:
            before = resident()
        simulation = polhode.Simulation(molecules="argon", count=1000, density="1 g/cm3", seed=k, threads=1)
        view = simulation.state.positions
        simulation.step()
        state = sum(a.nbytes for a in (view, simulation.state.momenta, simulation.state.orientations, simulation.state.angular_momenta))
    print(f"\nafter {simulations} simulations of 1000 atoms {(resident() - before) / 1024:.0f} kB more than after the first hundred; "
          f"the state of one has {state / 1024:.0f} kB", flush=True)


def main():
    p = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    p.add_argument("--polhode", default="polhode", help="the program")
    p.add_argument("--rounds", type=int, default=15)
    p.add_argument("--steps", type=int, default=2000)
    p.add_argument("--simulations", type=int, default=10_000)
    options = p.parse_args()
    print(f"{datetime.date.today()}, {study.processor()}, {polhode.instruction_set()}, Python {platform.python_version()}, "
          f"NumPy {np.__version__}\n")
    with tempfile.TemporaryDirectory() as folder:
        steps_table(options, folder)
    import_times(options.rounds)
    view_times()
    memory(options.simulations)


if __name__ == "__main__":
    main()
