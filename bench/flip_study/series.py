# SPDX-License-Identifier: Apache-2.0
"""Tables by time, and what the study reads out of them. SI units."""
import bisect
import csv
import math


def read(path):
    """Columns by name, as floats; a cell that is empty is not a number. Comments are left out."""
    with open(path, newline="") as file:
        rows = csv.reader(line for line in file if not line.startswith("#"))
        names = next(rows)
        columns = [[] for _ in names]
        for row in rows:
            for column, cell in zip(columns, row):
                try:
                    column.append(float(cell))
                except ValueError:
                    column.append(math.nan)
    return dict(zip(names, columns))


def pitch_rad(table):
    """Of the base about +y, counted on through whole turns."""
    out = []
    for w, y in zip(table["base_qw_position"], table["base_qy_position"]):
        angle = 2 * math.atan2(y, w)
        if out:
            angle += 2 * math.pi * round((out[-1] - angle) / (2 * math.pi))
        out.append(angle)
    return out


def at(times, values, time_s):
    """Straight between samples, the first and last beyond them."""
    if time_s <= times[0]:
        return values[0]
    if time_s >= times[-1]:
        return values[-1]
    i = bisect.bisect_left(times, time_s)
    span = times[i] - times[i - 1]
    share = (time_s - times[i - 1]) / span if span > 0 else 1.0
    return values[i - 1] + share * (values[i] - values[i - 1])


def gear_motor_Nm(table, drive, rotor_kg_m2, ratio, window_s=0.01):
    """What passes a drive's gears, at the motor: torque less what its rotor takes, as the mean of
    the window before each sample. `rotor_kg_m2` at the motor."""
    times = table["time_s"]
    torque = table[f"{drive}_drive_torque_Nm"]
    speed = table[f"{drive}_drive_speed_rad_s"]
    integral = [0.0]
    for i in range(1, len(times)):
        integral.append(integral[-1] + torque[i - 1] * (times[i] - times[i - 1]))
    out, first = [], 0
    for i, time_s in enumerate(times):
        while times[first] < time_s - window_s - 1e-9:
            first += 1
        span = time_s - times[first]
        if span < 0.9 * window_s:
            out.append(math.nan)
            continue
        mean = (integral[i] - integral[first]) / span
        out.append(mean / ratio - rotor_kg_m2 * ratio * (speed[i] - speed[first]) / span)
    return out


def band(tables, grid):
    """Least and greatest over several (times, values) at each time of the grid; a run that has
    ended says nothing more."""
    rows = []
    for time_s in grid:
        values = [at(times, values, time_s) for times, values in tables if times[0] <= time_s <= times[-1]]
        values = [value for value in values if not math.isnan(value)]
        rows.append((time_s, min(values), max(values)) if values else (time_s, math.nan, math.nan))
    return rows


def write(path, names, rows):
    with open(path, "w", newline="") as file:
        file.write(",".join(names) + "\n")
        for row in rows:
            file.write(",".join("" if isinstance(x, float) and math.isnan(x) else f"{x:.9g}" for x in row) + "\n")
