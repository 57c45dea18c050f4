#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Does load friction lower or raise the held-out error of the cycloidal drive's two good logs?

An analysis apart from the tool, sharing no code with it: least squares with numpy, at several
splits, with and without the sensor's delay, the load of the friction column taken from the current.
Usage: load_friction_evidence.py FOLDER, the folder of torqueripple2.csv and torqueripple3.csv.
docs/identification.md holds what it prints, and what follows.
"""
import sys

import numpy

RAW_HZ, BAND_HZ = 25.0, 20.0
TORQUE_PER_AMPERE_NM_A = 2.0  # 10:1 and 0.2 Nm/A, fitted anew in every model
SPLITS = {"last third": (2 / 3, 1), "middle third": (1 / 3, 2 / 3), "first third": (0, 1 / 3),
          "last half": (1 / 2, 1), "first half": (0, 1 / 2), "last quarter": (3 / 4, 1)}
PLAIN = ["current", "inertia", "viscous"]
MODELS = {"plain": PLAIN, "+ Coulomb": PLAIN + ["coulomb"],
          "+ Coulomb + load": PLAIN + ["coulomb", "load"],
          "+ Coulomb + saturation": PLAIN + ["coulomb", "saturation"],
          "+ Coulomb + saturation + load": PLAIN + ["coulomb", "saturation", "load"],
          "+ Coulomb + gravity": PLAIN + ["coulomb", "sine", "cosine"],
          "+ Coulomb + gravity + load": PLAIN + ["coulomb", "sine", "cosine", "load"]}


def low_pass(signal, cutoff_hz, rate_hz):
    """Butterworth of second order, both ways, ends mirrored."""
    k = numpy.tan(numpy.pi * cutoff_hz / rate_hz)
    norm = 1 / (1 + numpy.sqrt(2) * k + k * k)
    b, a1, a2 = k * k * norm, 2 * (k * k - 1) * norm, (1 - numpy.sqrt(2) * k + k * k) * norm
    pad = int(numpy.ceil(1.1 * rate_hz / cutoff_hz))
    padded = numpy.concatenate([2 * signal[0] - signal[pad:0:-1], signal,
                                2 * signal[-1] - signal[-2:-pad - 2:-1]])

    def once(values):
        out = numpy.empty_like(values)
        x1 = x2 = y1 = y2 = values[0]
        for i, x in enumerate(values):
            y = b * (x + 2 * x1 + x2) - a1 * y1 - a2 * y2
            x2, x1, y2, y1, out[i] = x1, x, y1, y, y
        return out

    return once(once(padded)[::-1])[::-1][pad:-pad]


def read(path):
    log = numpy.genfromtxt(path, delimiter=",", names=True)
    time = log["t_s"]
    rate_hz = (len(time) - 1) / (time[-1] - time[0])
    grid = time[0] + numpy.arange(len(time)) / rate_hz
    channels = {name: low_pass(numpy.interp(grid, time, log[name]), RAW_HZ, rate_hz)
                for name in ("q_rad", "i_A", "tau_Nm")}
    return channels, rate_hz


def columns(channels, rate_hz, delay_s):
    position, current, sensor = channels["q_rad"], channels["i_A"], channels["tau_Nm"]
    place = numpy.arange(len(position))
    sensor = numpy.interp(numpy.clip(place + delay_s * rate_hz, 0, place[-1]), place, sensor)
    speed = numpy.gradient(position) * rate_hz
    direction = numpy.clip(speed / 0.05, -1, 1)
    load = TORQUE_PER_AMPERE_NM_A * current  # never the measured torque itself
    made = {"current": load, "inertia": -numpy.gradient(speed) * rate_hz, "viscous": -speed,
            "coulomb": -direction, "load": -abs(load) * direction,
            "saturation": -load * abs(load) / 20, "sine": numpy.sin(position),
            "cosine": numpy.cos(position)}
    made = {name: low_pass(values, BAND_HZ, rate_hz) for name, values in made.items()}
    usable = abs(speed) > 0.02 * numpy.quantile(abs(speed), 0.95)
    edge = int(0.22 * rate_hz)
    usable[:edge] = usable[-edge:] = False
    return made, low_pass(sensor, BAND_HZ, rate_hz), usable, load, speed


def fit(made, target, rows, names):
    matrix = numpy.array([made[name][rows] for name in names]).T
    return numpy.linalg.lstsq(matrix, target[rows], rcond=None)[0]


def rms(made, target, rows, names, values):
    matrix = numpy.array([made[name][rows] for name in names]).T
    return numpy.sqrt(((target[rows] - matrix @ values) ** 2).mean())


def report(path):
    channels, rate_hz = read(path)
    for delay_s in (0.0, 0.078):
        made, target, usable, load, speed = columns(channels, rate_hz, delay_s)
        driving, braked = usable & (load * speed > 0), usable & (load * speed < 0)
        print(f"{path}: sensor moved by {1000 * delay_s:.0f} ms; driving {driving.sum() / usable.sum():.0%} "
              f"of the time at {abs(load[driving]).mean():.1f} Nm, back-driving "
              f"{braked.sum() / usable.sum():.0%} at {abs(load[braked]).mean():.1f} Nm")
        print(" " * 32 + "".join(f"{name:>16}" for name in SPLITS))
        place = numpy.arange(len(target)) / len(target)
        for model, names in MODELS.items():
            cells = []
            for start, end in SPLITS.values():
                held_out = (place >= start) & (place < end)
                values = fit(made, target, usable & ~held_out, names)
                cells.append("{:.3f} -> {:.3f}".format(
                    rms(made, target, usable & ~held_out, names, values),
                    rms(made, target, usable & held_out, names, values)))
            print(f"  {model:<30}" + "".join(f"{cell:>16}" for cell in cells))


if __name__ == "__main__":
    for name in ("torqueripple2.csv", "torqueripple3.csv"):
        report(sys.argv[1] + "/" + name)
