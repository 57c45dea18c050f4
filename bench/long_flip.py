#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""long_flip.py TRAJECTORY ROWS OUT: the trajectory with so many rows over the same time, as evenly
as its impacts let them lie. Positions are the cubics through each two rows' positions and
velocities, velocities those through velocities and accelerations, accelerations straight lines;
quaternions are not normalised."""
import bisect
import csv
import sys


def read(file):
    with open(file) as stream:
        rows = csv.reader(line for line in stream if not line.startswith("#"))
        return next(rows), [[float(cell) for cell in row] for row in rows]


def rates_of(header):
    """By column the column of its rate, where it has one."""
    places = {name: i for i, name in enumerate(header)}
    pairs = {"_position_rad": "_velocity_rad_s", "_position_m": "_velocity_m_s",
             "_velocity_rad_s": "_acceleration_rad_s2", "_velocity_m_s": "_acceleration_m_s2"}
    rates = {}
    for name, i in places.items():
        for ending, rate in pairs.items():
            if name.endswith(ending) and name.removesuffix(ending) + rate in places:
                rates[i] = places[name.removesuffix(ending) + rate]
    return rates


def between(left, right, share, rates):
    step_s = right[0] - left[0]
    row = [(1 - share) * a + share * b for a, b in zip(left, right)]
    for i, rate in rates.items():
        a, b, da, db = left[i], right[i], step_s * left[rate], step_s * right[rate]
        bend = share * (1 - share)
        row[i] += bend * ((1 - share) * (da - (b - a)) - share * (db - (b - a)))
    return row


def lengthened(header, rows, count):
    rates = rates_of(header)
    first_s, last_s = rows[0][0], rows[-1][0]
    times_s = [row[0] for row in rows]
    kept = {time_s for time_s in times_s if times_s.count(time_s) > 1}
    for i in range(count):
        time_s = first_s + (last_s - first_s) * i / (count - 1)
        for impact_s in sorted(t for t in kept if t <= time_s):
            kept.remove(impact_s)
            yield from (row for row in rows if row[0] == impact_s)
        left = min(max(bisect.bisect_right(times_s, time_s) - 1, 0), len(rows) - 2)
        share = (time_s - times_s[left]) / (times_s[left + 1] - times_s[left])
        yield between(rows[left], rows[left + 1], share, rates)


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    header, rows = read(sys.argv[1])
    with open(sys.argv[3], "w") as stream:
        stream.write(",".join(header) + "\n")
        for row in lengthened(header, rows, int(sys.argv[2])):
            stream.write(",".join(f"{value:.12g}" for value in row) + "\n")


main()
