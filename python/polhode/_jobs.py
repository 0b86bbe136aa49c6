# SPDX-License-Identifier: MIT
"""The verbs of the command line as functions, with the same library calls, files and reports."""

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
from ._quantities import plain
from ._results import Report
from ._settings import made, settings
from ._types import Messages, Path, Progress, Quantity, Source, Texts

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._keywords import Keywords

__all__ = ["advise", "analyze", "bench", "convert", "energy", "export", "minimise", "new", "prepare", "run",
           "study", "tune_scheme"]


def _text(value):
    """The text of an option. Entries of a list are separated by commas, and a dict becomes "tip4p 512, na 4"."""
    value = plain(value)
    if isinstance(value, Mapping):
        return ", ".join(f"{name} {count}" if count else str(name) for name, count in value.items())
    return ", ".join(map(_text, value)) if isinstance(value, (list, tuple)) else str(value)


# Arguments that are not options of a particular job: settings, and arguments of all jobs.
_COMMON = ("source", "keywords", "kind", "path", "run", "particles", "resume", "force", "threads", "progress", "messages")


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
        """The given arguments as texts."""
        return {name: _text(value) for name, value in self._given.items() if value is not None and name not in _COMMON}

    def settings(self):
        """The library's settings, with the arguments that are settings."""
        given = self._given
        own = {name: given[name] for name in _core.job_settings(self._name) if name in given}
        found = made(given["source"], {**given["keywords"], **own}, self._name, given.get("quick", False))
        for note in found.notes if callable(given.get("messages")) else ():
            given["messages"](note)
        return found._core

    def call(self, function, *arguments):
        """Calls a function of the library with these arguments and the options of the job."""
        with self._hooks as h:
            return function(*arguments, _core.JobOptions(self._threads, self._existing, self._call, h.progress, h.message))


def new(kind: str, path: Path | None = None, *, ensemble: str | None = None,
        mdp: Path | None = None, messages: Messages = None) -> pathlib.Path:
    """Writes a commented run file to start from, as ``polhode new``.

    Args:
        kind (str): "water", "nvt", "npt", "mixture", "gromacs" or "lammps".
        path: file to write; default: KIND.toml. An existing file is never overwritten.
        ensemble (str): ensemble, for the kinds gromacs, lammps, water and mixture: nvt adds a thermostat, npt
            a thermostat and a barostat.
        mdp: file of GROMACS run parameters (.mdp) to translate; parameters without a counterpart are listed.
        messages: called with each parameter without counterpart, and why, such as print.

    Returns:
        pathlib.Path: the file.
    """
    job = _Job(new, {**locals(), "progress": False})
    return pathlib.Path(job.call(_core.new_run_file, kind, "" if path is None else os.fspath(path), job.texts))


@takes_settings
def run(source: Source = None, *, output: Path | None = None, resume: bool = False,
        force: bool = False, threads: int | None = None, progress: Progress = None,
        messages: Messages = None, **keywords: Unpack[Keywords]) -> Report:
    """Simulates with all output files, as ``polhode run``: energies, trajectories, checkpoints.

    Args:
        source, **keywords: as in settings(); the other arguments have precedence.
        output: prefix of output file names (the prefix must not end in /).
        resume (bool): resume from the last checkpoint; start a new run if there is none.
        force (bool): overwrite output files that exist.
        threads (int): number of threads; default: one for each available core.
        progress, messages: see Progress.

    Returns:
        Report: with the keys of ``polhode run --json``.

    Raises:
        Error: before anything is computed, if a setting does not fit, or outputs exist.
        RunError: if the trajectory blows up.
        KeyboardInterrupt: after Ctrl-C; a checkpoint is written, and resume=True continues.
    """
    job = _Job(run, locals())
    text, files, complete = job.call(_core.run, job.settings())
    return Report("run", json.loads(text) or {}, files, complete)


@takes_settings
def energy(source: Source = None, *, gradient: bool = False, derivative: bool = False, messages: Messages = None,
           **keywords: Unpack[Keywords]) -> Report:
    """Energies and pressure of an initial configuration, as ``polhode energy``.

    Args:
        source, **keywords: as in settings(); the other arguments have precedence.
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
        source, **keywords: as in settings(); the other arguments have precedence.
        pressure: pressure of the barostat: "1 bar"; without a pressure, the volume is constant.
        nvt: length of the constant-volume stage of prepare: "20 ps".
        npt: length of the constant-pressure stage of prepare, if there is a barostat: "100 ps".
        output, resume, force, threads, progress, messages: as in run().

    Returns:
        Report: with the keys of ``polhode prepare --json``; files are PREFIX-prepared.*.
    """
    job = _Job(prepare, locals())
    data = json.loads(job.call(_core.prepare, job.settings()))
    return Report("prepare", data, data.get("files") or [])


@takes_settings
def minimise(source: Source = None, *, max_force: Quantity | None = None,
             max_torque: Quantity | None = None, max_steps: SupportsIndex | None = None,
             output: Path | None = None, force: bool = False, threads: int | None = None,
             progress: Progress = None, messages: Messages = None, **keywords: Unpack[Keywords]) -> Report:
    """Minimises the energy of an initial configuration, as ``polhode minimise``.

    Args:
        source, **keywords: as in settings(); the other arguments have precedence.
        max_force: bound on the largest force on a molecule; default: "10 kJ/mol/nm".
        max_torque: bound on the largest torque; default: "1 kJ/mol".
        max_steps (int): maximum number of steps; default: 20000.
        output, force, threads, progress, messages: as in run().

    Returns:
        Report: with the keys of ``polhode minimise --json``; the file is PREFIX-minimised.gro.
    """
    job = _Job(minimise, locals())
    data = json.loads(job.call(_core.minimise, job.settings(), job.texts))
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
        molecules (dict): models and counts in the order of the file, instead of a run file: "tip4p 512,
            na-tip4p-ew 4".
        names: coordinate file with the atom names, for formats without them.
        what (list of str): observables: rdf, msd, rotation, velocity, dielectric, density; default: all that
            the frames allow.
        start: leave out frames before this time: "10 ps".
        interval: time between frames, instead of the times in the file: "0.1 ps".
        window: maximum lag of correlations; default: "10 ps".
        fit: range of lags for the straight-line fit that gives D: "2 ps, 10 ps"; default: from a fifth of the
            maximum lag to the maximum lag.
        pairs (list of str): site pairs of g(r): "OW-OW, OW-HW"; HW means HW1 and HW2; default: all pairs.
        cutoff: maximum distance of g(r); default: "1 nm", or half of the shortest edge.
        bin: bin width of g(r); default: "0.002 nm".
        viscosity: viscosity of the liquid, "0.855 mPa s", for the Yeh-Hummer finite-size correction of D;
            default: the published value of the model.
        temperature: temperature, "298 K"; default: the temperature of the velocities, or of the run file.
        electrostatics (str): electrostatics of the run, instead of the setting in the run file: pme,
            reaction-field (relative permittivity 78.5), coulomb.
        energies: energies file of the run, for the time-step bias in g(r) and the dielectric constant; needs
            the run file.
        output: prefix of the output files; default: polhode-analysis.
        plot (str): format of figures: svg, png, none; default: svg.
        force, threads, progress, messages: as in run().

    Returns:
        Report: with the keys of ``polhode analyze --json``.
    """
    job = _Job(analyze, locals())
    config = None if run is None else settings(run)._core
    text, files = job.call(_core.analyze, os.fspath(trajectory), config, job.texts)
    return Report("analyze", json.loads(text), files)


def convert(source: Path, target: Path, *, names: Path | None = None,
            particles: Source = None, every: SupportsIndex | None = None,
            start: Quantity | None = None, stop: Quantity | None = None, force: bool = False,
            progress: Progress = None, messages: Messages = None) -> int:
    """Converts coordinates and trajectories, as ``polhode convert``.

    Args:
        source, target: files; their extensions select the formats.
        names: file with the atom names, for formats without names: XTC, TRR, DCD.
        particles: settings of the run whose molecules the particles of a LAMMPS dump file are.
        every (int): write every Nth frame; default: 1.
        start: leave out frames before this time: "10 ps".
        stop: leave out frames after this time.
        force (bool): overwrite output files that exist.
        progress, messages: see Progress.

    Returns:
        int: number of frames written.
    """
    job = _Job(convert, {**locals(), "threads": 1})
    config = None if particles is None else settings(particles)._core
    return job.call(_core.convert, os.fspath(source), os.fspath(target), config, job.texts)


@takes_settings
def export(program: str, source: Source = None, *, pair_style: str = "table",
           output: Path | None = None, force: bool = False, progress: Progress = None,
           messages: Messages = None,
           **keywords: Unpack[Keywords]) -> list[pathlib.Path]:
    """Writes a run as input of another program, as ``polhode export``.

    Args:
        program (str): "lammps".
        source, **keywords: as in settings(); the other arguments have precedence.
        pair_style (str): table: the pair potentials as tables; polhode: pair_style polhode of the plugin;
            polhode-particles: pair_style polhode with one particle per molecule; default: table.
        output: prefix of output file names (the prefix must not end in /).
        force (bool): overwrite output files that exist.
        progress, messages: see Progress.

    Returns:
        list of Path: data file, tables of the pair potentials if there are any, input script.
    """
    if program != "lammps":
        raise Error(f"export to {program!r} is not supported; the program must be \"lammps\"")
    job = _Job(export, {**locals(), "threads": 1})
    return [pathlib.Path(file) for file in job.call(_core.export_lammps, job.settings(), pair_style)]


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
        source, **keywords: as in settings(); the other arguments have precedence.
        schemes (list of str): single or nested schemes to compare.
        steps (list): time steps: "2 fs".
        runs (int): number of independent runs for each scheme and step.
        length: length of each run: "15 ps".
        decorrelate: equilibration time of each initial configuration after new momenta are drawn: "10 ps".
        configurational_sample: interval between values of the configurational temperatures: "20 fs".
        ensemble (str): measure of accuracy, R or the bias of canonical averages: nve, nvt.
        quick (bool): small study, which takes one to three minutes on two cores.
        from_record: record of an earlier study by any version of polhode; makes tables and figure from this
            record without new runs.
        output: prefix of the output files; default: study.
        force (bool): overwrite output files that exist.
        threads (int): number of simultaneous runs; default: one for each available core.
        progress, messages: see Progress.

    Returns:
        Report: with the keys of ``polhode study --json``; plot() draws it.
    """
    job = _Job(study, locals())
    text, files, complete = job.call(_core.study, job.settings(), quick, job.texts)
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
        source, **keywords: as in settings(); the other arguments have precedence.
        accuracy: upper bound on R of a run: "0.5 %".
        drift: upper bound on the energy drift per molecule: "0.1 kJ/mol/ns".
        temperature_bias: upper bound on the difference between the temperatures of translation and rotation:
            "0.5 %".
        bias (str): upper bound on the time-step bias of an average: "0.1 K" (of T_rot - T_trans), "energy
            0.01 kJ/mol", "pressure 4 bar", "density 0.02 %".
        schemes (list of str): single or nested schemes from which the adviser chooses.
        ensemble (str): ensemble: nve, or nvt to choose step and trajectory length of hybrid Monte Carlo;
            default: nve.
        evaluations (int): force evaluations of each pilot run in the ensemble nvt; default: 5000.
        time (float): approximate computing time, in seconds; default: 60.
        length: length of the run, rounded to whole steps, at least one step: "15 ps"; the advice is for a run
            of this length.
        output: prefix of the output files; default: advice.
        force, threads, progress, messages: as in study().

    Returns:
        Report: with the keys of ``polhode advise --json``, and ``answer``, a sentence.

    Raises:
        RunError: if no scheme meets it.
    """
    job = _Job(advise, locals())
    text, files, answer = job.call(_core.advise, job.settings(), job.texts, schemes is not None)
    return Report("advise", {**json.loads(text), "answer": answer}, files)


@takes_settings
def tune_scheme(source: Source = None, *, scheme: str | None = None, step: Quantity | None = None,
                runs: SupportsIndex | None = None, length: Quantity | None = None,
                decorrelate: Quantity | None = None, sample: Quantity | None = None,
                threads: int | None = None, progress: Progress = None, messages: Messages = None,
                **keywords: Unpack[Keywords]) -> Report:
    """Optimizes the parameters of a scheme for a system and step, as ``polhode tune-scheme``.

    Args:
        source, **keywords: as in settings(); the other arguments have precedence.
        scheme (str): stages with free parameters: "free b = 0.2; B(b) A(1/2) ..."; default: the scheme of the
            run file, or the families of hoa2 and gier4.
        step: time step to tune for: "5 fs".
        runs (int): number of runs for tuning, and the same number for confirmation; default: 4.
        length: length of each run; default: "2 ps".
        decorrelate: equilibration of each initial configuration; default: "2 ps".
        sample: time between samples of the error brackets; default: "20 fs".
        threads, progress, messages: as in study().

    Returns:
        Report: with the keys of ``polhode tune-scheme --json``.
    """
    job = _Job(tune_scheme, locals())
    return Report("tune_scheme", json.loads(job.call(_core.tune_scheme, job.settings(), job.texts)), [])


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
    """Measures how fast this computer simulates water, and what limits the speed, as ``polhode bench``.

    Args:
        quick (bool): measure only 512 waters with fewer and shorter repeats, in a few seconds.
        sizes (list of int): numbers of waters; default: 512,4096.
        precision (str): precision of pair interactions, double or mixed; default: both.
        threads (int): number of threads, compared with a single thread; default: one for each available core.
        progress, messages: see Progress.

    Returns:
        Report: with the keys of ``polhode bench --json``.
    """
    job = _Job(bench, locals())
    return Report("bench", json.loads(job.call(_core.bench, quick, job.texts, _processor())), [])
