# SPDX-License-Identifier: MIT
"""What several documents state has one value: how long a command takes, the default of a key, and the facts listed here.

Durations are those in the comment of a command (`polhode bench --quick  # a few seconds; without --quick, half a minute`), in
the line of an option in a help page, and in a sentence that names the command. Defaults are those in the tables of keys, and
in sentences such as "`skin` (default: 0.05 nm)". A value that is stated once is not checked.
"""

import re
from collections import defaultdict

from pages import options, report

NOT_CHECKED = ("bench/results", "studies/records", "build", "third_party", "CHANGELOG.md", "docs/glossary.md", "docs/bibliography.md")
BLOCK = re.compile(r"^```(\w*).*?\n(.*?)^```", re.S | re.M)
WORDS = {w: str(n) for n, w in enumerate("zero one two three four five six seven eight nine ten eleven twelve".split())}
WORDS |= {"a": "1", "an": "1", "fifteen": "15", "twenty": "20", "thirty": "30", "half a": "0.5", "half an": "0.5", "a quarter of an": "0.25"}
NUMBER = r"\d+(?:\.\d+)?|" + "|".join(sorted(WORDS, key=len, reverse=True))
DURATION = re.compile(rf"(?:\b(a few|(?:{NUMBER})(?: to (?:{NUMBER}))?) )?\b(second|minute|hour)s?\b", re.I)
COMMAND = re.compile(r"(?:\bpolhode ((?:study|bench|advise|verify|analyze)\b)|\./(demo|test)\b|\b((?:bench/\w+|studies)/\w+\.py))([^#`;]*)")
FACTS = {  # what is stated: how; the group is the value
    "kelvins by which velocity Verlet at 2 fs cools the rotation of water":
        r"velocity Verlet at 2 fs[^|]{0,60}?rotation(?: of water)? is(?: then)? (\d+) K colder",
    "kelvins by which velocity Verlet at 4 fs cools the rotation of water": r"(\d+) K colder,? at 4 fs|at 4 fs it is (\d+) K colder",
    "R of velocity Verlet at 2 fs in water": r"velocity Verlet at 2 fs has R of (\d+) %",
    "p-value below which an energy drift is significant": r"p-value is below\s+(\d+ %)|below (0\.\d+) the energy drift is called significant",
    "lambda of gier4-fd in double precision": r"\\lambda = (\S+?)\$, the default of `gier4-fd` in double|`lambda` \|[^|]*\| (\S+?);",
    "force evaluations as which a derivative counts": r"derivative(?: of them|, which)? counts as (\w+)",
    "time that idle threads spin": r"[Ii]dle threads spin for (\d+ µs)",
}
FORMS = {  # lines that may not be: what to write
    r"^\./polhode\b": "write polhode, which README puts on the PATH",
    r"^\| GROMACS(?! md| \| -)(?![^|]*(?:SSE|AVX))": "name the instruction set of GROMACS in the row of its numbers",  # rows of md are averages
}


def pages(root):
    for page in sorted(root.rglob("*.md")):
        name = page.relative_to(root).as_posix()
        if not any(name == place or name.startswith(place + "/") for place in NOT_CHECKED):
            yield name, page.read_text(encoding="utf-8")


def number(text):
    return WORDS.get(text.lower(), text)


def durations(text):
    """The durations that a text states, as '2 minute', '6 to 20 minute', 'a few second' or 'hour'."""
    for match in DURATION.finditer(text):
        first, _, last = (match[1] or "").partition(" to ")
        value = f"{number(first)} to {number(last)}" if last else number(first)
        yield f"{value} {match[2].lower()}".strip()


def times_of_line(line):
    """(command, duration) of a command with a comment; after "without --quick" the command is the one without it."""
    command, _, comment = line.partition("#")
    named = COMMAND.search(command)
    if not named:
        return
    name = next(filter(None, named.groups()[:3]))
    options = " --quick" if "--quick" in named[4] else ""
    others = named[4].replace("--quick", "").strip()
    plain = others in ("", "--output figure1")
    if named[3] and not plain:  # a script of bench or studies takes a time of its own with each choice of options
        name = f"{name} {others}"
    for clause in re.split(r"; ", comment):
        quick = " --quick" if re.match(r"\s*--quick", clause) else "" if "without --quick" in clause else options
        if plain or not quick:
            yield from ((name + quick, value) for value in durations(clause))


def times(text):
    """(position, command, duration) of a page."""
    for block in BLOCK.finditer(text):
        position = block.start(2)
        help_of = re.search(r"<!-- help: (\w+) -->\n$", text[:block.start()])
        for line in block[2].splitlines(keepends=True):
            if help_of and (option := re.match(r"\s+(--quick)\s+(.*)", line)):
                yield from ((position, f"{help_of[1]} --quick", value) for value in durations(option[2]))
            elif not help_of:
                yield from ((position, *found) for found in times_of_line(line))
            position += len(line)
    prose = BLOCK.sub(lambda m: re.sub(r"[^\n]", " ", m[0]), text)
    for sentence in re.finditer(r"[^.|]*?`([^`]+)`[^.|]*", prose):
        named = COMMAND.fullmatch(sentence[1].strip())
        if named and named[4].strip() in ("", "--quick"):
            name = next(filter(None, named.groups()[:3])) + (" --quick" if "--quick" in named[4] else "")
            yield from ((sentence.start(1), name, value) for value in durations(sentence[0]))


def plain_value(text):
    return re.sub(r'[`"\s]', "", re.split(r"[;:,]", text)[0])


def defaults_in_tables(text):
    """(key, default) of each table of keys; those of keys of the same name, in other sections, may differ."""
    for table in re.finditer(r"^\| key \|[^\n]*\| default \|[^\n]*\n\|[-| ]+\n((?:\|.*\n)*)", text, re.M):
        yield from ((key, plain_value(default)) for key, default in
                    re.findall(r"^\| `(\w+)` \|[^|]*\| ([^|]+) \|", table[1], re.M))


def defaults_in_sentences(text):
    """(position, key, default) of `skin` (default: 0.05 nm)."""
    for stated in re.finditer(r"`(\w+)`[^.|`()]{0,40}\(default:? ([^)]*\d[^)]*)\)", text):
        yield stated.start(), stated[1], plain_value(stated[2])


def facts(text):
    for what, pattern in FACTS.items():
        for match in re.finditer(pattern.replace(" ", r"\s+"), text):
            value = next(filter(None, match.groups()))
            yield match.start(), what, {"1 %": "0.01", "10^{-4}": "1e-4", "two": "2"}.get(value, value)


def main():
    root = options(__doc__).root
    stated = defaultdict(lambda: defaultdict(list))  # what, value: where
    documents = dict(pages(root))
    tables = defaultdict(set)
    for text in documents.values():
        for key, default in defaults_in_tables(text):
            tables[key].add(default)
    wrong = []
    for name, text in documents.items():
        wrong += [f"{name}:{text.count(chr(10), 0, position) + 1}: the default of {key} is {default}, elsewhere {', '.join(tables[key])}"
                  for position, key, default in defaults_in_sentences(text) if key in tables and default not in tables[key]]
        wrong += [f"{name}:{text.count(chr(10), 0, line.start()) + 1}: {better}"
                  for form, better in FORMS.items() for line in re.finditer(form, text, re.M)]
        for kind, found in (("time of ", times), ("", facts)):
            for position, what, value in found(text):
                stated[kind + what][value].append(f"{name}:{text.count(chr(10), 0, position) + 1}")
    wrong += [f"{what} has several values, correct all but one: " + "; ".join(f"{value} ({', '.join(places)})" for value, places in values.items())
             for what, values in stated.items() if len(values) > 1]
    several = sum(sum(map(len, values.values())) > 1 for values in stated.values())
    report(wrong, f"{several} values are stated several times, the same each time")


if __name__ == "__main__":
    main()
