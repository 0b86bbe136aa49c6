# SPDX-License-Identifier: MIT
"""A file includes its own folder and lower floors, never above or sideways (ARCHITECTURE.md)."""

import re

from tree import Finding, files, lines, main

FLOOR = {"base": 0, "math": 1, "model": 2, "rotor": 3, "forces": 3, "integrate": 4,
         "measure": 5, "io": 5, "ensemble": 6, "run": 7, "cli": 8, "python": 8, "lammps": 8}
ALL = "include/polhode/polhode.hpp"  # includes the others for users, and is included by none of them
PRIVATE = re.compile(r"(fmt|toml\+\+|CLI|nlohmann|Eigen|benchmark|doctest)/|pocketfft|hdf5")
LONG = re.compile(r"CLI/|nlohmann/json\.hpp")  # seconds of compile time for each file
INCLUDE = re.compile(r'\s*#\s*include\s*(["<])([^">]+)[">]')


def folder_of(path, root):
    """The floor's name: the folder below include/polhode or src, or the front end's own."""
    parts = path.relative_to(root).parts
    if parts[:2] == ("include", "polhode"):
        return parts[2] if len(parts) > 3 else None
    return parts[1] if parts[0] == "src" and len(parts) > 2 else parts[0]


def check_include(own, target, is_public, is_header):
    """What is wrong with one include, or None."""
    if target.startswith("hwy/") and not is_public and own == "base":
        return None
    if target.startswith("hwy/"):
        return "only base/pack*.hpp and src/base know the SIMD library; use base/pack.hpp"
    if is_public and PRIVATE.match(target):
        return f"{target} in a public header; include it in the .cpp file"
    if is_header and LONG.match(target):
        return f"{target} in a header, for every file that includes it; include it in the .cpp file"
    if is_public and target.split("/")[0] in FLOOR:
        return f"{target} is a header of the project alone, in a public one; move it to include/polhode"
    if not target.startswith((*(f"{name}/" for name in FLOOR), "polhode/")):
        return None
    folder = target.removeprefix("polhode/").split("/")[0]
    if folder not in FLOOR:
        return f"{folder} is no floor; the floors are {', '.join(FLOOR)}"
    if folder != own and FLOOR[folder] >= FLOOR[own]:
        where = "above" if FLOOR[folder] > FLOOR[own] else "beside"
        return f"{own} includes {folder}, which is {where} it; move what both need to a lower floor"
    return None


def check(root):
    for path in files(root, (".hpp", ".cpp"), ("include", "src", "cli", "python", "lammps")):
        if path == root / ALL:
            continue
        own = folder_of(path, root)
        if own not in FLOOR:
            yield Finding(path, 1, f"lies on no floor; the floors are {', '.join(FLOOR)}")
            continue
        is_public = path.relative_to(root).parts[0] == "include"
        is_pack = own == "base" and path.name.startswith("pack")
        for number, text in lines(path):
            found = INCLUDE.match(text)
            if not found or (is_pack and found[2].startswith("hwy/")):
                continue
            wrong = check_include(own, found[2], is_public, path.suffix == ".hpp")
            if wrong:
                yield Finding(path, number, wrong)


if __name__ == "__main__":
    main(check, __doc__)
