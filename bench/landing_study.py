#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The hopper's landing from the hand-made flip with contact too early or too late: which of the
three handlings of the velocity error stand, in a table for docs/replay.md.

    bench/landing_study.py build/release/src/torquewright [--engine mujoco] [--fixed-clock]
"""
import json
import subprocess
import sys

MOTION = ["specs/robot/hopper.json", "specs/trajectory/hopper_flip.csv", "--from", "0.75"]
RISES_MM = [-60, -50, -40, -30, -20, -10, -4, 0, 2, 4, 6, 10, 20, 40, 60]
HANDLINGS = ["default", "no_derivative", "invariant"]


def replayed(program, rise_mm, handling, options):
    command = [program, "hopper", "replay", *MOTION, "--ground-rise", str(rise_mm / 1000),
               "--impact", handling, "--json", *options]
    done = subprocess.run(command, stdout=subprocess.PIPE, check=False)
    if done.returncode not in (0, 1, 3):
        sys.exit(f"{' '.join(command)} ends with {done.returncode}")
    return json.loads(done.stdout)


def main():
    program, options = sys.argv[1], sys.argv[2:]
    print("| ground, mm | contact, ms | rotation, degrees | " + " | ".join(HANDLINGS) + " |")
    print("|---|---|---|---|---|---|")
    for rise_mm in RISES_MM:
        reports = [replayed(program, rise_mm, handling, options) for handling in HANDLINGS]
        down = reports[0]["touch_down"]
        late_ms = 1000 * (down["time_s"] - down["planned_s"])
        turn = -down["rotation_short_rad"] * 57.29577951308232
        verdicts = " | ".join(report["verdict"] for report in reports)
        print(f"| {rise_mm:+d} | {late_ms:+.1f} | {turn:+.2f} | {verdicts} |")


main()
