# SPDX-License-Identifier: MIT
"""The manual shows the --help of each verb as the program prints it, and the docstring of its function in Python has the same
meanings of its options; with --write both are updated. No default in a help text is a number of its own.

The page docs/manual/VERB.md contains the help in the fenced block below `<!-- help: VERB -->`, and the index
docs/manual/README.md that of the program below `<!-- help -->`. The verbs are also in a table of the index, in a table of contents
of the site, and in the page of the Python interface.
"""

import re
import subprocess
import textwrap

from pages import is_current, options, report

WIDTH = 110  # of docstrings
OPTION = re.compile(r"^  --([\w-]+)\S*(?: \S+)*?\s{2,}(.+)$", re.M)
ENTRY = re.compile(r"^        (\w+(?:, \**\w+)*)( \(.*?\))?: (.*(?:\n {12}.*)*)\n", re.M)


# Page: the lines of verbs in it, and the line of one.
INDICES = {
    "docs/manual/README.md": (r"(?<=\| verb \| task \|\n\| --- \| --- \|\n)(?:\|.*\n)+", "| [{verb}]({verb}.md) | {meaning} |"),
    "docs/site/index.md": (r"(?<=\ndocs/manual/README\n)(?:docs/manual/.*\n)+?(?=docs/manual/python\n)", "docs/manual/{verb}"),
    "docs/api/python.md": (r"(?<=\nVerbs\n-----\n\n)(?:\.\. autofunction:: .*\n)+", ".. autofunction:: {name}")}


def help_text(program, *verb):
    return subprocess.run([program, *verb, "--help"], text=True, capture_output=True, check=True).stdout.strip() + "\n"


def verbs(program):
    """The verbs and what they do, in the order in which the program lists them."""
    listed = help_text(program).partition("examples\n")[0]
    return dict(re.findall(r"^  ([\w-]+) +(.*)", listed, re.M))


def with_help(text, verb, shown):
    """A page of the manual with the help; None: it has no place for one."""
    mark = f"<!-- help: {verb} -->" if verb else "<!-- help -->"
    block = re.search(re.escape(mark) + r"\n```text\n(.*?)```\n", text, re.S)
    return block and text[:block.start(1)] + shown + text[block.end(1):]


def function_of(source, verb):
    """The function of a verb: its parameters, and the arguments in its docstring."""
    return re.search(rf'^def {verb.replace("-", "_")}\((.*?)\).*?:\n    """.*?    Args:\n(.*?)(?=\n    """|\n\n)', source, re.S | re.M)


def with_meanings(source, verb, shown):
    """A module of Python whose docstring of the verb's function has the meanings of the options."""
    function = function_of(source, verb)
    if not function:
        return source
    meanings = {name.replace("-", "_"): f"{meaning}." for name, meaning in OPTION.findall(shown) if "--" not in meaning}
    of_python = re.findall(r"(\w+): (?:Source|Messages|Progress)\b", function[1])  # which a command line has not, or as a file

    def entry(found):
        words, kind, _ = found.groups()
        name = words.rstrip("_")
        if name not in meanings or name in of_python or found[3].startswith("as in"):
            return found[0]
        lines = textwrap.wrap(f"{words}{kind or ''}: {meanings[name]}", WIDTH, initial_indent=" " * 8, subsequent_indent=" " * 12,
                              break_on_hyphens=False, break_long_words=False)
        return "\n".join(lines) + "\n"

    arguments = ENTRY.sub(entry, function[2] + "\n")[:-1]
    listed = re.findall(r"\w+", " ".join(words for words, _, text in ENTRY.findall(arguments + "\n")
                                         if "," not in words or text.startswith("as in")))
    for name in set(meanings).intersection(re.findall(r"(\w+): ", function[1])).difference(listed, of_python):
        arguments += f"\n        {name}: {meanings[name]}"
    return source[:function.start(2)] + arguments + source[function.end(2):]


def with_verbs(text, page, meanings):
    """A page with the lines of all verbs that it does not have elsewhere; None: it has no place for them."""
    pattern, line = INDICES[page]
    block = re.search(pattern, text)
    if not block:
        return None
    before, after = text[:block.start()], text[block.end():]
    elsewhere = (before + after).splitlines()
    shown = [line.format(verb=verb, name=verb.replace("-", "_"), meaning=meaning) for verb, meaning in meanings.items()]
    return before + "".join(f"{one}\n" for one in shown if one not in elsewhere) + after


def main():
    given = options(__doc__, "bring pages and docstrings up to date", program=True)
    program, root, wrong = given.program, given.root, []

    def keep(path, text):
        if text is None:
            wrong.append(f"{path.relative_to(root)} has no place for the help or the list of verbs; add it")
        elif not is_current(path, text, given.write):
            wrong.append(f"{path.relative_to(root)} shows another help than the program prints; run this test with --write")

    meanings = verbs(program)
    for page in INDICES:
        keep(root / page, with_verbs((root / page).read_text(encoding="utf-8"), page, meanings))
    for verb in ("", *meanings):
        shown = help_text(program, *([verb] if verb else []))
        page = root / f"docs/manual/{verb or 'README'}.md"
        keep(page, with_help(page.read_text(encoding="utf-8") if page.exists() else "", verb, shown))
        for module in ("_jobs", "_lookup", "_tops"):
            path = root / f"python/polhode/{module}.py"
            keep(path, with_meanings(path.read_text(encoding="utf-8"), verb, shown))
    for source in sorted((root / "cli").rglob("*.cpp")):
        if written := re.search(r'default: \\"[\d.]+', source.read_text(encoding="utf-8")):
            wrong.append(f"{source.name} writes '{written[0]}'; take the number from the settings")
    report(wrong, "the manual and the docstrings show what the program prints")


if __name__ == "__main__":
    main()
