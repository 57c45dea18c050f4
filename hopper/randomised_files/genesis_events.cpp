// SPDX-License-Identifier: Apache-2.0
// Calls: Genesis, entity_accessor.py @ 637426fb: set_mass_shift (kg, of links), set_COM_shift (m),
// set_friction_ratio, set_dofs_frictionloss, each with a row for each environment. Its mass shift
// leaves the inertia; degrees of freedom differ by environment with RigidOptions.batch_dofs_info
// alone.
#include "hopper/randomised_files/every_event_writer.hpp"
#include "hopper/randomised_files/python_terms.hpp"

namespace torquewright::hopper::event_writers {
namespace {

constexpr std::string_view kFunction = R"(

def randomise(entity, envs, friction=1.0):
    """Draws the robots of some environments, by their indices; behind set_up().

    friction: the coefficient that the entity has. RigidOptions(batch_dofs_info=True).
    """
    import torch

    count = len(envs)

    def drawn(low, high):
        return low + (high - low) * torch.rand(count)

    factors = {name: torch.ones(count) for name in MASS_KG}
    if TOTAL_MASS_FACTOR is not None:
        shared = drawn(*TOTAL_MASS_FACTOR)
        factors = {name: shared for name in MASS_KG}
    for name, low, high in MASS_FACTOR:
        factors[name] = factors[name] * drawn(low, high)
    links = [entity.get_link(name).idx_local for name in MASS_KG]
    if TOTAL_MASS_FACTOR is not None or MASS_FACTOR:
        shifts = [MASS_KG[name] * (factors[name] - 1.0) for name in MASS_KG]
        entity.set_mass_shift(torch.stack(shifts, 1), links, envs)
    if CENTER_OF_MASS_M:
        moved = {name: [torch.zeros(count) for _ in range(3)] for name, *_ in CENTER_OF_MASS_M}
        for name, axis, low, high in CENTER_OF_MASS_M:
            moved[name][axis] = drawn(low, high)
        shifts = torch.stack([torch.stack(axes, 1) for axes in moved.values()], 1)
        places = [entity.get_link(name).idx_local for name in moved]
        entity.set_COM_shift(shifts, places, envs)
    if DRY_FRICTION_NM:
        names = [name for name, *_ in DRY_FRICTION_NM]
        values = [JOINTS[name]["dry_Nm"] + drawn(low, high) for name, low, high in DRY_FRICTION_NM]
        entity.set_dofs_frictionloss(torch.stack(values, 1), dofs_of(entity, names), envs)
    if GROUND_FRICTION is not None:
        ratio = drawn(*GROUND_FRICTION) / friction
        entity.set_friction_ratio(torch.stack([ratio] * len(links), 1), links, envs)


def motor_strength(count):
    """Factors of DRIVEN on what their motors make, a row each environment: apply(..., strength=...)."""
    import torch

    ranges = {name: (low, high) for name, low, high in MOTOR_STRENGTH}
    ends = [ranges.get(name, (1.0, 1.0)) for name in DRIVEN]
    return torch.stack([low + (high - low) * torch.rand(count) for low, high in ends], 1)
)";

std::string masses(const Robot& robot) {
  std::string text = "MASS_KG = {\n";
  for (const dynamics::Body& body : robot.tree.bodies) {
    if (body.inertia.mass_kg <= 0.0) continue;
    text += fmt::format("    {}: {},\n", actuator::python_string(body.name), body.inertia.mass_kg);
  }
  return text + "}\n";
}

EventText write(const DrawnParts& parts, const Robot& robot) {
  const Randomisation& stated = *parts.stated;
  EventText written;
  written.text =
      masses(robot) + python_pair_or_none("TOTAL_MASS_FACTOR", stated.total_mass_factor) +
      python_rows("MASS_FACTOR", parts.mass_factor) + python_shift_rows(parts.center_of_mass_m) +
      python_rows("MOTOR_STRENGTH", parts.strength_factor) +
      python_rows("DRY_FRICTION_NM", parts.dry_friction_Nm) +
      python_pair_or_none("GROUND_FRICTION", stated.friction_coefficient) + std::string(kFunction);
  std::vector<std::string>& left_out = written.left_out;
  if (!parts.inertia_factor.empty()) {
    left_out.emplace_back("body_inertia_factor: no call changes an inertia for one environment");
  }
  if (!parts.gain_factor.empty()) {
    left_out.emplace_back(
        "controller_gain_factor: gains are servo()'s: multiply what it answers by a draw");
  }
  if (stated.bus_voltage_factor) {
    left_out.push_back(fmt::format(
        "bus_voltage_factor {}: apply(..., voltage=...) takes it, a number for each environment",
        python_pair(*stated.bus_voltage_factor)));
  }
  if (stated.restitution) left_out.emplace_back("restitution: Genesis' rigid contacts have none");
  if (!parts.start_position_rad.empty() || !parts.start_velocity_rad_s.empty()) {
    left_out.emplace_back("initial joint positions and velocities: the environment's reset");
  }
  return written;
}

}  // namespace

const EventWriter genesis_events = {
    .formats = {"genesis"},
    .source =
        "https://github.com/Genesis-Embodied-AI/Genesis "
        "genesis/engine/entities/rigid_entity/impl/entity_accessor.py @ 637426fb",
    .advice =
        "randomise(entity, envs) at reset, of a scene built with "
        "RigidOptions(batch_dofs_info=True); motor_strength(count) once, for apply(). Friction of "
        "a contact is the greater of both geoms': "
        "the ground's has to be less.",
    .write = write,
};

}  // namespace torquewright::hopper::event_writers
