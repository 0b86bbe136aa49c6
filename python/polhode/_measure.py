# SPDX-License-Identifier: MIT
"""Properties of a model, each to a requested error."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping, Sequence
from concurrent.futures import Executor
from typing import SupportsIndex

from . import _core
from ._jobs import _Job
from ._quantities import text_of
from ._results import Report
from ._types import Messages, Path, Progress, Quantity


def _words(properties):
    """The words of the command line: names of properties, optionally with requested errors."""
    if isinstance(properties, str):
        return [properties]
    if isinstance(properties, Mapping):
        pairs = properties.items()
        return [word for name, error in pairs for word in ((name,) if error is None else (name, str(text_of(error))))]
    return [str(word) for word in properties]


def _perform(system, words, texts, task):
    """Performs a task of an executor, and returns the record of the replica."""
    return _core.perform_replica(system, words, texts, *task)


def measure(system: Path | Sequence[Path], properties: str | Sequence[str] | Mapping[str, Quantity | None], *,
            at: str | Sequence[str] | None = None, molecules: SupportsIndex | None = None, mixing: str | None = None,
            solute: Path | None = None, replicas: SupportsIndex | None = None, paired_runs: bool = True, sampling: str | None = None,
            scheme: str | None = None, step: Quantity | None = None, time_limit: Quantity | None = None, shard: str | None = None, seed: SupportsIndex | None = None,
            output: Path | None = None, executor: Executor | None = None,
            threads: int | None = None, progress: Progress = None,
            messages: Messages = None) -> Report:
    """Measures properties of a model, each to a requested error, as ``polhode measure``.

    Results are stored in records. The same call, also with other properties or errors, resumes from them.

    Args:
        system: run file, molecule file, name of a model, a mixture: "spce 488, na-spce 12", or files of GROMACS or
            LAMMPS: ["topol.top", "conf.gro", "run.mdp"], "system.data".
        properties: names, or a dict of names with their errors: {"density": "0.1 %"}; default of the error: 1 %.
        at (str or list of str): state points: "298.15 K, 1 bar", "298.15 K, 997 kg/m3" at constant volume, "250 K to 320 K,
            7 points".
        molecules (int): number of molecules of a pure substance; default: 256.
        mixing (str): mixing rule of unlike sites for a system of models: "lorentz-berthelot" or "geometric"; default: the
            rule of the models.
        solute: name of a model or molecule file: one molecule of it is added as the first kind, for its
            solvation-free-energy.
        replicas (int): number of independent simulations of each state point; default: 4.
        paired_runs (bool): repeat an eighth of the dynamics at half of the step to bound its time-step bias, for a quarter
            more time.
        sampling (str): of averages, chemical potentials and slabs: "molecular-dynamics" or "hybrid-monte-carlo", which
            has no time-step bias; default: "molecular-dynamics".
        scheme (str): of all runs, a palindrome without a bath; default: hoa2.
        step: of all runs: "2 fs"; default: a pilot chooses it.
        time_limit: wall-clock time after which the results so far are returned: "2 h".
        shard (str): part of the replicas for this process: "2/8".
        seed (int): of all replicas.
        output: prefix of the records; default: measure.
        executor (concurrent.futures.Executor): computes the replicas: a pool of processes, dask's
            ``Client.get_executor()``, ``mpi4py.futures.MPIPoolExecutor``. The bits do not depend on it.

    Returns:
        Report: with the keys of ``polhode measure --json``.

    Raises:
        Error: if there is no such property, or the model does not have it.
        RunError: if a replica blows up, or the state is a vapour, two phases or a solid.
    """
    return _measured(measure, locals(), executor=executor)


def merge(system: Path | Sequence[Path], properties: str | Sequence[str] | Mapping[str, Quantity | None], *,
          at: str | Sequence[str] | None = None, molecules: SupportsIndex | None = None, mixing: str | None = None,
          solute: Path | None = None, replicas: SupportsIndex | None = None, sampling: str | None = None,
          scheme: str | None = None, step: Quantity | None = None, seed: SupportsIndex | None = None, output: Path | None = None) -> Report:
    """The properties from the records of all shards, without new computations, as ``polhode merge``.

    Args:
        system, properties, at, molecules, mixing, solute, replicas, sampling, scheme, step, seed, output: as in measure().

    Returns:
        Report: as from measure().
    """
    return _measured(merge, locals(), only_evaluate=True)


def _measured(function, given, *, executor=None, only_evaluate=False):
    at = given["at"]
    at = at if at is None or isinstance(at, str) else "; ".join(at)
    job = _Job(function, {**given, "at": at})
    texts = {name: text for name, text in job.texts.items()
             if name not in ("system", "properties", "executor", "paired_runs")}
    if not given.get("paired_runs", True):
        texts["paired_runs"] = "no"
    files = given["system"]
    system, *others = [files] if isinstance(files, (str, os.PathLike)) else files
    system, words = os.fspath(system), [*map(os.fspath, others), *_words(given["properties"])]

    def execute(tasks):
        futures = [executor.submit(_perform, system, words, texts, task) for task in tasks]
        return [future.result() for future in futures]

    text, files = job.call(_core.measure, system, words, texts, only_evaluate, execute if executor is not None else None)
    return Report(function.__name__, json.loads(text), files)
