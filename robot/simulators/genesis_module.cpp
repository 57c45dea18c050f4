// SPDX-License-Identifier: Apache-2.0
// Calls: Genesis, genesis/engine/entities/rigid_entity/impl/entity_accessor.py @ 637426fb
// (get_joint, set_dofs_kp, set_dofs_kv, set_dofs_force_range, set_dofs_armature, set_dofs_damping,
// set_dofs_frictionloss, control_dofs_force), rigid_joint.py @ b0fa7990 (dof_idx_local, later the
// list dofs_idx_local). Morphs of MJCF and URDF give every joint an armature of 0.1 kg m^2 unless
// default_armature is None (genesis/options/morphs.py of genesis-world @ 906bc750). Springs of an
// MJCF stay the entity's.
#include "actuator/exporters/every_exporter.hpp"
#include "robot/simulators/every_region_module.hpp"

namespace torquewright::hopper::region_modules {

const RegionModule genesis = {
    .exporter = &actuator::exporters::genesis,
    .source =
        "https://github.com/Genesis-Embodied-AI/Genesis "
        "genesis/engine/entities/rigid_entity/impl/entity_accessor.py @ 637426fb, rigid_joint.py @ "
        "b0fa7990",
    .advice =
        "entity = load(scene, FILE) with the robot's MJCF or URDF, scene.build(), set_up(entity); "
        "then apply(entity, torques) or apply(entity, servo(...)) before each scene.step(). What "
        "set_up() writes takes the place of the file's friction, damping, armature and gains. A "
        "joint whose armature nobody states has none.",
    .functions = R"(

def load(scene, file, **morph):
    """Adds the robot's file to a scene that is not built yet, without armatures of the morph's."""
    import genesis

    kind = genesis.morphs.URDF if str(file).endswith(".urdf") else genesis.morphs.MJCF
    return scene.add_entity(kind(file=str(file), **{"default_armature": None, **morph}))


def dofs_of(entity, names=DRIVEN):
    """Local indices of the joints' degrees of freedom."""
    dofs = []
    for name in names:
        joint = entity.get_joint(name)
        listed = getattr(joint, "dofs_idx_local", None)
        dofs.append(joint.dof_idx_local if listed is None else listed[0])
    return dofs


def set_up(entity):
    """Once, of a scene that is built: what the joints have themselves and of their drives."""

    def write(setter, key, known=lambda value: value is not None, of=lambda value: value):
        names = [name for name in JOINTS if known(JOINTS[name][key])]
        if names:
            setter([of(JOINTS[name][key]) for name in names], dofs_of(entity, names))

    write(entity.set_dofs_damping, "viscous_Nm_s_rad")
    write(entity.set_dofs_frictionloss, "dry_Nm")
    write(entity.set_dofs_armature, "armature_kg_m2")
    write(entity.set_dofs_kp, "gains", of=lambda gains: gains[0])
    write(entity.set_dofs_kv, "gains", of=lambda gains: gains[1])
    peaks = [JOINTS[name]["peak_torque_Nm"] for name in DRIVEN]
    entity.set_dofs_force_range([-peak for peak in peaks], peaks, dofs_of(entity))


def apply(entity, torques, voltage=None, temperature=None, strength=1.0):
    """Before each step: what the motors can have of the torques [Nm] of DRIVEN. Returns it.

    strength: factors on what they then make, a number or one for each environment and joint.
    """
    dofs = dofs_of(entity)
    reached = strength * within(torques, entity.get_dofs_velocity(dofs), voltage, temperature)
    entity.control_dofs_force(reached, dofs)
    return reached
)",
    .holds_springs = true,
};

}  // namespace torquewright::hopper::region_modules
