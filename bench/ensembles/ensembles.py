# SPDX-License-Identifier: MIT
"""Whether runs sample the ensemble that they claim to, for every thermostat, barostat and hybrid Monte Carlo.

Pairs of runs at two temperatures and at two pressures: the log ratio of the densities of potential energy (or volume) has the slope
that theory gives (slopes.py). Then the same at one temperature: potential energy and pressure agree for all thermostats, hybrid
Monte Carlo and constant energy."""

import argparse
import shlex
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from datetime import date
from math import erfc, sqrt
from pathlib import Path
from resource import RUSAGE_CHILDREN, getrusage
from subprocess import PIPE, run

import numpy as np
from slopes import check, mean

for folder in ("", "liquids"):
    sys.path.append(str(Path(__file__).resolve().parents[1] / folder))
import machine  # noqa: E402
import records  # noqa: E402
import waters  # noqa: E402

TEMPERATURES = 300, 340  # [K]: potential energies of small systems overlap
STEP, SAMPLE = "4 fs", "80 fs"

RUN_FILE = """[system]
molecules = [{molecules}]
density = "{density} g/cm3"
temperature = "{temperature} K"
seed = {seed}
[forces]
precision = "mixed"
{forces}
[integrator]
scheme = "{scheme}"
step = "{step}"
[run]
equilibrate = "{equilibrate:g} ps"
length = "{length:g} ps"
sample = "{sample}"
[output]
prefix = "run"
trajectory_every = "0 ps"
plot = "none"
{tables}"""

WATER = '{ model = "spce", count = 64 }'
SHORT = 'cutoff = "0.52 nm"\nswitch = "0.46 nm"\n'  # small boxes: every law is sampled exactly, also one of short range
SYSTEMS = {
    "water, reaction field": {"molecules": WATER, "density": 0.98, "pressures": (1, 1200),
                              "forces": SHORT + 'electrostatics = "reaction-field"'},
    "water, PME": {"molecules": WATER, "density": 0.98, "pressures": (1, 1200), "forces": SHORT + 'electrostatics = "pme"'},
    "CO2": {"molecules": '{ model = "co2", count = 64 }', "density": 0.95, "pressures": (600, 1000), "compressibility": 3e-4,
            "forces": 'cutoff = "0.7 nm"\nswitch = "0.6 nm"'},
    "salt water, PME": {"molecules": '{ model = "spce", count = 58 }, { model = "na-spce", count = 3 }, { model = "cl-spce", count = 3 }',
                        "density": 1.05, "pressures": (1, 1200), "forces": SHORT + 'electrostatics = "pme"'},
}
LANGEVIN = '[thermostat]\ntype = "langevin"\nfriction = "2 1/ps"\n'
RESCALING = '[thermostat]\ntype = "{}"\ntime_constant = "0.2 ps"\n'
HYBRID = "[hybrid_monte_carlo]\nsteps = 20\n"
BAROSTAT = '[barostat]\ntype = "{}"\npressure = "{{pressure}} bar"\nevery = "80 fs"\n' \
    'compressibility = "{{compressibility}} 1/bar"\n'
RELAXATION = 'time_constant = "0.5 ps"\n'
SLOW = 'time_constant = "1 ps"\nmetropolis = false\n'  # its bias is that of the interval
METHODS = {  # name: scheme, tables, quantity
    "langevin": ("hoa2-ends", LANGEVIN, "potential"),
    "baoab": ("baoab", LANGEVIN, "potential"),
    "rescaling": ("hoa2-ends", RESCALING.format("rescaling"), "potential"),
    "separate-rescaling": ("hoa2-ends", RESCALING.format("separate-rescaling"), "potential"),
    "hybrid Monte Carlo": ("hoa2", HYBRID, "potential"),
    "langevin, cell-rescaling": ("hoa2-ends", LANGEVIN + BAROSTAT.format("cell-rescaling") + RELAXATION, "volume"),
    "langevin, cell-rescaling as published":
        ("hoa2-ends", LANGEVIN + BAROSTAT.format("cell-rescaling").replace("80 fs", "20 fs") + SLOW, "volume"),
    "rescaling, cell-rescaling":
        ("hoa2-ends", RESCALING.format("rescaling") + BAROSTAT.format("cell-rescaling") + RELAXATION, "volume"),
    "langevin, monte-carlo": ("hoa2-ends", LANGEVIN + BAROSTAT.format("monte-carlo"), "volume"),
    "hybrid Monte Carlo, monte-carlo": ("hoa2", HYBRID + BAROSTAT.format("monte-carlo"), "volume"),
}
CONSTANT_ENERGY = "constant energy"


def run_file(system, method, at, seed, o):
    scheme, tables, _ = METHODS.get(method, ("hoa2", "", None))
    s = SYSTEMS[system]
    return RUN_FILE.format(molecules=s["molecules"], density=s["density"], forces=s["forces"], temperature=at["temperature"],
                           seed=seed, scheme=scheme, step=STEP, sample=SAMPLE, equilibrate=o.equilibrate, length=o.length,
                           tables=tables.format(pressure=at["pressure"], compressibility=s.get("compressibility", 4.5e-5)))


def series(system, method, at, seed, o):
    """The samples of a run, by quantity."""
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "run.toml").write_text(run_file(system, method, at, seed, o), encoding="utf-8")
        done = run([o.program, "run", "run.toml", "--threads", "1"], cwd=folder, stdout=PIPE, stderr=PIPE, text=True, check=False)
        if done.returncode:
            raise RuntimeError(f"{system}, {method}, {at}: {done.stderr}")
        columns = {name: np.array(values) for name, values in waters.columns(Path(folder, "run-energies.csv")).items()}
    first = len(columns["time"]) // 10  # the method's own equilibration: [run] equilibrate is that of the temperature
    return {name: values[first:] for name, values in columns.items()}


def states(system, quantity):
    """The two states of a pair: temperatures for the potential energy, pressures for the volume."""
    low, high = SYSTEMS[system]["pressures"]
    if quantity == "potential":
        return [{"temperature": T, "pressure": low} for T in TEMPERATURES]
    return [{"temperature": TEMPERATURES[0], "pressure": P} for P in (low, high)]


def jobs(o):
    """Every run: (system, method, state), whose number is its seed."""
    pairs = [(s, m, at) for s in o.systems for m in o.methods for at in states(s, METHODS[m][2])]
    return pairs + [(s, CONSTANT_ENERGY, {"temperature": TEMPERATURES[0], "pressure": 0}) for s in o.systems if o.constant_energy]


def all_series(o):
    with ThreadPoolExecutor(o.runs) as pool:
        found = pool.map(lambda job: series(*job[1], seed=o.seed + job[0], o=o), enumerate(jobs(o)))
        return {(s, m, at["temperature"], at["pressure"]): x for (s, m, at), x in zip(jobs(o), found)}


def slopes(runs, o):
    """Of every pair the slope, and that of theory."""
    result = []
    for s in o.systems:
        for m in o.methods:
            quantity = METHODS[m][2]
            at = states(s, quantity)
            x = [runs[s, m, a["temperature"], a["pressure"]][quantity] for a in at]
            result.append({"system": s, "method": m, "quantity": quantity, **check(quantity, *x, *at)})
    return result


def agreement(runs, o):
    """Means of potential energy and pressure at the lower temperature, by method; of constant energy moved to it with the
    derivatives that a pair of runs gives."""
    result = []
    for s in o.systems:
        low = SYSTEMS[s]["pressures"][0]
        here = [m for m in o.methods if METHODS[m][2] == "potential"]
        for quantity in ("potential", "pressure"):
            for m in here:
                value, error = mean(runs[s, m, TEMPERATURES[0], low][quantity])
                result.append({"system": s, "method": m, "quantity": quantity, "mean": value, "error": error})
            if not o.constant_energy or not here:
                continue
            a, b = (np.mean([runs[s, m, T, low][quantity].mean() for m in here]) for T in TEMPERATURES)
            rate = (b - a) / (TEMPERATURES[1] - TEMPERATURES[0])
            x = runs[s, CONSTANT_ENERGY, TEMPERATURES[0], 0]
            value, error = mean(x[quantity] - rate * (x["temperature"] - TEMPERATURES[0]))
            result.append({"system": s, "method": CONSTANT_ENERGY, "quantity": quantity, "mean": value, "error": error})
    for group in {(r["system"], r["quantity"]) for r in result}:
        members = [r for r in result if (r["system"], r["quantity"]) == group]
        weights = np.array([r["error"] ** -2 for r in members])
        common = float(np.average([r["mean"] for r in members], weights=weights))
        for r, w in zip(members, weights):
            # The common mean contains this one: the variance of their difference is less by its own.
            r["deviation"] = (r["mean"] - common) / sqrt(max(1 / w - 1 / weights.sum(), 1e-300)) if len(members) > 1 else 0.0
    return result


def tables(result):
    rows = ["| system | thermostat, barostat | of | slope | expected | deviation [standard errors] |", "| --- | --- | --- | --- | --- | --- |"]
    rows += [f"| {r['system']} | {r['method']} | {r['quantity']} | {r['slope']:.5g} ± {r['error']:.2g} | {r['expected']:.5g} | {r['deviation']:+.2f} |"
             for r in result["slopes"]]
    z = np.array([r["deviation"] for r in result["slopes"]])
    beyond = sum(abs(z) > 2)
    rows += ["", f"{len(z)} pairs: rms deviation {np.sqrt(np.mean(z ** 2)):.2f}, largest {abs(z).max():.2f}; {beyond} beyond 2 standard errors, "
                 f"where chance gives {len(z) * erfc(sqrt(2)):.1f}.", ""]
    rows += [f"| system | at {TEMPERATURES[0]} K | potential energy [kJ/mol] | pressure [bar] |", "| --- | --- | --- | --- |"]
    of = {(r["system"], r["method"], r["quantity"]): r for r in result["agreement"]}
    for s, m in dict.fromkeys((r["system"], r["method"]) for r in result["agreement"]):
        U, P = of[s, m, "potential"], of[s, m, "pressure"]
        rows.append(f"| {s} | {m} | {U['mean']:.2f} ± {U['error']:.2f} ({U['deviation']:+.1f}) | {P['mean']:.0f} ± {P['error']:.0f} ({P['deviation']:+.1f}) |")
    return "\n".join(rows) + "\n"


def command(o):
    """What repeats the runs: all options that results depend on."""
    chosen = lambda option, names, of: [option, *map(shlex.quote, names)] if set(names) != set(of) else []
    return " ".join(["bench/ensembles/ensembles.py", *chosen("--systems", o.systems, SYSTEMS), *chosen("--methods", o.methods, METHODS),
                     *([] if o.constant_energy else ["--no-constant-energy"]), f"--equilibrate {o.equilibrate:g} --length {o.length:g} --seed {o.seed}"])


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", default="polhode", help="path of polhode")
    parser.add_argument("--systems", nargs="+", default=list(SYSTEMS), choices=SYSTEMS)
    parser.add_argument("--methods", nargs="+", default=list(METHODS), choices=METHODS)
    parser.add_argument("--constant-energy", action=argparse.BooleanOptionalAction, default=True)
    parser.add_argument("--length", type=float, default=400, help="length of each run [ps]")
    parser.add_argument("--equilibrate", type=float, default=10, help="time of rescaling before each run [ps]")
    parser.add_argument("--seed", type=int, default=1, help="of the first run")
    parser.add_argument("--runs", type=int, default=1, help="runs at a time")
    parser.add_argument("--series", type=Path, help="also write the samples of all runs, as an .npz file")
    parser.add_argument("--output", type=Path, default=Path(f"{date.today()}-ensembles"))
    o = parser.parse_args()
    o.program = machine.program(o.program)
    runs = all_series(o)
    if o.series:
        np.savez_compressed(o.series, **{" | ".join(map(str, [*key, name])): x for key, columns in runs.items()
                                         for name, x in columns.items() if name in ("potential", "volume", "pressure", "kinetic_translation")})
    result = {"machine": machine.processor(), "date": str(date.today()), "command": command(o), "length_ps": o.length, "seed": o.seed,
              "user_cpu_s": round(getrusage(RUSAGE_CHILDREN).ru_utime), "slopes": slopes(runs, o), "agreement": agreement(runs, o)}
    records.write(Path(f"{o.output}.json"), result)
    Path(f"{o.output}.md").write_text(
        f"# {date.today()}, {machine.processor()}: ensembles\n\n`{command(o)}`, "
        f"{result['user_cpu_s']} s of user CPU time\n\n{tables(result)}", encoding="utf-8")
    print(tables(result))


if __name__ == "__main__":
    main()
