# SPDX-License-Identifier: MIT
"""The keywords of settings: the keys of run files, as the reader of the library knows them.

A key is a keyword without its table, unless several tables have it: then it is that of the first.
"""

import inspect

from . import _core

__all__ = ["KEYWORDS", "LISTS", "TABLES", "TABLE_OF", "stub", "takes_settings"]

# Whose keys are keywords in their tables only: lengths and steps of several runs.
OF_TABLES = ("study", "prepare")
LISTS = ("pair", "shape")  # of tables
# Keys by another name, or none: thermostat="langevin" is the type of a thermostat.
RENAMED = {("integrator", "lambda"): "lambda_", ("hybrid_monte_carlo", "steps"): "hybrid_steps",
           ("thermostat", "type"): None, ("barostat", "type"): None}

KINDS = {"text": "Text", "quantity": "Quantity", "number": "float", "integer": "int", "boolean": "bool",
         "texts": "Texts", "table": "Mapping[str, Any]", "tables": "Sequence[Mapping[str, Any]]"}
# What Python takes besides the kinds of the run file.
MORE = {"molecules": "Text | Molecule | Mapping[str, Any] | Sequence[Any]",
        "forces": "Mapping[str, Any] | Callable[..., Any]",
        "thermostat": "str | Mapping[str, Any]", "barostat": "str | Mapping[str, Any]"}

TABLES, TABLE_OF, KEY_OF, KEYWORDS = [], {}, {}, {}


def _read_keys():
    for table, key, kinds in _core.setting_keys():
        kind = " | ".join(dict.fromkeys(KINDS[k] for k in kinds))
        if not table:
            TABLES.append(key)
            continue
        word = RENAMED.get((table, key), key)
        if table in OF_TABLES or word is None or word in TABLE_OF:
            continue
        TABLE_OF[word], KEY_OF[word] = table, key
        KEYWORDS[word] = MORE.get(word, kind)
        if word == "molecules":
            KEYWORDS["count"] = "int"
    for table in TABLES:
        KEYWORDS[table] = MORE.get(table, KINDS["tables" if table in LISTS else "table"])


_read_keys()


def takes_settings(function):
    """Shows the settings as keywords of a function that takes them as **keywords: in its signature,
    for completion and help(). Parameters of its own have precedence."""
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
TABLE_OF: dict[str, str]
KEY_OF: dict[str, str]
KEYWORDS: dict[str, str]

def takes_settings(function: _F) -> _F: ...
def stub() -> str: ...
'''
