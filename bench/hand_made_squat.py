#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A squat of specs/robot/hopper.json on its flat foot, as a motion for `hopper check` and `hopper
replay`: the knee bends and stretches, the centre of mass stays above one place of the sole.

    bench/hand_made_squat.py specs/robot/hopper.json > specs/trajectory/hopper_squat.csv
"""
import json
import math
import sys

KNEE_RAD = (1.0, 1.7)  # stretched, bent
ABOVE_M = 0.01  # of the sole: where the centre of mass stays, ahead of the ankle
REST_S, DOWN_S, UP_S, STEP_S = 0.2, 0.6, 0.5, 0.002


def turned(x, z, pitch):
    """About +y: x goes down as the pitch grows."""
    return x * math.cos(pitch) + z * math.sin(pitch), -x * math.sin(pitch) + z * math.cos(pitch)


def centre_of_mass_x(bodies, calf_m, knee, pitch):
    """Ahead of the ankle; the foot is flat, the base's origin is the knee."""
    ankle = turned(0, -calf_m, pitch + knee)
    mass = moment = 0.0
    for body, angle, origin in (
        ("thigh", pitch, (0, 0)),
        ("calf", pitch + knee, (0, 0)),
        ("ankle_cross", pitch + knee, ankle),
        ("foot", 0.0, ankle),
    ):
        centre = bodies[body]["center_of_mass_m"]
        place = origin[0] + turned(centre[0], centre[2], angle)[0] - ankle[0]
        mass += bodies[body]["mass_kg"]
        moment += bodies[body]["mass_kg"] * place
    return moment / mass


def pitch_of(bodies, calf_m, knee):
    """Of the thigh, by bisection: leaning forward moves the centre of mass ahead."""
    low, high = -knee, 1.5
    for _ in range(60):
        middle = 0.5 * (low + high)
        ahead = centre_of_mass_x(bodies, calf_m, knee, middle) > ABOVE_M
        low, high = (low, middle) if ahead else (middle, high)
    return 0.5 * (low + high)


def knee_at(time_s):
    """Of the third derivative no jump: 10 u^3 - 15 u^4 + 6 u^5 each way."""
    down = min(max((time_s - REST_S) / DOWN_S, 0), 1)
    up = min(max((time_s - REST_S - DOWN_S) / UP_S, 0), 1)
    share = [u**3 * (10 - 15 * u + 6 * u * u) for u in (down, up)]
    return KNEE_RAD[0] + (KNEE_RAD[1] - KNEE_RAD[0]) * (share[0] - share[1])


def main():
    robot = json.load(open(sys.argv[1], encoding="utf-8"))
    bodies = {body["name"]: body for body in robot["bodies"]}
    calf_m = -robot["joints"][1]["position_m"][2]
    sole_m = -robot["contacts"][0]["position_m"][2]
    print("# One-legged hopper, a squat on its flat foot, made by bench/hand_made_squat.py.")
    print("time_s,base_x_position_m,base_y_position_m,base_z_position_m,base_qw_position,"
          "base_qx_position,base_qy_position,base_qz_position,knee_position_rad,"
          "ankle_pitch_position_rad,ankle_roll_position_rad")
    steps = round((2 * REST_S + DOWN_S + UP_S) / STEP_S)
    for i in range(steps + 1):
        time_s = i * STEP_S
        knee = knee_at(time_s)
        pitch = pitch_of(bodies, calf_m, knee)
        x, z = turned(0, -calf_m, pitch + knee)
        print(f"{time_s:.6g},{-x:.12g},0,{sole_m - z:.12g},{math.cos(pitch / 2):.12g},0,"
              f"{math.sin(pitch / 2):.12g},0,{knee:.12g},{-pitch - knee:.12g},0")


main()
