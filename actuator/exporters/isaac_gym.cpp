// SPDX-License-Identifier: Apache-2.0
// Fields: Isaac Gym, GymDofProperties, the array of get_asset_dof_properties and
// set_actor_dof_properties
// (forums.developer.nvidia.com/t/carb-gymdofproperties-documentation/196552, by its makers):
// velocity and effort are the greatest (rad/s, N m), armature is added to the joint-space inertia,
// and friction is a coefficient by which the joint's force is multiplied, no torque. In
// DOF_MODE_EFFORT stiffness and damping act passively (isaac-sim/IsaacGymEnvs,
// isaacgymenvs/tasks/factory/factory_base.py @ 18465747: "zero passive damping"). So what drags is
// taken off the torque that is set.
#include <fmt/format.h>

#include "actuator/exporters/every_exporter.hpp"
#include "actuator/exporters/python_module.hpp"
#include "actuator/exporters/table_law.hpp"

namespace torquewright::actuator::exporters {
namespace {

std::string functions(bool has_friction) {
  return fmt::format(R"(

def set_dof_properties(properties, dofs):
    """Writes what the simulator's joints have of this drive into an array of DOF properties.

    properties is what get_asset_dof_properties gives, dofs are indices; hand it to
    set_actor_dof_properties. Returns it.
    """
    from isaacgym import gymapi

    values = {{
        "driveMode": int(gymapi.DOF_MODE_EFFORT),
        "effort": REGION.{0},
        "velocity": 2.0 * REGION.table["speed_rad_s"][-1],  # no limit of the motor's
        "stiffness": 0.0,
        "damping": 0.0,
        "friction": 0.0,
    }}
    if REGION.armature_kg_m2 is not None:
        values["armature"] = REGION.armature_kg_m2
    for name, value in values.items():
        for dof in dofs:
            properties[name][dof] = value
    return properties


def efforts(torques, velocities, voltage=None, temperature=None):
    """What set_dof_actuation_force_tensor is to have [Nm] of torques [Nm] that are commanded.

    Tensors of one shape, velocities [rad/s]; before each step of the simulation.
    """
    return REGION.{1}(torques, velocities, voltage, temperature)
)",
                     has_friction ? "joint_peak_torque_Nm" : "peak_torque_Nm",
                     has_friction ? "torque" : "clip");
}

std::string write(const Subject& subject, std::span<const double> shape,
                  const std::vector<std::string>& note) {
  return python_module(subject, shape, note,
                       {.methods = "",
                        .functions = functions(subject.friction.has_value()),
                        .composes_friction = true});
}

}  // namespace

const Exporter isaac_gym = {
    .name = "isaac-gym",
    .simulator = "Isaac Gym Preview 4, GymDofProperties",
    .source =
        "https://forums.developer.nvidia.com/t/carb-gymdofproperties-documentation/196552; "
        "https://github.com/isaac-sim/IsaacGymEnvs factory_base.py @ 18465747",
    .advice =
        "set_dof_properties(properties, dofs) once for each actor; efforts(torques, velocities) "
        "before each simulate, as in legged_gym's _compute_torques. Import isaacgym before torch.",
    .parameters = {},
    .shape = table_shape,
    .law = table_law,
    .write = write,
    .friction =
        {DryFriction::kComposed,
         "The simulator's own friction is a coefficient on the joint's force, no torque, and stays "
         "0: efforts() is the drive's law, the command clipped as the motor is, less friction, "
         "through the gear. Dry friction turns over with tanh(velocity / smoothing_rad_s) and "
         "holds "
         "nothing at rest; what turns on the angle is left out.",
         "set_dof_properties(properties, dofs) once for each actor; efforts(torques, velocities) "
         "before each simulate, as in legged_gym's _compute_torques. Import isaacgym before torch. "
         "Explicit friction needs a step shorter than the joint's inertia times smoothing_rad_s "
         "over the dry torque: make REGION.smoothing_rad_s larger where it is not."},
};

}  // namespace torquewright::actuator::exporters
