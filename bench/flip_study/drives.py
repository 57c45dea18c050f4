# SPDX-License-Identifier: Apache-2.0
"""The flip with other drives: ratios at the knee, a gearbox in the loop, what the documents do not
know, and an actuator that was identified."""
import json

import documents
import words

ROBOT = "specs/robot/hopper.json"
NAMES = ["", "outcome", "CAM, N m s", "CAV at take-off, rad/s", "rise, %", "what holds it", "effort, s",
         "the plan as documented, here"]


def effort(found):
    for one in found.get("objectives", []):
        if one["name"] == "effort":
            return f"{one['value']:.3f}"
    return ""


def plan_of(program, name, robot, nominal, *options):
    """From key frames; where that finds none, once more from the documented robot's plan."""
    found = program.plan(f"{name}_plan", robot, *options)
    if found["status"] != "planned":
        warm = program.plan(f"{name}_warm", robot, "--warm", nominal["motion"], *options)
        if warm["status"] == "planned":
            return warm
    return found


def row(program, what, name, changed, nominal, *options):
    """A plan with changed documents, and what `hopper check` says there of the documented robot's."""
    robot = changed.write(program.folder / name) if changed is not None else ROBOT
    # Conditions of a check are those of a plan.
    is_same = changed is None and not options
    found = nominal if is_same else plan_of(program, name, robot, nominal, *options)
    checked = program.check(f"{name}_nominal", nominal["motion"], robot, "--torques", "dynamics", *options)
    if checked is None:
        verdict = "refused"
    else:
        margin = min(checked["joints"], key=lambda one: one["margin_Nm"])
        verdict = f"{checked['verdict']}, {margin['name']} {margin['margin_Nm']:+.1f} N m"
    cam, off, _, rise = words.flight(found)
    return [what, words.status(found), cam, off, rise, words.why(found), effort(found), verdict]


def nominal_plan(program):
    return program.plan("mor", ROBOT, "--limits", "mor")


def ratios(program):
    nominal = nominal_plan(program)
    rows = [row(program, f"{ratio}:1", f"ratio_{ratio}", documents.with_knee_ratio(ratio), nominal)
            for ratio in (12, 16, 18, 20, 22, 24, 28, 32)]
    return ("### Ratio at the knee\n\nWhere a search from key frames finds none, another begins at the documented "
            "robot's plan. The motor is the same; the joint's limits of speed and torque, which are the "
            "drive's, follow the ratio.\n\n") + words.table(NAMES, rows)


def gearbox(program):
    """Another target ratio in the gearbox problem, the teeth found, the actuator with them."""
    nominal = nominal_plan(program)
    rows = []
    for ratio in (16, 19, 20, 22, 25):
        problem = documents.load("specs/gearbox/d151_knee.json")
        problem["target_ratio"] = ratio
        folder = program.folder / f"gearbox_{ratio}"
        folder.mkdir(exist_ok=True)
        (folder / "problem.json").write_text(json.dumps(problem))
        result = folder / "result.json"
        text, _, code = program.run("gearbox", "optimize", folder / "problem.json", "-o", result)
        if code != 0:
            rows.append([f"{ratio}:1", text.splitlines()[0] if text else "no gearbox"] + [""] * (len(NAMES) - 2))
            continue
        changed = documents.with_knee_ratio(ratio)
        changed.gears = documents.load(result)
        changed.knee["gearbox"] = {"file": "gears.json"}
        changed.knee["assumed"] = [one for one in changed.knee["assumed"] if not one.startswith("/gearbox")]
        design = changed.gears["designs"][0]
        teeth = "-".join(str(count) for count in design["teeth"].values())
        what = (f"{ratio}:1, teeth {teeth}, efficiency {design['forward_efficiency']:.3f} forward, "
                f"{design['backward_efficiency']:.3f} backward")
        rows.append(row(program, what, f"gearbox_{ratio}", changed, nominal))
    return ("### A gearbox in the loop\n\n`specs/gearbox/d151_knee.json` with another `target_ratio`, `gearbox "
            "optimize PROBLEM -o gears.json`, the knee's actuator with `\"gearbox\": {\"file\": \"gears.json\"}`, its "
            "strength with the same teeth, `hopper flip`:\n\n") + words.table(NAMES, rows)


def sensitivity(program):
    nominal = nominal_plan(program)
    cases = [("as documented", "as_is", None, ()),
             ("resistance x0.5", "resistance_half", documents.with_resistance(0.5), ()),
             ("resistance x2", "resistance_double", documents.with_resistance(2.0), ()),
             ("3.3 V a cell", "cells_3.3", documents.with_cell_voltage(3.3), ()),
             ("winding at 100 degrees C", "hot_winding", None, ("--winding-temperature", 373.15)),
             ("gear friction 0.05", "friction_0.05", documents.with_gear_friction(0.05), ()),
             ("gear friction 0.10", "friction_0.10", documents.with_gear_friction(0.10), ()),
             ("gear friction 0.15", "friction_0.15", documents.with_gear_friction(0.15), ()),
             ("thigh's inertia 0.25 kg m2", "thigh_0.25", documents.with_thigh_inertia(0.25), ())]
    rows = [row(program, what, name, changed, nominal, *options) for what, name, changed, options in cases]
    return "### What the documents do not know\n\n" + words.table(NAMES, rows)


# The knee as it is on the bench and in no document.
TRUTH = 0.1
NOISE_Nm = 0.3


def identified(program):
    """A log of a knee whose gears take a tenth of the load, what `identify` makes of it, the flip."""
    nominal = nominal_plan(program)
    folder = program.folder / "identified"
    truth = documents.with_gear_friction(TRUTH)
    truth.write(folder)
    log, refined = folder / "log.csv", folder / "refined.json"
    program.run("identify", "simulate", folder / "knee.json", "--rig", "specs/rig/knee_sweep.json", "--excitation",
                "specs/excitation/knee_sweep.csv", "--noise", f"output_torque_Nm={NOISE_Nm}", "--seed", 1, "-o", log)
    text, _, code = program.run("identify", log, "--rig", "specs/rig/knee_sweep.json", "--actuator",
                                "specs/actuator/d151_knee.json", "-o", refined)
    (folder / "identify.txt").write_text(text)
    said = "\n".join(line for line in text.splitlines()[:3])
    out = (f"### Closed through the identification\n\nA knee whose gears take {TRUTH:g} of the load both ways, of which "
           f"its document says nothing; `identify simulate` on `specs/rig/knee_sweep.json`, {NOISE_Nm:g} N m of noise, "
           f"then `identify` with the document as it is:\n\n    " + said.replace("\n", "\n    ") + "\n\n")
    if code != 0 or not refined.exists():
        return out
    changed = documents.Documents()
    changed.knee = documents.load(refined)
    rows = [row(program, "knee as documented", "identified_before", None, nominal),
            row(program, "knee refined by the log", "identified_after", changed, nominal)]
    return out + words.table(NAMES, rows)


def run(program):
    return "\n".join(part(program) for part in (ratios, gearbox, sensitivity, identified))
