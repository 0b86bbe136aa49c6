# SPDX-License-Identifier: MIT
"""The files with reference values: their contents and format."""
import datetime
import json
import sys
from math import inf

import numpy as np

from scenes import COULOMB, HERE, Scene


def read(name):
    return json.loads((HERE / f"{name}.json").read_text(encoding="utf-8"))


def of_file(name):
    """The scene of a file, or of the file that it names."""
    file = read(name)
    if "scene" in file:
        return of_file(file["scene"])
    return Scene({b["model"]: b["count"] for b in file["bodies"]}, file["box"],
                 [np.array(file["sites"])])


def provenance(script, name, engine_coulomb):
    return {"units": "nm, e, u, kJ/mol; torques about the centre of mass, in the laboratory frame",
            "date": datetime.date.today().isoformat(),
            "command": f"python3 tests/reference/peers/{script}.py {name}",
            "python": f"{sys.version.split()[0]}, numpy {np.__version__}",
            "coulomb": COULOMB, "engine_coulomb": engine_coulomb}


def bodies(scene):
    models = {m.name: m for m in scene.models}
    return {"mixing": "Lorentz-Berthelot",
            "models": [{"name": m.name, "sites": m.names, "position": m.r.tolist(),
                        "mass": m.m.tolist(), "charge": m.q.tolist(), "sigma": m.sigma.tolist(),
                        "epsilon": m.epsilon.tolist()} for m in models.values()],
            "bodies": [{"model": k, "count": n} for k, n in scene.counts.items()],
            "box": None if scene.box is None else scene.box.tolist(), "sites": scene.sites.tolist()}


def rounded(values, digits):
    return [[round(x, digits) for x in row] for row in np.asarray(values).tolist()]


def off(a, b):
    """The largest deviation of a component."""
    return float(np.abs(np.asarray(a) - np.asarray(b)).max())


def text(value, depth=0):
    """JSON with one body or site per line; numbers in the shortest form that reads back exactly."""
    pad = "  " * depth
    if isinstance(value, dict):
        inner = ",\n".join(f"{pad}  {json.dumps(k)}: {text(v, depth + 1)}" for k, v in value.items())
        return f"{{\n{inner}\n{pad}}}"
    if isinstance(value, list) and value and isinstance(value[0], (list, dict)):
        inner = ",\n".join(f"{pad} {text(v, depth + 1)}" for v in value)
        return f"[\n{inner}\n{pad}]"
    return json.dumps("infinite" if value == inf else value, separators=(",", ":"))


def write(name, out):
    (HERE / f"{name}.json").write_text(text(out) + "\n", encoding="utf-8")
