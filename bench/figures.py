# SPDX-License-Identifier: MIT
"""Figures of the benchmarks, from their results:

    figures.py engine|steps RESULT.json PREFIX      time per molecule against size, and speed-up by threads: PREFIX-sizes.svg, PREFIX-threads.svg
    figures.py peers|lammps RESULT.json IMAGE       cost at equal R"""

import functools
import json
import sys
from pathlib import Path

BENCH = Path(__file__).resolve().parent
sys.path[:0] = [str(BENCH.parent / "studies"), str(BENCH / "lammps")]
from lib import figures  # noqa: E402

GREYS = ("#404040", "#707070", "#9a9a9a", "#c0c0c0", "#585858", "#868686", "#aeaeae", "#d4d4d4")  # colours of other programs; polhode has the colours of its schemes
SHAPES = ("s", "o", "^", "v", "D", "p")
KINDS = {"reaction-field": "reaction field", "site-switch": "reaction field, site switch", "ewald": "Ewald sum"}


def against_size(curves, label, caveat, path, ideal=None):
    """One panel: curves {title: (arguments of plot, [(molecules, value)])}."""
    figure, ((ax,),) = figures.panels(1, size=(7.2, 5))
    for title, (look, points) in curves.items():
        if points:
            ax.plot(*zip(*sorted(points)), label=title, **look)
    if ideal:
        ax.axhline(ideal, color=figures.INK, linestyle=":", linewidth=1, label="ideal")
    ax.set(xscale="log", xlabel="number of waters", ylabel=label, ylim=(0, None))
    figure.supxlabel(caveat, fontsize=9)
    figures.legend(figure, ax, 2)
    figures.save(figure, path)


def two_figures(curves, cases, key, per_molecule, label, what, caveat, prefix):
    """PREFIX-sizes of one thread, and PREFIX-threads if there are cases with several. curves: {title: (look, whether a case belongs to it)}."""
    one = {key(c): c for c in cases if c["threads"] == 1}
    threads = max(c["threads"] for c in cases)
    of = lambda value, n: {title: (look, [(c["molecules"], value(c, title)) for c in cases if c["threads"] == n and belongs(c) and key(c) in one])
                           for title, (look, belongs) in curves.items()}
    image = lambda name: prefix.with_name(f"{prefix.name}-{name}.svg")
    against_size(of(per_molecule, 1), f"µs per molecule{label}, one thread", caveat, image("sizes"))
    if threads > 1:
        gain = lambda c, title: per_molecule(one[key(c)], title) / per_molecule(c, title)
        against_size(of(gain, threads), f"speed-up{what} by {threads} threads", caveat, image("threads"), threads)


def engine(result, prefix):
    """Force evaluations and steps of `polhode bench`."""
    curves = {f"{text}, {precision}": ({"color": colour, "marker": mark, **({} if text.startswith("a force") else {"markerfacecolor": "white"})},
                                       lambda s, p=precision: s["precision"] == p)
              for (precision, mark), colour in zip((("mixed", "o"), ("double", "s")), figures.PALETTE)
              for text in ("a force evaluation", "a step of HOA2")}
    value = lambda s, title: s["force_ns_per_molecule" if "force" in title else "step_ns_per_molecule"] / 1000
    caveat = f"TIP4P at 1 g/cm³; polhode {result['version']} with {result.get('instruction_set') or result['target']} on {result['processor']}"
    two_figures(curves, result["systems"], lambda s: (s["molecules"], s["precision"]), value, "", "", caveat, prefix)


def steps(result, prefix):
    """Whole steps of the program that was compared with an earlier version."""
    curves = {title: ({"color": figures.PALETTE[k], "marker": "os^"[k]}, lambda c, f=forces: c["forces"] == f) for k, (forces, title) in enumerate(KINDS.items())}
    caveat = f"TIP4P, {result['cases'][0]['precision']} precision, velocity Verlet; {result['processor']}, {result['date']}"
    two_figures(curves, result["cases"], lambda c: (c["forces"], c["molecules"]), lambda c, _: 1e3 * c["now_ms"] / c["molecules"], " and step",
                " of a step", caveat, prefix)


def peer_looks(names):
    """The colour and marker of its scheme for polhode, grey and open for other programs."""
    ours = figures.styles([n.removeprefix("polhode ") for n in names if n.startswith("polhode ")])
    others = [n for n in names if not n.startswith("polhode ")]
    return {n: ours[n.removeprefix("polhode ")].of() if n not in others else figures.Style(GREYS[others.index(n)], SHAPES[others.index(n) % 6]).of(open=True)
            for n in names}


def program(name):
    """The name of an engine with the usual spelling of its program, such as "GROMACS"."""
    return functools.reduce(lambda text, own: text.replace(own.lower(), own), ("GROMACS", "LAMMPS", "OpenMM"), name)


def absent(costs):
    """The engines that do not reach an R, as text."""
    return "\n".join(f"{program(r['engine'])} does not reach {r['R_percent']:g} %" for r in costs if not r["seconds_per_ns"])


def peers(result, path):
    """Seconds per nanosecond against the required R, a panel for each size and number of threads."""
    shown = list(dict.fromkeys((r["molecules"], r["threads"]) for r in result["costs"]))
    looks = peer_looks(list(dict.fromkeys(r["engine"] for r in result["costs"])))
    across = min(2, len(shown))
    figure, rows = figures.panels(across, -(-len(shown) // across), size=(5.1 * across if across > 1 else 7.6, 4.2 * -(-len(shown) // across) + 0.8), sharey=True)
    targets = sorted({r["R_percent"] for r in result["costs"]})
    for ax, (molecules, threads) in zip(rows.flat, shown):
        own = [r for r in result["costs"] if (r["molecules"], r["threads"]) == (molecules, threads)]
        for name, look in looks.items():
            points = [(r["R_percent"], r["seconds_per_ns"]) for r in own if r["engine"] == name and r["seconds_per_ns"]]
            ax.plot(*(zip(*points) if points else ((), ())), label=program(name), **look)
        ax.text(0.02, 0.03, absent(own), transform=ax.transAxes, fontsize=9)
        ax.set(xscale="log", yscale="log", xlabel="required R  (%)", xlim=(1.6 * targets[-1], targets[0] / 1.6),
               title=f"{molecules} molecules, {threads} thread{'s' * (threads > 1)}")
        figures.plain_ticks(ax.xaxis, targets)
    rows[0][0].set_ylabel("seconds per nanosecond")
    # Builds for other instruction sets run at different speeds.
    builds = "\n".join(f"{program(n)} {v}" for n, v in result.get("versions", {}).items() if n in looks and not n.startswith("polhode"))
    figure.supxlabel(f"Builds as distributed, others are faster or slower:\n{builds}" if builds else "", fontsize=9)
    figures.legend(figure, rows[0][0], 3)
    figures.save(figure, path)


def lammps(result, path):
    """R against seconds per nanosecond of water in LAMMPS, on one process."""
    import equal_accuracy as bench
    curves = [(bench.OTHER, bench.FASTEST, {"color": figures.PALETTE[6], "marker": "s"}, bench.OTHER)]
    for scheme, look in figures.styles([s for s in bench.SCHEMES if s != bench.OTHER]).items():
        curves += [(scheme, "particles, mixed, site-switch", look.of(open=True), f"{scheme}, same law"),
                   (scheme, "particles, mixed, molecule-switch", look.of(), f"{scheme}, by molecules")]
    figure, ((ax,),) = figures.panels(1, size=(7.6, 5))
    for scheme, form, look, title in curves:
        ax.plot(*zip(*[(bench.seconds_per_ns(result, scheme, form, 1, h), r) for h, r in bench.curve_of(result, scheme, form)]), label=title, **look)
    ax.set(xscale="log", yscale="log", xlabel="seconds per nanosecond of 4,096 TIP4P waters, one process", ylabel="R  (%)", xlim=(500, 2e5), ylim=(0.006, 10))
    figures.plain_ticks(ax.yaxis, (0.01, 0.1, 1, 10))
    figures.legend(figure, ax, 3)
    figures.save(figure, path)


if __name__ == "__main__":
    {"engine": engine, "steps": steps, "peers": peers, "lammps": lammps}[sys.argv[1]](
        json.loads(Path(sys.argv[2]).read_text(encoding="utf-8")), Path(sys.argv[3]))
