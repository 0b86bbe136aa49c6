# SPDX-License-Identifier: MIT
"""clang-tidy finds nothing with the checks of .clang-tidy; skipped (exit 77) without clang-tidy 14.

Most of its time goes into headers of libraries. So sources are examined in groups, each as one file that includes
them; no name of an anonymous namespace is used in two sources of a group. Sources with errors in a group are
examined alone as well. A group without findings is not examined again until one of its sources, a header or .clang-tidy
changes."""

import argparse
import hashlib
import json
import os
import re
import shlex
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from tree import Finding, files, main, without_comments

VERSION = "14"  # other versions find other things
FOLDERS = ("src", "cli")
HEADERS = ("include", *FOLDERS)
BUILD = None  # the build folder, from the command line; otherwise that of the release preset
ANONYMOUS = re.compile(r"^namespace \{$(.*?)^\}  // namespace$", re.S | re.M)
DECLARED = re.compile(r"^(?:struct|class|enum class|union) (\w+)|^using (\w+) ="
                      r"|^\w[\w:<>,&* ]*[&*> ](\w+)(?:\(|\{|\[\d| =|;)", re.M)
NOT_A_USE = re.compile(r'"(?:\\.|[^"\\\n])*"|(?:\.|->|::)\w+')  # text and members
FAILED = re.compile(r"^(/.+?):\d+:\d+: error: ", re.M)
LOCATED = re.compile(r"^(/.+?):\d+:\d+: ")
INCLUDED = re.compile(r'^#include "([^"]+)"', re.M)


class Source:
    """A source, the names that it alone declares, and those that it or one of its headers uses."""

    def __init__(self, root, path, options):
        self.path, self.options = path, options
        self.is_kernel = "kernels" in path.parts  # compiled with definitions of its own
        text = path.read_text(encoding="utf-8")
        self.own = {name for part in ANONYMOUS.findall(text) for found in DECLARED.findall(part)
                    for name in found if name}
        self.used = words(without_comments(text))
        for header in headers(root, path, set()):  # of these types only: their parameters hide other names
            self.used |= {word for word in words(without_comments(header.read_text())) if word[0].isupper()}


def words(text):
    return set(re.findall(r"\b[A-Za-z]\w*", NOT_A_USE.sub(" ", text)))


def headers(root, path, found):
    """The project's headers that a file includes, and those that they include."""
    for name in INCLUDED.findall(path.read_text(encoding="utf-8")):
        for header in (root / "include" / name, root / "src" / name, (path.parent / name).resolve()):
            if header.exists() and header not in found:
                found.add(header)
                headers(root, header, found)
    return found


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
                    yield Source(root, source, options_of(command, folder))


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
    """Lists of sources that fit together, by first fit."""
    found = []
    for source in sorted(of, key=lambda source: (-len(source.own), source.path)):
        for group in found:
            if all(source.is_kernel == other.is_kernel and not source.own & other.used and
                   not source.used & other.own for other in group):
                group.append(source)
                break
        else:
            found.append([source])
    return found


def examine(root, cache, group):
    """What clang-tidy writes about a group; nothing if it was examined before."""
    options = list(dict.fromkeys(option for source in group for option in source.options))
    text = "".join(f'#include "{source.path}"\n' for source in group)
    state = hashlib.sha256(repr((options, text)).encode())
    for path in [root / ".clang-tidy", *files(root, (".hpp",), HEADERS), *(source.path for source in group)]:
        state.update(path.read_bytes())
    unit = cache / f"{state.hexdigest()}.cpp"
    if unit.exists():
        return ""
    unit.write_text(text)
    run = subprocess.run(["clang-tidy", "--quiet", f"--config-file={root / '.clang-tidy'}",
                          f"--header-filter=^{re.escape(str(root))}/({'|'.join(HEADERS)})/", unit, "--", "-ferror-limit=0", *options],
                         text=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, check=False)
    found = run.stdout
    if len(group) > 1 and "[clang-diagnostic-error]" in found:  # perhaps because names collide
        found = apart(root, cache, group, found)
    elif run.returncode:
        found = found or f"{group[0].path}:1:1: error: clang-tidy failed with exit code {run.returncode}"
    if found:
        unit.unlink()
    return found


def apart(root, cache, group, found):
    """What is found in a group with errors, whose sources with errors are examined alone; all others were examined."""
    named = {Path(path) for path in FAILED.findall(found) if Path(path).is_relative_to(root)}
    alone = [source for source in group if source.path in named]
    if not alone or len(alone) < len(named):  # errors in headers: of any source
        half = len(group) // 2
        return examine(root, cache, group[:half]) + examine(root, cache, group[half:])
    places = [(LOCATED.match(line), line) for line in found.splitlines(True)]
    others = "".join(line for at, line in places if at and Path(at[1]).is_relative_to(root) and Path(at[1]) not in named)
    return others + "".join(examine(root, cache, [source]) for source in alone)


def check(root):
    build = (BUILD or root / "build/release").resolve()
    cache = build / "tidy"
    cache.mkdir(exist_ok=True)
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        reports = pool.map(lambda group: examine(root, cache, group), groups(sources(root, build)))
    seen = re.findall(r"^(/.+?):(\d+):\d+: (?:warning|error): (.+)$", "".join(reports), re.M)
    for path, line, text in sorted(set(seen)):
        yield Finding(Path(path).resolve(), int(line), text)


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
