# SPDX-License-Identifier: MIT
"""Every page of docs/ is in a table of contents of the documentation site, once, and every entry there is a page.

So is every public name of the Python package in the page of its API.
"""

import ast
import re
import sys
from collections import Counter
from pathlib import Path

ROOT = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).resolve().parents[2]).resolve()
SITE = ROOT / "docs/site"
TREE = re.compile(r"^```\{toctree\}\n(.*?)^```", re.M | re.S)
ENTRY = re.compile(r"^\.\. auto(?:class|function|exception):: (\w+)", re.M)


def entries(page):
    """The entries of the tables of contents of a page."""
    for tree in TREE.findall(page.read_text(encoding="utf-8")):
        for line in tree.splitlines():
            if line and not line.startswith(":"):
                yield line


def public_names(module="__init__"):
    """The names in __all__ of a module, and of those that it adds to its own: `__all__ += _jobs.__all__`."""
    names = set()
    for node in ast.parse((ROOT / f"python/polhode/{module}.py").read_text(encoding="utf-8")).body:
        if isinstance(node, ast.AugAssign) and node.target.id == "__all__":
            names |= public_names(node.value.value.id)
        elif isinstance(node, ast.Assign) and getattr(node.targets[0], "id", "") == "__all__":
            names |= set(ast.literal_eval(node.value))
    return names


def findings():
    listed = Counter(entries(SITE / "index.md"))
    pages = {p.relative_to(ROOT).with_suffix("").as_posix() for p in (ROOT / "docs").rglob("*.md") if SITE not in p.parents}
    for page in sorted(pages - set(listed)):
        yield f"{page}.md is not in docs/site/index.md; add it to a table of contents"
    for entry, count in sorted(listed.items()):
        if not (ROOT / f"{entry}.md").exists():
            yield f"docs/site/index.md: there is no page {entry}.md; correct the entry"
        elif count > 1:
            yield f"docs/site/index.md: {entry} is listed {count} times; leave one"
    names = set(ENTRY.findall((ROOT / "docs/api/python.md").read_text(encoding="utf-8")))
    for name in sorted(public_names() ^ names):
        yield f"docs/api/python.md and the public names of the package differ in {name}; list each public name once"


found = list(findings())
print("\n".join(found) or "every page and every public name is on the site")
sys.exit(1 if found else 0)
