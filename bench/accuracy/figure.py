# SPDX-License-Identifier: MIT
"""The figure: diffusion, relaxation time and temperatures against R, scheme by scheme, drawn by gnuplot."""

import json
import sys
from pathlib import Path
from string import Template

sys.path.append(str(Path(__file__).resolve().parents[1]))
import drawing  # noqa: E402

HERE = Path(__file__).resolve().parent
# The colours of Okabe and Ito, as in all figures here.
LOOKS = {"velocity-verlet": ("#0072B2", 7), "hoa2": ("#D55E00", 5), "gier4": ("#009E73", 9)}


def draw(result, image):
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

    def plots(column):
        return ", ".join(
            f'${s.replace("-", "_")} using 1:{column}:{column + 1} with yerrorbars linewidth 1.4 pointsize 0.9 pointtype '
            f'{LOOKS.get(s, ("#404040", 13))[1]} linecolor "{LOOKS.get(s, ("#404040", 13))[0]}" title "{s}"'
            for s in schemes)

    terminal = "svg size 960,340 dynamic font 'sans-serif,13'" if image.suffix == ".svg" else "pngcairo size 960,340"
    template = Template((HERE / "figure.gp").read_text(encoding="utf-8"))
    drawing.draw(template.substitute(image=image.name, terminal=terminal, data="\n".join(data), diffusion=plots(2),
                                     relaxation=plots(4), temperatures=plots(6)), image)


if __name__ == "__main__":
    draw(json.loads(Path(sys.argv[1]).read_text(encoding="utf-8")), Path(sys.argv[2]))
