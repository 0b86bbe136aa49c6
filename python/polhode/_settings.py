# SPDX-License-Identifier: MIT
"""Settings: the tables and keys of a run file, given by a file, a dict, or keywords."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from types import MappingProxyType
from typing import TYPE_CHECKING

from . import _core
from ._guard import Guarded
from .errors import Error
from .forces import add_forces
from ._calls import call_text
from ._keywords import CHOICES_OF, LISTS, PATH_OF, TABLES, takes_settings
from ._quantities import plain
from ._types import Source

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._keywords import Keywords

# Conversion of Python values to TOML text.

def _string(text):
    """A basic string of TOML."""
    out = ['"']
    for c in text:
        if c in '"\\':
            out.append("\\" + c)
        elif ord(c) < 32 or ord(c) == 127:
            out.append(f"\\u{ord(c):04x}")
        elif 0xD800 <= ord(c) <= 0xDFFF:
            raise Error(f"the text {text!r} has half of a character, which no file can hold")
        else:
            out.append(c)
    return "".join(out) + '"'


def _value(value, name, depth=0):
    """A value as TOML on a single line."""
    value = plain(value)
    if depth > 20:
        raise Error(f"{name} is nested more than 20 levels deep; run files have at most 4")
    if isinstance(value, str):
        return _string(value)
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, int):
        if not -2**63 <= value < 2**63:
            raise Error(f"{name} = {value} does not fit into 64 bits; give a smaller number")
        return str(value)
    if isinstance(value, float):
        return repr(value)
    if isinstance(value, Mapping):
        pairs = (f"{_string(str(k))} = {_value(v, f'{name}.{k}', depth + 1)}"
                 for k, v in value.items() if v is not None)
        return "{ " + ", ".join(pairs) + " }"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(_value(v, f"{name}[{i}]", depth + 1)
                               for i, v in enumerate(value)) + "]"
    raise Error(f"{name} is of type {type(value).__name__}, and must be a text, a number, true or "
                "false, a list, or a dict")


def toml_text(tables) -> str:
    """The TOML text of a dict of tables.

    Raises:
        Error: if a value is not possible in a run file.
    """
    lines = [f"{name} = {_value(tables[name], name)}\n" for name in LISTS  # before all tables
             if tables.get(name) is not None]
    for table, keys in tables.items():
        if keys is None or table in LISTS:
            continue
        if not isinstance(keys, Mapping):
            raise Error(f"{table} must be a dict with the keys of the table [{table}]")
        lines.append(f"[{_string(str(table))}]\n")
        lines += [f"{_string(str(key))} = {_value(value, f'{table}.{key}')}\n"
                  for key, value in keys.items() if value is not None]
    return "".join(lines)


def parsed(text) -> dict:
    """A TOML text as a dict."""
    try:
        import tomllib
    except ModuleNotFoundError:  # Python 3.10
        import tomli as tomllib
    return tomllib.loads(text)


# Keywords.

def _components(molecules, count):
    """Molecules given as "tip4p", a Molecule, {"tip4p": 512}, or a list as in run files."""
    def model(m):
        return m.as_dict() if hasattr(m, "as_dict") else m

    if isinstance(molecules, Mapping) and "site" not in molecules:
        return [{"model": name, "count": n} for name, n in molecules.items()]
    def component(c):
        if isinstance(c, Mapping):
            return {**c, "model": model(c.get("model"))}
        if isinstance(c, (list, tuple)) and len(c) == 2:
            return {"model": model(c[0]), "count": c[1]}
        raise Error(f"molecules has {c!r:.60}, and each must be a (model, count), or a dict with "
                    "the keys model and count")

    if isinstance(molecules, (list, tuple)):
        return [component(c) for c in molecules]
    return [{"model": model(molecules), "count": count}]


def _overrides(words, job):
    """(path, value, keyword) of each key that keywords set. Tables come first, because keys have precedence."""
    own = _core.job_settings(job)
    for word in sorted(words, key=lambda w: w not in TABLES):
        value = words[word]
        if word in TABLES and word not in LISTS and isinstance(value, Mapping):
            yield from ((f"{word}.{key}", v, f"{word}.{key}") for key, v in value.items() if v is not None)
        elif word in own:
            yield own[word], value, word
        elif word in ("thermostat", "barostat"):
            yield f"{word}.type", value, word
        elif word in LISTS:
            yield word, value, word
        elif word in TABLES:
            raise Error(f"{word} must be a dict with the keys of the table [{word}]")
        elif word in CHOICES_OF:
            raise Error(f"the keyword '{word}' has several meanings; write " + " or ".join(CHOICES_OF[word]))
        elif word in PATH_OF:
            yield PATH_OF[word], value, word
        else:
            near = _core.did_you_mean(word, [*PATH_OF, *CHOICES_OF, *TABLES, *own, "count", "threads"])
            raise Error(f"there is no keyword '{word}'{near or '; keys of a run file are keywords, as in '}"
                        + ("" if near else "scheme=\"hoa2\", step=\"2 fs\", run={\"length\": \"1 ps\"}"))


def _overlay(words, job, quick):
    """The overlay of the library that corresponds to keywords."""
    count = words.pop("count", None)
    if "molecules" in words:
        words["molecules"] = _components(words["molecules"], count)
    elif count is not None:
        raise Error("count belongs to molecules; write for example molecules=\"tip4p\", count=512")
    overlay = _core.Overlay(job, quick)
    for path, value, word in _overrides(words, job):
        overlay.add(path, _value(value, word), word)
    return overlay


def _parts(source):
    """Tables, keywords, and external forces of a dict, which has tables as in a run file or keywords."""
    tables = {k: v for k, v in source.items() if k in TABLES and (k in LISTS or isinstance(v, Mapping))}
    words = {k: v for k, v in source.items() if k not in tables and k != "external_forces"}
    return tables, words, source.get("external_forces")


@takes_settings
def settings(source: Source = None, **keywords: Unpack[Keywords]) -> Settings:
    """Makes the settings of a run, as a run file does.

    Args:
        source: path of a run file; a dict with its tables, ``{"system": {...}, ...}``, or with
            keywords; settings that were made before; or None for the default run, 512 TIP4P waters
            (with the keyword ``molecules`` or ``system``: an empty run file).
        **keywords: tables, as in ``run={"length": "1 ps"}``, or keys without their table:
            ``scheme="hoa2"``, ``step="4 fs"``, ``temperature="298 K"``, ``seed=7``,
            ``molecules="tip4p"`` with ``count=512``, ``thermostat="langevin"``; they have precedence
            over the source. With its table every key is a keyword, ``barostat_time_constant="2 ps"``,
            ``study_runs=4``, or a path, ``**{"study.runs": 4}``; a key of two tables, such as
            time_constant, needs it. ``pressure="1 bar"`` without a thermostat selects Langevin, and
            without a barostat cell rescaling. ``forces=f`` adds external forces given by a function, see
            polhode.forces.

    Returns:
        Settings: for any function of this package that takes a run file.

    Raises:
        Error: if a key or a value is invalid, with its place.
    """
    return made(source, keywords)


def made(source, keywords, job="", quick=False) -> Settings:
    """Makes the settings of a job, including the keywords that only this job has."""
    words = {k: v for k, v in keywords.items() if v is not None}
    text, name, own, is_file = None, "keywords", None, False
    if isinstance(source, Settings):
        text, name, own = source.text, source.name, source.own_forces
    elif isinstance(source, Mapping):
        tables, more, own = _parts(source)
        text, name, words = toml_text(tables), "dict", {**more, **words}
    elif source is not None:
        name, is_file = os.fspath(source), True
    if callable(words.get("forces")):
        own = words.pop("forces")
    is_default = not text and not is_file and "molecules" not in words and "system" not in words
    overlay = _overlay(words, job, quick)
    if is_file:
        core = _core.read_config(name, overlay)
    elif is_default:
        core = _core.default_config(overlay)
    else:
        core = _core.parse_config(text or "", name, overlay)
    return Settings(core, name, own, call_text(settings, {"source": source, "keywords": keywords}))


def _view(value):
    """An immutable copy of a value."""
    if isinstance(value, Mapping):
        return MappingProxyType({k: _view(v) for k, v in value.items()})
    return tuple(map(_view, value)) if isinstance(value, list) else value


class Settings(Guarded):
    """The settings of a run, made by settings(). They can be pickled, and are not changed: settings
    with other values are ``polhode.settings(these, step="2 fs")``.
    """

    __slots__ = ("_name", "_own_forces", "_core", "_call", "_tables", "__weakref__")
    _remedy = "settings with another value are polhode.settings(these, step=\"2 fs\")"
    _instead = dict.fromkeys((*PATH_OF, *TABLES), _remedy)

    def __init__(self, core, name, own_forces=None, call=""):
        self._core, self._name, self._own_forces, self._call = core, name, own_forces, call
        self._tables = None
        core.own_forces = None
        if own_forces is not None:
            add_forces(core, own_forces)

    @property
    def tables(self) -> Mapping:
        """The tables of a run file, read-only."""
        if self._tables is None:
            self._tables = _view(parsed(self.text))
        return self._tables

    @property
    def name(self) -> str:
        """str: the origin of the settings, for error messages."""
        return self._name

    @property
    def call(self) -> str:
        """str: the Python call that makes these settings, for records."""
        return self._call

    @property
    def notes(self) -> tuple[str, ...]:
        """tuple of str: notes on defaults that were selected, such as a thermostat for a pressure."""
        return tuple(self._core.notes)

    @property
    def own_forces(self):
        """ExternalForces, or the function that computes them; None if there are none."""
        return self._own_forces

    @property
    def text(self) -> str:
        """The TOML text that was read."""
        return self._core.text

    def describe(self, name: str = "") -> list[dict]:
        """Settings with their values, as ``polhode settings`` prints them.

        Args:
            name: path or key of a setting, or a table: "run.length", "cutoff", "barostat"; all by
                default.

        Returns:
            list: a dict for each setting, with its table, key, meaning, unit, bounds, default and value.

        Raises:
            Error: if the setting does not exist.
        """
        return json.loads(_core.settings_json(name, self._core))

    def __repr__(self):
        return f"<polhode settings of {self.name}>"

    def __reduce__(self):
        return _unpickled, (self.text, self._name, self._own_forces, self._call)


def _unpickled(text, name, own_forces, call):
    return Settings(_core.parse_config(text, name, _core.Overlay("", False)), name, own_forces, call)
