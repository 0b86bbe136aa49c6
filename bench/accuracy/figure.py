# SPDX-License-Identifier: MIT
"""The figure: diffusion, relaxation time and temperatures against R, scheme by scheme, drawn by gnuplot."""

import json
import sys
from pathlib import Path
from string import Template

sys.path.append(str(Path(__file__).resolve().parents[1]))
import drawing  # noqa: E402

HERE = Path(__file__).resolve().parent


def script(result, image):
    data, schemes = [], []
    for point in result["points"]:
        if point["scheme"] not in schemes:
            schemes.append(point["scheme"])
    for scheme in schemes:
        rows = []
        for p in (p for p in result["points"] if p["scheme"] == scheme):
            off = p["differences"]
            numbers = [100 * p["R"]["value"]]
            for q in ("D", "tau"):  # in per cent of the quantity
                numbers += [100 * off[q][part] / p[q]["value"] for part in ("value", "error")]
            numbers += [p["excess"]["value"], p["excess"]["error"]]
            rows.append(" ".join(f"{x:.8g}" for x in numbers))
        data.append(f"${scheme.replace('-', '_')} << EOD\n" + "\n".join(rows) + "\nEOD")

    looks = drawing.styles(schemes)

    def plots(column):
        return ", ".join(
            f'${s.replace("-", "_")} using 1:{column}:{column + 1} with yerrorbars linewidth 1.4 pointsize 0.9 pointtype '
            f'{looks[s].filled} linecolor "{looks[s].colour}" notitle' for s in schemes)

    key = [f'with points pointtype {style.filled} linecolor "{style.colour}" title "{s}"' for s, style in looks.items()]
    caveat = (f"{result['waters']} TIP4P waters, runs of {result['length_ps']:g} ps. Differences from the most accurate run, from the same "
              "configurations; bars are one standard error.")
    template = Template((HERE / "figure.gp").read_text(encoding="utf-8"))
    return template.substitute(style=drawing.begin(image, 1000, 400), data="\n".join(data), caveat=caveat, key=drawing.key(key, 0.9),
                               diffusion=plots(2), relaxation=plots(4), temperatures=plots(6))


def draw(result, image):
    """Writes the script to the folder of the image and runs gnuplot on it."""
    drawing.draw(script(result, image), image)


if __name__ == "__main__":
    draw(json.loads(Path(sys.argv[1]).read_text(encoding="utf-8")), Path(sys.argv[2]))
