# SPDX-License-Identifier: Apache-2.0
"""Runs modules of whole robots with stand-ins for the simulators that they call (no part of them),
and prints what those were given, as JSON.

    region_module_stand_ins.py FOLDER

FOLDER holds genesis.py, pybullet.py, isaac_gym.py, which are exported modules, and samples.json:
joints (names of all of the robot's), torque_Nm, velocity_rad_s and position_rad, a row a sample of
a number a joint. Signatures are those of the sources that robot/simulators names. Each stand-in has
its joints in another order than the module, and one that the module does not know in front."""

import importlib.util
import json
import pathlib
import sys
import types

import numpy

folder = pathlib.Path(sys.argv[1])
samples = json.loads((folder / "samples.json").read_text())
names = samples["joints"]
torque = numpy.asarray(samples["torque_Nm"])
velocity = numpy.asarray(samples["velocity_rad_s"])
position = numpy.asarray(samples["position_rad"])


def loaded(name):
    spec = importlib.util.spec_from_file_location("of_" + name, folder / (name + ".py"))
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def of_names(array, wanted):
    return array[..., [names.index(name) for name in wanted]]


class GenesisJoint:
    def __init__(self, name, dof):
        self.name, self.dofs_idx_local = name, [dof]


class GenesisEntity:
    """Local degrees of freedom: six of the base, then the joints backwards."""

    def __init__(self, morph):
        self.morph, self.written, self.force = morph, {}, None
        self.order = list(reversed(names))

    def get_joint(self, name=None, uid=None):
        return GenesisJoint(name, 6 + self.order.index(name))

    def _write(self, field, values, dofs):
        for value, dof in zip(values, dofs):
            self.written.setdefault(self.order[dof - 6], {})[field] = value

    def set_dofs_damping(self, damping, dofs_idx_local=None, envs_idx=None):
        self._write("damping", damping, dofs_idx_local)

    def set_dofs_frictionloss(self, frictionloss, dofs_idx_local=None, envs_idx=None):
        self._write("frictionloss", frictionloss, dofs_idx_local)

    def set_dofs_armature(self, armature, dofs_idx_local=None, envs_idx=None):
        self._write("armature", armature, dofs_idx_local)

    def set_dofs_kp(self, kp, dofs_idx_local=None, envs_idx=None):
        self._write("kp", kp, dofs_idx_local)

    def set_dofs_kv(self, kv, dofs_idx_local=None, envs_idx=None):
        self._write("kv", kv, dofs_idx_local)

    def set_dofs_force_range(self, lower, upper, dofs_idx_local=None, envs_idx=None):
        self._write("least", lower, dofs_idx_local)
        self._write("greatest", upper, dofs_idx_local)

    def get_dofs_velocity(self, dofs_idx_local=None, envs_idx=None):
        return of_names(velocity, [self.order[dof - 6] for dof in dofs_idx_local])

    def control_dofs_force(self, force, dofs_idx_local=None, envs_idx=None):
        self.force = [force, [self.order[dof - 6] for dof in dofs_idx_local]]


def of_genesis():
    def morph(kind):
        return lambda **given: {"kind": kind, **given}

    morphs = types.SimpleNamespace(URDF=morph("URDF"), MJCF=morph("MJCF"))
    sys.modules["genesis"] = types.SimpleNamespace(morphs=morphs)
    module = loaded("genesis")
    scene = types.SimpleNamespace(add_entity=GenesisEntity)
    entity = module.load(scene, "robot.xml", pos=(0, 0, 1))
    module.set_up(entity)
    module.apply(entity, of_names(torque, module.DRIVEN))
    driven = of_names(position, module.DRIVEN)
    return {
        "driven": module.DRIVEN,
        "morphs": [entity.morph, module.load(scene, "robot.urdf").morph],
        "written": entity.written,
        "force": entity.force[0].tolist(),
        "forced": entity.force[1],
        "servo": module.servo(driven + 0.01, driven, of_names(velocity, module.DRIVEN)).tolist(),
    }


class Bullet:
    """One sample at a time; joint 0 is a weld that the module does not know."""

    VELOCITY_CONTROL, TORQUE_CONTROL, URDF_USE_INERTIA_FROM_FILE = 0, 1, 2

    def __init__(self):
        self.order = ["weld"] + list(reversed(names))
        self.motors, self.dynamics, self.torques = {}, {}, None
        self.sample = 0

    def loadURDF(self, fileName, basePosition=None, flags=0, useFixedBase=0):
        self.file, self.flags = fileName, flags
        return 7

    def getNumJoints(self, bodyUniqueId, physicsClientId=0):
        return len(self.order)

    def getJointInfo(self, bodyUniqueId, jointIndex, physicsClientId=0):
        return (jointIndex, self.order[jointIndex].encode(), 0)

    def changeDynamics(self, bodyUniqueId, linkIndex, **given):
        self.dynamics.setdefault(linkIndex, {}).update(given)

    def setJointMotorControl2(
        self, bodyUniqueId, jointIndex, controlMode, targetVelocity=None, force=None
    ):
        assert controlMode == self.VELOCITY_CONTROL and targetVelocity == 0.0
        self.motors[self.order[jointIndex]] = force

    def getJointStates(self, bodyUniqueId, jointIndices, physicsClientId=0):
        at = [names.index(self.order[i]) for i in jointIndices]
        return tuple((position[self.sample][i], velocity[self.sample][i], (0.0,) * 6, 0.0) for i in at)

    def setJointMotorControlArray(self, bodyUniqueId, jointIndices, controlMode, forces=None):
        assert controlMode == self.TORQUE_CONTROL
        self.torques = {self.order[i]: force for i, force in zip(jointIndices, forces)}


def of_pybullet():
    module, bullet = loaded("pybullet"), Bullet()
    body = module.load(bullet, "robot.urdf", useFixedBase=1)
    module.set_up(bullet, body)
    given = []
    for bullet.sample in range(len(torque)):
        module.apply(bullet, body, of_names(torque[bullet.sample], module.DRIVEN))
        given.append(bullet.torques)
    return {
        "flags": bullet.flags,
        "motors": bullet.motors,
        "dynamics": {
            "base" if link < 0 else bullet.order[link]: given
            for link, given in bullet.dynamics.items()
        },
        "torques": given,
    }


def of_isaac_gym():
    gymapi = types.ModuleType("isaacgym.gymapi")
    gymapi.DOF_MODE_EFFORT, gymapi.AssetOptions = 3, types.SimpleNamespace
    package = types.ModuleType("isaacgym")
    package.gymapi = gymapi
    sys.modules.update({"isaacgym": package, "isaacgym.gymapi": gymapi})
    order = list(reversed(names))
    fields = "lower upper velocity effort stiffness damping friction armature".split()
    kinds = [("hasLimits", "?"), ("driveMode", "i4")] + [(name, "f4") for name in fields]
    properties = numpy.zeros(len(order), dtype=kinds)
    for name in ("stiffness", "damping", "friction"):
        properties[name] = 0.5

    class Gym:
        def load_asset(self, sim, root, file, options):
            return [sim, root, file, vars(options)]

        def get_asset_dof_properties(self, asset):
            return properties

        def get_asset_dof_names(self, asset):
            return order

    module, gym = loaded("isaac_gym"), Gym()
    asset = module.load(gym, "sim", "folder", "robot.urdf", fix_base_link=True)
    assert module.set_dof_properties(gym, asset) is properties
    efforts = module.efforts(
        order, of_names(torque, order), of_names(position, order), of_names(velocity, order)
    )
    back = [order.index(name) for name in names]
    return {
        "asset": asset,
        "properties": {
            name: {field: properties[field][order.index(name)].item() for field, _ in kinds}
            for name in names
        },
        "efforts": efforts[..., back].tolist(),
        "smoothing_rad_s": module.SMOOTHING_RAD_S,
    }


print(
    json.dumps(
        {"genesis": of_genesis(), "pybullet": of_pybullet(), "isaac_gym": of_isaac_gym()}
    )
)
