#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""identification_times.py TORQUEWRIGHT FOLDER [CASE ...]: has `identify simulate` write logs of a
drive with effects that its document lacks, has each identified in a process of its own, and prints
wall and CPU seconds, the greatest resident memory and what was named. README.md describes the
cases; the logs stay in the folder."""
import json
import math
import os
import pathlib
import subprocess
import sys
import time


def effect(name, **parameters):
    return {"effect": name, "parameters": parameters}


FRICTION = [effect("coulomb_friction", coulomb_Nm=0.6),
            effect("load_dependent_friction", driving_coefficient=0.06,
                   backdriving_coefficient=0.06)]
STRIBECK = [effect("stribeck_friction", coulomb_Nm=0.6, breakaway_Nm=1.1,
                   stribeck_velocity_rad_s=0.3)]
HYSTERESIS = [effect("presliding_friction", coulomb_Nm=0.6, stiffness_Nm_rad=30.0)]
RUNS = 4
# Rows, rate in Hz, rig, what the drive has and its document lacks.
CASES = {
    "million": (1_000_000, 1000.0, "dynamometer", FRICTION),
    "ten_million": (10_000_000, 1000.0, "dynamometer", FRICTION),
    "stribeck": (18_000, 100.0, "dynamometer", STRIBECK),
    "stribeck_pendulum": (18_000, 100.0, "pendulum", STRIBECK),
    "hysteresis": (18_000, 100.0, "dynamometer", HYSTERESIS),
    "hysteresis_pendulum": (18_000, 100.0, "pendulum", HYSTERESIS),
}
NOISE = {"dynamometer": {"output_torque_Nm": 0.05, "motor_current_A": 0.02,
                         "output_position_rad": 1e-5},
         "pendulum": {"winding_voltage_V": 0.02, "output_position_rad": 1e-5}}


def rig(name, load, **columns):
    return {"kind": "rig", "version": 1, "name": name, "load": load,
            "columns": {"run": "run", "t_s": "time_s", "q_rad": "output_position_rad"} | columns}


RIGS = {"dynamometer": rig("dynamometer", {"type": "dynamometer"}, i_A="motor_current_A",
                           tau_Nm="output_torque_Nm"),
        "pendulum": rig("pendulum", {"type": "pendulum", "mass_kg": 1.0, "length_m": 0.4,
                                     "inertia_kg_m2": 0.003}, v_V="winding_voltage_V")}
ACTUATOR = {"kind": "actuator", "version": 1, "name": "drive",
            "motor": {"torque_constant_Nm_A": 0.0865, "torque_constant_convention": "dc",
                      "resistance_ohm": 0.237, "resistance_convention": "dc", "pole_pairs": 21,
                      "rotor_inertia_kg_m2": 0.000173, "winding_temperature_K": 298.15},
            "drive": {"bus_voltage_V": 21, "peak_current_A": 28},
            "gearbox": {"ratio": 9.3, "forward_efficiency": 1, "backward_efficiency": 1}}


def excitation(path, rows, rate_Hz, rig_name):
    """Sums of sines that never repeat within the log: a current on the dynamometer, which imposes
    the speed, and a voltage on the pendulum."""
    is_pendulum = rig_name == "pendulum"
    with open(path, "w") as out:
        out.write("run,time_s," + ("winding_voltage_V" if is_pendulum
                                   else "motor_current_A,output_velocity_rad_s") + "\n")
        for k in range(rows):
            run = k * RUNS // rows
            t_s = k / rate_Hz
            drive = 5.0 * math.sin(1.7 * t_s + run) + 3.0 * math.sin(0.31 * math.pi * t_s)
            speed_rad_s = 2.2 * math.cos(1.1 * t_s) + 2.2 * math.cos(math.pi * t_s + 1.0 + run)
            imposed = "" if is_pendulum else f",{speed_rad_s:.4f}"
            out.write(f"run_{run},{t_s:.4f},{0.8 * drive if is_pendulum else drive:.4f}{imposed}\n")


def write(path, document):
    path.write_text(json.dumps(document))


def log_of(torquewright, folder, case):
    """Made once, as it takes longer than what is measured."""
    rows, rate_Hz, rig_name, effects = CASES[case]
    log = folder / f"{case}.csv"
    if log.exists():
        return log
    truth, played = folder / f"{case}_truth.json", folder / f"{case}_excitation.csv"
    write(truth, ACTUATOR | {"effects": effects})
    excitation(played, rows, rate_Hz, rig_name)
    noise = [word for name, sigma in NOISE[rig_name].items()
             for word in ("--noise", f"{name}={sigma}")]
    subprocess.run([torquewright, "identify", "simulate", truth, "--rig",
                    folder / f"{rig_name}.json", "--excitation", played, *noise, "-o", log],
                   check=True)
    played.unlink()
    return log


def measure(torquewright, folder, case):
    log = log_of(torquewright, folder, case)
    start_s = time.monotonic()
    process = subprocess.Popen(
        [torquewright, "identify", log, "--rig", folder / f"{CASES[case][2]}.json", "--actuator",
         folder / "nominal.json", "--json"], stdout=subprocess.PIPE)
    answer = process.stdout.read()
    _, status, used = os.wait4(process.pid, 0)
    wall_s = time.monotonic() - start_s
    (folder / f"{case}_answer.json").write_bytes(answer)
    names = ", ".join(each["effect"] for each in json.loads(answer)["effects_added"])
    print(f"{case}: {wall_s:.1f} s, of CPU {used.ru_utime:.1f} user and {used.ru_stime:.1f} system,"
          f" {used.ru_maxrss / 1024:.0f} MB, exit {os.waitstatus_to_exitcode(status)}, {names}",
          flush=True)


def main():
    torquewright, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    write(folder / "nominal.json", ACTUATOR)
    for name, document in RIGS.items():
        write(folder / f"{name}.json", document)
    for case in sys.argv[3:] or CASES:
        measure(torquewright, folder, case)


if __name__ == "__main__":
    main()
