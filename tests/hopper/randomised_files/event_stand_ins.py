# SPDX-License-Identifier: Apache-2.0
"""Runs an exported module with stand-ins of what it calls, and prints what it found as JSON.

    event_stand_ins.py isaac-lab|mjlab|playground|newton|genesis MODULE SHARE

SHARE is what every draw gives of its range's width: 0 the least, 1 the greatest."""
import json
import sys
import types

import numpy


def module(name, **members):
    made = types.ModuleType(name)
    made.__dict__.update(members)
    sys.modules[name] = made
    return made


class Named:
    """A function by its name: which ones there are is the simulator's affair."""

    def __init__(self, of):
        self.of = of

    def __getattr__(self, name):
        return f"{self.of}.{name}"


def scene_entity(name, **filters):
    return {"name": name, **filters}


def term(func, mode, params):
    return {"func": func if isinstance(func, str) else func.__name__, "mode": mode,
            "params": params}


def print_events(space):
    print(json.dumps(space["EVENTS"]))


class Indexed:
    def __init__(self, array, index):
        self.array, self.index = array, index

    def _with(self, value):
        changed = numpy.array(self.array.values)
        changed[self.index] = value
        return Array(changed)

    def set(self, value):
        return self._with(value)

    def add(self, value):
        return self._with(self.array.values[self.index] + value)

    def multiply(self, value):
        return self._with(self.array.values[self.index] * value)


class At:
    def __init__(self, array):
        self.array = array

    def __getitem__(self, index):
        return Indexed(self.array, index)


class Array:
    """As much of jax.Array as is called."""

    def __init__(self, values):
        self.values = numpy.array(values, dtype=float)
        self.at = At(self)

    def __mul__(self, factor):
        return Array(self.values * factor)


class Model:
    def __init__(self, **fields):
        self.fields = fields

    def __getattr__(self, name):
        return self.fields[name]

    def tree_replace(self, fields):
        return Model(**{**self.fields, **fields})


def print_drawn(space, share):
    import re

    bodies = ["world"] + re.findall(r'<body name="([^"]*)"', space["MJCF"])
    joints = re.findall(r'<joint name="([^"]*)"', space["MJCF"])
    actuators = re.findall(r'<(?:general|motor) name="([^"]*)"', space["MJCF"])

    class Names:
        @staticmethod
        def body(name):
            return types.SimpleNamespace(id=bodies.index(name))

        @staticmethod
        def joint(name):
            return types.SimpleNamespace(dofadr=[joints.index(name)])

        @staticmethod
        def actuator(name):
            return types.SimpleNamespace(id=actuators.index(name))

    module("mujoco", MjModel=types.SimpleNamespace(from_xml_string=lambda text: Names))
    random = types.SimpleNamespace(
        split=lambda rng: (rng, rng),
        uniform=lambda key, minval, maxval: minval + share * (maxval - minval))
    module("jax", vmap=lambda function: function, random=random,
           tree_util=types.SimpleNamespace(
               tree_map=lambda function, model: Model(**{k: function(v) for k, v in
                                                         model.fields.items()})))
    count = len(bodies)
    model = Model(body_mass=Array([2.0] * count), body_inertia=Array([[1.0, 2.0, 3.0]] * count),
                  body_ipos=Array([[0.0, 0.0, 0.0]] * count),
                  dof_frictionloss=Array([0.1] * len(joints)),
                  geom_friction=Array([[1.0, 0.005, 0.0001]] * 2),
                  actuator_ctrlrange=Array([[-48.0, 48.0]] * 2),
                  actuator_gainprm=Array([[3.0, 0.0, 0.0]] * len(actuators)),
                  actuator_biasprm=Array([[0.0, 0.0, -2.0]] * len(actuators)),
                  actuator_forcerange=Array([[-7.0, 7.0]] * len(actuators)), opt=Array([0.0]))
    drawn, axes = space["domain_randomize"](model, 0)
    print(json.dumps({"bodies": bodies, "joints": joints, "actuators": actuators, "axes": axes.fields,
                      "fields": {name: value.values.tolist()
                                 for name, value in drawn.fields.items()}}))


def print_friction(space, share):
    """add_dry_friction on two joints of an asset."""
    class Tensor:
        def __init__(self, values):
            self.values = numpy.array(values, dtype=float)

        def __getitem__(self, index):
            return self.values[index]

    written = {}
    module("torch", arange=lambda count, device: numpy.arange(count), int=int,
           tensor=lambda values, dtype, device: numpy.array(values),
           rand=lambda rows, columns, device: numpy.full((rows, columns), share))
    data = types.SimpleNamespace(joint_friction_coeff=Tensor([[0.5, 0.6]]),
                                 joint_dynamic_friction_coeff=Tensor([[0.4, 0.5]]),
                                 joint_viscous_friction_coeff=Tensor([[0.01, 0.02]]))
    asset = types.SimpleNamespace(
        device="cpu", num_joints=2, data=data,
        write_joint_friction_coefficient_to_sim_index=lambda **values: written.update(values))

    class Scene(dict):
        num_envs = 1

    class PhysxManager:
        pass

    env = types.SimpleNamespace(scene=Scene(robot=asset),
                                sim=types.SimpleNamespace(physics_manager=PhysxManager))
    space["add_dry_friction"](env, None, types.SimpleNamespace(name="robot", joint_ids=[0, 1]),
                              (0.2, 0.4))
    print(json.dumps({name: numpy.array(value).tolist() for name, value in written.items()}))


def print_strength(space, simulator, share):
    """scale_motor_strength on actuators that give 10 Nm at each joint, twice: a draw takes the
    place of the one before. The joints of two actuators stand mixed in the asset."""
    module("torch", arange=lambda count, device: numpy.arange(count),
           tensor=lambda values, device: numpy.array(values), ones=lambda shape, device: numpy.ones(shape),
           rand=lambda rows, columns, device: numpy.full((rows, columns), share))

    class Actuator:
        applied_effort = None

        def __init__(self, names):
            self.joint_names = self._actuated_names = names

        def compute(self, *arguments, **named):
            torques = numpy.full((1, len(self.joint_names)), 10.0)
            if simulator == "mjlab":
                return torques
            return types.SimpleNamespace(joint_efforts=torques)

    names = ["knee", "ankle_pitch", "free", "ankle_roll"]
    actuators = {"a": Actuator(["knee", "free"]), "b": Actuator(["ankle_pitch", "ankle_roll"])}
    asset = types.SimpleNamespace(
        device="cpu", joint_names=names,
        actuators=list(actuators.values()) if simulator == "mjlab" else actuators)

    class Scene(dict):
        num_envs = 1

    env = types.SimpleNamespace(scene=Scene(robot=asset))
    for _ in range(2):
        for term in space["EVENTS"].values():
            if term["func"] != "scale_motor_strength":
                continue
            wanted = term["params"]["asset_cfg"]["joint_names"]
            space["scale_motor_strength"](
                env, None, types.SimpleNamespace(
                    name="robot", joint_ids=[names.index(name) for name in wanted]),
                term["params"]["strength_range"])
    torques = {}
    for actuator in actuators.values():
        action = actuator.compute(None)
        given = action if simulator == "mjlab" else action.joint_efforts
        torques.update(zip(actuator.joint_names, given[0].tolist()))
    print(json.dumps({"torques": [torques[name] for name in names]}))


class Vec3(list):
    """As warp's: made of three numbers."""

    def __init__(self, x, y, z):
        super().__init__((x, y, z))


def print_newton(space, share):
    """Bodies of 2 kg, joints behind a floating base of six degrees of freedom."""
    names = sys.argv[4:]
    bodies = {name: i for i, name in enumerate(names)}
    joints = {name: i + 1 for i, name in enumerate(("knee", "ankle_pitch", "ankle_roll"))}
    count = len(names)
    builder = types.SimpleNamespace(
        body_mass=[2.0] * count, body_inv_mass=[0.5] * count,
        body_inertia=[numpy.diag([1.0, 2.0, 3.0])] * count,
        body_inv_inertia=[numpy.diag([1.0, 0.5, 1.0 / 3.0])] * count,
        body_com=[Vec3(0.0, 0.0, 0.0)] * count,
        joint_qd_start=[0, 6, 7, 8], joint_friction=[0.1] * 9,
        shape_material_mu=[1.0] * 2, shape_material_restitution=[0.5] * 2)
    random = types.SimpleNamespace(uniform=lambda low, high: low + share * (high - low))
    space["randomise"](builder, bodies, joints, random)
    print(json.dumps({"strength": space["motor_strength"](random),
                      **{name: numpy.array(value).tolist()
                         for name, value in vars(builder).items()}}))


class GenesisEntity:
    def __init__(self, bodies):
        self.bodies, self.calls = bodies, {}

    def get_link(self, name=None, uid=None):
        return types.SimpleNamespace(idx_local=self.bodies.index(name))

    def get_joint(self, name=None, uid=None):
        return types.SimpleNamespace(dofs_idx_local=[6 + list(JOINTS).index(name)])

    def _note(self, name, values, places, envs):
        self.calls[name] = [values.tolist(), places, envs]

    def set_mass_shift(self, mass_shift, links_idx_local=None, envs_idx=None):
        self._note("mass", mass_shift, links_idx_local, envs_idx)

    def set_COM_shift(self, com_shift, links_idx_local=None, envs_idx=None):
        self._note("com", com_shift, links_idx_local, envs_idx)

    def set_friction_ratio(self, friction_ratio, links_idx_local=None, envs_idx=None):
        self._note("friction", friction_ratio, links_idx_local, envs_idx)

    def set_dofs_frictionloss(self, frictionloss, dofs_idx_local=None, envs_idx=None):
        self._note("frictionloss", frictionloss, dofs_idx_local, envs_idx)


JOINTS = {"knee": {"dry_Nm": 0.1}, "ankle_pitch": {"dry_Nm": 0.2}, "ankle_roll": {"dry_Nm": 0.3}}


def print_genesis(space, share):
    """Two environments; JOINTS and dofs_of are the module's, in front of this."""
    module("torch", rand=lambda count: numpy.full(count, share), ones=numpy.ones,
           zeros=numpy.zeros, stack=lambda arrays, axis: numpy.stack(arrays, axis))
    space["DRIVEN"] = ["knee", "ankle_roll", "other"]
    entity = GenesisEntity(list(space["MASS_KG"]))
    space["randomise"](entity, [3, 5], friction=0.5)
    print(json.dumps({"bodies": entity.bodies, "masses": space["MASS_KG"],
                      "strength": space["motor_strength"](2).tolist(), **entity.calls}))


def main():
    simulator, file, share = sys.argv[1], sys.argv[2], float(sys.argv[3])
    for name in ("isaaclab", "isaaclab.actuators", "mjlab", "mjlab.actuator", "mjlab.managers"):
        module(name).__getattr__ = lambda name: lambda **values: values
    module("isaaclab.envs", mdp=Named("mdp"))
    module("isaaclab.managers", EventTermCfg=term, SceneEntityCfg=scene_entity)
    module("mjlab.envs", mdp=Named("mdp"))
    module("mjlab.envs.mdp", dr=Named("dr"))
    module("mjlab.managers.event_manager", EventTermCfg=term)
    module("mjlab.managers.scene_entity_config", SceneEntityCfg=scene_entity)
    space = {"JOINTS": JOINTS, "dofs_of": lambda entity, names: [
        entity.get_joint(name).dofs_idx_local[0] for name in names]}
    with open(file, encoding="utf-8") as text:
        exec(text.read(), space)
    special = {"playground": print_drawn, "newton": print_newton, "genesis": print_genesis}
    if simulator in special:
        special[simulator](space, share)
    else:
        print_events(space)
    if "add_dry_friction" in space:
        print_friction(space, share)
    if "scale_motor_strength" in space:
        print_strength(space, simulator, share)


main()
