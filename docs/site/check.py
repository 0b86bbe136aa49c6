# SPDX-License-Identifier: MIT
"""Every link of the site leads to a file and an anchor that exist, no page loads anything from another host, and the search
finds what a reader looks for.

    check.py FOLDER
"""

import json
import re
import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

from snowballstemmer import stemmer

# What a reader types, and a page that must be among the results.
QUERIES = {"diffusion": "docs/tasks/diffusion", "time-step bias": "docs/half-femtosecond", "rigid water": "index",
           "resume": "docs/tasks/resume", "Integrator": "docs/api/cpp/polhode-integrate"}
LOADED = {"script": "src", "img": "src", "iframe": "src", "source": "src", "link": "href"}


class Page(HTMLParser):
    """The anchors of a page, its links, and what it loads."""

    def __init__(self, path):
        super().__init__()
        self.anchors, self.links, self.loads = set(), [], []
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        given = dict(attributes)
        self.anchors |= {given.get("id"), given.get("name")}
        if tag == "a" and given.get("href"):
            self.links.append(given["href"])
        if given.get(LOADED.get(tag)) and given.get("rel") != "canonical":
            self.loads.append(given[LOADED[tag]])


def dead_links(site, pages):
    for path, page in pages.items():
        for link in page.links + page.loads:
            place = urlsplit(link)
            if place.scheme or place.netloc:
                continue
            target = (path.parent / unquote(place.path)).resolve() if place.path else path
            anchor = unquote(place.fragment)
            if not target.is_file():
                yield f"{path.relative_to(site)}: {link} does not exist"
            elif anchor and target in pages and anchor not in pages[target].anchors:
                yield f"{path.relative_to(site)}: {link} has no such anchor"


def other_hosts(site, pages):
    for path, page in pages.items():
        for link in page.loads:
            if urlsplit(link).netloc:
                yield f"{path.relative_to(site)}: loads {link} from another host"


def not_found(site):
    """Queries whose page is not among the pages that hold all their words."""
    index = json.loads(re.fullmatch(r"Search\.setIndex\((.*)\);?\s*", (site / "searchindex.js").read_text(encoding="utf-8"))[1])
    stem = stemmer("english").stemWord

    def pages_with(word):
        found = [index[part].get(stem(word.lower()), []) for part in ("terms", "titleterms")]
        return {number for pages in found for number in (pages if isinstance(pages, list) else [pages])}

    for query, page in QUERIES.items():
        results = set.intersection(*map(pages_with, re.findall(r"\w+", query)))
        if index["docnames"].index(page) not in results:
            yield f"the search for '{query}' does not find {page}"


def main():
    site = Path(sys.argv[1]).resolve()
    pages = {path: Page(path) for path in sorted(site.rglob("*.html"))}
    found = [*dead_links(site, pages), *other_hosts(site, pages), *not_found(site)]
    print("\n".join(found) or f"{len(pages)} pages, {sum(len(page.links) for page in pages.values())} links, none dead")
    sys.exit(1 if found else 0)


main()
