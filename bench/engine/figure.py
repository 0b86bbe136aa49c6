# SPDX-License-Identifier: MIT
"""The figures of the engine benchmark: time per molecule against the number of molecules, and speed-up by threads, drawn by
gnuplot."""

import json
import sys
from pathlib import Path
from string import Template

sys.path.append(str(Path(__file__).resolve().parents[1]))
import drawing  # noqa: E402

# Filled marks for forces, open ones for steps.
COLOURS = dict(zip(("mixed", "double"), drawing.PALETTE))
QUANTITIES = {"force": ("a force evaluation", (7, 5)), "step": ("a step of HOA2", (6, 4))}

SCRIPT = Template("""${style}
set key outside top center horizontal maxcols 2
set label 1 "${caveat}" at screen 0.02, screen 0.03 left noenhanced textcolor rgb ink font small
set bmargin at screen 0.2
set logscale x
set format x "10^{%T}"
set xrange [${low}:${high}]
set xlabel "number of waters"
set ylabel "${label}"
set yrange [${bottom}:${top}]

${data}

plot ${plots}
""")


def value(system, quantity):
    return system[f"{quantity}_ns_per_molecule"]


def scaling(result):
    """Curves (title, style, [(molecules, µs per molecule)]) of one thread."""
    for precision, colour in COLOURS.items():
        for quantity, (text, marks) in QUANTITIES.items():
            points = sorted((s["molecules"], value(s, quantity) / 1000) for s in result["systems"]
                            if s["precision"] == precision and s["threads"] == 1)
            yield f"{text}, {precision}", colour, marks[precision == "double"], points


def speed_up(result, threads):
    """Curves of the same kind: time of one thread divided by that of several."""
    times = {(s["molecules"], s["precision"], s["threads"]): s for s in result["systems"]}
    for precision, colour in COLOURS.items():
        for quantity, (text, marks) in QUANTITIES.items():
            points = sorted((n, value(times[n, p, 1], quantity) / value(s, quantity))
                            for (n, p, t), s in times.items()
                            if p == precision and t == threads and (n, p, 1) in times)
            yield f"{text}, {precision}", colour, marks[precision == "double"], points


def script(curves, image, label, caveat, top, extra=()):
    curves = [curve for curve in curves if curve[3]]
    data = [f"$curve{k} << EOD\n" + "\n".join(f"{x} {y:.6g}" for x, y in curve[3]) + "\nEOD"
            for k, curve in enumerate(curves)]
    plots = [*extra, *(f'$curve{k} using 1:2 with linespoints linewidth 1.6 linecolor "{colour}" '
                       f'pointtype {mark} pointsize 0.9 title "{title}"'
                       for k, (title, colour, mark, _) in enumerate(curves))]
    sizes = [x for curve in curves for x, _ in curve[3]]
    values = [y for curve in curves for _, y in curve[3]]
    return SCRIPT.substitute(
        style=drawing.begin(image, 720, 500), caveat=caveat, label=label, data="\n".join(data),
        low=f"{0.7 * min(sizes):g}", high=f"{1.4 * max(sizes):g}", bottom=0,
        top=f"{max(1.15 * max(values), top):g}", plots=", \\\n  ".join(plots))


def draw(result, prefix, form="svg"):
    """Writes the scripts to the folder of the images and runs gnuplot on them."""
    instruction_set = result.get("instruction_set") or result["target"]  # the word of older results
    caveat = f"TIP4P at 1 g/cm³; polhode {result['version']} with {instruction_set} on {result['processor']}"
    image = lambda name: prefix.with_name(f"{prefix.name}-{name}.{form}")
    drawing.draw(script(scaling(result), image("sizes"), "µs per molecule, one thread", caveat, 0), image("sizes"))
    threads = max(s["threads"] for s in result["systems"])
    if threads > 1:
        ideal = f'{threads} with lines linewidth 1 dashtype 3 linecolor rgb ink title "ideal"'
        drawing.draw(script(speed_up(result, threads), image("threads"), f"speed-up by {threads} threads", caveat,
                     1.1 * threads, [ideal]), image("threads"))


if __name__ == "__main__":  # figure.py RESULT.json PREFIX [svg|png]: redraws stored results
    draw(json.loads(Path(sys.argv[1]).read_text(encoding="utf-8")), Path(sys.argv[2]), *sys.argv[3:4])
