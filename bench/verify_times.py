#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What checking a proof costs beside finding it: CPU seconds of `gearbox optimize` and of `gearbox
verify` on its result, on random problems of one objective.

    bench/verify_times.py TORQUEWRIGHT OBJECTIVE SEED COUNT

The problems are those of relaxation_modes.py. Start and reading count on both sides; the least of
three runs each. Problems that are solved within 10 ms are left out."""
import json
import os
import random
import statistics
import subprocess
import sys
import tempfile

import relaxation_modes

LEAST_S = 0.01
RUNS = 3


def cpu_s(command):
    """The least CPU seconds of three runs, and the exit code."""
    least = None
    for _ in range(RUNS):
        before = os.times()
        code = subprocess.run(command, stdout=subprocess.DEVNULL).returncode
        after = os.times()
        seconds = (after.children_user - before.children_user
                   + after.children_system - before.children_system)
        least = seconds if least is None else min(least, seconds)
    return least, code


def main():
    program, objective, seed, count = (sys.argv[1], sys.argv[2], int(sys.argv[3]),
                                       int(sys.argv[4]))
    dice = random.Random(seed)
    ratios = []
    print(f"{'search s':>9} {'verify s':>9} {'times':>6}")
    with tempfile.TemporaryDirectory() as folder:
        file, result = os.path.join(folder, "problem.json"), os.path.join(folder, "result.json")
        while len(ratios) < count:
            problem = relaxation_modes.problem(dice)
            if problem["objective"] != objective:
                continue
            with open(file, "w", encoding="utf-8") as out:
                json.dump(problem, out)
            search_s, code = cpu_s([program, "gearbox", "optimize", file, "-o", result,
                                    "--time-limit", "60"])
            if code != 0 or search_s < LEAST_S:
                continue
            verify_s, code = cpu_s([program, "gearbox", "verify", result])
            if code != 0:
                sys.exit(f"verify refuses a result: exit {code}")
            ratios.append(verify_s / search_s)
            print(f"{search_s:9.2f} {verify_s:9.2f} {ratios[-1]:6.2f}")
    print(f"{objective}: median {statistics.median(ratios):.2f}, greatest {max(ratios):.2f}")


if __name__ == "__main__":
    main()
