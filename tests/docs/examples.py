# SPDX-License-Identifier: MIT
"""Pages show the examples as they are compiled: the block below `<!-- example: NAME -->` is examples/NAME/main.cpp without
its licence. With --write the pages are updated."""

import argparse
import re
import sys
from pathlib import Path

BLOCK = re.compile(r"<!-- example: (\w+) -->\n```cpp\n(.*?)```\n", re.S)


def source(root, name):
    return (root / f"examples/{name}/main.cpp").read_text(encoding="utf-8").partition("\n")[2]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--root", type=Path, default=Path(__file__).resolve().parents[2])
    parser.add_argument("--write", action="store_true", help="bring the pages up to date")
    options = parser.parse_args()
    wrong, shown = [], 0
    for page in sorted(options.root.glob("docs/**/*.md")):
        text = page.read_text(encoding="utf-8")
        now = BLOCK.sub(lambda m: m[0].replace(f"```cpp\n{m[2]}```", f"```cpp\n{source(options.root, m[1])}```"), text)
        shown += len(BLOCK.findall(text))
        if now != text and options.write:
            page.write_text(now, encoding="utf-8")
        elif now != text:
            wrong.append(f"{page.relative_to(options.root)} shows another program than examples/ has; run this test with --write")
    if not shown:
        wrong.append("no page shows an example")
    print("\n".join(wrong) or f"{shown} examples as they are compiled")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
