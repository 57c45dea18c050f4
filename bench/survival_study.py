#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Which randomised trials survive: plans each motion, replays it with each controller in each
engine, and writes the table of docs/survival.md between its marks. Trials are those of
specs/randomisation/hopper.json, sensor noise included; a plan that is there is taken as it is.

    bench/survival_study.py PROGRAM [--trials 60] [--only hop ...] [--controllers lqr weighing]
                            [--known "" "no shift" "2 %, 3 mm"] [--seed 3]
                            [--folder build/study_survival] [--write]
    bench/survival_study.py PROGRAM --pushes    # prints what pushes are survived instead
"""

import argparse
import json
import pathlib
import re
import subprocess
from itertools import product

SPECS = pathlib.Path("specs").resolve()
ROBOT = SPECS / "robot/hopper.json"
RANDOMISATION = SPECS / "randomisation/hopper.json"
PAGE = pathlib.Path("docs/survival.md")
MARKS = ("<!-- written by scripts/study-survival -->", "<!-- end of survival -->")
MOTIONS = {
    "hop": ["--task", "hop"],
    "hop, reserve 0.12": ["--task", "hop", "--reserve", "0.12"],
    "step, reserve 0.12": ["--task", "hop", "--stride", "0.3", "--land-at", "0.085",
                           "--reserve", "0.12"],
    "four hops at 0.8 m/s, reserve 0.12": ["--task", "hop", "--repeat", "2", "--alike", "--speed",
                                           "0.8", "--reserve", "0.12", "--intervals", "60"],
    "flip": [],
    "flip at 16:1, reserve 0.08": ["--reserve", "0.08"],
}
# Rigid ground is the hardest that there is; MuJoCo's usual one gives with 1 ms.
ENGINES = {"own engine, rigid ground": ["--engine", "own"],
           "own, 1 ms": ["--engine", "own", "--ground-time-constant", "0.001"],
           "MuJoCo, 1 ms": ["--engine", "mujoco"]}
UP = ("stands", "missed", "trembles")
WAYS = {"forwards": (1, 0, 0), "backwards": (-1, 0, 0), "to the left": (0, 1, 0),
        "to the right": (0, -1, 0)}
PUSHED_S = "2"
PUSHED_HOPS = ["--task", "hop", "--repeat", "2", "--alike", "--speed", "0.4", "--reserve", "0.08",
               "--intervals", "60"]
HOPS = {"four hops at 0.8 m/s, reserve 0.12": ["--hops", "4"]}
RATIO = re.compile(r" at (\d+):1")
# How well the robots that are drawn are known, beside what the document says: ranges of masses,
# inertias and gains about 1, and of centres of mass; None: no shift. Sensors are the same.
KNOWN = {"": {}, "no shift": {"shift_m": None}, "2 %, 3 mm": {"share": 0.02, "shift_m": 0.003}}


def written(file, document):
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(json.dumps(document))
    return file


def robot_of(name, folder):
    """The robot of a motion: the document's, or the same with another ratio at the knee, whose
    torque and speed limits are the drive's and follow it."""
    ratio = RATIO.search(name)
    if not ratio:
        return ROBOT
    ratio = int(ratio[1])
    robot = json.loads(ROBOT.read_text().replace('"../', f'"{SPECS}/'))
    knee_file = next(each for each in robot["mechanisms"] if each["joints"] == ["knee"])
    knee = json.loads(pathlib.Path(knee_file["actuators"][0]).read_text())
    change = ratio / knee["gearbox"]["ratio"]
    knee["gearbox"]["ratio"] = ratio
    knee["datasheet"]["peak_torque_Nm"] *= change
    knee["datasheet"]["no_load_speed_rad_s"] /= change
    joint = next(each for each in robot["joints"] if each["name"] == "knee")
    joint["torque_limit_Nm"] *= change
    joint["speed_limit_rad_s"] /= change
    knee_file["actuators"] = [str(written(folder / f"knee_{ratio}.json", knee).resolve())]
    return written(folder / f"hopper_{ratio}.json", robot)


def randomisation_of(known, folder):
    """The papers' ranges, or narrower ones."""
    change = KNOWN[known]
    if not change:
        return RANDOMISATION
    document = json.loads(RANDOMISATION.read_text())
    if "share" in change:
        even = {"least": 1 - change["share"], "greatest": 1 + change["share"]}
        document["total_mass_factor"] = even
        document["body_inertia_factor"] = document["controller_gain_factor"] = [even]
    if change["shift_m"] is None:
        del document["center_of_mass_shift_m"]
    else:
        document["center_of_mass_shift_m"][0].update(
            least=-change["shift_m"], greatest=change["shift_m"])
    document["assumed"] = [each for each in document["assumed"] if "center_of_mass" not in each]
    return written(folder / ("known_" + re.sub(r"\W+", "_", known) + ".json"), document)


def planned(program, name, folder):
    """The motion's file, or None where no plan was found."""
    file = folder / (re.sub(r"\W+", "_", name) + ".csv")
    if not file.exists():
        subprocess.run([program, "hopper", "flip", str(robot_of(name, folder)), *MOTIONS[name],
                        "--time-limit", "300", "-o", str(file)], stdout=subprocess.DEVNULL)
    return file if file.exists() else None


def trials(options, name, files, engine, controller):
    """What a cell says: successes of the trials that were finished, Wilson's interval, and how many
    are up at the end whatever they did. `files`: robot, motion, randomisation."""
    robot, motion, randomisation = map(str, files)
    run = subprocess.run([options.program, "hopper", "replay", robot, motion, *ENGINES[engine],
                          "--controller", controller, "--trials", str(options.trials),
                          "--seed", str(options.seed), "--randomise", randomisation, "--json",
                          *HOPS.get(name, [])],
                         capture_output=True, text=True)
    found = json.loads(run.stdout)["trials"]
    least, most = (100 * end for end in found["interval"])
    up = sum(each["verdict"] in UP for each in found["list"])
    return f"{found['succeeded']} of {found['count']}, {least:.0f} to {most:.0f} %; up {up}"


def rows(options):
    folder = pathlib.Path(options.folder)
    folder.mkdir(parents=True, exist_ok=True)
    for name in options.only:
        motion = planned(options.program, name, folder)
        ways = options.known or (KNOWN if RATIO.search(name) else [""])
        for controller, known in product(options.controllers if motion else [], ways):
            files = robot_of(name, folder), motion, randomisation_of(known, folder)
            cells = [trials(options, name, files, engine, controller) for engine in ENGINES]
            robot = f"{name}; {known}" if known else name
            yield f"| {robot} | {controller} | {' | '.join(cells)} |"
        if motion is None:
            yield f"| {name} | -{' | no plan' * len(ENGINES)} |"


def is_up(options, engine, command, push):
    run = subprocess.run([options.program, "hopper", "replay", *command, *ENGINES[engine],
                          "--push", push, "--json"], capture_output=True, text=True)
    return json.loads(run.stdout)["verdict"] in UP


def greatest_push(options, engine, command, way):
    """In N s, in steps of half a one: the last before the first after which it is not up."""
    halves = 0
    while is_up(options, engine, command,
                ",".join(str(0.5 * (halves + 1) * each) for each in way) + "@" + PUSHED_S):
        halves += 1
    return 0.5 * halves


def push_rows(options):
    """Robots as documented; the push at a time when the hopping one is in the air."""
    folder = pathlib.Path(options.folder)
    hops = folder / "hops_at_0_4.csv"
    if not hops.exists():
        subprocess.run([options.program, "hopper", "flip", str(ROBOT), *PUSHED_HOPS, "-o",
                        str(hops)], stdout=subprocess.DEVNULL)
    squat = str(SPECS / "trajectory/hopper_squat.csv")
    pushed = {"stands": [str(ROBOT), squat, "--controller", "weighing", "--stand", "3"],
              "hops at 0.4 m/s": [str(ROBOT), str(hops), "--hops", "8", "--controller", "stepping",
                                  "--forward", "0.4"]}
    for name, command in pushed.items():
        for engine in ENGINES:
            cells = [f"{greatest_push(options, engine, command, way):g}" for way in WAYS.values()]
            yield f"| {name} | {engine} | {' | '.join(cells)} |"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--trials", type=int, default=60)
    parser.add_argument("--only", nargs="+", choices=MOTIONS, default=list(MOTIONS))
    parser.add_argument("--controllers", nargs="+", default=["weighing"])
    parser.add_argument("--known", nargs="+", choices=KNOWN,
                        help="default: all where the flip is at another ratio, else the papers'")
    parser.add_argument("--seed", type=int, default=3,
                        help="1 and 2 chose the regulator's constants")
    parser.add_argument("--folder", default="build/study_survival")
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--pushes", action="store_true",
                        help="prints what pushes are survived, by direction, in N s")
    options = parser.parse_args()
    if options.pushes:
        print("| robot | engine | " + " | ".join(WAYS) + " |")
        for row in push_rows(options):
            print(row, flush=True)
        return
    table = [f"| motion | controller | {' | '.join(ENGINES)} |",
             "|---|---|" + "---|" * len(ENGINES)]
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
