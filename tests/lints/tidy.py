# SPDX-License-Identifier: MIT
"""clang-tidy finds nothing with the checks of .clang-tidy; skipped (exit 77) without clang-tidy 14.

Most of its time goes into headers of libraries. So sources are examined in groups, as one file that includes a copy of
each, in which names of anonymous namespaces have a number. Sources with errors in a group are examined alone as well. Two
headers of a group that define the same type are a finding. A group without findings is not examined again until one of its sources,
a header or .clang-tidy changes."""

import argparse
import hashlib
import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from tree import Finding, files, main, without_comments

VERSION = "14"  # other versions find other things
FOLDERS = ("src", "cli")
HEADERS = ("include", *FOLDERS)
SMALLEST_GROUP = 20
BUILD = None  # the build folder, from the command line; otherwise that of the release preset
ANONYMOUS = re.compile(r"^namespace \{$(.*?)^\}  // namespace$", re.S | re.M)
DECLARED = re.compile(r"^(?:struct|class|enum class|enum|union) (\w+)|^\w[\w:<>,&* ]*[&*> ](\w+)(?:\(|\{|\[\d| =|;)", re.M)
ALIAS = re.compile(r"^using (\w+) =", re.M)
ENUMERATORS = re.compile(r"^enum \w[^{]*\{(.*?)\}", re.M | re.S)
# Names of which a source may have its own, and what looks like them: lines of includes, texts, members, names of headers.
NAME = re.compile(r'#include .*|"(?:\\.|[^"\\\n])*"|(?:\.|->)\w+|\b(?:std|polhode)(?:::\w+)+|\b[A-Z]\w*::\w+|\b[A-Za-z_]\w*')
FAILED = re.compile(r"^(/.+?):\d+:\d+: error: ", re.M)
LOCATED = re.compile(r"^(/.+?):\d+:\d+: ")
INCLUDED = re.compile(r'^#include "([^"]+)"', re.M)


class Source:
    """A source, and the names that it alone declares."""

    def __init__(self, path, options):
        self.path, self.options = path, options
        self.is_kernel = "kernels" in path.parts  # compiled with definitions of its own
        self.text = path.read_text(encoding="utf-8")
        anonymous = without_comments("\n".join(ANONYMOUS.findall(self.text)))
        self.own = {name for found in DECLARED.findall(anonymous) for name in found if name}
        self.own.update(ALIAS.findall(self.text), re.findall(r"\b[A-Za-z]\w*", " ".join(ENUMERATORS.findall(anonymous))))

    def numbered(self, number):
        """The text for another folder, with a number behind the names that this source alone declares."""
        near = lambda name: self.path.parent / name if (self.path.parent / name).exists() else name
        text = INCLUDED.sub(lambda line: f'#include "{near(line[1])}"', self.text)
        return NAME.sub(lambda name: self.numbered_name(name[0], number), text)

    def numbered_name(self, name, number):
        """A member of a type keeps its name, unless it is a constructor."""
        first, *members = name.split("::")
        numbered = f"{first}_{number}" if first in self.own else first
        return "::".join([numbered, *(numbered if member == first else member for member in members)])


def sources(root, build):
    """Those of the library, kernels as the scalar instruction set has them, and of the program."""
    seen = set()
    for entry in json.loads((build / "compile_commands.json").read_text()):
        folder = (build / entry["directory"]).resolve()
        path, command = (folder / entry["file"]).resolve(), shlex.split(entry["command"])
        is_group = path.parent.name == "Unity"  # of a quick build: it includes its sources
        for source in map(Path, INCLUDED.findall(path.read_text())) if is_group else [path]:
            if any(source.is_relative_to(root / name) for name in FOLDERS):
                is_wanted = "kernels" not in source.parts or "-DPOLHODE_LOOPS=loops_scalar" in command
                if is_wanted and source not in seen:
                    seen.add(source)
                    yield Source(source, options_of(command, folder))


def options_of(command, folder):
    """The options that decide what the source says, with absolute folders."""
    options = []
    for word, following in zip(command, [*command[1:], ""]):
        if word.startswith("-I"):
            options.append(f"-I{(folder / word[2:]).resolve()}")
        elif word == "-isystem":
            options.append(f"-isystem{(folder / following).resolve()}")
        elif word.startswith(("-D", "-std=")):
            options.append(word)
    return options


def groups(of):
    """Kernels, and other sources, each as one list for each processor; lists are not shorter than SMALLEST_GROUP, but for the last."""
    of = sorted(of, key=lambda source: source.path)
    for is_kernel in (False, True):
        some = [source for source in of if source.is_kernel == is_kernel]
        size = max(-(-len(some) // os.cpu_count()), SMALLEST_GROUP)
        yield from (some[start:start + size] for start in range(0, len(some), size))


def copies(root, folder, group):
    """Writes numbered copies of the sources to a folder."""
    for number, source in enumerate(group):
        path = folder / source.path.relative_to(root)
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(source.numbered(number))
        yield path


def examine(root, cache, group):
    """What clang-tidy writes about a group; nothing if it was examined before."""
    options = list(dict.fromkeys(option for source in group for option in source.options))
    state = hashlib.sha256(repr(options).encode())
    for path in [Path(__file__), root / ".clang-tidy", *files(root, (".hpp",), HEADERS), *(source.path for source in group)]:
        state.update(str(path).encode() + path.read_bytes())
    mark = cache / state.hexdigest()
    if mark.exists():
        return ""
    with tempfile.TemporaryDirectory() as folder:
        unit = Path(folder) / "unit.cpp"
        paths, included = [group[0].path], []
        if len(group) > 1:
            paths = list(copies(root, Path(folder), group))
            included = dict.fromkeys(name for path in paths for name in INCLUDED.findall(path.read_text()))  # before names clash
        unit.write_text("".join(f'#include "{path}"\n' for path in [*included, *paths]))
        shown = f"^({re.escape(str(root))}|{re.escape(folder)})/({'|'.join(HEADERS)})/"
        run = subprocess.run(["clang-tidy", "--quiet", f"--config-file={root / '.clang-tidy'}", f"--header-filter={shown}",
                              unit, "--", "-ferror-limit=0", *options],
                             text=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, check=False)
        found = run.stdout.replace(f"{folder}/", f"{root}/")
    if len(group) > 1 and "[clang-diagnostic-error]" in found:  # perhaps because names collide
        return apart(root, cache, group, found)
    if run.returncode:
        return found or f"{group[0].path}:1:1: error: clang-tidy failed with exit code {run.returncode}"
    if not found:
        mark.touch()
    return found


def apart(root, cache, group, found):
    """What is found in a group with errors. Its sources with errors are examined alone; errors in headers are findings."""
    named = set(FAILED.findall(found))
    own = tuple(f"{root}/{folder}/" for folder in HEADERS)
    alone = [source for source in group if str(source.path) in named or not all(path.startswith(own) for path in named)]
    places = [(LOCATED.match(line), line) for line in found.splitlines(True)]
    others = "".join(line for at, line in places if at and all(at[1] != str(source.path) for source in alone))
    return others + "".join(examine(root, cache, [source]) for source in alone)


def check(root):
    build = (BUILD or root / "build/release").resolve()
    cache = build / "tidy"
    cache.mkdir(exist_ok=True)
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        reports = pool.map(lambda group: examine(root, cache, group), groups(sources(root, build)))
    for path, line, text in sorted(set(located("".join(reports), root))):
        yield Finding(Path(path).resolve(), int(line), text)


def located(report, root):
    """Path, line and text of each finding. A finding in a header of a library has the next place in the project, which its notes name."""
    place = re.compile(rf"^({re.escape(str(root))}/.+?):(\d+):", re.M)
    for found in re.finditer(r"^(/.+?):(\d+):\d+: (?:warning|error): (.+)$", report, re.M):
        own = place.search(report, found.start())
        yield (*(own.groups() if own else found.groups()[:2]), found[3])


if __name__ == "__main__":
    program = shutil.which("clang-tidy")
    version = program and subprocess.run([program, "--version"], text=True, capture_output=True,
                                         check=True).stdout
    if not program or f"version {VERSION}." not in version:
        print(f"skipped: no clang-tidy {VERSION} on PATH")
        sys.exit(77)
    parser = argparse.ArgumentParser(add_help=False)
    parser.add_argument("--build", type=Path)
    arguments, sys.argv[1:] = parser.parse_known_args()
    BUILD = arguments.build
    main(check, __doc__)
