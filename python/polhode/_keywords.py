# SPDX-License-Identifier: MIT
"""The keywords of settings, which are the keys of run files.

With its table every key is a keyword: barostat_time_constant, study_runs; or as a path,
"barostat.time_constant". A key that occurs in a single table is also a keyword without the table.
"""

import inspect

from . import _core

# Tables whose keywords always contain the table name, such as study_length, because other tables have the same keys.
OF_TABLES = ("study", "prepare")
LISTS = ("pair", "shape")  # of tables
# Keys whose keyword differs from the key. None marks a key without its own keyword: thermostat="langevin" sets the type of the
# thermostat.
RENAMED = {("integrator", "lambda"): "lambda_", ("hybrid_monte_carlo", "steps"): "hybrid_steps",
           ("thermostat", "type"): None, ("barostat", "type"): None}

KINDS = {"text": "Text", "quantity": "Quantity", "number": "float", "integer": "int", "boolean": "bool",
         "texts": "Texts", "table": "Mapping[str, Any]", "tables": "Sequence[Mapping[str, Any]]"}
# Types of values that Python accepts in addition to the types of run files.
MORE = {"molecules": "Text | Molecule | Mapping[str, Any] | Sequence[Any]",
        "forces": "Mapping[str, Any] | Callable[..., Any]",
        "thermostat": "str | Mapping[str, Any]", "barostat": "str | Mapping[str, Any]"}

TABLES, KEYWORDS = [], {}
PATH_OF = {}  # of a keyword: "table.key"
CHOICES_OF = {}  # of a key of several tables: the keywords that it could mean


def _read_keys():
    bare = {}  # of a key without its table: (table, key, kind) of each
    for table, key, kinds in _core.setting_keys():
        if not table:
            TABLES.append(key)
            continue
        kind = " | ".join(dict.fromkeys(KINDS[k] for k in kinds))
        PATH_OF[f"{table}.{key}"] = PATH_OF[f"{table}_{key}"] = f"{table}.{key}"
        word = RENAMED.get((table, key), key)
        if table in OF_TABLES or word is None:
            KEYWORDS[f"{table}_{key}"] = kind
        else:
            bare.setdefault(word, []).append((table, key, kind))
    for word, found in bare.items():
        if len(found) > 1:
            CHOICES_OF[word] = [f"{table}_{word}" for table, _, _ in found]
            KEYWORDS.update((f"{table}_{word}", kind) for table, _, kind in found)
            continue
        [(table, key, kind)] = found
        PATH_OF[word] = f"{table}.{key}"
        KEYWORDS[word] = MORE.get(word, kind)
    KEYWORDS["count"] = "int"  # of molecules
    for table in TABLES:
        KEYWORDS[table] = MORE.get(table, KINDS["tables" if table in LISTS else "table"])


_read_keys()


def takes_settings(function):
    """Adds the settings as keywords to the signature of a function that takes **keywords, for
    completion and help(). Parameters of the function have precedence."""
    signature = inspect.signature(function)
    own = [p for p in signature.parameters.values() if p.kind is not p.VAR_KEYWORD]
    names = {p.name for p in own}
    more = [inspect.Parameter(word, inspect.Parameter.KEYWORD_ONLY, default=None,
                              annotation=f"{kind} | None")
            for word, kind in KEYWORDS.items() if word not in names]
    if more:
        function.__signature__ = signature.replace(parameters=own + more)
    return function


def stub() -> str:
    """The types of this module for type checkers, with the keywords as a TypedDict."""
    words = "".join(f"    {word}: {kind} | None\n" for word, kind in KEYWORDS.items())
    return f'''from collections.abc import Callable, Mapping, Sequence
from typing import Any, TypedDict, TypeVar

from ._lookup import Molecule
from ._types import Quantity, Text, Texts

_F = TypeVar("_F", bound=Callable[..., Any])

class Keywords(TypedDict, total=False):
{words}
TABLES: list[str]
LISTS: tuple[str, ...]
PATH_OF: dict[str, str]
CHOICES_OF: dict[str, list[str]]
KEYWORDS: dict[str, str]

def takes_settings(function: _F) -> _F: ...
def stub() -> str: ...
'''
