# SPDX-License-Identifier: MIT
"""The three water models, and their runs at constant energy: run files, energies and frames."""

import json
import subprocess
from typing import NamedTuple

TEMPERATURE = 298.15  # [K]
RUN_FILE = """[system]
molecules = [{{ model = "{model}", count = {count} }}]
density = "{density} g/cm3"
temperature = "{temperature:g} K"
seed = {seed}
[forces]
electrostatics = "pme"
pme_accuracy = 1e-4
cutoff = "0.9 nm"
dispersion_correction = true
precision = "mixed"
[integrator]
scheme = "gier4-fd"
step = "4 fs"
[run]
equilibrate = "{equilibrate:g} ps"
length = "{length:g} ps"
sample = "20 fs"
[output]
prefix = "{prefix}"
trajectory_every = "{every:g} ps"
formats = ["trr"]
plot = "none"
"""


class Water(NamedTuple):
    model: str
    name: str
    density: float  # of published values of its energy or pressure [g/cm3]


# jorgensen1983 at 298 K and 1 atm; hummer1998 at 298 K; abascal2005 at 298 K and 1 bar.
WATERS = (Water("tip4p", "TIP4P", 0.999), Water("spce", "SPC/E", 0.997), Water("tip4p-2005", "TIP4P/2005", 0.9979))


class Run(NamedTuple):
    summary: dict  # of polhode run --json
    energies: list  # {column: value} of each sample
    peak: dict  # of g(r), of polhode analyze --json
    g: list  # (r [nm], g) of each bin


def table(path):
    """The rows of a CSV file as {column: number, nan if empty}, columns named without their units."""
    text = path.read_text(encoding="utf-8")
    lines = [line for line in text.splitlines() if not line.startswith("#")]
    names = [column.split(" [")[0] for column in lines[0].split(",")]
    return [dict(zip(names, (float(field or "nan") for field in line.split(",")))) for line in lines[1:]]


def columns(path):
    """Those of a CSV file, as {column: [numbers]}."""
    rows = table(path)
    return {name: [row[name] for row in rows] for name in rows[0]}


def made(program, folder, water, count, seed, temperature, equilibrate, length, every):
    """The prefix of the files of one run from a lattice; a finished run of the same run file is not repeated."""
    prefix = f"{water.model}-{seed}"
    text = RUN_FILE.format(model=water.model, count=count, density=water.density, temperature=temperature,
                           seed=seed, equilibrate=equilibrate, length=length, every=every, prefix=prefix)
    run_file, said = folder / f"{prefix}.toml", folder / f"{prefix}.json"
    if not (said.exists() and run_file.exists() and run_file.read_text(encoding="utf-8") == text):
        for old in (said, folder / f"{prefix}-analysis.json"):
            old.unlink(missing_ok=True)
        run_file.write_text(text, encoding="utf-8")
        done = subprocess.run([program, "run", run_file.name, "--threads", "1", "--force", "--json"], cwd=folder,
                              check=True, stdout=subprocess.PIPE, text=True)
        said.write_text(done.stdout, encoding="utf-8")
    return prefix


def analyzed(program, folder, prefix, every, *options):
    """The results of `polhode analyze` for a finished run without its first frame; stored ones are not made again."""
    said = folder / f"{prefix}-analysis.json"
    if not said.exists():
        done = subprocess.run(
            [program, "analyze", f"{prefix}-trajectory.trr", "--run", f"{prefix}.toml", "--from", f"{every:g} ps",
             "--pairs", "OW-OW", "--plot", "none", "--threads", "1", "--force", "--json", "--output", prefix, *options],
            cwd=folder, check=True, stdout=subprocess.PIPE, text=True)
        said.write_text(done.stdout, encoding="utf-8")
    return json.loads(said.read_text(encoding="utf-8"))


def run(program, folder, water, count, seed, temperature, equilibrate, length, every):
    """One run, performed or read from the folder."""
    prefix = made(program, folder, water, count, seed, temperature, equilibrate, length, every)
    peak, = analyzed(program, folder, prefix, every, "--what", "rdf")["rdf"]
    return Run(json.loads((folder / f"{prefix}.json").read_text(encoding="utf-8")), table(folder / f"{prefix}-energies.csv"),
               peak, [(row["r"], row["g OW-OW"]) for row in table(folder / f"{prefix}-rdf.csv")])
