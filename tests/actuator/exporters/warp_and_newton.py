# SPDX-License-Identifier: Apache-2.0
"""Stand-ins for Warp's kernels and for Newton's actuators (no part of them), by the names and
signatures of newton/_src/actuators: usd_parser.py as of Newton 1.6, clamping/clamping_dc_motor.py @
1f5efb33, clamping/base.py @ 081a5a0c. A kernel runs once for each thread, on NumPy's arrays."""

import enum
import math
import types
import warnings

import numpy
from simulator_classes import module

_thread = [0]


def array(data=None, dtype=None, device=None):
    """Of data; without, an annotation."""
    return None if data is None else numpy.asarray(data, dtype=numpy.float32)


def launch(kernel, dim, inputs, outputs, device):
    for i in range(dim):
        _thread[0] = i
        kernel(*inputs, *outputs)


module(
    "warp",
    array=array,
    launch=launch,
    kernel=lambda function: function,
    func=lambda function: function,
    tid=lambda: _thread[0],
    clamp=lambda x, low, high: min(max(low, x), high),
    min=min,
    max=max,
    abs=abs,
    sqrt=math.sqrt,
    isnan=math.isnan,
    tanh=math.tanh,
    float32=numpy.float32,
    uint32=numpy.uint32,
)


class ClampingDCMotor:
    @classmethod
    def resolve_arguments(cls, args):
        if args["saturation_effort"] <= 0 or args["velocity_limit"] <= 0:
            raise ValueError("must be positive")
        return {
            "saturation_effort": args["saturation_effort"],
            "velocity_limit": args["velocity_limit"],
            "max_motor_effort": args.get("max_motor_effort", math.inf),
        }

    def __init__(self, saturation_effort, velocity_limit, max_motor_effort):
        self.saturation_effort = saturation_effort
        self.velocity_limit = velocity_limit
        self.max_motor_effort = max_motor_effort

    def finalize(self, device, num_actuators):
        self.device = device

    def modify_forces(
        self, src_forces, dst_forces, positions, velocities, pos_indices, vel_indices, device=None
    ):
        share = velocities[vel_indices] / self.velocity_limit
        most = numpy.minimum(self.saturation_effort * (1.0 - share), self.max_motor_effort)
        least = numpy.maximum(self.saturation_effort * (-1.0 - share), -self.max_motor_effort)
        dst_forces[:] = numpy.minimum(numpy.maximum(src_forces, least), most)


class ComponentKind(enum.Enum):
    DRIVE = "drive"
    CLAMPING = "clamping"
    DELAY = "delay"


registered = []
_registry = {"NewtonDCMotorClampingAPI": ClampingDCMotor}


def register_actuator_component(schema_name, component_class, kind):
    if schema_name in _registry:
        warnings.warn(f"Actuator schema {schema_name!r} is already registered; overwriting")
    registered.append([schema_name, kind.value])
    _registry[schema_name] = component_class


warnings.simplefilter("error")
module(
    "newton",
    actuators=module(
        "newton.actuators",
        ClampingDCMotor=ClampingDCMotor,
        ComponentKind=ComponentKind,
        register_actuator_component=register_actuator_component,
    ),
)


def clamped(arguments, torque, velocity):
    """What the component that reads a prim of these arguments makes of torques, as a list: of every
    second degree of freedom of a model, as Newton builds and steps it."""
    component = _registry["NewtonDCMotorClampingAPI"]
    if not isinstance(component, type):
        component = component(dict(arguments))
    count = len(torque)
    resolved = component.resolve_arguments(dict(arguments))
    arrays = {name: numpy.full(count, value, numpy.float32) for name, value in resolved.items()}
    clamping = component(**arrays)
    clamping.finalize("cpu", count)
    velocities = numpy.zeros(2 * count, numpy.float32)
    velocities[1::2] = velocity
    places = numpy.arange(1, 2 * count, 2)
    forces = numpy.zeros(count, numpy.float32)
    clamping.modify_forces(
        torque.astype(numpy.float32), forces, None, velocities, None, places, "cpu"
    )
    return forces.tolist()
