# SPDX-License-Identifier: MIT
"""Citations: the entries of the bibliography that a simulation uses."""

import re
from importlib import resources

from . import _core

PAPER = "vanzon2008"  # that the program implements


def bibliography():
    """dict: the BibTeX entries of the documents by their keys."""
    text = (resources.files("polhode") / "references.bib").read_text(encoding="utf-8")
    entries = re.split(r"(?m)^(?=@)", text)
    return {m[1]: entry.strip() for entry in entries if (m := re.match(r"@\w+\{([^,\s]+),", entry))}


def citations(simulation):
    """BibTeX entries for the program's paper, and for the scheme and the models of a simulation."""
    from ._lookup import Scheme

    entries = bibliography()
    integrator = simulation.settings.tables.get("integrator") or {}
    keys = [PAPER]
    scheme = integrator.get("scheme", "hoa2")
    if "/" not in scheme.partition("B(")[0]:
        keys.append(Scheme(scheme).source)
    keys += [kind.source for kind in simulation.kinds]
    found = [entries[k] for k in dict.fromkeys(keys) if k in entries]
    return f"% polhode {_core.version}\n" + "\n\n".join(found)
