# SPDX-License-Identifier: Apache-2.0
"""Fig. 5: a plan under the region and a plan in the box, replayed."""
import json
import statistics

import documents
import pictures
import series
import words

REPLAYS = [("mor_in_mor", "mor", "mor"), ("box_in_box", "box", "box"), ("box_in_mor", "box", "mor")]
TRIALS = "specs/randomisation/hopper.json"
BANDED = 20  # trials whose runs by time are asked for, at most


def quiet_document(program):
    """The randomisation without its sensor noise."""
    return written(program, "quiet", documents.quiet_randomisation(TRIALS))


def known_document(program):
    """The same of a robot whose masses were measured."""
    return written(program, "known", documents.known_randomisation(TRIALS))


def written(program, name, document):
    path = program.folder / f"{name}_randomisation.json"
    path.write_text(json.dumps(document))
    return path


def of(path, name):
    table = series.read(path)
    if name == "pitch_rate":
        return table["time_s"], table["base_angular_y_velocity_rad_s"]
    if name == "pitch":
        return table["time_s"], [words.DEGREES * angle for angle in series.pitch_rad(table)]
    return table["time_s"], table["base_z_position_m"]


def run(program):
    plans = {limits: program.plan(limits, "specs/robot/hopper.json", "--limits", limits) for limits in ("mor", "box")}
    rows = []
    for limits, found in plans.items():
        rows.append([f"`hopper flip --limits {limits}`", words.status(found), *words.flight(found),
                     f"{len(found['rounds'])} rounds, {found['iterations']} iterations, {found['seconds']:.0f} s"])
    out = "### The plans\n\n" + words.table(
        ["command", "outcome", "CAM, N m s", "CAV, rad/s", "peak, rad/s", "rise, %", "search"], rows)
    rows = []
    for name, plan, limits in REPLAYS:
        for engine in ("own", "mujoco"):
            report = program.replay(f"{name}_{engine}", plans[plan]["motion"], "specs/robot/hopper.json",
                                    "--limits", limits, "--engine", engine)
            short = words.shortness(report)
            stands = report["verdict"] == "stands"
            wanted = (short >= 10 or not stands) if name == "box_in_mor" else (abs(short) <= 1 and stands)
            rows.append([f"`hopper replay {plan}.csv --limits {limits} --engine {engine}`",
                         f"{short:+.2f} degrees short", words.fell(report),
                         f"{100 * max(one['clipped_share'] for one in report['joints']):.2f} % clipped",
                         words.reached(wanted)])
    out += "\n### Fig. 5: planned and replayed\n\n" + words.table(
        ["command", "at touch-down", "1 s later", "greatest share of a drive", "asked for"], rows)
    out += "\n" + trials(program, plans)
    draw(program, plans)
    return out


def trials(program, plans):
    rows = []
    for document, what in ((TRIALS, "as documented"), (quiet_document(program), "without sensor noise"),
                           (known_document(program), "measured robot, without sensor noise")):
        for engine in ("own", "mujoco"):
            report = program.trials_of(f"trials_{what.split()[0]}_{engine}", plans["mor"]["motion"], document,
                                       "specs/robot/hopper.json", "--engine", engine)
            of_trials = report["trials"]
            short = [words.DEGREES * one["rotation_short_rad"] for one in of_trials["list"]
                     if one.get("rotation_short_rad") is not None]
            rows.append([what, engine, f"{of_trials['succeeded']} of {of_trials['count']}",
                         f"{100 * of_trials['interval'][0]:.0f} to {100 * of_trials['interval'][1]:.0f} %",
                         f"{min(short):+.1f}, {statistics.median(short):+.1f}, {max(short):+.1f}" if short else ""])
    return (f"`hopper replay mor.csv --trials {program.trials} --randomise {TRIALS}`; *measured*: masses, inertias "
            "within 2 % instead of 15 %, centres of mass within 3 mm instead of 30, gains within 5 % instead of "
            "10:\n\n") + words.table(
        ["randomised", "engine", "stand", "interval of 95 %", "degrees short at touch-down: least, median, most"], rows)


def draw(program, plans):
    runs = [program.trial("mor_trial", number, plans["mor"]["motion"], TRIALS) for number in range(min(program.trials, BANDED))]
    grid = [0.5 + 0.01 * i for i in range(211)]
    for name in ("pitch_rate", "pitch", "height"):
        rows = series.band([of(path, name) for path in runs], grid)
        series.write(program.folder / f"{name}_band.csv", ["time_s", "least", "greatest"],
                     [row for row in rows if row[1] == row[1]])
        for replay, _, _ in REPLAYS:
            times, values = of(program.folder / f"{replay}_own.series.csv", name)
            end = len(times)
            series.write(program.folder / f"{replay}_{name}.csv", ["time_s", name],
                         list(zip(times, values))[0:end:20])
    flight = plans["mor"]["flight"]
    pictures.curves("docs/pictures/flip_replays.svg", program.folder, flight["from_s"], flight["until_s"])
