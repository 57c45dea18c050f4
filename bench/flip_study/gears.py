# SPDX-License-Identifier: Apache-2.0
"""Figs. 6 to 8: what passes the gears at the landing, and flip after flip."""
import curves
import documents
import pictures
import series
import words

ROBOT = "specs/robot/hopper.json"
ROTORS = {"knee": (0.000922, 20), "ankle_left": (0.0002, 8)}  # of specs/actuator
PLANS = [("without", "effort alone", ["--objective", "effort"]),
         ("with", "effort and gear load", ["--objective", "gear_load=3", "--objective", "effort"])]


def run(program):
    rows, limits = [], {}
    for name, what, options in PLANS:
        found = program.plan(f"gears_{name}", ROBOT, *options)
        checked = program.check(f"gears_{name}", found["motion"]) if found["motion"] else None
        planned = {one["drive"]: one for one in checked["transmission_load"]} if checked else {}
        document = curves.quiet_document(program)
        report = program.trials_of(f"gears_{name}_trials", found["motion"], document)
        loads = list(zip(*(one["transmission_load_Nm"] for one in report["trials"]["list"])))
        for drive, of_trials in zip(("knee", "ankle_left"), loads):
            here = next(one for one in report["transmission_load"] if one["drive"] == drive)
            limits[drive] = here["limit"]["torque_Nm"]
            rows.append([what, words.planned_or_best(found), drive,
                         f"{planned[drive]['motor_Nm']:.2f}" if drive in planned else "",
                         f"{here['motor_Nm']:.2f}", f"{min(of_trials):.1f} to {max(of_trials):.1f}",
                         f"{limits[drive]:.2f}",
                         f"{sum(value > limits[drive] for value in of_trials)} of {len(of_trials)}"])
        bands(program, name, found, document, report)
    pictures.gear_bands("docs/pictures/flip_gears.svg", program.folder, list(limits.items()))
    out = (f"`hopper flip --objective effort`, or `--objective gear_load=3 --objective effort`, then `hopper replay --trials {program.trials}` "
           "without sensor noise, own engine; the mean of the worst 10 ms of the run, N m at the motor:\n\n")
    out += words.table(["plan for", "", "drive", "plan", "replay", "trials", "strength", "trials beyond it"], rows)
    return "### Figs. 6 and 7: gears at the landing\n\n" + out + "\n" + landing(program, limits) + "\n" + repeated(program)


LANDING_S = 0.03  # after touch-down: a trial that falls hits its gears later


def landing(program, limits):
    """The greatest of the bands just after touch-down."""
    rows = []
    for name, what, _ in PLANS:
        for drive in ROTORS:
            table = series.read(program.folder / f"{drive}_{name}.csv")
            most = max(max(abs(least), abs(greatest)) for after, least, greatest in
                       zip(table["after_s"], table["least_Nm"], table["greatest_Nm"]) if 0 <= after <= LANDING_S)
            rows.append([what, drive, f"{most:.1f}", f"{limits[drive]:.2f}", words.reached(most <= limits[drive])])
    return (f"Of the worst 10 ms within {1000 * LANDING_S:.0f} ms after touch-down alone, over {BANDED} of these trials (a "
            "trial that falls hits its gears again, later):\n\n") + words.table(
        ["plan for", "drive", "most, N m at the motor", "strength", "within it"], rows)


BANDED = 10  # trials whose runs by time are asked for


def bands(program, name, found, document, report):
    """From 20 ms before each run's own touch-down."""
    after = [0.001 * i - 0.02 for i in range(101)]
    runs = {drive: [] for drive in ROTORS}
    for number, one in enumerate(report["trials"]["list"][:BANDED]):
        if one.get("touch_down_s") is None:
            continue
        table = series.read(program.trial(f"gears_{name}", number, found["motion"], document))
        for drive, (rotor_kg_m2, ratio) in ROTORS.items():
            times = [time_s - one["touch_down_s"] for time_s in table["time_s"]]
            runs[drive].append((times, series.gear_motor_Nm(table, drive, rotor_kg_m2, ratio)))
    for drive in ROTORS:
        rows = series.band(runs[drive], after)
        series.write(program.folder / f"{drive}_{name}.csv", ["after_s", "least_Nm", "greatest_Nm"], rows)


# Of the motors' size, not of these motors: neither seed nor maker states any.
THERMAL = {"winding_to_case_K_W": 0.5, "case_to_ambient_K_W": 1.0, "winding_J_K": 100, "case_J_K": 600,
           "winding_limit_K": 393.15}


def repeated(program):
    """Heat from flip to flip."""
    hot = documents.Documents()
    for drive in hot.drives():
        drive["thermal"] = THERMAL
    robot = hot.write(program.folder / "hot")
    rows = []
    for runs, pause_s in ((1, 0), (8, 10), (8, 0), (100, 0)):
        report = program.check(f"repeat_{runs}_{pause_s}", program.folder / "gears_without.csv", robot, "--repeat",
                               runs, "--pause", pause_s)
        if report is None:
            continue
        rows.append([f"`hopper check --repeat {runs} --pause {pause_s}`", report["verdict"],
                     *(warmest(report, drive) for drive in ("knee", "ankle_left"))])
    return ("### Fig. 8: flip after flip\n\nDocuments state no thermal data; assumed here for both motors: "
            + ", ".join(f"{key} {value:g}" for key, value in THERMAL.items()) + ".\n\n"
            + words.table(["command", "verdict", "knee's winding, K", "ankle's winding, K"], rows))


def warmest(report, drive):
    winding = next(one["winding"] for one in report["joints"] if one["name"] == drive)
    return f"{winding['peak_K']:.1f}; {winding['steady_peak_K']:.1f} if it never ends"
