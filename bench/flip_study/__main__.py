# SPDX-License-Identifier: Apache-2.0
"""The study of the flip: docs/flip_study.md says what for. Run by scripts/study-flip."""
import argparse
import pathlib
import re

import curves
import drives
import gears
import momentum
import program

PAGE = pathlib.Path("docs/flip_study.md")
PARTS = {"curves": curves.run, "momentum": momentum.run, "gears": gears.run, "ratios": drives.ratios,
         "gearbox": drives.gearbox, "sensitivity": drives.sensitivity, "identified": drives.identified}


def write(name, text):
    """Between the part's marks of the page; all else stays."""
    begin, end = f"<!-- written by scripts/study-flip {name} -->", f"<!-- end of {name} -->"
    page = PAGE.read_text()
    if begin not in page:
        raise SystemExit(f"{PAGE} has no mark for {name}")
    pattern = re.escape(begin) + ".*?" + re.escape(end)
    PAGE.write_text(re.sub(pattern, lambda _: f"{begin}\n\n{text}\n{end}", page, flags=re.DOTALL))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("parts", nargs="*", default=[], metavar="PART", help=", ".join(PARTS))
    parser.add_argument("--program", required=True)
    parser.add_argument("--folder", default="build/study_flip")
    parser.add_argument("--time-limit", default="120", help="of each plan, in s")
    parser.add_argument("--trials", type=int, default=20)
    parser.add_argument("--keep", action="store_true", help="take plans that lie in the folder from a run before")
    options = parser.parse_args()
    unknown = set(options.parts) - set(PARTS)
    if unknown:
        parser.error(f"no part {', '.join(sorted(unknown))}; there are {', '.join(PARTS)}")
    runner = program.Program(options.program, options.folder, options.time_limit, options.trials,
                             options.keep)
    for name in options.parts or PARTS:
        text = PARTS[name](runner)
        (runner.folder / f"{name}.md").write_text(text)
        write(name, text)
        print(text)


main()
