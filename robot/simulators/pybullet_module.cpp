// SPDX-License-Identifier: Apache-2.0
// Calls: bulletphysics/bullet3, examples/pybullet/pybullet.c @ 8af62239: loadURDF(fileName, flags),
// getNumJoints, getJointInfo (index 0, name 1 in bytes, type 2), changeDynamics (linearDamping,
// angularDamping, jointDamping, maxJointVelocity), setJointMotorControl2,
// setJointMotorControlArray, getJointStates (position 0, velocity 1). URDF_USE_INERTIA_FROM_FILE:
// otherwise inertias are those of collision shapes. btMultiBody starts with damping 0.04 and holds
// every speed to 100. Joints have no springs and no armature (actuator/exporters/pybullet.cpp).
#include "actuator/exporters/every_exporter.hpp"
#include "robot/simulators/every_region_module.hpp"

namespace torquewright::hopper::region_modules {

const RegionModule pybullet = {
    .exporter = &actuator::exporters::pybullet,
    .source =
        "https://github.com/bulletphysics/bullet3 examples/pybullet/pybullet.c @ 8af62239; "
        "src/BulletDynamics/Featherstone/btMultiBody.cpp @ adcaa757",
    .advice =
        "body = load(pybullet, FILE) with the robot's URDF, set_up(pybullet, body); then "
        "apply(pybullet, body, torques) before each stepSimulation. What set_up() writes takes the "
        "place of the file's damping. PyBullet has no armature: of JOINTS' armature_kg_m2 each "
        "joint lacks its own, times its acceleration in Nm. Dry friction at rest is that in "
        "motion.",
    .functions = R"(

FASTEST_RAD_S = 1e4  # no limit: Bullet would hold every joint to 100


def load(bullet, file, **options):
    """Loads the robot's URDF with its own inertias and without Bullet's damping of bodies."""
    body = bullet.loadURDF(str(file), **{"flags": bullet.URDF_USE_INERTIA_FROM_FILE, **options})
    for link in range(-1, bullet.getNumJoints(body)):
        bullet.changeDynamics(body, link, linearDamping=0.0, angularDamping=0.0)
    return body


def indices_of(bullet, body, names=DRIVEN):
    """Indices of the joints in the body."""
    found = {}
    for index in range(bullet.getNumJoints(body)):
        found[bullet.getJointInfo(body, index)[1].decode()] = index
    return [found[name] for name in names]


def set_up(bullet, body):
    """Once: friction and damping of every joint; Bullet's own motors hold nothing else."""
    for name, index in zip(JOINTS, indices_of(bullet, body, JOINTS)):
        joint = JOINTS[name]
        bullet.setJointMotorControl2(
            body, index, bullet.VELOCITY_CONTROL, targetVelocity=0.0, force=joint["dry_Nm"]
        )
        bullet.changeDynamics(
            body,
            index,
            jointDamping=joint["viscous_Nm_s_rad"],
            maxJointVelocity=FASTEST_RAD_S,
        )


def states_of(bullet, body, names=DRIVEN):
    """Positions and velocities of joints, as arrays."""
    import numpy

    states = bullet.getJointStates(body, indices_of(bullet, body, names))
    return tuple(numpy.asarray([state[i] for state in states], dtype=float) for i in (0, 1))


def apply(bullet, body, torques, voltage=None, temperature=None):
    """Before each step: what the motors can have of the torques [Nm] of DRIVEN, and the springs.
    Returns the former."""
    import numpy

    _, velocities = states_of(bullet, body)
    reached = within(numpy.asarray(torques, dtype=float), velocities, voltage, temperature)
    total = dict(zip(DRIVEN, reached.tolist()))
    sprung = [name for name in JOINTS if JOINTS[name]["spring"] is not None]
    for name, position in zip(sprung, states_of(bullet, body, sprung)[0] if sprung else ()):
        stiffness, rest = JOINTS[name]["spring"]
        total[name] = total.get(name, 0.0) - stiffness * (float(position) - rest)
    bullet.setJointMotorControlArray(
        body,
        indices_of(bullet, body, total),
        bullet.TORQUE_CONTROL,
        forces=list(total.values()),
    )
    return reached
)",
};

}  // namespace torquewright::hopper::region_modules
