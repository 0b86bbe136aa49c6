# SPDX-License-Identifier: MIT
"""Density, potential energy and compressibility of liquids at constant temperature and pressure: polhode against GROMACS.

    npt.py --job check                 both programs compute the energy of the same configuration
    npt.py --job run --length 500      runs each to this length [ps]; continues what was interrupted
    npt.py --job compare               the table of what there is, in Markdown
    npt.py --job rerun                 GROMACS computes the energies of frames of polhode: what differs, and by how much this
                                       shifts density and potential energy

Runs are kept in --folder and can be continued to a greater length. Two calls with other --models or --runs may run at a time.
SIGTERM to the two programs suspends a run in good order."""

import re
import subprocess
import sys
from math import floor, log10, sqrt
from pathlib import Path
from typing import NamedTuple

import npt_liquids as liquids
import numpy
from lib import runs, study
from lib.statistics import inefficiency
from npt_liquids import LIQUIDS

SCALED = (0.99, 1.01)  # edges of the box, for the check of energies
COMPARED = ("density [kg/m³]", "potential energy [kJ/mol]", "compressibility [1e-5/bar]")


class Way(NamedTuple):
    """How polhode samples the ensemble."""
    name: str
    scheme: str
    thermostat: str
    barostat: str
    step: float  # of water [fs]
    seed: int

    def of(self, model):
        """Molecules without hydrogen allow 2.5 times the step."""
        return self._replace(step=2.5 * self.step) if model == "co2" else self


WAYS = (Way("baoab-cell-rescaling", "baoab", "langevin", "cell-rescaling", 2, 1),
        Way("baoab-monte-carlo", "baoab", "langevin", "monte-carlo", 2, 2),
        Way("hoa2-rescaling", "hoa2", "rescaling", "cell-rescaling", 4, 3))


def called(folder, *command, given=None):
    done = subprocess.run([str(c) for c in command], cwd=folder, text=True, input=given, capture_output=True, check=False)
    if done.returncode:
        sys.exit(f"{' '.join(map(str, command))}: exit code {done.returncode}\n{(done.stdout + done.stderr)[-2000:]}")
    return done


def prepared(liquid, o):
    """The initial configuration of both programs, and the topology of GROMACS."""
    start = o.folder / f"{liquid.model}-start-final.gro"
    if not start.exists():
        runs.run(o, liquids.lattice(liquid, 0.1 if o.smoke else 10), o.folder, name=f"{liquid.model}-start")
    return start


def gromacs_input(liquid, o, name, configuration, steps):
    for ending, text in (("mdp", liquids.parameters(liquid, steps)), ("top", liquids.topology(liquid)),
                         ("gro", liquids.coordinates(liquid, configuration))):
        (o.folder / f"{name}.{ending}").write_text(text, encoding="utf-8")
    called(o.folder, o.gmx, "-nobackup", "grompp", "-f", f"{name}.mdp", "-c", f"{name}.gro", "-p", f"{name}.top",
           "-o", f"{name}.tpr", "-po", f"{name}-out.mdp", "-maxwarn", 2)


def gromacs_table(o, name, terms):
    """The columns of these terms in an energy file."""
    chosen = "".join(f"{term}\n" for term in terms if term != "Time") + "\n"
    called(o.folder, o.gmx, "-nobackup", "energy", "-f", f"{name}.edr", "-o", f"{name}.xvg", "-dp", given=chosen)
    text = (o.folder / f"{name}.xvg").read_text(encoding="utf-8")
    rows = numpy.atleast_2d(numpy.array([[float(x) for x in line.split()] for line in text.splitlines() if line[0] not in "#@"]))
    legends = ["Time", *(word.replace(" ", "-") for word in re.findall(r'^@ s\d+ legend "([^"]*)"', text, re.M))]
    return [rows[:, legends.index(term)] for term in terms]


def terms_of_gromacs(liquid, o, configuration):
    """Energies of a configuration [kJ/mol]."""
    name = f"{liquid.model}-check"
    gromacs_input(liquid, o, name, configuration, 0)
    called(o.folder, o.gmx, "-nobackup", "mdrun", "-deffnm", name, "-ntmpi", 1, "-ntomp", 1, "-noconfout")
    short, tail, real, mesh, potential = (float(v[0]) for v in gromacs_table(
        o, name, ("LJ-(SR)", "Disper.-corr.", "Coulomb-(SR)", "Coul.-recip.", "Potential")))
    return {"potential": potential, "van der Waals": short + tail, "Coulomb": real + mesh, "dispersion correction": tail}


def terms_of_polhode(liquid, o, configuration, accuracy, precision):
    name = f"{liquid.model}-check"
    (o.folder / f"{name}-polhode.gro").write_text(configuration, encoding="utf-8")
    (o.folder / f"{name}.toml").write_text(runs.run_file(**liquids.static(liquid, f"{name}-polhode.gro", accuracy, precision)), encoding="utf-8")
    found = runs.asked(o, "energy", f"{name}.toml", folder=o.folder)
    return {"potential": found["potential_kJ_per_mol"], "van der Waals": found["van_der_waals_kJ_per_mol"],
            "Coulomb": found["coulomb_kJ_per_mol"], "dispersion correction": found["terms_kJ_per_mol"]["dispersion tail"]}


def check(liquid, o):
    """Prints the energies of the initial configuration by both programs, and how they change as centres of mass are
    scaled with the box: the virial, by differences."""
    start = prepared(liquid, o).read_text(encoding="utf-8")
    programs = {"GROMACS": lambda c: terms_of_gromacs(liquid, o, c),
                "polhode, pme_accuracy 1e-4, mixed": lambda c: terms_of_polhode(liquid, o, c, 1e-4, "mixed"),
                "polhode, pme_accuracy 1e-6, double": lambda c: terms_of_polhode(liquid, o, c, 1e-6, "double")}
    names = ["potential", "van der Waals", "Coulomb", "dispersion correction"]
    changes = [f"potential, edges {100 * (f - 1):+g} %" for f in SCALED]
    print(f"\n| {liquid.model}, initial configuration [kJ/mol] | {' | '.join(names + changes)} |\n"
          f"| --- |{' --- |' * len(names + changes)}")
    for program, terms in programs.items():
        own = terms(liquids.expanded(liquid, start, 1))
        scaled = [terms(liquids.expanded(liquid, start, f))["potential"] - own["potential"] for f in SCALED]
        print(f"| {program} | " + " | ".join([*(f"{own[n]:.2f}" for n in names), *(f"{x:+.2f}" for x in scaled)]) + " |", flush=True)


# Runs

def run_gromacs(liquid, o):
    name = f"{liquid.model}-gromacs"
    gromacs_input(liquid, o, name, prepared(liquid, o).read_text(encoding="utf-8"), round(1000 * o.length / liquid.gromacs_step))
    called(o.folder, o.gmx, "-nobackup", "mdrun", "-deffnm", name, "-cpi", f"{name}.cpt", "-cpt", 1, "-ntmpi", 1, "-ntomp", 1,
           "-pin", "off", "-noconfout")


def run_polhode(liquid, way, o):
    name = f"{liquid.model}-{way.name}"
    tables = liquids.production(liquid, prepared(liquid, o).name, way, name)
    (o.folder / f"{name}.toml").write_text(runs.run_file(**tables), encoding="utf-8")
    runs.called(o, "run", f"{name}.toml", "--resume", "--length", f"{o.length:g} ps", "--threads", 1, folder=o.folder)


def run(o):
    """Runs, or continues, each up to the required length."""
    for model in o.models:
        for name in o.runs:
            if name == "gromacs":
                run_gromacs(LIQUIDS[model], o)
            else:
                run_polhode(LIQUIDS[model], next(w for w in WAYS if w.name == name).of(model), o)
            print(f"{model}, {name}: {o.length:g} ps done", file=sys.stderr, flush=True)


# Results

class Series(NamedTuple):
    """The samples of one run, without its beginning."""
    length: float  # [ps]
    volume: numpy.ndarray  # [nm³]
    potential: numpy.ndarray  # [kJ/mol]
    temperature: numpy.ndarray  # [K]
    pressure: numpy.ndarray  # [bar]


def series(skipped, times, *columns):
    kept = times >= skipped
    return Series(float(times[-1] - skipped), *(c[kept] for c in columns))


def series_of(liquid, name, o):
    """None for a run that does not exist, or is too short."""
    if name == "gromacs":
        if not (o.folder / f"{liquid.model}-gromacs.edr").exists():
            return None
        times, potential, temperature, pressure, volume = gromacs_table(
            o, f"{liquid.model}-gromacs", ("Time", "Potential", "Temperature", "Pressure", "Volume"))
    else:
        path = o.folder / f"{liquid.model}-{name}-energies.csv"
        if not path.exists():
            return None
        rows = runs.columns(path).dropna()  # without one that is being written
        times, volume, potential, temperature, pressure = (rows[k].to_numpy() for k in ("time", "volume", "potential", "temperature", "pressure"))
    return series(o.skip, times, volume, potential, temperature, pressure) if len(times) and times[-1] > 2 * o.skip else None


class Estimate(NamedTuple):
    value: float
    error: float
    samples: float  # independent ones


def estimate(x):
    """The mean of correlated samples."""
    n = len(x) / inefficiency(x)
    return Estimate(float(numpy.mean(x)), float(numpy.std(x)) / sqrt(n), n)


def variance(x):
    """The variance of the distribution, not of the mean, corrected for the variance of the sample mean."""
    return scaled(estimate((x - numpy.mean(x)) ** 2), 1 / (1 - 1 / estimate(x).samples))


def scaled(of, factor):
    return Estimate(of.value * factor, of.error * abs(factor), of.samples)


def results(liquid, s):
    """Estimates from one run; the density from the mean volume."""
    volume = estimate(s.volume)
    density = liquid.count * liquid.mass * liquids.GRAMS * 1000 / volume.value
    unit = liquids.PRESSURE / (volume.value * liquids.BOLTZMANN * liquid.temperature)
    return {"density [kg/m³]": Estimate(density, density * volume.error / volume.value, volume.samples),
            "potential energy [kJ/mol]": scaled(estimate(s.potential), 1 / liquid.count),
            "compressibility [1e-5/bar]": scaled(variance(s.volume), 1e5 * unit),
            "temperature [K]": estimate(s.temperature),
            "pressure [bar]": estimate(s.pressure)}


def digits(error):
    """Decimals that show two digits of an error."""
    return max(0, 1 - floor(log10(error))) if error > 0 else 3


def cell(own, other):
    text = f"{own.value:.{digits(own.error)}f} ± {own.error:.{digits(own.error)}f}"
    return text if other is None else f"{text} ({(own.value - other.value) / sqrt(own.error**2 + other.error**2):+.1f})"


def compare(o):
    """Prints a table for each liquid; in brackets the deviation from GROMACS in combined standard errors."""
    for model in o.models:
        liquid = LIQUIDS[model]
        found = {name: s for name in o.runs if (s := series_of(liquid, name, o))}
        values = {name: results(liquid, s) for name, s in found.items()}
        if not values:
            continue
        reference = values.get("gromacs")
        names = list(next(iter(values.values())))
        print(f"\n{model}, {liquid.temperature:g} K, {liquid.pressure:g} bar; published: {liquid.published or 'none'}\n")
        print(f"| run | length [ps] | independent volumes | {' | '.join(names)} |\n| --- | --- | --- |{' --- |' * len(names)}")
        for name, own in values.items():
            other = None if name == "gromacs" else reference
            print(f"| {name} | {found[name].length:.0f} | {own[names[0]].samples:.0f} | "
                  + " | ".join(cell(own[n], other[n] if other and n in COMPARED else None) for n in names) + " |")


# Energies of the same frames

def frames(path, skipped):
    """(time [ps], text) of each frame of a GRO file from a time on."""
    lines, begin = path.read_text(encoding="utf-8").splitlines(), 0
    while begin + 1 < len(lines) and len(lines) >= (end := begin + 3 + int(lines[begin + 1])):
        time = float(lines[begin].split("t=")[1].split()[0])
        if time >= skipped:
            yield time, "\n".join(lines[begin:end])
        begin = end


def rerun_by_gromacs(liquid, o, name, found):
    """Potential energies of frames by GROMACS, on the mesh of its own runs [kJ/mol]."""
    gromacs_input(liquid, o, name, prepared(liquid, o).read_text(encoding="utf-8"), 0)
    (o.folder / f"{name}-frames.gro").write_text(
        "".join(liquids.coordinates(liquid, text, title=f"frame t= {k}.0") for k, (_, text) in enumerate(found)), encoding="utf-8")
    called(o.folder, o.gmx, "-nobackup", "mdrun", "-s", f"{name}.tpr", "-deffnm", name, "-rerun", f"{name}-frames.gro", "-ntmpi", 1,
           "-ntomp", 1, "-noconfout")
    return gromacs_table(o, name, ("Potential",))[0]


def shift(values, difference, kT):
    """First-order change -cov/kT of a mean if the potential changes by `difference`, with the error for independent frames."""
    product = -(values - values.mean()) * (difference - difference.mean()) / kT
    return Estimate(float(product.mean()), float(product.std() / len(product) ** 0.5), len(product))


def rerun(o):
    """Prints the potential of GROMACS less that of polhode in frames of polhode's runs, and what follows for the means."""
    print("| run | frames | GROMACS less polhode [kJ/mol per molecule] | its scatter [kT of the box] "
          "| shift of the density [kg/m³] | of the potential energy [kJ/mol] |\n| --- | --- | --- | --- | --- | --- |")
    for liquid in map(LIQUIDS.get, o.models):
        for way in (w.name for w in WAYS if w.name in o.runs):
            path = o.folder / f"{liquid.model}-{way}-trajectory.gro"
            if not path.exists():
                continue
            samples = runs.columns(o.folder / f"{liquid.model}-{way}-energies.csv").dropna()
            rows = {round(r["time"], 3): r for r in samples.to_dict("records")}
            found = [frame for frame in frames(path, o.skip) if round(frame[0], 3) in rows]
            if len(found) < 5:
                continue
            own = [rows[round(time, 3)] for time, _ in found]
            potential, volume = (numpy.array([r[k] for r in own]) for k in ("potential", "volume"))
            theirs = rerun_by_gromacs(liquid, o, f"{liquid.model}-{way}-rerun", found)
            difference, kT = theirs - potential, liquids.BOLTZMANN * liquid.temperature
            density = liquid.count * liquid.mass * liquids.GRAMS * 1000 / volume
            energy = scaled(shift(potential, difference, kT), 1 / liquid.count)
            energy = energy._replace(value=energy.value + difference.mean() / liquid.count)
            print(f"| {liquid.model}, {way} | {len(found)} | {difference.mean() / liquid.count:.5f} | {difference.std() / kT:.3f} "
                  f"| {cell(shift(density, difference, kT), None)} | {cell(energy, None)} |", flush=True)


def main():
    # The shortest study that runs all steps of the comparison that need only polhode.
    o = study.options(__doc__, {"job": "run", "models": ["spce"], "runs": [WAYS[0].name], "length": 3.0, "skip": 0.5},
                      job=("compare", "check, run, compare or rerun"), models=(list(LIQUIDS), "liquids"),
                      runs=(["gromacs", *(w.name for w in WAYS)], "gromacs, or how polhode samples"), length=(500.0, "length of each run [ps]"),
                      skip=(10.0, "what results leave out at the beginning of each run [ps]"), gmx=("gmx", "GROMACS"))
    o.folder = o.folder or Path("npt").resolve()
    o.folder.mkdir(parents=True, exist_ok=True)
    if o.job == "check":
        for model in o.models:
            check(LIQUIDS[model], o)
    else:
        {"run": run, "compare": compare, "rerun": rerun}[o.job](o)
    if o.smoke:
        compare(o)


if __name__ == "__main__":
    main()
