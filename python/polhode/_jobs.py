# SPDX-License-Identifier: MIT
"""The verbs of the command line as functions: the same library calls, files and reports."""

from __future__ import annotations

import json
import os
import pathlib
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, SupportsIndex

from . import _core
from ._keywords import takes_settings
from .errors import Error
from ._progress import hooks
from ._quantities import optional_text
from ._results import Report
from ._settings import settings
from ._types import Messages, Path, Progress, Quantity, Source, Texts

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._keywords import Keywords

__all__ = ["advise", "analyze", "bench", "convert", "energy", "export", "minimise", "new", "prepare", "run",
           "study", "tune_scheme"]


def _texts(values, name, dimension=None):
    """None, or a list of texts."""
    if values is None:
        return None
    if isinstance(values, str) or not hasattr(values, "__iter__"):
        values = [values]
    if dimension is not None:
        return [optional_text(v, dimension, name) for v in values]
    return [str(v) for v in values]


def _number(value, name, first, last):
    """A whole number within bounds."""
    if isinstance(value, bool) or not hasattr(value, "__index__"):
        raise Error(f"{name} = {value!r} must be a whole number")
    if not first <= value.__index__() <= last:
        raise Error(f"{name} = {value} must be from {first} to {last}")
    return value.__index__()


class _Job:
    """What the jobs have in common: outputs, threads, progress."""

    def __init__(self, verb, resume=False, force=False, threads=None, progress=None, messages=None):
        if resume and force:
            raise Error("resume and force contradict each other: resume continues from existing "
                        "files, force overwrites them; give one of them")
        self._verb = verb
        self._existing = "resume" if resume else "replace" if force else "refuse"
        self._threads = _core.threads(threads)
        self._hooks = hooks(progress, messages)

    def __enter__(self):
        h = self._hooks.__enter__()
        return _core.JobOptions(self._threads, self._existing, f"polhode.{self._verb}()",
                                h.progress, h.message)

    def __exit__(self, *error):
        self._hooks.__exit__(*error)


def _settings(source, output, keywords):
    """The library's settings, with the prefix of the outputs."""
    given = settings(source, **keywords)._core
    config = _core.Config(given)
    config.own_forces = given.own_forces
    if output is not None:
        config.prefix = os.fspath(output)
    return config


def new(kind: str, path: Path | None = None, *, ensemble: str | None = None,
        mdp: Path | None = None, messages: Messages = None) -> pathlib.Path:
    """Writes a commented run file to start from, as ``polhode new``.

    Args:
        kind (str): "water", "nvt", "npt", "mixture", "gromacs" or "lammps".
        path: file to write; default: KIND.toml. An existing one is never overwritten.
        ensemble (str): "nvt" or "npt", for a kind at constant energy.
        mdp: run parameters of GROMACS to translate; kind is "gromacs".
        messages: called with each parameter without counterpart, and why, such as print.

    Returns:
        pathlib.Path: the file.
    """
    path = pathlib.Path(f"{kind}.toml" if path is None else path)
    if mdp is None:
        text = _core.run_file_template(kind, ensemble or "")
    elif kind != "gromacs" or ensemble is not None:
        raise Error("mdp has parameters of GROMACS, with the ensemble; give the kind \"gromacs\" "
                    "and no ensemble")
    else:
        text, differences = _core.read_mdp(os.fspath(mdp), path.stem)
        for parameter, reason in differences if messages is not None else []:
            messages(f"note: {parameter}: {reason}")
    try:
        with open(path, "x", encoding="utf-8") as file:
            file.write(text)
    except FileExistsError:
        raise Error(f"'{path}' exists and is never overwritten; give another name") from None
    except OSError as e:
        raise Error(f"'{path}' cannot be written: {e.strerror}; give another name") from None
    return path


@takes_settings
def run(source: Source = None, *, output: Path | None = None, resume: bool = False,
        force: bool = False, threads: int | None = None, progress: Progress = None,
        messages: Messages = None, **keywords: Unpack[Keywords]) -> Report:
    """Simulates with all output files, as ``polhode run``: energies, trajectories, checkpoints.

    Args:
        source, **keywords: as in settings().
        output: prefix of the files; default: that of the settings.
        resume (bool): continue from the last checkpoint, if there is one.
        force (bool): overwrite files that exist.
        threads (int): default: one for each available core.
        progress, messages: see Progress.

    Returns:
        Report: with the keys of ``polhode run --json``.

    Raises:
        Error: before anything is computed, if a setting does not fit, or outputs exist.
        RunError: if the trajectory blows up.
        KeyboardInterrupt: after Ctrl-C; a checkpoint is written, and resume=True continues.
    """
    config = _settings(source, output, keywords)
    with _Job("run", resume, force, threads, progress, messages) as options:
        text, files, complete = _core.run(config, options)
    return Report("run", json.loads(text) or {}, files, complete)


@takes_settings
def energy(source: Source = None, *, derivative: bool = False, messages: Messages = None,
           **keywords: Unpack[Keywords]) -> Report:
    """Energies and pressure of an initial configuration, as ``polhode energy``.

    Args:
        source, **keywords: as in settings().
        derivative (bool): evaluate the derivative of the forces, too.

    Returns:
        Report: with the keys of ``polhode energy --json``.
    """
    return Report("energy", json.loads(_core.energy(_settings(source, None, keywords), derivative,
                                                    messages)), [])


@takes_settings
def prepare(source: Source = None, *, pressure: Quantity | None = None, nvt: Quantity | None = None,
            npt: Quantity | None = None, output: Path | None = None, resume: bool = False,
            force: bool = False, threads: int | None = None, progress: Progress = None,
            messages: Messages = None, **keywords: Unpack[Keywords]) -> Report:
    """Prepares an equilibrated start, as ``polhode prepare``: minimises, NVT, NPT.

    Args:
        source, **keywords: as in settings().
        pressure: of the barostat: "1 bar"; default: that of the settings.
        nvt, npt: lengths of the stages: "20 ps", "100 ps".
        output, resume, force, threads, progress, messages: as in run().

    Returns:
        Report: with the keys of ``polhode prepare --json``; files are PREFIX-prepared.*.
    """
    config = _settings(source, output, keywords)
    with _Job("prepare", resume, force, threads, progress, messages) as options:
        data = json.loads(_core.prepare(
            config, optional_text(pressure, "pressure", "pressure"),
            optional_text(nvt, "time", "nvt"), optional_text(npt, "time", "npt"), options))
    return Report("prepare", data, data.get("files") or [])


@takes_settings
def minimise(source: Source = None, *, max_force: Quantity | None = None,
             max_torque: Quantity | None = None, max_steps: SupportsIndex = 20000,
             output: Path | None = None, force: bool = False, threads: int | None = None,
             progress: Progress = None, messages: Messages = None, **keywords: Unpack[Keywords]) -> Report:
    """Minimises the energy of an initial configuration, as ``polhode minimise``.

    Args:
        source, **keywords: as in settings().
        max_force, max_torque: bounds at which it ends: "10 kJ/mol/nm", "1 kJ/mol".
        max_steps (int): of one force evaluation each.
        output, force, threads, progress, messages: as in run().

    Returns:
        Report: with the keys of ``polhode minimise --json``; the file is PREFIX-minimised.gro.
    """
    config = _settings(source, output, keywords)
    with _Job("minimise", False, force, threads, progress, messages) as options:
        data = json.loads(_core.minimise(
            config, optional_text(max_force, "force", "max_force"),
            optional_text(max_torque, "energy", "max_torque"),
            _number(max_steps, "max_steps", 1, 100_000_000), options))
    return Report("minimise", data, data["files"])


def analyze(trajectory: Path, *, run: Source = None, molecules: Mapping[str, int] | None = None,
            names: Path | None = None, what: Texts | None = None, start: Quantity | None = None,
            interval: Quantity | None = None, window: Quantity | None = None,
            fit: Sequence[Quantity] | None = None, pairs: Texts | None = None,
            cutoff: Quantity | None = None, bin: Quantity | None = None,
            viscosity: Quantity | None = None, temperature: Quantity | None = None,
            electrostatics: str | None = None, energies: Path | None = None,
            output: Path = "polhode-analysis", plot: str = "none", force: bool = False,
            threads: int | None = None, progress: Progress = None,
            messages: Messages = None) -> Report:
    """Structure and dynamics from a trajectory, as ``polhode analyze``.

    Args:
        trajectory: file of frames.
        run: settings or run file of the trajectory, for its molecules and electrostatics.
        molecules (dict): instead: {"tip4p": 512}, in the order of the file.
        names: coordinate file with the names of the atoms, for formats without them.
        what (list of str): any of "rdf", "msd", "rotation", "velocity", "dielectric", "density".
        start, interval, window, cutoff, bin: times and lengths: "10 ps", "0.1 ps", "1 nm".
        fit: two lags between which D is fitted: ("2 ps", "10 ps").
        pairs (list of str): of sites, for g(r): ["OW-OW", "OW-HW"].
        viscosity, temperature, electrostatics: as the options of the command line.
        energies: energies file of the run, for the bias of the step; needs run.
        output: prefix of the files with the curves.
        plot (str): "svg", "png" or "none"; Report.plot() draws, too.
        force, threads, progress, messages: as in run().

    Returns:
        Report: with the keys of ``polhode analyze --json``.
    """
    if (run is None) == (molecules is None):
        raise Error("the molecules of the trajectory are not known; give one of run=\"water.toml\" "
                    "and molecules={\"tip4p\": 512}")
    options = _core.AnalysisOptions()
    options.what, options.pairs = _texts(what, "what"), _texts(pairs, "pairs")
    for name, value in (("start", start), ("interval", interval), ("window", window)):
        setattr(options, name, optional_text(value, "time", name))
    for name, value in (("cutoff", cutoff), ("bin", bin)):
        setattr(options, name, optional_text(value, "length", name))
    options.viscosity = optional_text(viscosity, "viscosity", "viscosity")
    options.temperature = optional_text(temperature, "temperature", "temperature")
    options.electrostatics = electrostatics
    options.energies = None if energies is None else os.fspath(energies)
    options.fit = _texts(fit, "fit", "time")
    config = None if run is None else settings(run)._core
    counts = [(str(k), _number(v, k, 0, 2**40)) for k, v in (molecules or {}).items()]
    with _Job("analyze", False, force, threads, progress, messages) as job:
        text, files = _core.analyze(os.fspath(trajectory), config, counts,
                                    "" if names is None else os.fspath(names), options,
                                    os.fspath(output), plot, job)
    return Report("analyze", json.loads(text), files)


def convert(source: Path, target: Path, *, names: Path | None = None,
            particles: Source = None, every: SupportsIndex = 1,
            start: Quantity | None = None, stop: Quantity | None = None, force: bool = False,
            progress: Progress = None, messages: Messages = None) -> int:
    """Converts coordinates and trajectories, as ``polhode convert``.

    Args:
        source, target: files; their extensions select the formats.
        names: file with the atom names, if the source has none.
        particles: settings of the run whose molecules the particles of a LAMMPS dump file are.
        every (int): write every n-th frame.
        start, stop: times between which frames are taken: "10 ps".
        force (bool): overwrite the target.

    Returns:
        int: number of frames written.
    """
    config = None if particles is None else settings(particles)._core
    with _Job("convert", False, force, 1, progress, messages) as options:
        return _core.convert(os.fspath(source), os.fspath(target),
                             "" if names is None else os.fspath(names), config,
                             _number(every, "every", 1, 2**40),
                             optional_text(start, "time", "start"),
                             optional_text(stop, "time", "stop"), options)


@takes_settings
def export(program: str, source: Source = None, *, pair_style: str = "table",
           output: Path | None = None, force: bool = False, progress: Progress = None,
           messages: Messages = None,
           **keywords: Unpack[Keywords]) -> list[pathlib.Path]:
    """Writes a run as input of another program, as ``polhode export``.

    Args:
        program (str): "lammps".
        source, **keywords: as in settings().
        pair_style (str): "table", the pair laws as tables; "polhode", that of the plugin; or
            "polhode-particles", the same with one particle a molecule.
        output: prefix of the files; default: that of the settings.
        force (bool): overwrite existing files.

    Returns:
        list of Path: data file, tables of the pair laws if there are any, input script.
    """
    if program != "lammps":
        raise Error(f"there is no export to {program!r}; the program must be \"lammps\"")
    config = _settings(source, output, keywords)
    with _Job("export", False, force, 1, progress, messages) as options:
        return [pathlib.Path(file) for file in _core.export_lammps(config, pair_style, options)]


@takes_settings
def study(source: Source = None, *, schemes: Texts | None = None,
          steps: Sequence[Quantity] | Quantity | None = None, quick: bool = False,
          from_record: Path | None = None, output: Path = "study", force: bool = False,
          threads: int | None = None, progress: Progress = None, messages: Messages = None,
          **keywords: Unpack[Keywords]) -> Report:
    """Accuracy against cost of each scheme, as ``polhode study``: the figure of the paper.

    A study that was interrupted resumes from its record of runs.

    Args:
        source, **keywords: as in settings(); the table ``study={"runs": 4, "length": "2 ps"}``.
        schemes (list of str): names, or stages as text.
        steps (list): steps for every scheme: ["2 fs", "4 fs"].
        quick (bool): a small version.
        from_record: make tables and figure from this record, without new runs.
        output: prefix of the files.
        force (bool): start over if results of another study exist.
        threads (int): simultaneous runs; default: one for each available core.
        progress, messages: see Progress.

    Returns:
        Report: with the keys of ``polhode study --json``; plot() draws it.
    """
    config = _settings(source, None, keywords)
    resume = not force and from_record is None
    with _Job("study", resume, force, threads, progress, messages) as options:
        text, files, complete = _core.study(
            config, _texts(schemes, "schemes"), _texts(steps, "steps", "time"), quick,
            os.fspath(output), None if from_record is None else os.fspath(from_record), options)
    return Report("study", json.loads(text), files, complete)


@takes_settings
def advise(source: Source = None, *, accuracy: Quantity | None = None,
           drift: Quantity | None = None, temperature_bias: Quantity | None = None,
           bias: str | None = None, schemes: Texts | None = None, ensemble: str = "nve",
           evaluations: SupportsIndex = 5000, time: float = 60, output: Path = "advice",
           force: bool = False, threads: int | None = None, progress: Progress = None,
           messages: Messages = None, **keywords: Unpack[Keywords]) -> Report:
    """Chooses scheme and step for a required accuracy, as ``polhode advise``.

    Args:
        source, **keywords: as in settings().
        accuracy: largest R: "0.5 %"; or
        drift: largest energy drift per molecule: "0.1 kJ/mol/ns"; or
        temperature_bias: "0.5 %"; or
        bias (str): of an average by the step: "0.1 K", "energy 0.01 kJ/mol", "pressure 4 bar".
        schemes (list of str): to choose from.
        ensemble (str): "nvt": step and trajectory length of hybrid Monte Carlo instead.
        evaluations (int): with "nvt": force evaluations of each pilot run.
        time (float): approximate computing time [s].
        output: prefix of the files.

    Returns:
        Report: with the keys of ``polhode advise --json``, and ``answer``, a sentence.

    Raises:
        RunError: if no scheme meets it.
    """
    if ensemble not in ("nve", "nvt"):
        raise Error(f"ensemble = \"{ensemble}\" must be \"nve\" or \"nvt\"")
    if isinstance(time, bool) or not isinstance(time, (int, float)) or not 0.1 <= time <= 1e6:
        raise Error(f"time = {time!r} must be a number of seconds from 0.1 to 1e6")
    config, names = _settings(source, None, keywords), _texts(schemes, "schemes")
    with _Job("advise", False, force, threads, progress, messages) as options:
        if ensemble == "nvt":
            text, answer = _core.advise_nvt(config, names[0] if names else None,
                                            _number(evaluations, "evaluations", 100, 10**8), options)
            return Report("advise", {**json.loads(text), "answer": answer}, [])
        text, files, answer = _core.advise(
            config, optional_text(accuracy, "fraction", "accuracy"),
            optional_text(drift, "power", "drift"),
            optional_text(temperature_bias, "fraction", "temperature_bias"), bias, names,
            float(time), os.fspath(output), options)
    return Report("advise", {**json.loads(text), "answer": answer}, files)


@takes_settings
def tune_scheme(source: Source = None, *, scheme: str | None = None, step: Quantity | None = None,
                runs: SupportsIndex = 4, length: Quantity | None = None,
                decorrelate: Quantity | None = None, sample: Quantity | None = None,
                threads: int | None = None, progress: Progress = None, messages: Messages = None,
                **keywords: Unpack[Keywords]) -> Report:
    """Optimizes the parameters of a scheme for a system and step, as ``polhode tune-scheme``.

    Args:
        source, **keywords: as in settings().
        scheme (str): stages with free parameters: "free b = 0.2; B(b) A(1/2) ...".
        step, length, decorrelate, sample: times: "5 fs", "2 ps", "2 ps", "20 fs".
        runs (int): for the measurement, and again for the confirmation.

    Returns:
        Report: with the keys of ``polhode tune-scheme --json``.
    """
    times = [optional_text(v, "time", n) for n, v in
             (("step", step), ("length", length), ("decorrelate", decorrelate), ("sample", sample))]
    with _Job("tune_scheme", False, False, threads, progress, messages) as options:
        text = _core.tune_scheme(_settings(source, None, keywords), scheme, times[0],
                                 _number(runs, "runs", 2, 1000), *times[1:], options)
    return Report("tune_scheme", json.loads(text), [])


def _processor():
    """The name of the processor, or "unknown processor"."""
    try:
        for line in pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines():
            if line.startswith("model name"):
                return line.partition(": ")[2]
    except OSError:
        pass
    return "unknown processor"


def bench(*, quick: bool = False, sizes: Sequence[SupportsIndex] | None = None,
          precision: str | None = None, threads: int | None = None, progress: Progress = None,
          messages: Messages = None) -> Report:
    """Measures the speed of this computer on water, as ``polhode bench``.

    Args:
        quick (bool): a few seconds.
        sizes (list of int): numbers of waters.
        precision (str): "double" or "mixed"; default: both.

    Returns:
        Report: with the keys of ``polhode bench --json``.
    """
    sizes = None if sizes is None else [_number(n, "sizes", 1, 10**8) for n in sizes]
    with _Job("bench", False, False, threads, progress, messages) as options:
        text = _core.bench(quick, sizes, precision, _processor(), options)
    return Report("bench", json.loads(text), [])
