#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The error of the step in rigid water: temperatures, energy, pressure and density against the step, for many schemes.

Every run adds a line to a record; a study that was interrupted, or is given more runs, continues where the record ends."""

import argparse
import json
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import points
import properties
import tables

sys.path.append(str(Path(__file__).resolve().parents[1]))
import machine  # noqa: E402

ENERGIES = ("potential_kJ_per_mol", "temperature_K", "temperature_translation_K", "temperature_rotation_K", "pressure_bar", "R",
            "temperature_configurational_K", "step_bias", "half_steps", "force_evaluations", "degrees_of_freedom_rotation")


GROUPS = ["energy", "starts", "canonical", "friction", "properties", "structure", "compression", "density"]


def arguments():
    p = argparse.ArgumentParser(description=__doc__)
    p.add_argument("--polhode", default="polhode", help="path of polhode")
    p.add_argument("--record", type=Path, default=Path("half-femtosecond.jsonl"), help="a line for each run (half-femtosecond.jsonl)")
    p.add_argument("--groups", type=lambda text: text.split(","), default=GROUPS, help=f"any of {','.join(GROUPS)}; default: all")
    p.add_argument("--runs", type=int, default=4, help="of each point (4)")
    p.add_argument("--jobs", type=int, default=2, help="simultaneous runs (2)")
    p.add_argument("--quick", action="store_true", help="constant energy alone, short runs: a few minutes")
    p.add_argument("--report", action="store_true", help="only print the tables of the record")
    o = p.parse_args()
    o.groups = ["quick"] if o.quick else o.groups
    o.polhode = machine.program(o.polhode)
    return o


def key(point, seed):
    return json.dumps([*point, seed])


def known(record):
    """The lines of a record by their keys."""
    if not record.exists():
        return {}
    lines = record.read_text(encoding="utf-8").splitlines()
    return {json.dumps([*line["point"], line["seed"]]): line for line in map(json.loads, lines)}


def analysis(program, folder, energies):
    """g(r) and dielectric constant; with the energies also the bias of the step."""
    done = subprocess.run([program, "analyze", "run-trajectory.trr", "--run", "run.toml", "--names", "run-final.gro", *energies,
                           "--what", "rdf,dielectric", "--pairs", "OW-OW, OW-HW", "--cutoff", "0.6 nm", "--plot", "none", "--threads", "1", "--json"],
                          cwd=folder, text=True, capture_output=True, check=True)
    report = json.loads(done.stdout)
    return {"rdf": report["rdf"], "dielectric": report["dielectric"], "frames": report["frames"],
            "notes": report["notes"]}


def run(program, point, seed):
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "run.toml").write_text(points.run_file(point, seed), encoding="utf-8")
        done = subprocess.run([program, "run", "run.toml", "--threads", "1", "--json"], cwd=folder, text=True, capture_output=True, check=False)
        if done.returncode:
            raise RuntimeError(f"{point}, seed {seed}: {done.stderr}")
        report = json.loads(done.stdout)
        energies = {"properties": ["--energies", "run-energies.csv"], "structure": []}
        found = analysis(program, folder, energies[point.group]) if point.group in energies else None
    line = {"point": list(point), "seed": seed, **{name: report.get(name) for name in ENERGIES}, "seconds": report["seconds"]["all"]}
    if found:
        line["analysis"] = found
    if report["ensemble"] and report["ensemble"]["barostat"]:
        line.update({name: report["ensemble"]["barostat"][name] for name in ("density_kg_per_m3", "volume_nm3", "compressibility_per_bar")})
    return line


def complete(o, lines):
    """Makes the runs that the record lacks, the first of all points before the second."""
    jobs = [(point, seed) for seed in range(1, o.runs + 1) for point in points.points(o.quick)
            if point.group in o.groups and key(point, seed) not in lines]
    with ThreadPoolExecutor(o.jobs) as pool, o.record.open("a", encoding="utf-8") as record:
        for (point, seed), line in zip(jobs, pool.map(lambda job: run(o.polhode, *job), jobs)):
            lines[key(point, seed)] = line
            print(json.dumps(line), file=record, flush=True)
            print(f"{len(lines)}: {point.ensemble}, {point.scheme} {point.step:g} fs, {point.temperature:g} K, run {seed}", file=sys.stderr, flush=True)


def report(lines):
    """The tables of the groups that have runs."""
    points = tables.by_point(lines)
    of = lambda *groups: {p: runs for p, runs in points.items() if p.group in groups}
    several = of("density") if len({p.temperature for p in of("density")}) > 3 else {}
    parts = []
    for title, make, chosen in (("Constant energy", tables.constant_energy, of("energy", "quick")),
                                ("Force evaluations per ps for a required bias", tables.costs, of("energy", "quick")),
                                ("Starts", properties.starts, of("starts")), ("Constant temperature", tables.controlled, of("canonical")),
                                ("Friction", properties.friction, of("friction")), ("Structure", properties.structure, of("properties")),
                                ("Structure with Langevin thermostats", properties.structure_seen, of("structure")),
                                ("Compressibility", properties.compressibilities, of("compression")),
                                ("Compressibility from volumes", properties.from_volumes, of("density")),
                                ("Density", tables.densities, of("density")), ("Temperature of maximum density", tables.maxima, several)):
        if chosen:
            parts += [f"### {title}\n", make(chosen)]
    return "\n".join(parts)


def main():
    o = arguments()
    lines = known(o.record)
    if not o.report:
        complete(o, lines)
    print(report([line for line in lines.values() if line["point"][0] in o.groups]))


if __name__ == "__main__":
    main()
