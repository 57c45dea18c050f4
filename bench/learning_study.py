#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Policies that learn the flip along a planned one, seed by seed, under the region and in the box:
when they had learned it, and who does it where. Leaves the plan, tables.md and learning_curves.svg
in build/study_learning.

    bench/learning_study.py build/release/src/torquewright [--robot hopper_16.json --reserve 0.08]
                            [--seeds 5] [--iterations 120] [--keep]
                            [--randomise specs/randomisation/hopper.json]

With --randomise episodes differ by that, share after share, and policies are judged under it too.
"""
import argparse
import csv
import json
import pathlib
import resource
import subprocess

FOLDER = pathlib.Path("build/study_learning")
PICTURE = FOLDER / "learning_curves.svg"
LIMITS = ["mor", "box"]
ENGINES = ["own", "mujoco"]
DEGREES = 57.29577951308232
START = {"kind": "randomisation", "version": 1,
         "initial_joint_position_rad": [{"least": -0.1, "greatest": 0.1}],
         "initial_joint_velocity_rad_s": [{"least": -0.05, "greatest": 0.05}]}


def cpu_s():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def run(*words):
    done = subprocess.run(list(map(str, words)), stdout=subprocess.PIPE, text=True, check=False)
    if done.returncode not in (0, 1, 3):
        raise SystemExit(f"{' '.join(map(str, words))} ends with {done.returncode}")
    return done.stdout


def planned(options):
    """The flip that policies go along."""
    plan = FOLDER / "plan.csv"
    if not (options.keep and plan.exists()):
        reserve = ["--reserve", options.reserve] if options.reserve else []
        run(options.program, "hopper", "flip", options.robot, *reserve, "-o", plan)
    return plan


def trained(options, seed, limits):
    """Policy, curve and CPU seconds of one training; a former one where that is to be kept."""
    name = f"{limits}_{seed}"
    policy, curve, spent = (FOLDER / f"{name}{end}" for end in (".json", ".csv", ".cpu_s"))
    if not (options.keep and spent.exists()):
        before_s = cpu_s()
        varied = ["--randomise", options.randomise, "--curriculum"] if options.randomise else []
        run(options.program, "hopper", "train", options.robot, "--task", options.task, "--limits",
            limits, "--reference", planned(options), "--seed", seed, "--iterations",
            options.iterations, "--seconds", 1e6, "-o", policy, "--curve", curve, *varied)
        spent.write_text(str(cpu_s() - before_s))
    with curve.open() as rows:
        return {"seed": seed, "limits": limits, "policy": policy, "curve": curve,
                "cpu_s": float(spent.read_text()), "rows": list(csv.DictReader(rows))}


def learned_at(training, share):
    """Steps and, in proportion to them, CPU seconds after which that share of the judged runs did
    it for the first time."""
    last = int(training["rows"][-1]["steps"])
    for row in training["rows"]:
        if row["judged_runs"] and int(row["judged_succeeded"]) >= share * int(row["judged_runs"]):
            steps = int(row["steps"])
            return f"{steps / 1e6:.1f} M, {training['cpu_s'] * steps / last:.0f} s"
    return "not"


def judged(options, training, limits, engine, randomisation=None):
    start = FOLDER / "start.json"
    start.write_text(json.dumps(START))
    report = json.loads(run(options.program, "hopper", "replay", options.robot, training["policy"],
                            "--limits", limits, "--engine", engine, "--trials", options.trials,
                            "--randomise", randomisation or start, "--json"))
    down = report.get("touch_down")
    short = DEGREES * down["rotation_short_rad"] if down else None
    turns = [deed["done"] for deed in report.get("deeds", []) if deed["deed"] == "rotation"]
    return {"done": report["trials"]["succeeded"], "short": short,
            "turned": DEGREES * turns[0] if turns else None}


def whole(value):
    return "-" if value is None else f"{value:.0f}"


def tables(options, trainings):
    columns = ["trained in", "seed", "half of the runs do it after", "nine of ten after",
               "own, MOR", "own, box", "MuJoCo, MOR", "MuJoCo, box", "short at touch-down",
               "turned in all"]
    if options.randomise:
        columns += [f"{engine}, MOR, randomised" for engine in ENGINES]
    lines = [f"| {' | '.join(columns)} |", "|" + "---|" * len(columns)]
    for training in trainings:
        cells = [judged(options, training, limits, engine) for engine in ENGINES
                 for limits in LIMITS]
        at_home = cells[LIMITS.index(training["limits"])]
        row = [training["limits"], training["seed"], learned_at(training, 0.5),
               learned_at(training, 0.9),
               *[f"{cell['done']} of {options.trials}" for cell in cells],
               whole(at_home["short"]), whole(at_home["turned"])]
        if options.randomise:
            row += [f"{cell['done']} of {options.trials}" for cell in
                    (judged(options, training, "mor", engine, options.randomise)
                     for engine in ENGINES)]
        lines.append(f"| {' | '.join(map(str, row))} |")
    return lines


def draw(trainings):
    curves = ", ".join(
        f"'{one['curve']}' skip 1 using (column(2)/1e6):(column(15)/column(16)*100) with linespoints "
        f"lc rgb '{'#1f77b4' if one['limits'] == 'mor' else '#d62728'}' pt 7 ps 0.4 title '{one['limits']} {one['seed']}'"
        for one in trainings)
    script = f"""set datafile separator ','
set terminal svg size 720,360 dynamic font 'sans-serif,12' background 'white'
set output '{PICTURE}'
set grid lc rgb '#dddddd'
set key left top
set xlabel 'control steps, millions'
set ylabel 'judged runs that do it and stand, %'
set yrange [0:105]
plot {curves}
"""
    subprocess.run(["gnuplot"], input=script, text=True, check=True)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--robot", default="specs/robot/hopper.json")
    parser.add_argument("--reserve", type=float, default=0.0)
    parser.add_argument("--task", default="flip_along")
    parser.add_argument("--seeds", type=int, default=5)
    parser.add_argument("--iterations", type=int, default=120)
    parser.add_argument("--trials", type=int, default=100)
    parser.add_argument("--randomise")
    parser.add_argument("--keep", action="store_true")
    options = parser.parse_args()
    FOLDER.mkdir(parents=True, exist_ok=True)
    trainings = [trained(options, seed, limits) for limits in LIMITS
                 for seed in range(1, options.seeds + 1)]
    draw(trainings)
    text = "\n".join(tables(options, trainings)) + "\n"
    (FOLDER / "tables.md").write_text(text)
    print(text)


main()
