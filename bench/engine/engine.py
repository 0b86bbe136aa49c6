#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Performance of the engine for small to large systems: times of a force evaluation, of the neighbour list, and of a
step with its parts, by `polhode bench`; peak memory and the time to the first energies, each in a separate process."""

import argparse
import datetime
import json
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1]))
import water  # noqa: E402
from lib import runs, study  # noqa: E402

# The run whose memory use is measured: a few short steps of the water box of `polhode bench`, starting from a lattice.
RUN = {"forces": {"truncation": "molecule-switch", "cutoff": "0.9 nm", "switch": "0.765 nm", "electrostatics": "reaction-field"},
       "integrator": {"scheme": "hoa2", "step": "0.1 fs"}, "run": {"length": "1 fs", "sample": "1 fs"},
       "system": {"density": "1 g/cm3", "temperature": "297 K"}}


def arguments():
    numbers = lambda text: [int(word) for word in text.split(",")]
    words = lambda text: text.split(",")
    p = argparse.ArgumentParser(description=__doc__)
    p.add_argument("--sizes", type=numbers, help="waters (512,4096,32768,110592,884736; quick: 512,1000)")
    p.add_argument("--threads", type=numbers, default=[1, 2], help="(1,2)")
    p.add_argument("--precisions", type=words, default=["mixed", "double"], help="(mixed,double)")
    p.add_argument("--quick", action="store_true", help="small systems, short repeats")
    p.add_argument("--json", type=Path, metavar="FILE", help="write all results to this file")
    p.add_argument("--figures", type=Path, metavar="PREFIX", help="draw PREFIX-sizes.svg and PREFIX-threads.svg")
    p.add_argument("--polhode", default="polhode", dest="program", help="path of polhode")
    o = p.parse_args()
    o.sizes = o.sizes or ([512, 1000] if o.quick else [512, 4096, 32768, 110592, 884736])
    o.program = study.program(o.program)
    return o


def peak_memory(command, folder):
    """Peak memory of a process [bytes], sampled every ms during the run, because the value from wait4(2) includes the memory
    of the parent process."""
    peak = 0
    with tempfile.TemporaryFile() as complaint:
        with subprocess.Popen(command, cwd=folder, stdout=subprocess.DEVNULL, stderr=complaint) as process:
            while process.poll() is None:
                peak = max(peak, memory_of(process.pid))
                time.sleep(0.001)
        complaint.seek(0)
        if process.returncode != 0:
            sys.exit(f"'{' '.join(command)}' ended with {process.returncode}: {complaint.read().decode()}")
    return peak


def memory_of(pid):
    """Peak memory of a process so far [bytes]; 0 if the process has just ended, or if the system does not report it."""
    try:
        status = Path(f"/proc/{pid}/status").read_text(encoding="utf-8")
    except OSError:
        return 0
    found = re.search(r"VmHWM:\s*(\d+) kB", status)
    return 1024 * int(found[1]) if found else 0


def timed(o, molecules, precision):
    """The systems of `polhode bench`, one for each number of threads, and the complete report of the last call."""
    systems, report = {}, None
    for threads in [n for n in o.threads if n > 1] or [1]:
        report = runs.asked(o, "bench", "--sizes", molecules, "--precision", precision, "--threads", threads,
                            *(["--quick"] if o.quick else []), folder=".")
        for system in report["systems"]:
            systems.setdefault(system["threads"], system)
    return [systems[n] for n in o.threads if n in systems], report


def at_rest(o, molecules, precision):
    """Peak memory of a run [bytes], and seconds from the start of the program to the first energies."""
    with tempfile.TemporaryDirectory() as folder:
        run_file = water.run_file(molecules, None, **{**RUN, "forces": {**RUN["forces"], "precision": precision}})
        Path(folder, "run.toml").write_text(run_file, encoding="utf-8")
        seconds = water.spent([o.program, "energy", "run.toml"], folder)[0]
        peak = peak_memory([o.program, "run", "run.toml", "--threads", "1", "--json"], folder)
    return {"peak_bytes": peak, "bytes_per_molecule": peak / molecules, "first_energies_s": seconds}


def measured(o):
    result = {"date": datetime.date.today().isoformat(), "quick": o.quick, "limits": [], "systems": []}
    for precision in o.precisions:
        for molecules in o.sizes:
            systems, report = timed(o, molecules, precision)
            rest = at_rest(o, molecules, precision)
            result.update({key: report[key] for key in ("version", "processor", "instruction_set")})
            if molecules == o.sizes[0]:
                result["limits"] += report["limits"]
            for system in systems:
                forces = system["evaluations"][0]["forces_us"]["best"]
                system["force_ns_per_molecule"] = 1e3 * forces / molecules
                system["step_ns_per_molecule"] = 1e3 * system["steps"][0]["step_us"]["best"] / molecules
                result["systems"].append({**system, **rest})
                line(result["systems"][-1])
    return result


def line(s):
    e, step = s["evaluations"][0], s["steps"][0]
    parts = " ".join(f"{name} {100 * us / step['step_us']['best']:.0f} %" for name, us in step["parts_us"].items())
    print(f"{s['molecules']:>8} waters {s['precision']:>6} {s['threads']:>2} threads: forces "
          f"{e['forces_us']['best']:.4g} µs, {s['force_ns_per_molecule']:.4g} ns a molecule, list "
          f"{e['list_us']['best']:.4g} µs; step {step['step_us']['best']:.4g} µs: {parts}; "
          f"{s['bytes_per_molecule']:.0f} bytes a molecule, first energies after {s['first_energies_s']:.2f} s",
          flush=True)


def main():
    o = arguments()
    result = measured(o)
    if o.json:
        o.json.write_text(json.dumps(result, indent=1) + "\n", encoding="utf-8")
    if o.figures:
        import figures  # imported only here, because measurements need no matplotlib
        figures.engine(result, o.figures)


if __name__ == "__main__":
    main()
