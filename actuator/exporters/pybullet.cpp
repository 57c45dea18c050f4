// SPDX-License-Identifier: Apache-2.0
// Calls: bulletphysics/bullet3, examples/pybullet/pybullet.c @ 8af62239: setJointMotorControl2(
// bodyUniqueId, jointIndex, controlMode, targetVelocity, force), setJointMotorControlArray(...,
// forces), getJointStates, changeDynamics(bodyUniqueId, linkIndex, jointDamping). Law: PyBullet
// Quickstart Guide, setJointMotorControl2: torque control is an external torque for one step; every
// joint has a velocity motor, a constraint of no more than its force, which is to be switched off
// with force 0, or left as the joint's friction with little. jointDamping: issues 1815 and 1916,
// which say that it acts explicitly: much of it is unstable. N m, N m s/rad.
#include <fmt/format.h>

#include "actuator/exporters/every_exporter.hpp"
#include "actuator/exporters/python_module.hpp"
#include "actuator/exporters/table_law.hpp"

namespace torquewright::actuator::exporters {
namespace {

std::string damping_line(const std::optional<JointFriction>& friction) {
  if (!friction) return "";
  return fmt::format("        bullet.changeDynamics(body, joint, jointDamping={})\n",
                     friction->viscous_Nm_s_rad);
}

std::string functions(const std::optional<JointFriction>& friction) {
  return fmt::format(R"(

def set_up(bullet, body, joints):
    """Once: PyBullet's own velocity motor of each joint becomes its dry friction.

    bullet is the module pybullet, or a client of bullet_client; joints are indices.
    """
    for joint in joints:
        bullet.setJointMotorControl2(
            body, joint, bullet.VELOCITY_CONTROL, targetVelocity=0.0, force={}
        )
{}

def apply(bullet, body, joints, torques, voltage=None, temperature=None):
    """Before each step: what the motors can have of the torques [Nm] at their speeds. Returns it."""
    import numpy

    velocities = numpy.asarray([state[1] for state in bullet.getJointStates(body, joints)])
    within = REGION.clip(numpy.asarray(torques, dtype=float), velocities, voltage, temperature)
    bullet.setJointMotorControlArray(body, joints, bullet.TORQUE_CONTROL, forces=within.tolist())
    return within
)",
                     friction ? friction->coulomb_Nm : 0.0, damping_line(friction));
}

std::string write(const Subject& subject, std::span<const double> shape,
                  const std::vector<std::string>& note) {
  return python_module(subject, shape, note,
                       {.methods = "", .functions = functions(subject.friction)});
}

}  // namespace

const Exporter pybullet = {
    .name = "pybullet",
    .simulator = "PyBullet, TORQUE_CONTROL",
    .source =
        "https://github.com/bulletphysics/bullet3 examples/pybullet/pybullet.c @ 8af62239; "
        "PyBullet Quickstart Guide, setJointMotorControl2",
    .advice =
        "set_up(pybullet, body, joints) once, apply(pybullet, body, joints, torques) before each "
        "stepSimulation: a torque lasts one step. PyBullet has no armature: add it to the link's "
        "inertia about the axis (changeDynamics, localInertiaDiagonal). Bullet damps every body by "
        "0.04 unless linearDamping and angularDamping are 0.",
    .parameters = {},
    .shape = table_shape,
    .law = table_law,
    .write = write,
    .friction =
        {DryFriction::kOneValue,
         "The force of the velocity motor about 0 rad/s is Coulomb's friction at rest and in "
         "motion, a constraint solved by iteration (Quickstart Guide); jointDamping is in Nm "
         "s/rad, takes the place of the URDF's, and acts explicitly (issue 1815): steps must be "
         "short beside the joint's inertia over it.",
         ""},
};

}  // namespace torquewright::actuator::exporters
