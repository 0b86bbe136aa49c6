# SPDX-License-Identifier: MIT
"""Whether all thermostats, hybrid Monte Carlo and constant energy agree for short steps: potential energy, pressure and first peak
of g(r) of water, as a table in Markdown.

The run at constant energy begins from the last state of another one, whose velocities are scaled once, so that its total energy is
the mean one at the temperature. Runs are kept in --folder; what is there already is not run again."""

import argparse
import json
import sys
from math import sqrt
from pathlib import Path
from subprocess import PIPE, run
from typing import NamedTuple

import numpy as np
from slopes import BOLTZMANN

for folder in ("", "liquids"):
    sys.path.append(str(Path(__file__).resolve().parents[1] / folder))
import machine  # noqa: E402
import waters  # noqa: E402

TEMPERATURE = 300  # [K]
SKIPPED = 10  # at the beginning of each run [ps]
BLOCK = 10  # several relaxation times of potential energy and pressure [ps]
LANGEVIN = '[thermostat]\ntype = "langevin"\nfriction = "2 1/ps"\n'
RESCALING = '[thermostat]\ntype = "{}"\ntime_constant = "0.2 ps"\n'


class Method(NamedTuple):
    name: str
    scheme: str
    step: float  # [fs]
    tables: str = ""


METHODS = (
    Method("Langevin at the ends", "obabo", 1, LANGEVIN),
    Method("Langevin in the middle", "baoab", 2, LANGEVIN),
    Method("rescaling", "hoa2-ends", 2, RESCALING.format("rescaling")),
    Method("separate rescaling", "hoa2-ends", 2, RESCALING.format("separate-rescaling")),
    Method("hybrid Monte Carlo", "hoa2", 4, "[hybrid_monte_carlo]\nsteps = 10\n"),
)
CONSTANT_ENERGY = Method("constant energy", "hoa2", 2)
QUANTITIES = "potential energy [kJ/mol per molecule]", "pressure [bar]", "first peak of g(r), OW-OW"

RUN_FILE = """[system]
molecules = [{{ model = "spce", count = {o.molecules} }}]
{start}
temperature = "{temperature} K"
seed = {seed}
[forces]
precision = "mixed"
electrostatics = "reaction-field"
cutoff = "{o.cutoff:g} nm"
switch = "{switch:g} nm"
[integrator]
scheme = "{method.scheme}"
step = "{method.step:g} fs"
[run]
length = "{length:g} ps"
sample = "40 fs"
{equilibrate}
[output]
prefix = "{name}"
trajectory_every = "0.2 ps"
formats = ["xtc"]
plot = "none"
{method.tables}"""


def called(o, *command):
    done = run([o.program, *command], cwd=o.folder, stdout=PIPE, stderr=PIPE, text=True, check=False)
    if done.returncode:
        sys.exit(f"polhode {' '.join(command)}: exit code {done.returncode}\n{done.stderr}")
    return done.stdout


def trajectory(o, method, start, seed, length, equilibrate=""):
    name = method.name.replace(" ", "-")
    if (o.folder / f"{name}-final.gro").exists():
        return
    (o.folder / f"{name}.toml").write_text(RUN_FILE.format(
        o=o, method=method, name=name, start=start, seed=seed, length=length, equilibrate=equilibrate, temperature=TEMPERATURE,
        switch=0.88 * o.cutoff), encoding="utf-8")
    called(o, "run", f"{name}.toml", "--threads", "1", "--force")


def columns(o, method):
    """Of the energies file, by quantity."""
    path = o.folder / f"{method.name.replace(' ', '-')}-energies.csv"
    return {name: np.array(values) for name, values in waters.columns(path).items()}


def mean(values, blocks):
    """With its standard error, from the scatter of blocks: the pressure has a slow part below its fast fluctuations, which sums of
    its autocorrelation miss."""
    means = values[:len(values) // blocks * blocks].reshape(blocks, -1).mean(axis=1)
    return float(means.mean()), float(means.std(ddof=1) / sqrt(blocks))


def results(o, method):
    """Of each quantity the mean and its standard error."""
    name, found = method.name.replace(" ", "-"), columns(o, method)
    kept = found["time"] >= SKIPPED
    potential, pressure = (mean(found[quantity][kept], round((o.length - SKIPPED) / BLOCK)) for quantity in ("potential", "pressure"))
    analysis = json.loads(called(o, "analyze", f"{name}-trajectory.xtc", "--run", f"{name}.toml", "--what", "rdf", "--pairs", "OW-OW",
                                 "--from", f"{SKIPPED} ps", "--bin", "0.004 nm", "--output", f"{name}-analysis", "--plot", "none",
                                 "--threads", "1", "--force", "--json"))
    peak = analysis["rdf"][0]["peak_height"]
    return [tuple(x / o.molecules for x in potential), pressure, (peak["value"], peak["error"])]


def with_scaled_velocities(text, factor):
    """A GRO file of polhode: the columns of its numbers have 15 characters."""
    lines = text.splitlines()
    for k in range(2, len(lines) - 1):
        velocities = [factor * float(lines[k][at:at + 15]) for at in (65, 80, 95)]
        lines[k] = lines[k][:65] + "".join(f"{v:15.11f}" for v in velocities)
    return "\n".join(lines) + "\n"


def start_of_constant_energy(o, potential):
    """From the last state of rescaling, so that the total energy is the mean one: <U> + n kT/2 with n = 6 N - 3."""
    last = {name: values[-1] for name, values in columns(o, METHODS[2]).items()}
    kinetic = last["kinetic_translation"] + last["kinetic_rotation"]
    required = potential + (6 * o.molecules - 3) * BOLTZMANN * TEMPERATURE / 2 - last["potential"]
    text = (o.folder / "rescaling-final.gro").read_text(encoding="utf-8")
    (o.folder / "matched.gro").write_text(with_scaled_velocities(text, sqrt(required / kinetic)), encoding="utf-8")


def all_results(o):
    begin = Method("start", "hoa2-ends", 2, RESCALING.format("rescaling"))
    trajectory(o, begin, f'density = "{o.density:g} g/cm3"', o.seed, 1, 'equilibrate = "10 ps"')
    found = []
    for k, method in enumerate(METHODS, 1):
        trajectory(o, method, 'initial_configuration = "start-final.gro"\nvelocities = "new"', o.seed + k, o.length)
        found.append(results(o, method))
    start_of_constant_energy(o, o.molecules * np.mean([r[0][0] for r in found]))
    trajectory(o, CONSTANT_ENERGY, 'initial_configuration = "matched.gro"', o.seed, o.length)
    return [*found, results(o, CONSTANT_ENERGY)]


def deviations(values):
    """Of each (mean, error) from the mean of all others, in standard errors of the difference."""
    found = []
    for k, (value, error) in enumerate(values):
        others = values[:k] + values[k + 1:]
        variance = error**2 + sum(e**2 for _, e in others) / len(others)**2
        found.append((value - sum(v for v, _ in others) / len(others)) / sqrt(variance))
    return found


def table(found):
    rows = [f"| method | scheme, step | {' | '.join(QUANTITIES)} |", f"| --- | --- |{' --- |' * len(QUANTITIES)}"]
    away = [deviations([r[q] for r in found]) for q in range(len(QUANTITIES))]
    for k, method in enumerate((*METHODS, CONSTANT_ENERGY)):
        cells = [f"{found[k][q][0]:.{d}f} ± {found[k][q][1]:.{d}f} ({away[q][k]:+.1f})" for q, d in enumerate((3, 0, 4))]
        rows.append(f"| {method.name} | {method.scheme}, {method.step:g} fs | {' | '.join(cells)} |")
    z = np.array(away)
    return "\n".join([*rows, "", f"{z.size} differences: rms {np.sqrt(np.mean(z**2)):.2f}, largest {abs(z).max():.2f} standard errors."])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default="polhode", help="path of polhode")
    parser.add_argument("--folder", type=Path, default=Path("agreement"), help="where the runs are kept")
    parser.add_argument("--molecules", type=int, default=216)
    parser.add_argument("--cutoff", type=float, default=0.85, help="[nm]")
    parser.add_argument("--density", type=float, default=0.998, help="[g/cm3]")
    parser.add_argument("--length", type=float, default=200, help="of each run [ps]")
    parser.add_argument("--seed", type=int, default=1, help="of the first run")
    o = parser.parse_args()
    o.program, o.folder = machine.program(o.program), o.folder.resolve()
    o.folder.mkdir(parents=True, exist_ok=True)
    print(table(all_results(o)))


if __name__ == "__main__":
    main()
