#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What Ipopt's relaxations do for the search: seconds, boxes and boxes closed by them, in each of
the three modes, on random problems of all objectives.

    bench/relaxation_modes.py TORQUEWRIGHT SEED COUNT
    bench/relaxation_modes.py TORQUEWRIGHT bores

"bores" prints the table of bench/README.md: 20:1 in ever wider bores, minima 12/12/12.
Every mode of a problem runs in turn in one sitting, three times; the least time counts. A mode that
the program refuses is left out."""
import json
import os
import random
import subprocess
import sys
import tempfile

MODES = ("auto", "always", "never")
OBJECTIVES = {
    "3k": ("paper_cost", "mass", "hollow_shaft", "forward_efficiency", "backward_efficiency",
           "reflected_inertia"),
    "planetary": ("mass", "hollow_shaft", "forward_efficiency", "reflected_inertia"),
}


def problem(dice):
    topology = dice.choice(("3k", "3k", "planetary"))
    gears = ("sun", "planet_1", "planet_2") if topology == "3k" else ("sun", "planet")
    objective = dice.choice(OBJECTIVES[topology])
    module_mm = dice.choice((0.3, 0.5, 0.8, 1))
    widths = {"layer_1": 10, "layer_2": 8} if topology == "3k" else {"layer_1": 10}
    return {
        "kind": "gearbox_problem", "version": 1, "topology": topology,
        "target_ratio": dice.randint(8, 40) if topology == "3k" else dice.randint(3, 9),
        "ratio_tolerance": dice.choice((0.005, 0.02, 0.1)),
        "rotor_inner_diameter_mm": round(module_mm * dice.randint(130, 1000), 1),
        "module_mm": module_mm, "planet_count": dice.choice((3, 4)),
        "min_teeth": {gear: dice.randint(18, 40) for gear in gears},
        "min_carrier_clearance_rad": dice.choice((0.05, 0.1, 0.2)),
        "constraints": "buildable" if topology == "planetary" else
                       dice.choice(("paper", "buildable")),
        "objective": objective, "friction_coefficient": 0.08, "face_width_mm": widths,
        "materials": {"density_kg_m3": 7800},
    }


def solve(program, file, mode):
    """Seconds, boxes, solves, boxes closed; None where the mode is refused."""
    best = None
    for _ in range(3):
        run = subprocess.run([program, "gearbox", "optimize", file, "--relaxation", mode,
                              "--timing", "--json", "--time-limit", "20"], capture_output=True)
        if run.returncode == 2:
            return None
        search = json.loads(run.stdout)["search"]
        if best is None or search["seconds"] < best[0]:
            best = (search["seconds"], search["nodes"], search["relaxations"],
                    search["closed_by_relaxation"])
    return best


def in_bore(bore_in_modules, tolerance):
    module_mm = 0.6
    return {
        "kind": "gearbox_problem", "version": 1, "topology": "3k", "target_ratio": 20,
        "ratio_tolerance": tolerance,
        "rotor_inner_diameter_mm": round(bore_in_modules * module_mm, 1), "module_mm": module_mm,
        "planet_count": 4, "min_teeth": {"sun": 12, "planet_1": 12, "planet_2": 12},
        "min_carrier_clearance_rad": 0, "constraints": "paper", "objective": "paper_cost",
    }


def print_bores(program):
    print("| D/M, ratio | `always`: boxes, solves, s | `auto` | `never` |")
    print("|---|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, "problem.json")
        for bore in (132.33, 300, 1000, 3000):
            for words, tolerance in (("exact", 0), ("1 %", 0.01)):
                with open(file, "w", encoding="utf-8") as stream:
                    json.dump(in_bore(bore, tolerance), stream)
                found = [solve(program, file, mode) for mode in ("always", "auto", "never")]
                cells = " | ".join(f"{boxes}, {solves}, {seconds:.2g}"
                                   for seconds, boxes, solves, _ in found)
                print(f"| {bore:g}, {words} | {cells} |", flush=True)


def main():
    if sys.argv[2:] == ["bores"]:
        print_bores(sys.argv[1])
        return
    program, seed, count = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
    dice = random.Random(seed)
    sums, least = {}, {}
    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, "problem.json")
        for _ in range(count):
            document = problem(dice)
            with open(file, "w", encoding="utf-8") as stream:
                json.dump(document, stream)
            found = {mode: solve(program, file, mode) for mode in MODES}
            objective = document["objective"]
            least[objective] = (least.get(objective, 0.0) +
                                min(each[0] for each in found.values() if each))
            for mode, each in found.items():
                total = sums.setdefault((objective, mode), [0, 0.0, 0, 0, 0])
                if each:
                    total[0] += 1
                    for place, value in enumerate(each):
                        total[place + 1] += value
    print("| objective | mode | problems | seconds | over the best | boxes | solves | closed |")
    print("|---|---|---|---|---|---|---|---|")
    for (objective, mode), (number, seconds, *rest) in sorted(sums.items()):
        if number == 0:
            print(f"| {objective} | {mode} | refused | | | | | |")
            continue
        boxes, solves, closed = rest
        print(f"| {objective} | {mode} | {number} | {seconds:.3f} | "
              f"{seconds / least[objective]:.2f} | {boxes} | {solves} | {closed} |")
    total_auto = sum(value[1] for (_, mode), value in sums.items() if mode == "auto")
    print(f"\nauto over the best of the three modes: {total_auto / sum(least.values()):.3f}")


if __name__ == "__main__":
    main()
