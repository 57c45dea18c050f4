#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Whether two effects at once are named, and nothing else, at three levels of noise.

effect_pairs.py TORQUEWRIGHT [FOLDER]

From the repository's root. The actuator and rig of specs/log, an excitation of `identify plan`, and
every pair of the effects below that may stand in one actuator: `identify simulate` plays the pair
with the plan's noise times 0.3, 1 and 3, and `identify` has to name both. One line for each log,
then the counts with Wilson's interval at 95 %.
"""
import itertools
import json
import os
import subprocess
import sys
import tempfile

from foreign_rates import parameters_within, wilson

SIZES = {
    "viscous_friction": {"viscous_Nm_s_rad": 0.05},
    "coulomb_friction": {"coulomb_Nm": 0.5},
    "quadratic_drag": {"drag_Nm_s2_rad2": 0.004},
    "eddy_current_drag": {"peak_Nm": 0.6, "critical_rad_s": 5.0},
    "stribeck_friction": {"coulomb_Nm": 0.4, "breakaway_Nm": 0.9, "stribeck_velocity_rad_s": 0.5},
    "asymmetric_friction": {"coulomb_positive_Nm": 0.7, "coulomb_negative_Nm": 0.4,
                            "viscous_positive_Nm_s_rad": 0.02, "viscous_negative_Nm_s_rad": 0.05},
    "presliding_friction": {"coulomb_Nm": 0.6, "stiffness_Nm_rad": 60.0},
    "load_dependent_friction": {"driving_coefficient": 0.1, "backdriving_coefficient": 0.06},
    "torque_constant_error": {"factor": 1.08},
    "torque_constant_saturation": {"saturation_current_A": 30.0, "exponent": 2.0},
    "torque_lag": {"time_constant_s": 0.015},
    "reflected_inertia": {"inertia_kg_m2": 0.006},
    "cogging_torque": {"harmonics": [{"order": 7, "amplitude_Nm": 0.05, "phase_rad": 0.4}]},
    "gear_ripple": {"harmonics": [{"order": 12, "amplitude_Nm": 0.4, "phase_rad": 1.0}]},
    "parallel_spring": {"stiffness_Nm_rad": 0.6, "neutral_angle_rad": 0.2},
}
FRICTIONS = {"coulomb_friction", "stribeck_friction", "asymmetric_friction", "presliding_friction"}
DRAGS = {"viscous_friction", "asymmetric_friction"}
NOISE_LEVELS = (0.3, 1.0, 3.0)


def may_stand_together(a, b):
    """Laws that contain one another are one friction, not two."""
    return not ({a, b} <= FRICTIONS or {a, b} <= DRAGS)


class Bench:
    def __init__(self, torquewright, folder):
        self.torquewright, self.folder = torquewright, folder
        with open("specs/log/bench_actuator.json") as file:
            self.actuator = json.load(file)
        done = self.run("plan", "specs/log/bench_actuator.json", "--rig", "specs/log/bench_rig.json",
                        "--duration", "40", "-o", self.path("plan.csv"), "--json")
        self.noise = json.loads(done.stdout)["noise"]

    def path(self, name):
        return os.path.join(self.folder, name)

    def run(self, *words):
        return subprocess.run([self.torquewright, "identify", *words], capture_output=True,
                              text=True)

    def found(self, effects, level, seed):
        truth = dict(self.actuator, effects=effects)
        with open(self.path("truth.json"), "w") as file:
            json.dump(truth, file)
        words = ["simulate", self.path("truth.json"), "--rig", "specs/log/bench_rig.json",
                 "--excitation", self.path("plan.csv"), "--seed", str(seed), "-o",
                 self.path("log.csv")]
        for quantity, sigma in self.noise.items():
            words += ["--noise", f"{quantity}={level * sigma}"]
        played = self.run(*words)
        if played.returncode != 0:
            return None, played.stderr.strip()[:150]
        done = self.run(self.path("log.csv"), "--rig", "specs/log/bench_rig.json", "--actuator",
                        "specs/log/bench_actuator.json", "--json")
        return (json.loads(done.stdout), "") if done.stdout else (None, done.stderr.strip()[:150])


def judged(report, pair):
    added = [each["effect"] for each in report["effects_added"]]
    groups = [set(group["effects"]) for group in report["confounded"]]
    exact = [set(group["effects"]) for group in report["confounded"] if group["exact"]]
    grouped = set().union(*[group for group in groups if group not in exact])
    allowed = set(pair).union(*[group for group in exact if group & set(pair)])
    said = set(added) | grouped | set().union(*exact)
    wrong = [name for name in added if name not in allowed and name not in grouped]
    alone = all(name in said and name not in grouped for name in pair)
    return {"right": alone and not wrong, "found": all(name in said for name in pair),
            "wrong": wrong, "groups": [sorted(group) for group in groups]}


def main():
    if len(sys.argv) < 2:
        print(__doc__, file=sys.stderr)
        return 2
    folder = sys.argv[2] if len(sys.argv) > 2 else tempfile.mkdtemp()
    os.makedirs(folder, exist_ok=True)
    bench = Bench(sys.argv[1], folder)
    pairs = [pair for pair in itertools.combinations(SIZES, 2) if may_stand_together(*pair)]
    for level in NOISE_LEVELS:
        totals = {"right": 0, "found": 0, "wrong": 0}
        values, within = 0, 0
        for seed, pair in enumerate(pairs, 1):
            effects = [{"effect": name, "parameters": SIZES[name], "provenance": "assumed"}
                       for name in pair]
            report, why = bench.found(effects, level, seed)
            if report is None:
                print(f"{level} {','.join(pair)}: refused: {why}", flush=True)
                continue
            verdict = judged(report, pair)
            for key in totals:
                totals[key] += bool(verdict[key])
            more, hits = parameters_within({"effects": effects}, report)
            values, within = values + more, within + hits
            mark = "ok  " if verdict["right"] else "WRONG" if verdict["wrong"] else "miss"
            names = [each["effect"] for each in report["effects_added"]]
            print(f"{level} {mark} {','.join(pair)} -> {report['verdict']} {names} "
                  f"{verdict['groups'] or ''} {hits}/{more}", flush=True)
        for key, hits in totals.items():
            low, high = wilson(hits, len(pairs))
            print(f"noise x {level}, {key}: {hits} of {len(pairs)} ({100 * low:.1f} to "
                  f"{100 * high:.1f} %)")
        print(f"noise x {level}, parameters within 3 errors: {within} of {values}", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
