# SPDX-License-Identifier: MIT
"""The documentation site: settings of Sphinx. Built by scripts/site, whose staging folder is the source."""

import importlib.util
import re
import sys
from pathlib import Path

from docutils import nodes
from sphinx import addnodes
from sphinx.transforms import SphinxTransform

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "python"))

project = "polhode"
author = "the maintainers of polhode"
project_copyright = "MIT licence"
release = version = re.search(r"project\(polhode VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text())[1]

extensions = ["myst_nb", "sphinx.ext.autodoc", "sphinx.ext.napoleon", "sphinx.ext.mathjax", "sphinx_design",
              "sphinx_copybutton", "breathe"]
include_patterns = ["index.md", "docs/**", "ARCHITECTURE.md", "CHANGELOG.md", "CONTRIBUTING.md",
                    "LICENSES.md", "bench/**.md", "studies/**.md", "tests/**.md", "data/**.md", "python/*.md"]
exclude_patterns = ["docs/site/index.md"]
nitpicky = True
nitpick_ignore_regex = [("py:class", r"(?!polhode\.[^_]).*"), ("cpp:identifier", ".*")]  # types of other packages

# Documents are those that are read on the web: links to headings, formulas between dollars.
myst_enable_extensions = ["dollarmath", "amsmath", "colon_fence"]
myst_heading_anchors = 4
myst_fence_as_directive = ["math"]
suppress_warnings = ["misc.highlighting_failure",
                     "myst.header",  # the bibliography has no headings of level 2
                     "duplicate_declaration.cpp"]  # each header declares the namespace

# Tutorials are notebooks, which run with the installed package.
nb_execution_mode = "cache"
nb_execution_cache_path = str(ROOT / "build/site/tutorials")
nb_execution_in_temp = True
nb_execution_raise_on_error = True
nb_execution_timeout = 600

autodoc_mock_imports = ["polhode._core"]  # docstrings need no compiled module
autodoc_member_order = "bysource"
autodoc_typehints = "none"  # docstrings name the types
python_use_unqualified_type_names = True

breathe_projects = {"polhode": str(ROOT / "build/site/doxygen/xml")}
breathe_default_project = "polhode"
breathe_show_include = False  # without the folder
cpp_maximum_signature_line_length = 100

html_theme = "furo"
html_title = f"polhode {version}"
html_static_path = ["style.css", importlib.util.find_spec("sphinx-mathjax-offline").submodule_search_locations[0] + "/static"]
mathjax_path = "mathjax/tex-chtml.js"  # formulas without a network
html_css_files = ["style.css"]
html_show_sphinx = False
html_theme_options = {"light_css_variables": {"color-brand-primary": "#0072b2", "color-brand-content": "#0072b2"},
                      "dark_css_variables": {"color-brand-primary": "#56b4e9", "color-brand-content": "#56b4e9"}}


def add_readme(app, name, source):
    """The start page is README.md, with the doors of docs/site/index.md after what polhode is and why."""
    if name == "index":
        introduction, heading, rest = (ROOT / "README.md").read_text(encoding="utf-8").partition("**For whom.**")
        source[0] = f"{introduction}{source[0]}\n{heading}{rest}"


def show_names_of_files(app, name, source):
    """A block below <!-- file: NAME --> has the name of the file above it."""
    source[0] = re.sub(r"^<!-- file: (\S+) -->\n```(\w+)\n", r"```{code-block} \2\n:caption: \1\n\n", source[0],
                       flags=re.M)


class CppContents(SphinxTransform):
    """On pages of C++ the namespace is no level of its own, and the contents of a page list only what is directly in it."""
    default_priority = 500

    def apply(self):
        declared = [node for node in self.document.findall(addnodes.desc) if node["domain"] == "cpp"]
        for node in declared:
            if node[0].astext() == "namespace polhode":
                index = node.parent[node.parent.index(node) - 1]
                index["entries"] = []
                node.replace_self([nodes.container(ids=node[0]["ids"]), *node[1].children])
                continue
            node[0]["_toc_name"] = node[0].get("_toc_name", "").removeprefix("polhode::")
            for member in node[1].findall(addnodes.desc_signature):
                member["_toc_name"] = ""


def fold_navigation(app, name, template, context, doctree):
    """Each section of the navigation is folded, except the one that is read."""
    def folded(section):
        caption, pages = section.groups()
        return f"<details{' open' if 'current' in pages else ''}><summary class='caption'>{caption}</summary>{pages}</details>"

    context["furo_navigation_tree"] = re.sub(r'<p class="caption".*?>(<span.*?</span>)</p>\s*(<ul.*?</ul>)(?=\s*(?:<p|</div>|$))',
                                             folded, context["furo_navigation_tree"], flags=re.S)


def escape_stars(app, what, name, obj, options, lines):
    """The stars of `**keywords` in a docstring are no marks."""
    lines[:] = [line.replace("**keywords", r"\*\*keywords") for line in lines]


def setup(app):
    app.connect("source-read", add_readme)
    app.connect("source-read", show_names_of_files)
    app.add_transform(CppContents)
    app.connect("html-page-context", fold_navigation, priority=900)  # after furo
    app.connect("autodoc-process-docstring", escape_stars, priority=400)  # before napoleon
