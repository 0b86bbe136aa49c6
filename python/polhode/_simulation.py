# SPDX-License-Identifier: MIT
"""A simulation in memory: steps, views of its state, energies, checkpoints."""

import json
import math
import os
from collections.abc import Callable, Sequence
from typing import SupportsIndex, TypeAlias

import numpy as np

from . import _core
from .errors import Error
from ._lookup import Molecule, kinds_of
from ._progress import hooks
from ._quantities import quantity
from ._results import EnergySeries, Report, Run
from ._settings import settings
from ._types import Path, Progress, Quantity, Source

__all__ = ["Simulation", "State"]

Observers: TypeAlias = \
    "Callable[[Simulation], object] | Sequence[Callable[[Simulation], object]] | None"


def _steps_of(time, step, name):
    """The number of steps in a time [ps].

    Raises:
        Error: if it is not a whole number from 1.
    """
    steps = time / step
    if not 0.5 <= steps < 2**53 or abs(steps - round(steps)) > 1e-6 * max(steps, 1):
        raise Error(f"{name} of {time:g} ps is not a whole number of steps of {1000 * step:g} fs; "
                    f"{1000 * step * max(1, round(min(steps, 1e15))):g} fs would be")
    return round(steps)


class State:
    """The state of a simulation: views of the numbers in use, without a copy.

    A view shows the present state at any time, also after further steps; it is read-only, and
    stays valid as long as it exists. To change the state, enter change()::

        with simulation.state.change() as state:
            state.positions[0] += [0.1, 0, 0]

    Rows are molecules, in the order of the topology.
    """

    def __init__(self, core, settings):
        self._core = core
        self._settings = settings  # which have the forces of one's own

    @property
    def positions(self) -> np.ndarray:
        """Centres of mass (n, 3) [nm], lab frame, not wrapped into the box."""
        return self._core.positions

    @property
    def momenta(self) -> np.ndarray:
        """Momenta (n, 3) [u nm/ps], lab frame."""
        return self._core.momenta

    @property
    def attitudes(self) -> np.ndarray:
        """Attitudes (n, 4), unit quaternions (w, x, y, z) that rotate body to lab."""
        return self._core.attitudes

    @property
    def angular_momenta(self) -> np.ndarray:
        """Angular momenta (n, 3) about the centres of mass [u nm²/ps], lab frame."""
        return self._core.angular_momenta

    @property
    def box(self) -> np.ndarray:
        """Edges of the periodic box (3) [nm]; a copy."""
        return self._core.box

    @property
    def time(self) -> float:
        """Time [ps]."""
        return self._core.time

    def __len__(self):
        return self._core.molecules

    def __repr__(self):
        return f"<state of {len(self)} molecules at {self.time:g} ps>"

    def change(self) -> "_Change":
        """A context in which the state can be changed: its target has the writable arrays
        `positions`, `momenta`, `attitudes` and `angular_momenta`.

        At its end attitudes are normalized, and a trajectory begins with new forces and statistics;
        steps are counted on. If an exception leaves the block, or a number is wrong, the state is
        as it was before. The arrays must not be kept: later writes have no defined effect.

        Raises:
            Error: at the end, naming the molecule, if a number is not finite or an angular momentum
                has a component along an axis without inertia.
        """
        return _Change(self._core, self._settings)

    def _set(self, **arrays):
        with self.change() as state:
            for name, values in arrays.items():
                getattr(state, name)[...] = values


class _Change:
    """The target of State.change()."""

    def __init__(self, core, settings):
        self._core, self._settings, self._arrays = core, settings, ()

    def __enter__(self):
        self._arrays = self._core.begin_change()
        self.positions, self.momenta, self.attitudes, self.angular_momenta = self._arrays
        return self

    def __exit__(self, kind, *_):
        for array in self._arrays:
            array.flags.writeable = False
        self._core.end_change(kind is None)
        return False


class Simulation:
    """The system of a run file and its trajectory.

    Args:
        source, **keywords: as in polhode.settings(): a run file, a dict, or keywords such as
            ``molecules="tip4p", count=512, density="1 g/cm3", scheme="hoa2", step="4 fs"``.
        threads (int): default: one for each available core, or POLHODE_THREADS. Results have the
            same bits for any number.

    The trajectory has the same bits as that of ``polhode run``, whether it is computed by step()
    or run(), or resumed.

    Raises:
        Error: if a setting or the initial configuration does not fit.

    A simulation is used by one thread at a time; several simulations can run in several threads.
    """

    def __init__(self, source: Source = None, *, threads: int | None = None,
                 **keywords: object) -> None:
        self.settings = settings(source, **keywords)
        self._core = _core.Simulation(self.settings._core, _core.threads(threads))
        #: Run: the last result of run(), also if it was interrupted.
        self.last_run = None

    @property
    def state(self) -> State:
        """State: views of positions, momenta, attitudes and angular momenta."""
        return State(self._core, self.settings)

    @property
    def steps(self) -> int:
        """Steps of the trajectory done so far."""
        return self._core.steps

    @property
    def time(self) -> float:
        """Time of the state [ps]."""
        return self._core.time

    @property
    def masses(self) -> np.ndarray:
        """Mass of each molecule (n) [u]; a read-only view."""
        return self._core.masses

    @property
    def moments(self) -> np.ndarray:
        """Principal moments of inertia of each molecule (n, 3) [u nm²]; a read-only view."""
        return self._core.moments

    @property
    def molecules(self) -> list[tuple[str, int]]:
        """list of (str, int): names and counts, in the order of the rows."""
        return self._core.parts()

    @property
    def kinds(self) -> list[Molecule]:
        """list of Molecule: of each entry of `molecules`."""
        return kinds_of(self._core)

    @property
    def energies(self) -> dict[str, float]:
        """dict: energies of the present state [kJ/mol], temperature [K], pressure [bar], volume
        [nm³]; from a force evaluation that leaves the trajectory as it is."""
        row = self._core.energies()
        return dict(zip(EnergySeries.names(), row, strict=True))

    @property
    def forces(self) -> tuple[np.ndarray, np.ndarray]:
        """Forces (n, 3) [kJ/mol/nm], and torques (n, 3) about the centres of mass [kJ/mol], at the
        present positions; lab frame."""
        return self._core.forces()

    @property
    def summary(self) -> Report:
        """Report: statistics of the trajectory so far, with the keys of ``polhode run --json``.

        Raises:
            Error: if there is no trajectory yet.
        """
        return Report("run", json.loads(self._core.report()), [])

    def sites(self, massless: bool = True) -> tuple[np.ndarray, np.ndarray]:
        """Positions (m, 3) [nm] and velocities (m, 3) [nm/ps] of all sites, molecules whole and
        with their centres in the box."""
        return self._core.sites(massless)

    def choose_step(self, progress: Progress = None) -> None:
        """Lets the adviser choose the step, if the settings ask for an accuracy.

        Raises:
            RunError: if no scheme meets it.
        """
        with hooks(progress) as h:
            self._core.choose_step(h.progress, h.message)

    def step(self, steps: SupportsIndex = 1) -> None:
        """Advances by a number of steps, with the equilibration of the settings before the first.

        Raises:
            RunError: if the trajectory blows up.
            KeyboardInterrupt: after Ctrl-C, between two steps; the simulation can be used on.
        """
        if isinstance(steps, bool) or not hasattr(steps, "__index__"):
            raise Error(f"steps = {steps!r} must be a whole number; a time is simulated by "
                        "run(\"1 ps\")")
        if not 0 <= steps.__index__() < 2**53:
            raise Error(f"steps = {steps} must be from 0 to 2^53")
        self._core.step(steps.__index__(), False, None, None)

    def run(self, length: Quantity | None = None, *,
            observe: Observers = None, every: Quantity | None = None,
            frames: Quantity | None = None, progress: Progress = None) -> Run:
        """Advances by a time, in memory; no file is written.

        Args:
            length: "15 ps"; default: that of the settings.
            observe: function, or list of functions, called with this simulation at the start, and
                then at each interval.
            every: the interval: "20 fs"; default: that of the samples of the energies.
            frames: interval at which positions of sites are kept for the result: "0.1 ps".
            progress: see polhode.Progress.

        Returns:
            Run: energies, frames and summary.

        Raises:
            RunError: if the trajectory blows up.
            KeyboardInterrupt: after Ctrl-C, between two steps; `last_run` has the results so far,
                and another call continues.
        """
        config = self.settings._core
        if config_accuracy(self.settings):
            self.choose_step(progress)
        step = self._core.config.step
        total = _steps_of(quantity(length, "time", "length"), step, "the length") if length is not \
            None else max(1, math.floor(config.length / step + 1e-9) - self.steps)
        tasks = _tasks(observe, every, frames, step, config.sample)
        self.last_run = Run(self)
        with hooks(progress) as h:
            try:
                _advance(self._core, total, tasks, self, h)
            finally:
                self.last_run._add(self._core.take_energies(), tasks)
        return self.last_run

    def save(self, path: Path) -> None:
        """Writes a checkpoint, from which a simulation of the same settings resumes bit for bit."""
        self._core.save(os.fspath(path))

    def resume(self, path: Path) -> None:
        """Continues from a checkpoint of the same run.

        Raises:
            Error: if it is damaged, or of another run, version or instruction set.
        """
        self._core.resume(os.fspath(path))

    def write(self, path: Path, massless: bool = True, velocities: bool = True) -> None:
        """Writes the state to a coordinate file, whose extension selects the format; an existing
        one is replaced."""
        self._core.write(os.fspath(path), massless, velocities)

    def cite(self) -> str:
        """str: what to cite for this simulation, as in the manual, "How to cite"."""
        from ._citing import citations

        return citations(self)

    def to_mdanalysis(self):
        """MDAnalysis.Universe with the present state; of a Run: with all its frames."""
        from ._trajectories import universe

        return universe(self, [self._frame()])

    def to_mdtraj(self):
        """mdtraj.Trajectory with the present state."""
        from ._trajectories import mdtraj_trajectory

        return mdtraj_trajectory(self, [self._frame()])

    def view_3d(self, width: int = 640, height: int = 480, js: str | None = None):
        """A view of the atoms in three dimensions for notebooks, to turn and zoom; of a Run: an
        animation of its frames.

        The browser of the notebook loads the script 3Dmol.js from the network.

        Args:
            width, height: in pixels.
            js: the address of 3Dmol.js, such as that of a copy; default: that of py3Dmol.

        Returns:
            py3Dmol.view, whose methods change style and labels; lengths in Å, as it has them.

        Raises:
            Error: if py3Dmol is not installed, or there are more than 200,000 atoms.
        """
        from ._viewer import view_3d

        return view_3d(self, [self._frame()], width, height, js)

    def _frame(self):
        return self.time, self.state.box, self.sites()[0]

    def __repr__(self):
        names = ", ".join(f"{n} {name}" for name, n in self.molecules)
        return f"<Simulation of {names}: {self.steps} steps, {self.time:g} ps>"

    def _repr_html_(self):
        from ._html import simulation_html

        return simulation_html(self)

    def __reduce__(self):
        raise TypeError("a Simulation cannot be pickled: write a checkpoint with save(), and pickle "
                        "its settings")


def config_accuracy(of):
    """Whether settings ask for an accuracy instead of a step."""
    return (of.tables.get("integrator") or {}).get("accuracy") is not None


class _Frames:
    """Keeps the positions of sites."""

    def __init__(self):
        self.kept = []

    def __call__(self, simulation):
        self.kept.append(simulation._frame())


def _tasks(observe, every, frames, step, sample):
    """[(steps between calls, function)]."""
    tasks = []
    if frames is not None:
        tasks.append((_steps_of(quantity(frames, "time", "frames"), step, "frames"), _Frames()))
    if observe is not None:
        functions = observe if isinstance(observe, (list, tuple)) else [observe]
        if not all(callable(f) for f in functions):
            raise Error("observe must be a function of the simulation, or a list of them")
        interval = max(1, round(sample / step)) if every is None else \
            _steps_of(quantity(every, "time", "every"), step, "every")
        tasks += [(interval, f) for f in functions]
    elif every is not None:
        raise Error("every is the interval of observe, which is not given")
    return tasks


def _advance(core, total, tasks, simulation, h):
    """Takes steps, and calls each task at its interval, the first time at the start."""
    for _, task in tasks:
        task(simulation)
    if not tasks:
        core.step(total, True, h.progress, h.message)
        return
    chunk = math.gcd(total, *(interval for interval, _ in tasks))
    for done in range(chunk, total + 1, chunk):
        core.step(chunk, True, None, h.message)
        for interval, task in tasks:
            if done % interval == 0:
                task(simulation)
        if h.progress is not None:
            h.progress("running", done / total, "")
