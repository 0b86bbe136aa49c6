# SPDX-License-Identifier: MIT
"""A simulation in memory: steps, views of its state, energies, checkpoints."""

from __future__ import annotations

import json
import math
import os
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, SupportsIndex, TypeAlias

import numpy as np

from . import _core
from ._guard import Energies, Guarded
from ._html import simulation_html
from ._keywords import PATH_OF, takes_settings
from ._lookup import Molecule, kinds_of
from ._progress import hooks
from ._quantities import positive
from ._results import EnergySeries, Report, Run
from ._settings import Settings, settings
from ._state import State
from ._trajectories import mdtraj_trajectory, universe
from ._types import Path, Progress, Quantity, Source
from ._viewer import view_3d
from .errors import Error

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._keywords import Keywords

Observers: TypeAlias = \
    "Callable[[Simulation], object] | Sequence[Callable[[Simulation], object]] | None"


# The settings that determine the scheme and the ensemble.
_CHANGEABLE = {"temperature", "integrator", "thermostat", "barostat",
               *(word for word, path in PATH_OF.items() if path.split(".")[0] in ("integrator", "thermostat", "barostat"))}
_METHODS = {"step": "it is the method that advances; the time step is simulation.time_step = \"1 fs\"",
            "run": "it is the method that advances by a time",
            "state": "write 'with simulation.state.change() as state:', and there state.positions = ..."}


class Simulation(Guarded):
    """The system of a run file and its trajectory.

    Args:
        source, **keywords: as in polhode.settings(): a run file, a dict, or keywords such as
            ``molecules="tip4p", count=512, density="1 g/cm3", scheme="hoa2", step="4 fs"``.
        threads (int): default: one for each available core, or POLHODE_THREADS. Results have the
            same bits for any number.

    The trajectory has the same bits as the trajectory of ``polhode run``, whether it is computed by step()
    or run(), or resumed.

    Raises:
        Error: if a setting or the initial configuration is invalid.

    A simulation may be used by only one thread at a time. Several simulations can run in several threads.

    Between steps, temperature, pressure, time_step, scheme, thermostat and barostat can be set; see
    change().
    """

    __slots__ = ("_settings", "_core", "_last_run", "__weakref__")
    _remedy = "it follows from the settings and the state; another one needs a new Simulation"
    _instead = {**{word: f"write simulation.change({word}=...)" if word in _CHANGEABLE else
                   f"make a new simulation, polhode.Simulation(simulation.settings, {word}=...)"
                   for word in PATH_OF}, **_METHODS}

    @takes_settings
    def __init__(self, source: Source = None, *, threads: int | None = None,
                 **keywords: Unpack[Keywords]) -> None:
        self._settings = settings(source, **keywords)
        self._core = _core.Simulation(self._settings._core, _core.threads(threads))
        self._last_run = None

    @property
    def settings(self) -> Settings:
        """Settings: the present settings, with all changes since the simulation was made."""
        return self._settings

    @property
    def last_run(self) -> Run | None:
        """Run: the last result of run(), also if it was interrupted."""
        return self._last_run

    @property
    def state(self) -> State:
        """State: views of positions, momenta, orientations and angular momenta."""
        return State(self._core, self.settings)

    @property
    def steps(self) -> int:
        """Steps of the trajectory done so far."""
        return self._core.steps

    @property
    def time(self) -> float:
        """Time of the state [ps]."""
        return self._core.time

    def change(self, **keywords: Unpack[Keywords]) -> None:
        """Changes one or more of scheme, step, temperature, thermostat and barostat between two steps:
        ``simulation.change(scheme="gier4-fd", step="6 fs")``. Momenta do not change.

        A new segment of the trajectory begins, with separate statistics, heat and work, to which the
        summary refers. ``summary.segment`` contains its first step and the changes. Checkpoints are
        the same as for a simulation that is made with these settings.

        Args:
            **keywords: keywords of polhode.settings() for the scheme and the ensemble.

        Raises:
            Error: if a setting cannot be changed, or is invalid; nothing is changed then.
        """
        for word in keywords:
            if word not in _CHANGEABLE:
                raise Error(f"{word} cannot be changed in a simulation under way, but scheme, step, temperature, "
                            "thermostat and barostat can; make a new one: "
                            f"polhode.Simulation(simulation.settings, {word}=...)")
        new = settings(self._settings, **keywords)
        self._core.change(new._core)
        self._settings = new

    @property
    def time_step(self) -> float:
        """The time step [ps]; it is set as a quantity such as ``"2 fs"``."""
        return self._core.config.step

    @time_step.setter
    def time_step(self, value: Quantity) -> None:
        self.change(step=value)

    @property
    def scheme(self) -> str:
        """The splitting scheme: a name, or stages as text."""
        return self._core.config.scheme

    @scheme.setter
    def scheme(self, value: str) -> None:
        self.change(scheme=str(value))

    @property
    def temperature(self) -> float | None:
        """Target temperature [K], None at constant energy; it is set as a quantity such as ``"300 K"``.
        The temperature of the momenta is in `energies`."""
        return self._core.config.kept_temperature

    @temperature.setter
    def temperature(self, value: Quantity) -> None:
        self.change(temperature=value)

    @property
    def pressure(self) -> float | None:
        """Target pressure of a barostat [bar], None without a barostat; it is set as a quantity such as ``"1 bar"``."""
        return self._core.config.pressure

    @pressure.setter
    def pressure(self, value: Quantity) -> None:
        self.change(pressure=value)

    @property
    def thermostat(self) -> str | None:
        """The type of the thermostat, None if there is none; it is set as a type or a dict with parameters."""
        return self._core.config.thermostat

    @thermostat.setter
    def thermostat(self, value: str | Mapping[str, Any] | None) -> None:
        self.change(thermostat="none" if value is None else value)

    @property
    def barostat(self) -> str | None:
        """The type of the barostat, None if there is none; it is set as a type or a dict with parameters."""
        return self._core.config.barostat

    @barostat.setter
    def barostat(self, value: str | Mapping[str, Any] | None) -> None:
        self.change(barostat="none" if value is None else value)

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
        """list of (str, int): names and counts of the molecules, in the order of the rows."""
        return self._core.parts()

    @property
    def kinds(self) -> list[Molecule]:
        """list of Molecule: the molecule of each entry of `molecules`."""
        return kinds_of(self._core)

    @property
    def energies(self) -> dict[str, float]:
        """dict: energies of the present state [kJ/mol], temperature [K], pressure [bar], volume
        [nm³]; computed by a separate force evaluation, which does not affect the trajectory."""
        row = self._core.energies()
        return Energies(zip(EnergySeries.names(), row, strict=True))

    @property
    def forces(self) -> tuple[np.ndarray, np.ndarray]:
        """Forces (n, 3) [kJ/mol/nm], and torques (n, 3) about the centres of mass [kJ/mol], at the
        present positions; lab frame."""
        return self._core.forces()

    @property
    def summary(self) -> Report:
        """Report: statistics of the trajectory so far, with the keys of ``polhode run --json``. After a
        change, only the present segment is included.

        Raises:
            Error: if there is no trajectory yet.
        """
        return Report("run", json.loads(self._core.report()), [])

    def sites(self, massless: bool = True) -> tuple[np.ndarray, np.ndarray]:
        """Positions (m, 3) [nm] and velocities (m, 3) [nm/ps] of all sites. Molecules are whole, and
        their centres are in the box."""
        return self._core.sites(massless)

    def choose_step(self, progress: Progress = None) -> None:
        """Lets the adviser choose the step, if the settings require an accuracy.

        Raises:
            RunError: if no scheme meets it.
        """
        with hooks(progress) as h:
            self._core.choose_step(h.progress, h.message)

    def step(self, steps: SupportsIndex = 1) -> None:
        """Advances by a number of steps, with the equilibration of the settings before the first.

        Raises:
            RunError: if the trajectory blows up.
            KeyboardInterrupt: after Ctrl-C, between two steps; the simulation remains usable.
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
            length: "15 ps", rounded to whole steps; default: the remaining part of the length in the settings.
            observe: function, or list of functions, called with this simulation at the start, and
                then at each interval.
            every: interval of calls such as "20 fs", rounded down to whole steps; default: the interval
                of the energy samples.
            frames: interval at which positions of sites are stored in the result, such as "0.1 ps".
            progress: see polhode.Progress.

        Returns:
            Run: energies, frames and summary.

        Raises:
            RunError: if the trajectory blows up.
            KeyboardInterrupt: after Ctrl-C, between two steps; `last_run` has the results so far,
                and another call continues.
        """
        if (self.settings.tables.get("integrator") or {}).get("accuracy") is not None:  # instead of a step
            self.choose_step(progress)
        tasks = _tasks(observe, every, frames, self._core)
        total = _steps(self._core, length)
        self._last_run = Run(self)
        with hooks(progress) as h:
            try:
                _advance(self._core, total, tasks, self, h)
            finally:
                self._last_run._add(self._core.take_energies(), tasks)
        return self._last_run

    def save(self, path: Path) -> None:
        """Writes a checkpoint, from which a simulation with the same settings resumes bit for bit."""
        call = self._settings.call.replace("polhode.settings(", "polhode.Simulation(", 1)
        self._core.save(os.fspath(path), f"{call}.save({os.fspath(path)!r})")

    def resume(self, path: Path) -> None:
        """Continues from a checkpoint of the same run.

        Raises:
            Error: if the file is damaged, or belongs to another run, version or instruction set.
        """
        self._core.resume(os.fspath(path))

    def write(self, path: Path, massless: bool = True, velocities: bool = True) -> None:
        """Writes the state to a coordinate file. The extension selects the format, and an existing file is replaced."""
        self._core.write(os.fspath(path), massless, velocities)

    def cite(self) -> str:
        """str: the references to cite for this simulation, as in the manual, "How to cite"."""
        from ._citing import citations

        return citations(self)

    def to_mdanalysis(self):
        """MDAnalysis.Universe with the present state or, for a Run, with all its frames."""
        return universe(self, [self._frame()])

    def to_mdtraj(self):
        """mdtraj.Trajectory with the present state."""
        return mdtraj_trajectory(self, [self._frame()])

    def view_3d(self, width: int = 640, height: int = 480, js: str | None = None):
        """A three-dimensional view of the atoms for notebooks, which can be rotated and zoomed. For a Run the view is
        an animation of the frames.

        The browser of the notebook loads the script 3Dmol.js from the network.

        Args:
            width, height: in pixels.
            js: address of 3Dmol.js, such as a local copy; default: the address that py3Dmol uses.

        Returns:
            py3Dmol.view, whose methods change style and labels; lengths are in Å.

        Raises:
            Error: if py3Dmol is not installed, or there are more than 200,000 atoms.
        """
        return view_3d(self, [self._frame()], width, height, js)

    def _frame(self):
        return self.time, self.state.box, self.sites()[0]

    def __repr__(self):
        names = ", ".join(f"{n} {name}" for name, n in self.molecules)
        return f"<Simulation of {names}: {self.steps} steps, {self.time:g} ps>"

    _repr_html_ = simulation_html

    def __reduce__(self):
        raise TypeError("a Simulation cannot be pickled: write a checkpoint with save(), and pickle "
                        "its settings")


class _Frames:
    """Stores the positions of sites."""

    def __init__(self):
        self.kept = []

    def __call__(self, simulation):
        self.kept.append(simulation._frame())


def _steps(core, length):
    """The number of steps in a length, or up to the length in the settings."""
    if length is None:
        steps = core.steps_left()
        if steps == 0:
            raise Error(f"the trajectory has the {core.config.length:g} ps of the settings already; give the length "
                        "to run further: run(\"1 ps\")")
        return steps
    steps = core.steps_in(positive(length, "time", "length"))
    if steps == 0:
        raise Error(f"length = \"{length}\" is shorter than half a step of {1000 * core.config.step:g} fs; it must "
                    "be at least one step")
    return steps


def _interval(core, time):
    """The number of whole steps (or trajectories of hybrid Monte Carlo) in an interval [ps], at least one."""
    step = core.config.step
    whole = core.steps_in(step)
    return math.ceil(max(1, math.floor(min(time / step, 2**53) + 1e-9)) / whole) * whole


def _tasks(observe, every, frames, core):
    """The list of tasks as (steps between calls, function)."""
    tasks = []
    if frames is not None:
        tasks.append((_interval(core, positive(frames, "time", "frames")), _Frames()))
    if observe is not None:
        functions = observe if isinstance(observe, (list, tuple)) else [observe]
        if not all(callable(f) for f in functions):
            raise Error("observe must be a function of the simulation, or a list of them")
        interval = _interval(core, core.config.sample if every is None else positive(every, "time", "every"))
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
