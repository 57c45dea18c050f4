# SPDX-License-Identifier: Apache-2.0
"""Runs exported modules on samples and prints what came out, as JSON: a list.

region_module.py LIBRARY FOLDER: LIBRARY is numpy, standard, torch or torch32; FOLDER holds 0.py and
0.json, 1.py and 1.json, ...: modules, and lists of torque_Nm, velocity_rad_s and, where they are
asked for, voltage_V and temperature_K."""

import importlib.util
import json
import pathlib
import sys
import types

sys.path.insert(0, str(pathlib.Path(__file__).parent))
library, folder = sys.argv[1], pathlib.Path(sys.argv[2])


def loaded(file):
    """A module, and the names of what it imported."""
    before = set(sys.modules)
    spec = importlib.util.spec_from_file_location("region", file)
    region = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(region)
    return region, sorted(set(sys.modules) - before)


first, imported = loaded(folder / "0.py")

import numpy

names = ("torque_Nm", "velocity_rad_s", "voltage_V", "temperature_K")
if library == "numpy":
    make = numpy.asarray
elif library == "standard":
    import array_library

    make = array_library.Array
else:
    import torch

    dtype = torch.float32 if library == "torch32" else torch.float64
    make = lambda values: torch.tensor(values, dtype=dtype, requires_grad=True)


def as_list(array):
    if library == "standard":
        array = array._values
    return (array if library in ("numpy", "standard") else array.detach()).tolist()


def answer_of(region, samples):
    arrays = [make(samples[name]) if name in samples else None for name in names]
    answer = {}
    if library.startswith("torch"):
        with torch.inference_mode():  # as roll-outs do, before anyone asks for slopes
            region.clip(*arrays)
    clipped = region.clip(*arrays)
    answer["clipped_Nm"] = as_list(clipped)
    if library.startswith("torch"):
        clipped.sum().backward()
        answer["slopes"] = [as_list(array.grad) for array in arrays if array is not None]

    if library in ("numpy", "torch"):
        import simulator_classes

        torque, velocity = arrays[0], arrays[1]
        zero = 0.0 * velocity
        isaac = simulator_classes.isaaclab_actuators
        cfg = region.REGION.isaac_lab(["knee"], stiffness=20.0, damping=0.5)
        actuator = cfg.class_type(cfg, cfg.stiffness, cfg.damping, cfg.actuator_effort_limit)
        if len(samples) > 2:
            actuator.voltage_V, actuator.temperature_K = arrays[2:]
        # 20 (q_des - q) + 0.5 (0 - w) + feed-forward is the sample's torque.
        action = types.SimpleNamespace(
            joint_positions=zero + 2.0, joint_velocities=zero, joint_efforts=torque + 0.5 * velocity
        )
        action = actuator.compute(action, zero + 2.0, velocity)
        answer["isaac_lab_Nm"] = as_list(action.joint_efforts)
        answer["isaac_lab_fields"] = {
            name: value for name, value in vars(cfg).items() if name != "class_type"
        }
        isaac.IdealPDActuatorCfg = simulator_classes.OlderCfg
        older = vars(region.REGION.isaac_lab(["knee"], stiffness=20.0, damping=0.5))
        isaac.IdealPDActuatorCfg = simulator_classes.IdealPDActuatorCfg
        answer["older_fields"] = {name: value for name, value in older.items() if name != "class_type"}

        cfg = region.REGION.mjlab(("knee",), stiffness=20.0, damping=0.5)
        actuator = cfg.build("entity", [0], ["knee"])
        actuator.stiffness, actuator.damping = cfg.stiffness, cfg.damping
        actuator.force_limit = cfg.effort_limit
        if len(samples) > 2:
            actuator.voltage_V, actuator.temperature_K = arrays[2:]
        answer["mjlab_Nm"] = as_list(
            actuator.compute(
                types.SimpleNamespace(
                    position_target=zero + 2.0,
                    velocity_target=zero,
                    effort_target=torque + 0.5 * velocity,
                    pos=zero + 2.0,
                    vel=velocity,
                )
            )
        )
        answer["mjlab_fields"] = vars(cfg)
    return answer


answers = []
while (folder / f"{len(answers)}.py").exists():
    of = folder / f"{len(answers)}.py"
    answers.append(answer_of(loaded(of)[0], json.loads(of.with_suffix(".json").read_text())))
answers[0]["imported"] = imported
print(json.dumps(answers))
