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
from ._calls import call_text
from ._quantities import text_of
from ._results import Report
from ._settings import made, settings
from ._types import Messages, Path, Progress, Quantity, Source, Texts

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._keywords import Keywords

__all__ = ["advise", "analyze", "bench", "convert", "energy", "export", "minimise", "new", "prepare", "run",
           "study", "tune_scheme"]


def _text(value):
    """The text of an option: of a list its entries with commas, of a dict "tip4p 512, na 4"."""
    value = text_of(value)
    if isinstance(value, Mapping):
        return ", ".join(f"{name} {count}" if count else str(name) for name, count in value.items())
    if hasattr(value, "tolist"):  # of NumPy
        value = value.tolist()
    if isinstance(value, (list, tuple)):
        return ", ".join(map(_text, value))
    return os.fspath(value) if isinstance(value, os.PathLike) else str(value)


# Arguments that are no options of a job: those of all jobs, and settings.
_COMMON = ("source", "keywords", "run", "particles", "resume", "force", "threads", "progress", "messages")


class _Job:
    """A call of a job: its arguments, outputs, threads and progress.

    Args:
        function: the public function.
        given (dict): its arguments, by name.
    """

    def __init__(self, function, given):
        self._name, self._given, self._call = function.__name__, given, call_text(function, given)
        resume, force = given.get("resume", False), given.get("force", False)
        if resume and force:
            raise Error("resume and force contradict each other: resume continues from existing "
                        "files, force overwrites them; give one of them")
        self._existing = "resume" if resume else "replace" if force else "refuse"
        self._threads = _core.threads(given.get("threads"))
        self._hooks = hooks(given.get("progress"), given.get("messages"))

    @property
    def texts(self):
        """The arguments as texts, without those that are not given."""
        return {name: _text(value) for name, value in self._given.items() if value is not None and name not in _COMMON}

    def settings(self):
        """The library's settings, with the arguments that are settings."""
        given = self._given
        own = {name: given[name] for name in _core.job_settings(self._name) if name in given}
        found = made(given["source"], {**given["keywords"], **own}, self._name, given.get("quick", False))
        for note in found.notes if callable(given.get("messages")) else ():
            given["messages"](note)
        return found._core

    def __enter__(self):
        h = self._hooks.__enter__()
        return _core.JobOptions(self._threads, self._existing, self._call, h.progress, h.message)

    def __exit__(self, *error):
        self._hooks.__exit__(*error)


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
    job = _Job(run, locals())
    config = job.settings()
    with job as options:
        text, files, complete = _core.run(config, options)
    return Report("run", json.loads(text) or {}, files, complete)


@takes_settings
def energy(source: Source = None, *, gradient: bool = False, derivative: bool = False, messages: Messages = None,
           **keywords: Unpack[Keywords]) -> Report:
    """Energies and pressure of an initial configuration, as ``polhode energy``.

    Args:
        source, **keywords: as in settings().
        gradient (bool): evaluate the directional derivative of the forces, too.
        derivative (bool): the name of gradient before version 0.3.

    Returns:
        Report: with the keys of ``polhode energy --json``.
    """
    config = _Job(energy, locals()).settings()
    return Report("energy", json.loads(_core.energy(config, gradient or derivative, messages)), [])


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
    job = _Job(prepare, locals())
    config = job.settings()
    with job as options:
        data = json.loads(_core.prepare(config, options))
    return Report("prepare", data, data.get("files") or [])


@takes_settings
def minimise(source: Source = None, *, max_force: Quantity | None = None,
             max_torque: Quantity | None = None, max_steps: SupportsIndex | None = None,
             output: Path | None = None, force: bool = False, threads: int | None = None,
             progress: Progress = None, messages: Messages = None, **keywords: Unpack[Keywords]) -> Report:
    """Minimises the energy of an initial configuration, as ``polhode minimise``.

    Args:
        source, **keywords: as in settings().
        max_force, max_torque: bounds at which it ends: "10 kJ/mol/nm", "1 kJ/mol".
        max_steps (int): of one force evaluation each; default: 20000.
        output, force, threads, progress, messages: as in run().

    Returns:
        Report: with the keys of ``polhode minimise --json``; the file is PREFIX-minimised.gro.
    """
    job = _Job(minimise, locals())
    config = job.settings()
    with job as options:
        data = json.loads(_core.minimise(config, job.texts, options))
    return Report("minimise", data, data["files"])


def analyze(trajectory: Path, *, run: Source = None, molecules: Mapping[str, int] | None = None,
            names: Path | None = None, what: Texts | None = None, start: Quantity | None = None,
            interval: Quantity | None = None, window: Quantity | None = None,
            fit: Sequence[Quantity] | None = None, pairs: Texts | None = None,
            cutoff: Quantity | None = None, bin: Quantity | None = None,
            viscosity: Quantity | None = None, temperature: Quantity | None = None,
            electrostatics: str | None = None, energies: Path | None = None,
            output: Path | None = None, plot: str = "none", force: bool = False,
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
        energies: energies file of the run, for the time-step bias; needs run.
        output: prefix of the files with the curves; default: polhode-analysis.
        plot (str): "svg", "png" or "none"; Report.plot() draws, too.
        force, threads, progress, messages: as in run().

    Returns:
        Report: with the keys of ``polhode analyze --json``.
    """
    job = _Job(analyze, locals())
    config = None if run is None else settings(run)._core
    with job as options:
        text, files = _core.analyze(os.fspath(trajectory), config, job.texts, options)
    return Report("analyze", json.loads(text), files)


def convert(source: Path, target: Path, *, names: Path | None = None,
            particles: Source = None, every: SupportsIndex | None = None,
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
    job = _Job(convert, {**locals(), "threads": 1})
    config = None if particles is None else settings(particles)._core
    with job as options:
        return _core.convert(os.fspath(source), os.fspath(target), config, job.texts, options)


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
    job = _Job(export, {**locals(), "threads": 1})
    config = job.settings()
    with job as options:
        return [pathlib.Path(file) for file in _core.export_lammps(config, pair_style, options)]


@takes_settings
def study(source: Source = None, *, schemes: Texts | None = None,
          steps: Sequence[Quantity] | Quantity | None = None, runs: SupportsIndex | None = None,
          length: Quantity | None = None, decorrelate: Quantity | None = None,
          configurational_sample: Quantity | None = None, ensemble: str | None = None,
          quick: bool = False, from_record: Path | None = None, output: Path | None = None,
          force: bool = False, threads: int | None = None, progress: Progress = None, messages: Messages = None,
          **keywords: Unpack[Keywords]) -> Report:
    """Accuracy against cost of each scheme, as ``polhode study``: the figure of the paper.

    A study that was interrupted resumes from its record of runs.

    Args:
        source, **keywords: as in settings().
        schemes (list of str): names, or stages as text.
        steps (list): steps for every scheme: ["2 fs", "4 fs"].
        runs (int): independent runs at each point.
        length, decorrelate: of each run, "15 ps", and of the equilibration before it, "10 ps".
        configurational_sample: time between samples of the configurational temperature: "20 fs".
        ensemble (str): "nve": R and energy drift; "nvt": bias of canonical averages.
        quick (bool): a small version.
        from_record: make tables and figure from this record, without new runs.
        output: prefix of the files; default: study.
        force (bool): start over if results of another study exist.
        threads (int): simultaneous runs; default: one for each available core.
        progress, messages: see Progress.

    Returns:
        Report: with the keys of ``polhode study --json``; plot() draws it.
    """
    job = _Job(study, locals())
    config = job.settings()
    with job as options:
        text, files, complete = _core.study(config, quick, job.texts, options)
    return Report("study", json.loads(text), files, complete)


@takes_settings
def advise(source: Source = None, *, accuracy: Quantity | None = None,
           drift: Quantity | None = None, temperature_bias: Quantity | None = None,
           bias: str | None = None, schemes: Texts | None = None, ensemble: str | None = None,
           evaluations: SupportsIndex | None = None, time: float | None = None,
           length: Quantity | None = None, output: Path | None = None,
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
        evaluations (int): with "nvt": force evaluations of each pilot run; default: 5000.
        time (float): approximate computing time [s]; default: 60.
        length: of the runs to be planned: "15 ps"; default: that of the settings.
        output: prefix of the files; default: advice.

    Returns:
        Report: with the keys of ``polhode advise --json``, and ``answer``, a sentence.

    Raises:
        RunError: if no scheme meets it.
    """
    job = _Job(advise, locals())
    config = job.settings()
    with job as options:
        text, files, answer = _core.advise(config, job.texts, schemes is not None, options)
    return Report("advise", {**json.loads(text), "answer": answer}, files)


@takes_settings
def tune_scheme(source: Source = None, *, scheme: str | None = None, step: Quantity | None = None,
                runs: SupportsIndex | None = None, length: Quantity | None = None,
                decorrelate: Quantity | None = None, sample: Quantity | None = None,
                threads: int | None = None, progress: Progress = None, messages: Messages = None,
                **keywords: Unpack[Keywords]) -> Report:
    """Optimizes the parameters of a scheme for a system and step, as ``polhode tune-scheme``.

    Args:
        source, **keywords: as in settings().
        scheme (str): stages with free parameters: "free b = 0.2; B(b) A(1/2) ...".
        step, length, decorrelate, sample: times: "5 fs", "2 ps", "2 ps", "20 fs".
        runs (int): for the measurement, and again for the confirmation; default: 4.

    Returns:
        Report: with the keys of ``polhode tune-scheme --json``.
    """
    job = _Job(tune_scheme, locals())
    config = job.settings()
    with job as options:
        text = _core.tune_scheme(config, job.texts, options)
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
    job = _Job(bench, locals())
    with job as options:
        text = _core.bench(quick, job.texts, _processor(), options)
    return Report("bench", json.loads(text), [])
