# SPDX-License-Identifier: MIT
"""Calls of the package as Python code that could be typed again, for the records of results."""

import inspect
from collections.abc import Mapping

from ._quantities import plain, text_of


def expression(value) -> str:
    """Python code for a value; for a function, its name."""
    value = text_of(value)
    if hasattr(value, "call") and hasattr(value, "tables"):
        return value.call
    value = value.as_dict() if hasattr(value, "as_dict") else plain(value)
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{k!r}: {expression(v)}" for k, v in value.items()) + "}"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(map(expression, value)) + "]"
    if callable(value):
        return getattr(value, "__qualname__", type(value).__qualname__)
    return repr(value)


def _differs(value, default):
    try:
        return value is not default and not bool(value == default)
    except Exception:  # of arrays
        return True


# Arguments that do not affect the contents of files, like the options of the same names on the command line.
_WITHOUT_EFFECT = ("resume", "force", "threads", "executor", "progress", "messages")


def call_text(function, given) -> str:
    """The call of a public function, with all given arguments that have an effect on its files.

    Args:
        given (dict): its arguments by name, with **keywords under "keywords"; defaults are omitted.
    """
    words, paths = [], []
    for name, parameter in inspect.signature(function).parameters.items():
        if name not in given or name in _WITHOUT_EFFECT or not _differs(given[name], parameter.default):
            continue
        positional = parameter.kind is parameter.POSITIONAL_OR_KEYWORD
        words.append(("" if positional else f"{name}=") + expression(given[name]))
    for name, value in (given.get("keywords") or {}).items():
        if value is not None and name.isidentifier():
            words.append(f"{name}={expression(value)}")
        elif value is not None:
            paths.append(f"{name!r}: {expression(value)}")
    if paths:
        words.append("**{" + ", ".join(paths) + "}")
    return f"polhode.{function.__name__}({', '.join(words)})"
