# SPDX-License-Identifier: Apache-2.0
"""Runs exported modules with stand-ins for the simulators that they call (no part of them), and
prints what those were given, as JSON.

simulator_calls.py FOLDER: pybullet.py, isaac_gym.py, genesis.py, playground.py and native.py, which
are exported modules, other.py, a second native one, and samples.json (torque_Nm, velocity_rad_s).
Signatures are those of the sources that the exporters' files name."""

import importlib.util
import json
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import numpy
import simulator_classes
import warp_and_newton

folder = pathlib.Path(sys.argv[1])
samples = json.loads((folder / "samples.json").read_text())
torque, velocity = numpy.asarray(samples["torque_Nm"]), numpy.asarray(samples["velocity_rad_s"])
count = len(torque)


def loaded(name):
    spec = importlib.util.spec_from_file_location("of_" + name, folder / (name + ".py"))
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


class Bullet:
    VELOCITY_CONTROL, TORQUE_CONTROL = 0, 1

    def __init__(self):
        self.motors, self.damping, self.torques = {}, {}, None

    def setJointMotorControl2(
        self,
        bodyUniqueId,
        jointIndex,
        controlMode,
        targetPosition=None,
        targetVelocity=None,
        force=None,
        positionGain=None,
        velocityGain=None,
        maxVelocity=None,
        physicsClientId=0,
    ):
        self.motors[jointIndex] = [bodyUniqueId, controlMode, targetVelocity, force]

    def changeDynamics(self, bodyUniqueId, linkIndex, jointDamping=-1.0, physicsClientId=0):
        self.damping[linkIndex] = jointDamping

    def getJointStates(self, bodyUniqueId, jointIndices, physicsClientId=0):
        return tuple((0.0, float(velocity[i]), (0.0,) * 6, 0.0) for i in jointIndices)

    def setJointMotorControlArray(
        self,
        bodyUniqueId,
        jointIndices,
        controlMode,
        targetPositions=None,
        targetVelocities=None,
        forces=None,
        positionGains=None,
        velocityGains=None,
        physicsClientId=0,
    ):
        assert controlMode == self.TORQUE_CONTROL and list(jointIndices) == list(range(count))
        self.torques = forces


def of_pybullet():
    module, bullet, joints = loaded("pybullet"), Bullet(), list(range(count))
    module.set_up(bullet, 7, joints)
    returned = module.apply(bullet, 7, joints, torque.tolist())
    assert returned.tolist() == bullet.torques
    return {"motor": bullet.motors[3], "damping": bullet.damping, "torque_Nm": bullet.torques}


def of_isaac_gym():
    simulator_classes.module(
        "isaacgym", gymapi=simulator_classes.module("isaacgym.gymapi", DOF_MODE_EFFORT=3)
    )
    fields = "lower upper velocity effort stiffness damping friction armature".split()
    kinds = [("hasLimits", "?"), ("driveMode", "i4")] + [(name, "f4") for name in fields]
    properties = numpy.zeros(4, dtype=kinds)
    properties["friction"] = 0.5
    module = loaded("isaac_gym")
    assert module.set_dof_properties(properties, [1, 3]) is properties
    return {
        "properties": {name: properties[name].tolist() for name, _ in kinds},
        "torque_Nm": module.efforts(torque, velocity).tolist(),
        "smoothing_rad_s": module.REGION.smoothing_rad_s,
    }


class Entity:
    def __init__(self):
        self.calls = {}

    def set_dofs_force_range(self, lower, upper, dofs_idx_local=None, envs_idx=None):
        self.calls["force_range"] = [lower, upper, dofs_idx_local]

    def set_dofs_armature(self, armature, dofs_idx_local=None, envs_idx=None):
        self.calls["armature"] = [armature, dofs_idx_local]

    def set_dofs_damping(self, damping, dofs_idx_local=None, envs_idx=None):
        self.calls["damping"] = [damping, dofs_idx_local]

    def set_dofs_frictionloss(self, frictionloss, dofs_idx_local=None, envs_idx=None):
        self.calls["frictionloss"] = [frictionloss, dofs_idx_local]

    def get_dofs_velocity(self, dofs_idx_local=None, envs_idx=None):
        return velocity

    def control_dofs_force(self, force, dofs_idx_local=None, envs_idx=None):
        self.calls["force"] = force.tolist()


def of_genesis():
    module, entity = loaded("genesis"), Entity()
    module.set_up(entity, [6, 7])
    module.apply(entity, [6, 7], torque)
    return entity.calls


class Controls(numpy.ndarray):
    """Arrays with JAX's at[...].set(...)."""

    @property
    def at(self):
        return self

    def __getitem__(self, places):
        found = numpy.asarray(self)[places]
        return Place(self, places) if isinstance(places, list) else found


class Place:
    def __init__(self, array, places):
        self.array, self.places = array, places

    def set(self, values):
        changed = numpy.array(self.array)
        changed[self.places] = values
        return changed.view(Controls)


class Data:
    def __init__(self, qvel, ctrl):
        self.qvel, self.ctrl = qvel, ctrl

    def replace(self, **changes):
        return Data(**{"qvel": self.qvel, "ctrl": self.ctrl, **changes})


def of_playground():
    def scan(function, carry, xs, length):
        for _ in range(length):
            carry, _ = function(carry, None)
        return carry, None

    given = []

    def mjx_step(model, data):
        assert model == "model"
        given.append(numpy.asarray(data.ctrl).tolist())
        return data.replace(qvel=data.qvel + 1.0)  # so that the next substep is another

    lax = simulator_classes.module("jax.lax", scan=scan)
    simulator_classes.module("jax", lax=lax)
    simulator_classes.module("mujoco", mjx=simulator_classes.module("mujoco.mjx", step=mjx_step))
    module = loaded("playground")
    data = Data(numpy.asarray([0.0, 23.5, -24.0]), numpy.asarray([5.0, 6.0, 7.0]).view(Controls))
    data = module.step("model", data, numpy.asarray([100.0, -100.0]), [0, 2], [1, 2], n_substeps=2)
    return {
        "torque_Nm": module.controls(torque, velocity).tolist(),
        "given": given,
        "mjcf": module.MJCF,
    }


def of_native():
    """Isaac Lab's way: a configuration becomes a prim, and Newton's parser asks who reads it."""
    module, other = loaded("native"), loaded("other")
    cfg = module.REGION.isaac_lab_native([".*knee.*"], stiffness=20.0, damping=0.5)
    other.REGION.isaac_lab_native([".*hip.*"], stiffness=1.0, damping=0.0)
    module.REGION.register_with_newton()  # twice is once
    answer = {"fields": dict(vars(cfg))}
    answer["class"] = answer["fields"].pop("class_type").__name__
    numbers = {
        "saturation_effort": cfg.saturation_effort,
        "velocity_limit": cfg.actuator_velocity_limit,
        "max_motor_effort": cfg.actuator_effort_limit,
    }
    single = {name: float(numpy.float32(value)) for name, value in numbers.items()}
    answer["torque_Nm"] = warp_and_newton.clamped(single, torque, velocity)
    answer["other_Nm"] = warp_and_newton.clamped(other.REGION.newton_arguments(), torque, velocity)
    plain = {"saturation_effort": 100.0, "velocity_limit": 10.0, "max_motor_effort": 50.0}
    answer["plain_Nm"] = warp_and_newton.clamped(plain, torque, velocity)
    answer["registered"] = warp_and_newton.registered
    answer["smoothing_rad_s"] = module.REGION.smoothing_rad_s
    clash = loaded("native").REGION
    clash.name, clash.table = "clash", dict(clash.table, rest_Nm=[-1.0, 1.0])
    try:
        clash.register_with_newton()
    except ValueError as error:
        answer["refused"] = str(error)
    return answer


print(
    json.dumps(
        {
            "pybullet": of_pybullet(),
            "isaac_gym": of_isaac_gym(),
            "genesis": of_genesis(),
            "playground": of_playground(),
            "native": of_native(),
        }
    )
)
