#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Times of `gearbox optimize` on the six instances of a synthesis: 320 Nm (the last 160) in 79.4 mm
with a hollow shaft of 12 mm, modules of 0.4 to 1 mm, 3 to 6 planets, minima of 12 teeth, the default
steel and cycles, a gap of 0.1 %. Two more: 120 Nm at 20:1 for 10^6 loads, and 9:1 in 60 mm.

    bench/synthesis_times.py build/release/src/torquewright [--unlimited] [--second-module]
"""
import argparse
import json
import pathlib
import subprocess
import tempfile
import time

MODULES = [0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0]


def problem(ratio, tolerance, torque, **changes):
    return {"kind": "gearbox_problem", "version": 1, "topology": "3k", "target_ratio": ratio,
            "ratio_tolerance": tolerance, "rotor_inner_diameter_mm": 79.4, "module_mm": MODULES,
            "min_hollow_shaft_diameter_mm": 12, "load": {"output_torque_Nm": torque},
            "synthesis": {}} | changes


INSTANCES = {
    "20:1 +-1 %": problem(20, 0.01, 320),
    "20:1 +-0.1 %": problem(20, 0.001, 320),
    "20:1 exact": problem(20, 0, 320),
    "12:1 +-1 %": problem(12, 0.01, 320),
    "35:1 +-1 %": problem(35, 0.01, 320),
    "50:1 +-0.5 %, 160 Nm": problem(50, 0.005, 160),
    "120 Nm, 20:1 +-1 %, 10^6 loads": problem(
        20, 0.01, 120, load={"output_torque_Nm": 120, "cycles": 1000000}),
    "9:1 +-1 % in 60 mm, 20 Nm": problem(9, 0.01, 20, rotor_inner_diameter_mm=60),
}


def run(program, document, folder):
    path = folder / "problem.json"
    path.write_text(json.dumps(document))
    start = time.perf_counter()
    ended = subprocess.run([program, "gearbox", "optimize", path, "--json", "--timing"],
                           capture_output=True, text=True, check=False)
    seconds = time.perf_counter() - start
    if ended.returncode == 2:
        raise SystemExit(ended.stderr)
    return json.loads(ended.stdout), seconds


def teeth(found):
    if not found["designs"]:
        return "none"
    best = found["designs"][0]
    modules = {best["module_mm"], best.get("layer_2_module_mm", best["module_mm"])}
    return "{}, n {}, m {}, b {:.2f} and {:.2f} mm".format(
        "/".join(str(z) for z in best["teeth"].values()), best["planet_count"],
        " and ".join(f"{m:g}" for m in sorted(modules)), *best["face_width_mm"].values())


def main():
    reader = argparse.ArgumentParser(description=__doc__)
    reader.add_argument("program")
    reader.add_argument("--unlimited", action="store_true", help="face widths have no limit")
    reader.add_argument("--second-module", action="store_true",
                        help="planet 2 and output ring have a module of their own")
    chosen = reader.parse_args()
    print("| instance | g | bound g | s | choices | opened | boxes | design |")
    print("|---|---|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as name:
        for title, document in INSTANCES.items():
            if chosen.unlimited:
                document["synthesis"]["max_face_width_mm"] = 1000
            if chosen.second_module:
                document["synthesis"]["layer_2_module_mm"] = MODULES
            found, seconds = run(chosen.program, document, pathlib.Path(name))
            mass, bound = (1e3 * (found[key] or 0) for key in ("objective", "bound"))
            search = found["search"]
            print(f"| {title} | {mass:.2f} | {bound:.2f} | {seconds:.2f} | {search['choices']} | "
                  f"{search['choices_opened']} | {search['nodes']} | {teeth(found)} |", flush=True)


if __name__ == "__main__":
    main()
