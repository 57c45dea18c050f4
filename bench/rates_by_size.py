#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""How often one effect is named rightly, by its size in noise floors.

rates_by_size.py NAME=FILE ...

Each FILE is what bench/foreign_rates.py printed of the class `one`; several files of one NAME are
counted together. A table of Markdown: right and wrong for each bin of sizes, with Wilson's interval
at 95 %.
"""
import re
import sys

from foreign_rates import wilson

BINS = ((1, 3), (3, 10), (10, 30), (30, 100), (100, 300))
LINE = re.compile(r"^\d+ (ok|miss|WRONG)\s.*? \[(\d+)\] ->")


def cell(hits, count):
    if count == 0:
        return "-"
    low, high = wilson(hits, count)
    return f"{hits} of {count} ({100 * low:.0f} to {100 * high:.0f} %)"


def logs_of(path):
    with open(path) as file:
        for line in file:
            found = LINE.match(line)
            if found:
                yield found.group(1), int(found.group(2))


def main():
    if len(sys.argv) < 2 or any("=" not in word for word in sys.argv[1:]):
        print(__doc__, file=sys.stderr)
        return 2
    logs = {}
    for word in sys.argv[1:]:
        name, path = word.split("=", 1)
        logs.setdefault(name, []).extend(logs_of(path))
    print("| floors |" + "".join(f" right, {name} | wrong |" for name in logs))
    print("|---|" + "---|---|" * len(logs))
    for low, high in BINS:
        cells = []
        for each in logs.values():
            marks = [mark for mark, size in each if low <= size < high or size == high == 300]
            cells += [cell(marks.count("ok"), len(marks)), cell(marks.count("WRONG"), len(marks))]
        print(f"| {low} to {high} | " + " | ".join(cells) + " |")
    return 0


if __name__ == "__main__":
    sys.exit(main())
