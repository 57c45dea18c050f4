#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""How often the right effect is named in logs of a foreign generator.

foreign_rates.py GENERATOR TORQUEWRIGHT CLASS FIRST_SEED COUNT [FOLDER]

GENERATOR is a program that writes a log with a known truth (tests/oracles/mujoco_bench,
tests/oracles/sampled_bench, tests/oracles/loop_bench); its documents go to torquewright identify, and what that says is
compared with the truth. One line for each log, then the counts with Wilson's interval at 95 %.
"""
import json
import math
import os
import subprocess
import sys
import tempfile
import time

ERROR_OF_POINTER = {
    "torque_constant_Nm_A": "torque_constant_error",
    "inertia_kg_m2": "load_inertia_error",
    "mass_kg": "load_mass_error",
}

# What a generator draws as outside of the effects of its day, and has a name since.
NAME_OF_OUTSIDE = {
    "parallel_spring": "parallel_spring",
    "encoder_eccentricity": "encoder_harmonics",
    "current_gain_by_sign": "current_gain_error",
}
SAME_STIFFNESS = 0.25  # Of flanks, as the log tells it beside a gap.
NAMES_OF_STOP = {"upper_end_stop", "lower_end_stop"}


def wilson(hits, count):
    if count == 0:
        return 0.0, 1.0
    z, p = 1.96, hits / count
    middle = (p + z * z / (2 * count)) / (1 + z * z / count)
    half = z * math.sqrt(p * (1 - p) / count + z * z / (4 * count * count)) / (1 + z * z / count)
    return max(0.0, middle - half), min(1.0, middle + half)


def corrected_names(report):
    """A value that the rig calls uncertain, and that came out otherwise, stands for its effect."""
    names = []
    for each in report.get("corrected", []):
        stated, value, error = each.get("stated"), each.get("value"), each.get("standard_error")
        name = ERROR_OF_POINTER.get(each.get("pointer", "").rsplit("/", 1)[-1])
        if name and stated is not None and error is not None and abs(value - stated) > 3 * error:
            names.append(name)
    return names


def flanks_give(truth, report):
    """Flanks of a gap are a spring in MuJoCo's plant: rightly named with its stiffness."""
    stiffness = truth.get("flank_stiffness_Nm_rad")
    found = [each["parameters"]["stiffness_Nm_rad"] for each in report["effects_added"]
             if each["effect"] == "torsional_compliance"]
    return stiffness and found and all(abs(each / stiffness - 1) < SAME_STIFFNESS for each in found)


def tolerated_names(truth, report):
    """What a recorder's filters and differences are rightly called: no later than they are."""
    names = {"torsional_compliance"} if flanks_give(truth, report) else set()
    for name, most_s in truth.get("tolerated", {}).items():
        delays = [abs(each["parameters"].get("delay_s", 0.0)) for each in report["effects_added"]
                  if each["effect"] == name]
        if most_s is None or all(delay <= most_s for delay in delays):
            names.add(name)
    return names


def judge(truth, report):
    accept = truth.get("accept", [])
    allowed = {name for names in accept for name in names}
    outside = truth.get("outside", {}).get("kind")
    allowed |= NAMES_OF_STOP if outside == "end_stop" else {NAME_OF_OUTSIDE.get(outside)}
    added = [each["effect"] for each in report["effects_added"]]
    groups = [g["effects"] for g in report["confounded"] if not g["exact"]]
    exact = [g["effects"] for g in report["confounded"] if g["exact"]]
    grouped = {name for group in groups for name in group}
    one_of_several = grouped | {name for group in exact for name in group}
    doubted = {each["effect"] for each in report["effects_added"] if each.get("doubt")}
    certain = [name for name in added if name not in grouped | doubted]
    for group in exact:  # what no log of such a rig can tell
        if allowed & set(group):
            allowed |= set(group)
            accept = [names + group if set(names) & set(group) else names for names in accept]
    said = set(added) | set(corrected_names(report)) | grouped | {n for g in exact for n in g}
    found = [any(name in said for name in names) for names in accept]
    alone = [any(name in certain or name in corrected_names(report) for name in names)
             for names in accept]
    allowed |= tolerated_names(truth, report)
    wrong = [name for name in certain if name not in allowed]
    kind = truth["class"]
    if kind == "undecidable":
        wrong = [name for name in certain if name not in one_of_several]
        right = not wrong
    elif kind in ("none", "outside"):
        right = not wrong
    else:
        right = all(alone) and not wrong
    coordinates = {each["coordinate"] for each in report["unexplained"]}
    named_place = bool(coordinates & set(truth.get("outside", {}).get("coordinates", [])))
    return {"right": right, "found": all(found), "wrong": wrong, "certain": certain,
            "groups": groups, "coordinate": named_place}


def over_noise(truth, report):
    """Held-out error over the noise that was put in."""
    noise = truth.get("noise_rms", {}).get("value")
    after = (report.get("after") or {}).get("holdout_rms")
    return after / noise if noise and after is not None else float("nan")


def parameters_within(truth, report):
    """Of right names: values, and those within three standard errors of the truth."""
    count, within = 0, 0
    for effect in truth["effects"]:
        for each in report["effects_added"]:
            if each["effect"] != effect["effect"]:
                continue
            for key, value in effect["parameters"].items():
                error = (each.get("standard_error") or {}).get(key)
                if not isinstance(value, (int, float)) or not isinstance(error, (int, float)):
                    continue
                count += 1
                within += abs(each["parameters"][key] - value) <= 3 * error
    return count, within


def run(generator, torquewright, kind, seed, folder):
    subprocess.run([generator, kind, str(seed), folder], check=True, stdout=subprocess.DEVNULL)
    with open(os.path.join(folder, "truth.json")) as file:
        truth = json.load(file)
    command = [torquewright, "identify", os.path.join(folder, "log.csv"), "--rig",
               os.path.join(folder, "rig.json"), "--json"]
    with open(os.path.join(folder, "rig.json")) as file:
        links = json.load(file).get("load", {}).get("links")
    actuators = sorted(name for name in os.listdir(folder) if name.startswith("actuator"))
    for name in actuators:
        joint = name[len("actuator_"):-len(".json")] if name != "actuator.json" else ""
        path = os.path.join(folder, name)
        command += ["--actuator", f"{joint}={path}" if links and joint else path]
    began = time.time()
    done = subprocess.run(command, capture_output=True, text=True)
    return truth, done, time.time() - began


def main():
    if len(sys.argv) < 6:
        print(__doc__, file=sys.stderr)
        return 2
    generator, torquewright, kind = sys.argv[1:4]
    first, count = int(sys.argv[4]), int(sys.argv[5])
    folder = sys.argv[6] if len(sys.argv) > 6 else tempfile.mkdtemp()
    os.makedirs(folder, exist_ok=True)
    totals = {"right": 0, "found": 0, "wrong": 0, "coordinate": 0, "refused": 0}
    recoverable, right_of_those = 0, 0
    values, within, below = 0, 0, 0
    for seed in range(first, first + count):
        truth, done, seconds = run(generator, torquewright, kind, seed, folder)
        truths = ",".join(each["effect"] for each in truth["effects"]) or truth.get(
            "outside", {}).get("kind", "-")
        sizes = ",".join(f"{size:.0f}" for size in truth.get("size_floors", []))
        try:
            report = json.loads(done.stdout)
        except ValueError:
            totals["refused"] += 1
            print(f"{seed} {truths} REFUSED ({done.returncode}): {done.stderr.strip()[:150]}")
            continue
        verdict = judge(truth, report)
        for key in ("right", "found", "coordinate"):
            totals[key] += bool(verdict[key])
        totals["wrong"] += bool(verdict["wrong"])
        if truth.get("recoverable") and all(truth["recoverable"]):
            recoverable += 1
            right_of_those += verdict["right"]
        more, hits = parameters_within(truth, report)
        values, within = values + more, within + hits
        ratio = over_noise(truth, report)
        below += ratio <= 1.15
        mark = "ok  " if verdict["right"] else "WRONG" if verdict["wrong"] else "miss"
        print(f"{seed} {mark} {truth.get('rig', '')}/{truth.get('drive', '')} {truths} [{sizes}] -> "
              f"{report['verdict']} {verdict['certain']} {verdict['groups'] or ''} "
              f"{ratio:.2f} noise, {hits}/{more}, {seconds:.1f} s", flush=True)
    for key, hits in totals.items():
        low, high = wilson(hits, count)
        print(f"{kind} {key}: {hits} of {count} = {100 * hits / count:.1f} % "
              f"({100 * low:.1f} to {100 * high:.1f})")
    if recoverable:
        print(f"{kind} right of those whose truth a least squares of the true law recovers: "
              f"{right_of_those} of {recoverable}")
    print(f"{kind} parameters within 3 errors: {within} of {values}; "
          f"held out within 1.15 of the noise put in: {below} of {count}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
