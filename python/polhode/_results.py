# SPDX-License-Identifier: MIT
"""Results: energies as a structured array, and reports of jobs as dicts with a display for notebooks."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from . import _core
from ._guard import Guarded, Record, missing
from ._html import report_html, run_html
from ._plots import plot_energies, plot_report
from ._trajectories import mdtraj_trajectory, universe
from ._viewer import view_3d
from .errors import Error


class EnergySeries(Guarded):
    """Energies along a trajectory: the columns of PREFIX-energies.csv."""

    __slots__ = ("_array", "_conserves")

    def __init__(self, rows, conserves=True):
        self._conserves = conserves
        self._array = rows.view([(name, float) for name in self.names()]).reshape(len(rows))

    @property
    def conserves(self) -> bool:
        """bool: whether "conserved" is a conserved energy. With hybrid Monte Carlo it performs a random walk, the sum
        of the energy errors of all trajectories. Rejections compensate for these errors."""
        return self._conserves

    @property
    def array(self) -> np.ndarray:
        """numpy.ndarray: structured, one row per sample, fields names(); times [ps], energies [kJ/mol],
        temperature [K], pressure [bar], volume [nm³]."""
        return self._array

    @staticmethod
    def names() -> list[str]:
        """list of str: the names of the fields."""
        return [name for name, _ in _core.energy_columns()] + ["external"]

    @staticmethod
    def units() -> dict[str, str]:
        """dict: the unit of each field."""
        return {**dict(_core.energy_columns()), "external": "kJ/mol"}

    def __len__(self):
        return len(self.array)

    def __getitem__(self, key):
        if isinstance(key, str) and key not in self.array.dtype.names:
            raise KeyError(missing(key, self.names()))
        return self.array[key]

    def __array__(self, dtype=None, copy=None):
        return np.array(self.array, dtype=dtype, copy=True if copy is None else copy)

    @property
    def ratio(self) -> float | None:
        """R, the rms fluctuation of the conserved energy divided by the rms fluctuation of the potential
        energy; None for hybrid Monte Carlo, which does not conserve any energy."""
        if not self.conserves:
            return None
        if len(self) < 3:
            raise Error(f"R needs at least 3 samples of the energies, and there are {len(self)}")
        return float(self["conserved"].std() / self["potential"].std())

    def to_pandas(self):
        """pandas.DataFrame with the time as its index."""
        import pandas

        return pandas.DataFrame(self.array).set_index("time")

    def __repr__(self):
        if not len(self):
            return "<no energies>"
        return (f"<energies of {len(self)} samples, {self['time'][0]:g} to "
                f"{self['time'][-1]:g} ps>")


class Report(Record, Mapping):
    """The report of a job. Its keys are the keys of the JSON output, as in ``report["R"]`` or ``report.R``. Names contain
    units, as in "length_ps"."""

    __slots__ = ("_job", "_files", "_complete", "_rows")

    def __init__(self, job, data, files, complete=True):
        self._rows = data.pop("rows", [])
        self._job, self._data, self._complete = job, data, complete
        self._files = list(files)
        if not files:
            self._data = {k: v for k, v in data.items() if k not in ("files", "energies_file")}

    @property
    def job(self) -> str:
        """str: the verb of the job, such as "run" or "study"."""
        return self._job

    @property
    def files(self) -> list[str]:
        """list of str: paths of the files that were written."""
        return self._files

    @property
    def rows(self) -> list[dict]:
        """list of dict: the rows that --verbose prints on the command line, with "label", "text", "meaning", "level" of
        indentation and "table", whose first row is the head."""
        return self._rows

    @property
    def complete(self) -> bool:
        """bool: whether the job was completed; False if it was interrupted."""
        return self._complete

    def __getitem__(self, key):
        if key not in self.data:
            raise KeyError(missing(key, self.data))
        return self.data[key]

    def __iter__(self):
        return iter(self.data)

    def __len__(self):
        return len(self.data)

    def __repr__(self):
        return f"<report of {self.job}: {', '.join(list(self.data)[:6])}, ...>"

    _repr_html_ = report_html

    def plot(self, ax=None):
        """Draws the results with matplotlib, if the job has a figure, as a study does.

        Returns:
            matplotlib.axes.Axes, or an array of them.
        """
        return plot_report(self, ax)


class Run(Guarded):
    """The result of Simulation.run()."""

    __slots__ = ("_simulation", "_energies", "_frames", "_summary", "__weakref__")

    def __init__(self, simulation):
        self._simulation = simulation
        self._energies = EnergySeries(np.zeros((0, len(EnergySeries.names()))))
        self._frames = []

    def _add(self, rows, tasks):
        hybrid = self.simulation.settings.tables.get("hybrid_monte_carlo") is not None
        self._energies = EnergySeries(rows, conserves=not hybrid)
        self._frames = next((task.kept for _, task in tasks if hasattr(task, "kept")), [])

    @property
    def energies(self) -> EnergySeries:
        """EnergySeries: samples of the energies."""
        return self._energies

    @property
    def frames(self) -> list:
        """list of (time [ps], box (3) [nm], positions of all sites (m, 3) [nm]), if requested."""
        return self._frames

    @property
    def simulation(self):
        """Simulation: the simulation of the run; None in a pickled copy, which keeps the summary."""
        return self._simulation

    @property
    def summary(self) -> Report:
        """Report: statistics of the simulation's trajectory so far, or of its present segment."""
        return self._summary if self.simulation is None else self.simulation.summary

    def __getstate__(self):
        return {"_energies": self.energies, "_frames": self.frames, "_simulation": None,
                "_summary": self.summary}

    def __setstate__(self, state):
        for name, value in state.items():
            setattr(self, name, value)

    @property
    def ratio(self) -> float | None:
        """R of these samples: the rms fluctuation of the conserved energy, divided by the rms fluctuation of the
        potential energy. It is None for hybrid Monte Carlo. The summary then has the acceptance and the number of
        effective samples."""
        return self.energies.ratio

    def to_pandas(self):
        """pandas.DataFrame of the energies."""
        return self.energies.to_pandas()

    def plot(self, ax=None):
        """Draws total and potential energy against time with matplotlib, and returns the two Axes."""
        return plot_energies(self.energies, ax)

    def to_mdanalysis(self):
        """MDAnalysis.Universe with the frames in memory."""
        return universe(self.simulation, self.frames)

    def to_mdtraj(self):
        """mdtraj.Trajectory with the frames."""
        return mdtraj_trajectory(self.simulation, self.frames)

    def view_3d(self, width: int = 640, height: int = 480, js: str | None = None):
        """A three-dimensional animation of the frames for notebooks, with the box of the first frame; see
        Simulation.view_3d()."""
        return view_3d(self.simulation, self.frames, width, height, js)

    def __repr__(self):
        return f"<Run: {self.energies!r}, {len(self.frames)} frames>"

    _repr_html_ = run_html
