# SPDX-License-Identifier: MIT
"""Files name their licence, stay under 500 lines, and hold no absolute path and no open end."""

import re

from tree import CODE, Finding, files, lines, main

LONGEST = 500
OPEN_END = re.compile(r"\b(TO" r"DO|FIX" r"ME|X" r"XX)\b")
# Two components or more, at the start of a word; the system's own are no project's.
ABSOLUTE = re.compile(r"(?<![\w.:/~$})>*@\\-])/(?!usr/bin/|dev/|proc/|sys/fs/)[a-z]\w*/[\w.]")


def check(root):
    for path in files(root):
        numbered = lines(path)
        is_code = path.suffix in CODE or path.name in ("demo", "test", "run")
        if is_code and not any("SPDX-License-Identifier: MIT" in t for _, t in numbered[:3]):
            yield Finding(path, 1, "no licence line; begin with 'SPDX-License-Identifier: MIT'")
        if is_code and len(numbered) >= LONGEST:
            yield Finding(path, LONGEST, f"{len(numbered)} lines; split it below {LONGEST}")
        for number, text in numbered:
            if OPEN_END.search(text):
                yield Finding(path, number, "an open end; finish it, or open an issue and delete it")
            if ABSOLUTE.search(text):
                yield Finding(path, number, "an absolute path; make it relative to the project")


if __name__ == "__main__":
    main(check, __doc__)
