# SPDX-License-Identifier: MIT
"""The documentation site: settings of Sphinx. Built by scripts/site, whose staging folder is the source."""

import importlib.util
import json
import re
import sys
from pathlib import Path

from docutils.parsers.rst import directives
from sphinx.directives.code import CodeBlock

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "python"))

project = "polhode"
author = "the maintainers of polhode"
project_copyright = "MIT licence"
release = version = re.search(r"project\(polhode VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text())[1]

extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.napoleon", "sphinx.ext.mathjax", "sphinx_design",
              "sphinx_copybutton"]
include_patterns = ["index.md", "docs/**", "ARCHITECTURE.md", "CHANGELOG.md", "CONTRIBUTING.md",
                    "LICENSES.md", "bench/**.md", "studies/**.md", "tests/**.md", "data/**.md", "python/*.md"]
exclude_patterns = ["docs/site"]
nitpicky = True
nitpick_ignore_regex = [("py:class", r"(?!polhode\.[^_]).*")]  # types of other packages

# Documents are those that are read on the web: links to headings, formulas between dollars.
myst_enable_extensions = ["dollarmath", "amsmath", "colon_fence"]
myst_heading_anchors = 4
myst_fence_as_directive = ["math"]
suppress_warnings = ["misc.highlighting_failure", "myst.header"]  # the bibliography has no headings of level 2

autodoc_mock_imports = ["polhode._core"]  # docstrings need no compiled module
autodoc_member_order = "bysource"
autodoc_typehints = "none"  # docstrings name the types
python_use_unqualified_type_names = True

html_theme = "furo"
html_title = f"polhode {version}"
html_static_path = ["style.css", importlib.util.find_spec("sphinx-mathjax-offline").submodule_search_locations[0] + "/static"]
mathjax_path = "mathjax/tex-chtml.js"  # formulas without a network
html_css_files = ["style.css"]
html_show_sphinx = False
html_theme_options = {"light_css_variables": {"color-brand-primary": "#0072b2", "color-brand-content": "#0072b2"},
                      "dark_css_variables": {"color-brand-primary": "#56b4e9", "color-brand-content": "#56b4e9"}}


class CodeCell(CodeBlock):
    """A cell of a tutorial: code."""
    option_spec = {**CodeBlock.option_spec, "tags": directives.unchanged}


def add_readme(app, name, source):
    """The start page is README.md, with the doors of docs/site/index.md after what polhode is and why."""
    if name == "index":
        introduction, heading, rest = (ROOT / "README.md").read_text(encoding="utf-8").partition("**For whom.**")
        source[0] = f"{introduction}{source[0]}\n{heading}{rest}"


def show_names_of_files(app, name, source):
    """A block below <!-- file: NAME --> has the name of the file above it."""
    source[0] = re.sub(r"^<!-- file: (\S+) -->\n```(\w+)\n", r"```{code-block} \2\n:caption: \1\n\n", source[0],
                       flags=re.M)


def show_outputs(app, name, source):
    """Below each cell of a tutorial is what it shows, as docs/site/tutorials.py has written it."""
    page = re.fullmatch(r"docs/tutorials/(?!README)(.+)", name)
    if not page:
        return
    file = ROOT / f"build/site/tutorials/{page[1]}.json"
    cells = iter(json.loads(file.read_text(encoding="utf-8"))[1])

    def with_outputs(cell):
        blocks = {"text": "````{{code-block}} none\n:class: output\n\n{}\n````",
                  "html": "````{{raw}} html\n<div class='output'>{}</div>\n````",
                  "image": "````{{raw}} html\n<img class='output' alt='the figure' src='data:image/png;base64,{}'>\n````"}
        return "\n\n".join([cell[0], *(blocks[kind].format(shown) for kind, shown in next(cells))])

    source[0] = re.sub(r"^```\{code-cell\} python\n.*?^```$", with_outputs, source[0], flags=re.M | re.S)


def escape_stars(app, what, name, obj, options, lines):
    """The stars of `**keywords` in a docstring are no marks."""
    lines[:] = [line.replace("**keywords", r"\*\*keywords") for line in lines]


def setup(app):
    app.add_directive("code-cell", CodeCell)
    app.connect("source-read", add_readme)
    app.connect("source-read", show_names_of_files)
    app.connect("source-read", show_outputs)
    app.connect("autodoc-process-docstring", escape_stars, priority=400)  # before napoleon
