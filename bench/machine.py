# SPDX-License-Identifier: MIT
"""The machine that a benchmark ran on, for the stored results."""

import platform
from pathlib import Path


def processor():
    try:
        for line in Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines():
            if line.startswith("model name"):
                return line.split(":", 1)[1].strip()
    except OSError:
        pass
    return platform.processor() or platform.machine()


def program(name):
    """A program as typed: a path, made absolute, or a name that the shell finds."""
    return str(Path(name).resolve()) if Path(name).exists() else name
