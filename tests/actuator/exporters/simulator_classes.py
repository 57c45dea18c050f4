# SPDX-License-Identifier: Apache-2.0
"""Stand-ins for the classes of Isaac Lab and mjlab that the exported module builds on (no part of
them): methods and fields by their documented names, for arrays of NumPy or PyTorch."""

import dataclasses
import sys
import types
from typing import Any


def module(name, **members):
    made = types.ModuleType(name)
    made.__dict__.update(members)
    sys.modules[name] = made
    return made


class IdealPDActuator:
    def __init__(self, cfg, stiffness, damping, effort_limit):
        self.cfg, self.stiffness, self.damping = cfg, stiffness, damping
        self.effort_limit = effort_limit

    def compute(self, control_action, joint_pos, joint_vel):
        wanted = self.stiffness * (control_action.joint_positions - joint_pos)
        wanted = wanted + self.damping * (control_action.joint_velocities - joint_vel)
        self.computed_effort = wanted + control_action.joint_efforts
        self.applied_effort = self._clip_effort(self.computed_effort)
        control_action.joint_efforts = self.applied_effort
        return control_action

    def _clip_effort(self, effort):
        return effort.clip(-self.effort_limit, self.effort_limit)


@dataclasses.dataclass
class IdealPDActuatorCfg:  # of Isaac Lab 3
    class_type: type = IdealPDActuator
    joint_names_expr: Any = None
    stiffness: Any = None
    damping: Any = None
    armature: Any = None
    friction: Any = None
    dynamic_friction: Any = None
    viscous_friction: Any = None
    actuator_effort_limit: Any = None
    joint_effort_limit: Any = None


@dataclasses.dataclass
class OlderCfg:  # of Isaac Lab 2
    class_type: type = IdealPDActuator
    joint_names_expr: Any = None
    stiffness: Any = None
    damping: Any = None
    armature: Any = None
    friction: Any = None
    effort_limit: Any = None
    effort_limit_sim: Any = None


class DCMotor(IdealPDActuator):
    pass


@dataclasses.dataclass
class DCMotorCfg(IdealPDActuatorCfg):  # of Isaac Lab 3
    class_type: type = DCMotor
    saturation_effort: Any = None
    actuator_velocity_limit: Any = None


class IdealPdActuator:
    def __init__(self, cfg, entity, target_ids, target_names):
        self.cfg, self.entity = cfg, entity
        self.target_ids, self.target_names = target_ids, target_names

    def compute(self, cmd):
        raise NotImplementedError("the region's own was to be called")


@dataclasses.dataclass(kw_only=True)
class IdealPdActuatorCfg:
    target_names_expr: tuple
    stiffness: float
    damping: float
    effort_limit: float = float("inf")
    armature: Any = None
    frictionloss: Any = None


module("isaaclab")
isaaclab_actuators = module(
    "isaaclab.actuators",
    IdealPDActuator=IdealPDActuator,
    IdealPDActuatorCfg=IdealPDActuatorCfg,
    DCMotorCfg=DCMotorCfg,
)
module("mjlab")
module("mjlab.actuator", IdealPdActuator=IdealPdActuator, IdealPdActuatorCfg=IdealPdActuatorCfg)
