# SPDX-License-Identifier: Apache-2.0
"""Figs. 3 and 4: torque-speed points about take-off; CAM, CAV, composite inertia by objective."""
import series
import words

ROBOT = "specs/robot/hopper.json"
WINDOW_S = 0.25
SEED = [("CAM", "N m s", 6.0, 15), ("CAV at take-off", "rad/s", 7.4, 10), ("CAV at most", "rad/s", 10.6, 5)]


def run(program):
    rows = []
    for name, options in (("effort (default)", []), ("cam", ["--objective", "cam"]), ("cav", ["--objective", "cav"]),
                          ("bav", ["--objective", "bav"])):
        file = "momentum_" + name.split()[0]
        found = program.plan(file, ROBOT, *options, "--plot-momentum", program.folder / f"{file}.svg")
        rows.append([name, words.status(found), *words.flight(found), f"{found['seconds']:.0f} s"])
        if name.startswith("effort"):
            first = found
    out = "### Fig. 4: objectives\n\n`hopper flip --objective NAME --plot-momentum FILE`\n\n" + words.table(
        ["objective", "outcome", "CAM, N m s", "CAV at take-off, rad/s", "at most, rad/s", "rise, %", "took"], rows)
    return out + "\n" + against_seed(first) + "\n" + about_take_off(program, first)


def against_seed(found):
    got = [found["cam_kg_m2_s"], found["cav_take_off_rad_s"], found["cav_peak_rad_s"]]
    rows = [[name, f"{seed:g} {unit} +-{percent} %", f"{value:.2f}", f"{100 * (value / seed - 1):+.1f} %",
             words.reached(abs(value / seed - 1) <= percent / 100)]
            for (name, unit, seed, percent), value in zip(SEED, got)]
    rise = 100 * (got[2] / got[1] - 1)
    rows.append(["rise of CAV in flight", "+35 to +45 %", f"{rise:+.1f} %", "", words.reached(35 <= rise <= 45)])
    return "The plan for effort beside the paper:\n\n" + words.table(["", "seed", "plan", "off by", ""], rows)


def about_take_off(program, found):
    """Points within 0.25 s of take-off, drawn by the program's own command."""
    off_s = found["flight"]["from_s"]
    program.check("take_off", found["motion"], ROBOT, "--from", off_s - WINDOW_S, "--until", off_s + WINDOW_S,
                  "--plot", program.folder / "take_off_region.svg")
    program.check("momentum_plan", found["motion"])
    table = series.read(program.folder / "momentum_plan.check.csv")
    rows = []
    for drive in ("knee", "ankle_left"):
        near = [i for i, time_s in enumerate(table["time_s"]) if abs(time_s - off_s) <= WINDOW_S]
        margin = [table[f"{drive}_torque_margin_Nm"][i] for i in near]
        speed = [table[f"{drive}_drive_speed_rad_s"][i] for i in near]
        least = min(range(len(near)), key=lambda i: margin[i])
        close = sum(value < 0.1 * max(map(abs, table[f"{drive}_torque_max_Nm"])) for value in margin)
        rows.append([drive, len(near), f"{max(map(abs, speed)):.2f}", f"{min(margin):.1f}",
                     f"{table['time_s'][near[least]] - off_s:+.3f}", f"{100 * close / len(near):.0f} %"])
    return ("### Fig. 3: within 0.25 s of take-off\n\n`hopper check --from " f"{off_s - WINDOW_S:.3f} --until "
            f"{off_s + WINDOW_S:.3f} --plot FILE` draws them; of `--series`:\n\n") + words.table(
        ["drive", "samples", "greatest speed, rad/s", "least margin, N m", "at, s from take-off",
         "closer than a tenth of the greatest torque"], rows)
