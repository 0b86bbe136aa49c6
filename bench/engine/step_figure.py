# SPDX-License-Identifier: MIT
"""Figures of whole steps, from a comparison of programs: time per molecule against the number of molecules, and speed-up by threads,
of the program that was compared with an earlier one."""

import json
import sys
from pathlib import Path

import figure

sys.path.append(str(Path(__file__).resolve().parents[1]))
import drawing  # noqa: E402

TITLES = {"reaction-field": "reaction field", "site-switch": "reaction field, site switch", "ewald": "Ewald sum"}
MARKS = (7, 5, 9)


def curves(cases, value):
    """(title, colour, mark, [(molecules, value)]) for each kind of forces; without points of which value is None."""
    for k, (forces, title) in enumerate(TITLES.items()):
        points = sorted((c["molecules"], value(c)) for c in cases if c["forces"] == forces)
        yield title, drawing.PALETTE[k], MARKS[k], [p for p in points if p[1] is not None]


def draw(result, prefix, form="svg"):
    """PREFIX-sizes of one thread, and PREFIX-threads if there are runs with several."""
    cases, threads = result["cases"], max(c["threads"] for c in result["cases"])
    one = {(c["forces"], c["molecules"]): c for c in cases if c["threads"] == 1}
    caveat = f"TIP4P, {cases[0]['precision']} precision, velocity Verlet; {result['processor']}, {result['date']}"
    image = lambda name: prefix.with_name(f"{prefix.name}-{name}.{form}")
    per_molecule = curves(one.values(), lambda c: 1e3 * c["now_ms"] / c["molecules"])
    drawing.draw(figure.script(per_molecule, image("sizes"), "µs per molecule and step, one thread", caveat, 0), image("sizes"))
    if threads == 1:
        return
    gain = lambda c: one[c["forces"], c["molecules"]]["now_ms"] / c["now_ms"] if (c["forces"], c["molecules"]) in one else None
    ideal = f'{threads} with lines linewidth 1 dashtype 3 linecolor rgb ink title "ideal"'
    drawing.draw(figure.script(curves([c for c in cases if c["threads"] == threads], gain), image("threads"),
                               f"speed-up of a step by {threads} threads", caveat, 1.1 * threads, [ideal]), image("threads"))


if __name__ == "__main__":  # step_figure.py RESULT.json PREFIX [svg|png]: redraws stored results
    draw(json.loads(Path(sys.argv[1]).read_text(encoding="utf-8")), Path(sys.argv[2]), *sys.argv[3:4])
