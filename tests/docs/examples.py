# SPDX-License-Identifier: MIT
"""Pages show the examples as they are compiled: the block below `<!-- example: NAME -->` is examples/NAME/main.cpp without
its licence. With --write the pages are updated."""

import re

from pages import is_current, options, report

BLOCK = re.compile(r"<!-- example: (\w+) -->\n```cpp\n(.*?)```\n", re.S)


def source(root, name):
    return (root / f"examples/{name}/main.cpp").read_text(encoding="utf-8").partition("\n")[2]


def main():
    given = options(__doc__, "bring the pages up to date")
    wrong, shown = [], 0
    for page in sorted(given.root.glob("docs/**/*.md")):
        text = page.read_text(encoding="utf-8")
        now = BLOCK.sub(lambda m: m[0].replace(f"```cpp\n{m[2]}```", f"```cpp\n{source(given.root, m[1])}```"), text)
        shown += len(BLOCK.findall(text))
        if not is_current(page, now, given.write):
            wrong.append(f"{page.relative_to(given.root)} shows another program than examples/ has; run this test with --write")
    if not shown:
        wrong.append("no page shows an example")
    report(wrong, f"{shown} examples as they are compiled")


if __name__ == "__main__":
    main()
