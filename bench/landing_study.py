#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The hopper's landing from the hand-made flip or hop with contact too early or too late: which of
the three handlings of the velocity error stand, in a table for docs/replay.md.

    bench/landing_study.py build/release/src/torquewright flip [--engine mujoco] [--fixed-clock]
"""
import json
import subprocess
import sys

FROM_S = {"flip": "0.75", "hop": "0.65"}  # in mid-flight
RISES_MM = {"flip": [-60, -50, -40, -30, -20, -10, -4, 0, 2, 4, 6, 10, 20, 40, 60],
            "hop": [-20, -16, -12, -8, -4, -2, 0, 2, 4, 6, 8, 10]}
HANDLINGS = ["default", "no_derivative", "invariant"]


def replayed(program, motion, rise_mm, handling, options):
    command = [program, "hopper", "replay", "specs/robot/hopper.json",
               f"specs/trajectory/hopper_{motion}.csv", "--from", FROM_S[motion], "--ground-rise", str(rise_mm / 1000),
               "--impact", handling, "--json", *options]
    done = subprocess.run(command, stdout=subprocess.PIPE, check=False)
    if done.returncode not in (0, 1, 3):
        sys.exit(f"{' '.join(command)} ends with {done.returncode}")
    return json.loads(done.stdout)


def main():
    program, motion, options = sys.argv[1], sys.argv[2], sys.argv[3:]
    print("| ground, mm | contact, ms | rotation, degrees | " + " | ".join(HANDLINGS) + " |")
    print("|---|---|---|---|---|---|")
    for rise_mm in RISES_MM[motion]:
        reports = [replayed(program, motion, rise_mm, handling, options) for handling in HANDLINGS]
        down = reports[0]["touch_down"]
        late_ms = 1000 * (down["time_s"] - down["planned_s"])
        turn = -down["rotation_short_rad"] * 57.29577951308232
        verdicts = " | ".join(report["verdict"] for report in reports)
        print(f"| {rise_mm:+d} | {late_ms:+.1f} | {turn:+.2f} | {verdicts} |")


main()
