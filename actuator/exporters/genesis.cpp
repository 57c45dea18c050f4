// SPDX-License-Identifier: Apache-2.0
// Calls: Genesis, genesis/engine/entities/rigid_entity/impl/entity_accessor.py @ 637426fb:
// set_dofs_force_range(lower, upper, dofs_idx_local), set_dofs_armature, set_dofs_damping,
// set_dofs_frictionloss, get_dofs_velocity, control_dofs_force(force, dofs_idx_local). Law: the
// force that is controlled is clamped to the force range in each step, whatever the speed (its
// rigid solver's func_compute_qf); friction loss is a constraint as MuJoCo's
// (add_frictionloss_constraints), whose time is RigidOptions.constraint_timeconst, of no less than
// two steps. N m, N m s/rad, kg m^2.
#include <fmt/format.h>

#include "actuator/exporters/every_exporter.hpp"
#include "actuator/exporters/python_module.hpp"
#include "actuator/exporters/table_law.hpp"

namespace torquewright::actuator::exporters {
namespace {

std::string friction_lines(const std::optional<JointFriction>& friction) {
  if (!friction) return "";
  return fmt::format(R"(    entity.set_dofs_frictionloss([{}] * count, dofs)
    entity.set_dofs_damping([{}] * count, dofs)
)",
                     friction->coulomb_Nm, friction->viscous_Nm_s_rad);
}

std::string functions(const std::optional<JointFriction>& friction) {
  return fmt::format(R"(

def set_up(entity, dofs):
    """Once, of a scene that is built: what the joints have of this drive. dofs are local indices."""
    count = len(dofs)
    peak = REGION.peak_torque_Nm
    entity.set_dofs_force_range([-peak] * count, [peak] * count, dofs)
    if REGION.armature_kg_m2 is not None:
        entity.set_dofs_armature([REGION.armature_kg_m2] * count, dofs)
{})",
                     friction_lines(friction)) +
         R"(

def apply(entity, dofs, torques, voltage=None, temperature=None):
    """Before each step: what the motors can have of the torques [Nm] at their speeds. Returns it.

    torques is a tensor of the shape that get_dofs_velocity gives.
    """
    within = REGION.clip(torques, entity.get_dofs_velocity(dofs), voltage, temperature)
    entity.control_dofs_force(within, dofs)
    return within
)";
}

std::string write(const Subject& subject, std::span<const double> shape,
                  const std::vector<std::string>& note) {
  return python_module(subject, shape, note,
                       {.methods = "", .functions = functions(subject.friction)});
}

}  // namespace

const Exporter genesis = {
    .name = "genesis",
    .simulator = "Genesis, control_dofs_force",
    .source =
        "https://github.com/Genesis-Embodied-AI/Genesis "
        "genesis/engine/entities/rigid_entity/impl/entity_accessor.py @ 637426fb",
    .advice =
        "set_up(entity, dofs) once after scene.build(), apply(entity, dofs, torques) before each "
        "scene.step(): a force that is controlled stays until the next, and its range knows no "
        "speed. With substeps the speed is that of the first.",
    .parameters = {},
    .shape = table_shape,
    .law = table_law,
    .write = write,
    .friction = {DryFriction::kOneValue,
                 "frictionloss and damping take the place of the morph's own; friction loss is "
                 "Coulomb's at "
                 "rest and in motion, a soft constraint as MuJoCo's, whose time is "
                 "RigidOptions.constraint_timeconst: make it two steps.",
                 ""},
};

}  // namespace torquewright::actuator::exporters
