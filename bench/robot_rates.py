#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""How often the right effect is named at the right joint in logs of robots with a known truth.

robot_rates.py GENERATOR TORQUEWRIGHT CLASS FIRST_SEED COUNT [FOLDER]

CLASS:EFFECT asks for logs in which that effect is missing.

GENERATOR is tests/oracles/robot_bench; its documents go to torquewright identify, and what that
says of each joint and of the load is compared with the truth. One line for each log, then the
counts with Wilson's interval at 95 %. Files stay in FOLDER/CLASS_SEED where FOLDER is given, and
what has a report there is not run again.
"""
import json
import os
import re
import resource
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from foreign_rates import tolerated_names, wilson  # noqa: E402

LOAD = "(load)"
STRENGTH = ("certain", "group", "doubted", "missed")
OUTCOMES = ("right", "group", "doubted", "missed", "wrong name", "wrong joint", "refused")


def pointer_claim(entry):
    """/controllers/JOINT/delay_s is the joint's /controller/delay_s."""
    found = re.match(r"/controllers?/(?:([^/]+)/)?(\w+)$", entry.get("pointer", ""))
    if found:
        return entry.get("joint") or found.group(1) or LOAD, "/controller/" + found.group(2)
    return entry.get("joint") or LOAD, entry.get("pointer", "")


def is_moved(entry):
    stated, value, error = (entry.get(key) for key in ("stated", "value", "standard_error"))
    return None not in (stated, value, error) and abs(value - stated) > 3 * error


def claims_of(report):
    """What is said for certain, with a doubt, or as one of several: (joint, name, how, entry)."""
    claims = []
    places = [(each["joint"], each) for each in report.get("joints", [])]
    if not places:
        places = [(None, report)]
    places.append((LOAD, report.get("load", {})))
    for joint, place in places:
        groups = [group["effects"] for group in place.get("confounded", [])]
        grouped = {name for names in groups for name in names}
        for entry in place.get("effects_added", []):
            doubted = entry.get("doubt") or entry.get("certain") is False
            how = "group" if entry["effect"] in grouped else "doubted" if doubted else "certain"
            claims.append((joint, entry["effect"], how, entry))
        named = {name for place_, name, _, _ in claims if place_ == joint}
        claims += [(joint, name, "group", {}) for name in sorted(grouped - named)]
    for entry in report.get("corrected", []):
        if is_moved(entry):
            claims.append((*pointer_claim(entry), "certain", entry))
    for error in report.get("load", {}).get("errors", []):
        claims += [(LOAD, "body " + reading["body"], "body", reading)
                   for reading in error["readings"]]
    return claims


def truths_of(truth):
    """Each missing effect: names that are right, joints where it is."""
    return [(set(each["accept"]), list(each["joints"])) for each in truth["effects"]]


def strays(truth, report, claims):
    """Certain names where nothing of the kind is missing: at a joint that lacks something else, and
    at one that lacks nothing."""
    names_at = {}
    for names, joints in truths_of(truth):
        for joint in joints:
            names_at.setdefault(joint, set()).update(names)
    tolerated = tolerated_names(truth, report) | set(base_of(truth))
    wrong_names, wrong_joints = [], []
    for joint, name, how, _ in claims:
        if how != "certain" or name in tolerated or (joint == LOAD and truth.get("load")):
            continue
        if joint == LOAD and any(name in names for names, _ in truths_of(truth)):
            continue  # a controller's value that all joints share
        if name in names_at.get(joint, set()):
            continue
        kin = truth.get("load", {}).get("joint") == joint and "mass" in name
        if joint in names_at:
            wrong_names.append(f"{joint}:{name}")
        elif not kin:
            wrong_joints.append(f"{joint}:{name}")
    return wrong_names, wrong_joints


def base_of(truth):
    """How the base hangs, where the rig calls it uncertain, by pointer."""
    if not truth["base_roll_rad"]:
        return {}
    return {"/load/roll_rad": truth["base_roll_rad"], "/load/pitch_rad": truth["base_pitch_rad"]}


def attitude_within(truth, claims):
    """Corrected attitudes of the base, and those within three standard errors of the truth."""
    base = base_of(truth)
    given = [(entry["value"] - base[name], entry["standard_error"])
             for _, name, how, entry in claims if how == "certain" and name in base]
    return len(given), sum(abs(off) <= 3 * error for off, error in given)


def found_as(names, joints, claims):
    """The weakest way in which one effect is named over all its joints."""
    worst = "certain"
    for joint in joints:
        ways = [how for place, name, how, _ in claims if name in names and place in (joint, LOAD)]
        best = min(ways, key=STRENGTH.index, default="missed")
        worst = max(worst, best, key=STRENGTH.index)
    return worst


def load_found(truth, claims):
    load = truth["load"]
    if any(name == "body " + load["body"] for _, name, how, _ in claims if how == "body"):
        return "certain"
    kin = {"load_mass_error", "load_inertia_error", "load_centre_error"}
    ways = [how for joint, name, how, _ in claims if name in kin or joint == LOAD and how != "body"]
    return "group" if ways else "missed"


def judge(truth, report):
    claims = claims_of(report)
    wrong_names, wrong_joints = strays(truth, report, claims)
    ways = [found_as(names, joints, claims) for names, joints in truths_of(truth)]
    if truth.get("load"):
        ways = [load_found(truth, claims)]
    if wrong_names:
        outcome = "wrong name"
    elif wrong_joints:
        outcome = "wrong joint"
    elif truth["class"] in ("none", "outside", "gantry"):
        outcome = "right"
    else:
        weakest = max(ways, key=STRENGTH.index)
        outcome = "right" if weakest == "certain" else weakest
    return outcome, ways, wrong_names + wrong_joints, claims


def parameters_within(truth, claims):
    """Of right names: values, and those within three standard errors of the truth. A friction that
    is stated may be given as what is more, or as the whole: the nearer counts."""
    count, within = 0, 0
    for effect in truth["effects"]:
        for joint in effect["joints"]:
            for place, name, _, entry in claims:
                if place != joint or name not in effect["accept"] or "parameters" not in entry:
                    continue
                for key, value in effect["parameters"].items():
                    error = (entry.get("standard_error") or {}).get(key)
                    if not isinstance(value, (int, float)) or not isinstance(error, (int, float)):
                        continue
                    if isinstance(value, bool) or key not in entry["parameters"]:
                        continue
                    count += 1
                    wholes = [value, value + truth["stated"].get(joint, {}).get(key, 0)]
                    within += any(abs(entry["parameters"][key] - v) <= 3 * error for v in wholes)
    return count, within


def values_moved(report):
    """Values that the fit by simulation gives as told and beyond three errors of what is stated."""
    values = (report.get("simulated") or {}).get("values", [])
    moved = [each for each in values if each["told"] and is_moved(each)]
    moved.sort(key=lambda each: -abs(each["value"] - each["stated"]) /
               max(each["standard_error"], 1e-300))
    return [f"{each.get('joint', LOAD)}:{each.get('effect') or each['name']}" for each in moved]


def stated_values(folder, truth):
    """Friction that the documents have, in the parameters' names."""
    with open(os.path.join(folder, "robot.json")) as file:
        joints = json.load(file)["joints"]
    stated = {joint["name"]: {"coulomb_Nm": joint.get("dry_friction_Nm", 0),
                              "viscous_Nm_s_rad": joint.get("damping_Nm_s_rad", 0)}
              for joint in joints}
    for _, joint, name in truth["arguments"]:
        with open(os.path.join(folder, name)) as file:
            for effect in json.load(file)["effects"]:
                stated[joint].update(effect["parameters"])
    for values in stated.values():
        for key, source in (("breakaway_Nm", "coulomb_Nm"), ("coulomb_positive_Nm", "coulomb_Nm"),
                            ("coulomb_negative_Nm", "coulomb_Nm"),
                            ("viscous_positive_Nm_s_rad", "viscous_Nm_s_rad"),
                            ("viscous_negative_Nm_s_rad", "viscous_Nm_s_rad")):
            values[key] = values.get(source, 0)
    return stated


def identify(torquewright, truth, folder):
    """Runs the program; its words, its exit status and its CPU seconds stay in the folder."""
    command = [torquewright, "identify", os.path.join(folder, "log.csv"), "--rig",
               os.path.join(folder, "rig.json"), "--json"]
    for option, joint, name in truth["arguments"]:
        command += [option, f"{joint}={os.path.join(folder, name)}"]
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(command, capture_output=True, text=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    with open(os.path.join(folder, "answer.json"), "w") as file:
        json.dump({"command": " ".join(command), "returncode": done.returncode,
                   "seconds": seconds, "stdout": done.stdout, "stderr": done.stderr}, file)


def run(generator, torquewright, kind, seed, folder):
    answered = os.path.exists(os.path.join(folder, "answer.json"))
    if not answered:
        name, _, effect = kind.partition(":")
        command = [generator, name, str(seed), folder] + ([effect] if effect else [])
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    with open(os.path.join(folder, "truth.json")) as file:
        truth = json.load(file)
    truth["stated"] = stated_values(folder, truth)
    if not answered:
        identify(torquewright, truth, folder)
    with open(os.path.join(folder, "answer.json")) as file:
        return truth, json.load(file)


def shown(number):
    return "-" if number is None else f"{1000 * number:.3g}"


def line_of(truth, report, verdict, more, hits, seconds):
    outcome, ways, wrong, claims = verdict
    what = "; ".join(f"{each['effect']} at {','.join(each['joints'])}" for each in truth["effects"])
    what = what or str(truth.get("load", truth.get("outside", {})).get("kind", "-"))
    where = truth.get("load", {}).get("body") or ",".join(truth.get("outside", {}).get("joints", []))
    sizes = ",".join(f"{size:.0f}" for size in truth["size_floors"])
    claims = [claim for claim in claims if claim[1] != "velocity_mismatch"]
    claims.sort(key=lambda claim: (*STRENGTH, "body").index(claim[2]))
    told = "; ".join(f"{joint}:{name} ({how})" for joint, name, how, _ in claims[:8])
    simulated = report.get("simulated") or {}
    errors = [shown((simulated.get(key) or {}).get("holdout_rms")) for key in ("before", "after")]
    return (f"{truth['seed']} {outcome:11s} {truth['robot']}, {truth['rate_hz']:.0f} Hz: {what} {where} "
            f"[{sizes} floors, {truth.get('distinct_floors', 0):.1f} distinct] -> "
            f"{report['verdict']}: {told or 'nothing'}; by simulation {values_moved(report)[:4]}; "
            f"held out {errors[0]} -> {errors[1]} mrad (floor {shown(truth['floor_rad'])}); "
            f"{hits}/{more} values; {seconds:.0f} CPU s")


def main():
    if len(sys.argv) < 6:
        print(__doc__, file=sys.stderr)
        return 2
    generator, torquewright, kind = sys.argv[1:4]
    first, count = int(sys.argv[4]), int(sys.argv[5])
    root = sys.argv[6] if len(sys.argv) > 6 else tempfile.mkdtemp()
    totals = dict.fromkeys(OUTCOMES, 0)
    values = within = by_value = named_place = blamed = attitudes = true_attitudes = 0
    all_seconds = []
    for seed in range(first, first + count):
        folder = os.path.join(root, f"{kind}_{seed}")
        os.makedirs(folder, exist_ok=True)
        truth, answer = run(generator, torquewright, kind, seed, folder)
        seconds = answer["seconds"]
        all_seconds.append(seconds)
        try:
            report = json.loads(answer["stdout"])
        except ValueError:
            totals["refused"] += 1
            print(f"{seed} REFUSED ({answer['returncode']}), {truth['robot']}: "
                  f"{answer['stderr'].strip()[:300]}; {seconds:.0f} CPU s", flush=True)
            continue
        if re.search(r"\b(NaN|nan|Infinity)\b", answer["stdout"]):
            print(f"{seed} NaN in the report")
        verdict = judge(truth, report)
        totals[verdict[0]] += 1
        more, hits = parameters_within(truth, verdict[3])
        values, within = values + more, within + hits
        given, true = attitude_within(truth, verdict[3])
        attitudes, true_attitudes = attitudes + given, true_attitudes + true
        blamed += not truth.get("load") and bool(report.get("load", {}).get("errors"))
        moved = set(values_moved(report))
        by_value += bool(truth["effects"]) and all(
            f"{joint}:{each['effect']}" in moved
            for each in truth["effects"] for joint in each["joints"])
        places = {each.get("joint") for each in report["unexplained"]}
        named_place += bool(places & set(truth.get("outside", {}).get("joints", [])))
        print(line_of(truth, report, verdict, more, hits, seconds), flush=True)
    for key, hits in totals.items():
        low, high = wilson(hits, count)
        print(f"{kind} {key}: {hits} of {count} = {100 * hits / count:.0f} % "
              f"({100 * low:.0f} to {100 * high:.0f})")
    print(f"{kind}: parameters within 3 errors {within} of {values}; fitted by simulation to other "
          f"than stated, right effect and joint, {by_value}; bodies blamed that are as stated {blamed}; "
          f"attitude of the base within 3 errors {true_attitudes} of {attitudes}; outside: unexplained at its joint "
          f"{named_place}; CPU s {min(all_seconds):.0f} to {max(all_seconds):.0f}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
