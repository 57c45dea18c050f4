#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Whether what a plan calls separable is separated on the planned log.

plan_closes.py TORQUEWRIGHT FIRST_SEED COUNT [FOLDER]

From the repository's root. Each seed draws an actuator near that of specs/log, a rig (a dynamometer
with a torque sensor, or a pendulum without) and three effects. `identify plan` is asked for them;
each that it calls separable is then the only thing wrong with a truth, by the size that the plan
calls typical; `identify simulate` plays the plan with the plan's own noise, and `identify` has to
name that effect, alone and beside no rival. One line for each log, then the counts with Wilson's
interval at 95 %.
"""
import json
import os
import random
import re
import subprocess
import sys
import tempfile

from foreign_rates import wilson

EFFECTS = ("viscous_friction", "coulomb_friction", "quadratic_drag", "stribeck_friction",
           "load_dependent_friction", "torque_constant_saturation", "reflected_inertia",
           "presliding_friction", "torque_constant_error", "torque_lag")
MOST_COEFFICIENT = 0.3  # Of load friction: beyond it, a gear that locks.
MOST_FACTOR = 1.3


def drawn_actuator(draw):
    with open("specs/log/bench_actuator.json") as file:
        actuator = json.load(file)
    motor = actuator["motor"]
    motor["torque_constant_Nm_A"] *= draw.uniform(0.5, 1.5)
    motor["rotor_inertia_kg_m2"] *= draw.uniform(0.3, 2.0)
    actuator["gearbox"]["ratio"] = round(draw.uniform(4.0, 16.0), 2)
    actuator["drive"]["peak_current_A"] *= draw.uniform(0.6, 1.4)
    return actuator


def drawn_rig(draw):
    if draw.random() < 0.5:
        with open("specs/log/bench_rig.json") as file:
            return json.load(file)
    with open("specs/rig/pendulum.json") as file:
        rig = json.load(file)
    rig.pop("uncertain", None)
    rig["load"]["mass_kg"] = round(draw.uniform(1.0, 3.0), 2)
    return rig


def value_at(parameter):
    """The number in the words of what a column stands at."""
    return float(re.search(r"[-+0-9.e]*[0-9]", parameter["at"]).group())


def true_parameters(effect, planned):
    """Of the document, by the plan's typical values; None where no such actuator makes sense."""
    typical = {each["parameter"]: each["typical"] for each in planned}
    if effect == "stribeck_friction":
        excess = typical["breakaway_over_coulomb_Nm"]
        return {"coulomb_Nm": excess, "breakaway_Nm": 2.0 * excess,
                "stribeck_velocity_rad_s": value_at(planned[0])}
    if effect == "presliding_friction":
        level = typical["coulomb_Nm"]
        return {"coulomb_Nm": level, "stiffness_Nm_rad": level / value_at(planned[0])}
    if effect == "torque_constant_saturation":
        if typical["share"] > 1.0:
            return None
        return {"saturation_current_A": value_at(planned[0]), "exponent": 2.0}
    if effect == "torque_lag":
        return {"time_constant_s": value_at(planned[0])} if typical["share"] <= 1.0 else None
    if effect == "torque_constant_error":
        return {"factor": min(1.0 + typical["factor"], MOST_FACTOR)}
    if effect == "load_dependent_friction":
        return {name: min(value, MOST_COEFFICIENT) for name, value in typical.items()}
    return typical


def with_effect(actuator, effect, parameters):
    stated = {"effect": effect, "parameters": parameters, "provenance": "assumed"}
    return dict(actuator, effects=[stated])


def outcome(report, effect):
    named = [each["effect"] for each in report["effects_added"]]
    rivals = {name for group in report["confounded"] if not group["exact"]
              for name in group["effects"] if effect in group["effects"]} - {effect}
    if named == [effect]:
        return f"rivals {','.join(sorted(rivals))}" if rivals else "separated"
    if effect in named:
        return "beside " + ",".join(sorted(set(named) - {effect}))
    return "as " + ",".join(named) if named else "not named"


class Trial:
    def __init__(self, torquewright, folder):
        self.torquewright, self.folder = torquewright, folder

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, document):
        with open(self.path(name), "w") as file:
            json.dump(document, file)
        return self.path(name)

    def identify(self, *words):
        return subprocess.run([self.torquewright, "identify", *words], capture_output=True,
                              text=True)

    def plan(self, actuator, rig, effects, seed):
        done = self.identify("plan", self.write("actuator.json", actuator), "--rig",
                             self.write("rig.json", rig), "--separate", ",".join(effects),
                             "--duration", "24", "--seed", str(seed), "-o", self.path("plan.csv"),
                             "--json")
        return json.loads(done.stdout) if done.stdout else None

    def found(self, truth, noise, seed):
        words = ["simulate", self.write("truth.json", truth), "--rig", self.path("rig.json"),
                 "--excitation", self.path("plan.csv"), "--seed", str(seed), "-o",
                 self.path("log.csv")]
        for quantity, sigma in noise.items():
            words += ["--noise", f"{quantity}={sigma}"]
        played = self.identify(*words)
        if played.returncode != 0:
            return None, played.stderr.strip()[:120]
        done = self.identify(self.path("log.csv"), "--rig", self.path("rig.json"), "--actuator",
                             self.path("actuator.json"), "--json")
        return (json.loads(done.stdout), "") if done.stdout else (None, done.stderr.strip()[:120])


def main():
    if len(sys.argv) < 4:
        print(__doc__, file=sys.stderr)
        return 2
    first, count = int(sys.argv[2]), int(sys.argv[3])
    trial = Trial(sys.argv[1], sys.argv[4] if len(sys.argv) > 4 else tempfile.mkdtemp())
    os.makedirs(trial.folder, exist_ok=True)
    separated, asked, inseparable = 0, 0, 0
    for seed in range(first, first + count):
        draw = random.Random(seed)
        actuator, rig = drawn_actuator(draw), drawn_rig(draw)
        effects = draw.sample(EFFECTS, 3)
        plan = trial.plan(actuator, rig, effects, seed)
        if plan is None:
            print(f"{seed} no plan for {','.join(effects)}")
            continue
        for effect in effects:
            planned = [each for each in plan["parameters"] if each["effect"] == effect]
            if not planned or not all(each["separable"] for each in planned):
                inseparable += 1
                continue
            parameters = true_parameters(effect, planned)
            if parameters is None:
                continue
            report, why = trial.found(with_effect(actuator, effect, parameters), plan["noise"],
                                      seed)
            said = outcome(report, effect) if report else f"refused: {why}"
            asked += 1
            separated += said == "separated"
            share = min(each["plan"]["separability"] for each in planned)
            print(f"{seed} {rig['load']['type']} {effect} separability {share:.2g}: {said}",
                  flush=True)
    low, high = wilson(separated, asked)
    print(f"separated {separated} of {asked} ({low:.2f} to {high:.2f}); "
          f"{inseparable} were not called separable")
    return 0


if __name__ == "__main__":
    sys.exit(main())
