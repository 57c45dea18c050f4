#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Which randomised trials survive: plans each motion, replays it with each controller in each
engine, and writes the table of docs/survival.md between its marks. Trials are those of
specs/randomisation/hopper.json, sensor noise included; a plan that is there is taken as it is.

    bench/survival_study.py PROGRAM [--trials 60] [--only hop ...] [--controllers lqr weighing]
                            [--folder build/study_survival] [--write]
"""

import argparse
import json
import pathlib
import subprocess

ROBOT = "specs/robot/hopper.json"
RANDOMISATION = "specs/randomisation/hopper.json"
PAGE = pathlib.Path("docs/survival.md")
MARKS = ("<!-- written by scripts/study-survival -->", "<!-- end of survival -->")
MOTIONS = {
    "hop": ["--task", "hop"],
    "hop, reserve 0.12": ["--task", "hop", "--reserve", "0.12"],
    "step, reserve 0.12": ["--task", "hop", "--stride", "0.3", "--land-at", "0.085",
                           "--reserve", "0.12"],
    "four hops": ["--task", "hop", "--repeat", "4", "--speed", "0.8"],
    "flip": [],
}


def planned(program, name, folder):
    """The motion's file, or None where no plan was found."""
    file = folder / (name.replace(",", "").replace(" ", "_") + ".csv")
    if not file.exists():
        subprocess.run([program, "hopper", "flip", ROBOT, *MOTIONS[name], "--time-limit", "300",
                        "-o", str(file)], stdout=subprocess.DEVNULL)
    return file if file.exists() else None


def trials(program, motion, engine, controller, count):
    """What a cell says: successes of the trials that were finished, and Wilson's interval."""
    run = subprocess.run([program, "hopper", "replay", ROBOT, str(motion), "--engine", engine,
                          "--controller", controller, "--trials", str(count), "--randomise",
                          RANDOMISATION, "--json"], capture_output=True, text=True)
    found = json.loads(run.stdout)["trials"]
    least, most = (100 * end for end in found["interval"])
    return (f"{found['succeeded']} of {found['count'] - found['unfinished']}, "
            f"{least:.0f} to {most:.0f} %")


def rows(options):
    folder = pathlib.Path(options.folder)
    folder.mkdir(parents=True, exist_ok=True)
    for name in options.only:
        motion = planned(options.program, name, folder)
        for controller in options.controllers if motion else []:
            cells = [trials(options.program, motion, engine, controller, options.trials)
                     for engine in ("own", "mujoco")]
            yield f"| {name} | {controller} | {cells[0]} | {cells[1]} |"
        if motion is None:
            yield f"| {name} | - | no plan | no plan |"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--trials", type=int, default=60)
    parser.add_argument("--only", nargs="+", choices=MOTIONS, default=list(MOTIONS))
    parser.add_argument("--controllers", nargs="+", default=["lqr", "weighing"])
    parser.add_argument("--folder", default="build/study_survival")
    parser.add_argument("--write", action="store_true")
    options = parser.parse_args()
    table = ["| motion | controller | own engine | MuJoCo |", "|---|---|---|---|"]
    for row in rows(options):
        print(row, flush=True)
        table.append(row)
    if not options.write:
        return
    page = PAGE.read_text()
    before, rest = page.split(MARKS[0])
    after = rest.split(MARKS[1])[1]
    PAGE.write_text(before + MARKS[0] + "\n\n" + "\n".join(table) + "\n\n" + MARKS[1] + after)


main()
