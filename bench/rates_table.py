#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""How often the right effect is named, by class and size, one column for each generator.

rates_table.py NAME=FILE ...

Each FILE is what bench/foreign_rates.py printed of one class; several of one NAME are counted
together. A table of Markdown, one effect by its size in noise floors too: right and a wrong name of
how many, with Wilson's interval of the right ones at 95 %, and right of those whose truth a least
squares of the true law recovers, where the generator says so.
"""
import re
import sys

from foreign_rates import wilson

CLASSES = {"none": "nothing missing", "one": "one effect", "two": "two effects",
           "coulomb_load": "Coulomb with load friction", "undecidable": "undecidable",
           "outside": "outside the library"}
BINS = ((1, 3), (3, 10), (10, 30), (30, 100), (100, 300))
LOG = re.compile(r"^\d+ (?:(ok|miss|WRONG)\s.*? \[([\d,]*)\] ->|\S+ REFUSED)")
KIND = re.compile(r"^(\w+) right: ")
RECOVERED = re.compile(r"^(\w+) right of those .*: (\d+) of (\d+)$")


def cell(marks, recovered=(0, 0)):
    if not marks:
        return "-"
    right, wrong = marks.count("ok"), marks.count("WRONG")
    low, high = wilson(right, len(marks))
    text = f"{right} of {len(marks)} ({100 * low:.0f} to {100 * high:.0f} %), {wrong} wrong"
    return text + (f"; {recovered[0]} of {recovered[1]} told" if recovered[1] else "")


def read(path, marks, recovered):
    """Of a file: verdicts by class, those of one effect by size, and right of the recoverable."""
    logs = []
    with open(path) as file:
        for line in file:
            log, kind, told = LOG.match(line), KIND.match(line), RECOVERED.match(line)
            if log:
                sizes = [int(size) for size in (log.group(2) or "").split(",") if size]
                logs.append((log.group(1) or "miss", sizes))
            elif kind:
                marks.setdefault(kind.group(1), []).extend(mark for mark, _ in logs)
                for low, high in BINS if kind.group(1) == "one" else ():
                    marks.setdefault((low, high), []).extend(
                        mark for mark, sizes in logs if sizes and low <= min(sizes[0], 299) < high)
                logs = []
            elif told:
                right, count = recovered.get(told.group(1), (0, 0))
                recovered[told.group(1)] = (right + int(told.group(2)), count + int(told.group(3)))


def main():
    if len(sys.argv) < 2 or any("=" not in word for word in sys.argv[1:]):
        print(__doc__, file=sys.stderr)
        return 2
    generators = {}
    for word in sys.argv[1:]:
        name, path = word.split("=", 1)
        read(path, *generators.setdefault(name, ({}, {})))
    print("| |" + "".join(f" {name} |" for name in generators))
    print("|---|" + "---|" * len(generators))
    for kind, title in CLASSES.items():
        rows = [(title, kind)]
        if kind == "one":
            rows += [(f"- {low} to {high} floors", (low, high)) for low, high in BINS]
        for head, key in rows:
            cells = [cell(marks.get(key), told.get(key, (0, 0)))
                     for marks, told in generators.values()]
            if any(each != "-" for each in cells):
                print(f"| {head} | " + " | ".join(cells) + " |")
    return 0


if __name__ == "__main__":
    sys.exit(main())
