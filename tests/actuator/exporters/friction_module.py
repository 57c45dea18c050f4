# SPDX-License-Identifier: Apache-2.0
"""Runs an exported module's torque() on samples and prints what came out, as JSON.

friction_module.py FOLDER: region.py and samples.json (torque_Nm, velocity_rad_s)."""

import json
import pathlib
import sys
import types

sys.path.insert(0, str(pathlib.Path(__file__).parent))
sys.path.insert(0, sys.argv[1])
import dual_library
import numpy
import region
import simulator_classes

samples = json.loads((pathlib.Path(sys.argv[1]) / "samples.json").read_text())
torque, velocity = numpy.asarray(samples["torque_Nm"]), numpy.asarray(samples["velocity_rad_s"])
zero = 0.0 * velocity

isaac = region.REGION.isaac_lab(["knee"], stiffness=20.0, damping=0.5)
actuator = isaac.class_type(isaac, 20.0, 0.5, isaac.actuator_effort_limit)
action = types.SimpleNamespace(
    joint_positions=zero, joint_velocities=zero, joint_efforts=torque + 0.5 * velocity
)
action = actuator.compute(action, zero, velocity)

mjlab = region.REGION.mjlab(("knee",), stiffness=20.0, damping=0.5)
actuator = mjlab.build("entity", [0], ["knee"])
actuator.stiffness, actuator.damping, actuator.force_limit = 20.0, 0.5, mjlab.effort_limit
given = types.SimpleNamespace(
    position_target=zero,
    velocity_target=zero,
    effort_target=torque + 0.5 * velocity,
    pos=zero,
    vel=velocity,
)


def slopes_of_torch():
    """Of PyTorch, by torque and by velocity, where it is installed."""
    try:
        import torch
    except ImportError:
        return None
    arrays = [torch.tensor(of, dtype=torch.float64, requires_grad=True) for of in (torque, velocity)]
    region.torque(*arrays).sum().backward()
    return [array.grad.tolist() for array in arrays]


Dual = dual_library.Array
print(
    json.dumps(
        {
            "torch": slopes_of_torch(),
            "torque_Nm": region.torque(torque, velocity).tolist(),
            "isaac_lab_Nm": action.joint_efforts.tolist(),
            "mjlab_Nm": actuator.compute(given).tolist(),
            "by_torque": region.torque(Dual(torque, 1.0), Dual(velocity)).slope.tolist(),
            "by_velocity": region.torque(Dual(torque), Dual(velocity, 1.0)).slope.tolist(),
            "smoothing_rad_s": region.REGION.smoothing_rad_s,
            "joint_effort_limit": isaac.joint_effort_limit,
            "effort_limit": mjlab.effort_limit,
            "viscous_friction": isaac.viscous_friction,
        }
    )
)
