# SPDX-License-Identifier: MIT
"""Each verb of the command line has its function in Python, and both call the same function of the
library: the verbs are those of cli/verbs.cpp."""

import re

from tree import Finding, line_of, lines, main

# Verb: functions of the library that its file of the command line and the Python module call.
CALLS = {
    "new": ["new_run_file"],
    "prepare": ["prepare"],
    "minimise": ["minimise_configuration"],
    "run": ["Simulation"],
    "measure": ["measure", "quantities"],
    "merge": ["measure", "quantities"],
    "energy": ["single_point", "quantities"],
    "analyze": ["run_analysis"],
    "convert": ["convert"],
    "export": ["export_to_lammps"],
    "advise": ["run_adviser", "advise_hybrid", "quantities"],
    "study": ["perform_study"],
    "tune-scheme": ["tune", "quantities"],
    "verify": ["verify", "quantities"],
    "molecules": ["find_molecules", "records"],
    "schemes": ["all_schemes", "quantities"],
    "settings": ["settings_json"],
    "top": ["integrate_top", "draw_top", "rotated_table"],
    "bench": ["run_benchmark", "quantities"],
}


def text_of(paths):
    return "\n".join(text for path in paths for _, text in lines(path))


def calls(text, function):
    """Whether a function is called, or passed on, in some C++ text."""
    return re.search(rf"\b{function}\b\s*[(<,)]|\b{function} simulation\(", text) is not None


def python_names(root):
    """The public names of the package."""
    package = root / "python/polhode/__init__.py"
    text = text_of([package] if package.exists() else [])
    return set(re.findall(r'"([a-z_A-Z]+)"', text.partition("__all__ = [")[2].partition("]")[0]))


def verbs_of(path):
    """(verb, line) of each entry of the table of verbs."""
    if not path.exists():
        return
    text = text_of([path])
    for match in re.finditer(r'\{"([a-z-]+)",\s*"[^"]*",\s*\w+_verb\}', text):
        yield match[1], line_of(text, match.start())


def check(root):
    verbs = root / "cli/verbs.cpp"
    python = text_of(sorted((root / "python/src").glob("*.cpp")))
    command_line = text_of(sorted((root / "cli").rglob("*.cpp")))
    names = python_names(root)
    for verb, number in verbs_of(verbs):
        if verb not in CALLS:
            yield Finding(verbs, number, f"{verb} is not in tests/lints/verbs.py; add its "
                                         "library functions, and a function in python/polhode")
            continue
        name = verb.replace("-", "_")
        if name not in names:
            yield Finding(verbs, number, f"{verb} has no function polhode.{name}; add it")
        for function in CALLS[verb]:
            for where, code in (("cli", command_line), ("python/src", python)):
                if not calls(code, function):
                    yield Finding(verbs, number, f"{where} does not call {function}() for {verb}; "
                                                 "both front ends must")


if __name__ == "__main__":
    main(check, __doc__)
