// SPDX-License-Identifier: Apache-2.0
// Terms: Isaac Lab, source/isaaclab/isaaclab/envs/mdp/events.py @ 025ffcd0: randomize_rigid_body_
// mass (a number for each body), _inertia (all nine elements by one), _com (one number for all
// bodies of a term, so that each has its own), randomize_actuator_gains (stiffness and damping
// apart), randomize_rigid_body_material, reset_joints_by_offset. randomize_joint_parameters is left
// alone: on PhysX it draws its friction range a second time for the friction in motion and adds it
// a third time to the viscous coefficient, whose unit is another.
#include "hopper/randomised_files/every_event_writer.hpp"
#include "hopper/randomised_files/python_terms.hpp"

namespace torquewright::hopper::event_writers {
namespace {

constexpr std::string_view kAddDryFriction = R"(

def add_dry_friction(env, env_ids, asset_cfg, friction_range):
    """One number [Nm] on each joint's dry friction at rest and in motion; once, at startup."""
    import torch

    def tensor(value):  # Isaac Lab 3 has arrays of Warp, with tensors at hand
        return getattr(value, "torch", value)

    asset = env.scene[asset_cfg.name]
    if env_ids is None:
        env_ids = torch.arange(env.scene.num_envs, device=asset.device)
    joint_ids = asset_cfg.joint_ids
    if isinstance(joint_ids, slice):
        joint_ids = list(range(asset.num_joints))[joint_ids]
    joint_ids = torch.tensor(joint_ids, dtype=torch.int, device=asset.device)
    rows = env_ids[:, None]
    low, high = friction_range
    further = low + (high - low) * torch.rand(len(env_ids), len(joint_ids), device=asset.device)
    values = {"joint_friction_coeff": tensor(asset.data.joint_friction_coeff)[rows, joint_ids] + further}
    if "newton" not in env.sim.physics_manager.__name__.lower():  # Newton has one dry friction
        in_motion = tensor(asset.data.joint_dynamic_friction_coeff)[rows, joint_ids]
        viscous = tensor(asset.data.joint_viscous_friction_coeff)[rows, joint_ids]
        values["joint_dynamic_friction_coeff"] = in_motion + further
        values["joint_viscous_friction_coeff"] = viscous
    asset.write_joint_friction_coefficient_to_sim_index(
        joint_ids=joint_ids, env_ids=env_ids, **values
    )


)";

/// compute() takes and returns what the solver is told: torques of explicit actuators.
constexpr ActuatorsInPython kIsaacLabActuators = {"asset.actuators.values()",
                                                  "actuator.joint_names",
                                                  R"(        action = plain(*arguments, **named)
        if action.joint_efforts is None:
            raise TypeError("motor strength is of actuators that compute a torque")
        action.joint_efforts = action.joint_efforts * actuator.motor_strength
        actuator.applied_effort = action.joint_efforts
        return action
)"};

void add_bodies(const DrawnParts& parts, const Robot& robot, PythonTerms& terms) {
  const std::optional<Range>& total = parts.stated->total_mass_factor;
  if (total) {
    std::vector<std::string> all;
    for (const dynamics::Body& body : robot.tree.bodies) {
      if (body.inertia.mass_kg > 0.0) all.push_back(body.name);
    }
    terms.add("total_mass", "mdp.randomize_rigid_body_mass", "startup",
              {asset("body_names", all), "\"mass_distribution_params\": " + python_pair(*total),
               "\"operation\": \"scale\"", "\"recompute_inertia\": False"});
  }
  for (const PartsRange& each : parts.mass_factor) {
    if (total) continue;
    terms.add("mass", "mdp.randomize_rigid_body_mass", "startup",
              {asset("body_names", each.names),
               "\"mass_distribution_params\": " + python_pair(each.range),
               "\"operation\": \"scale\"", "\"recompute_inertia\": False"});
  }
  for (const PartsRange& each : parts.inertia_factor) {
    terms.add("inertia", "mdp.randomize_rigid_body_inertia", "startup",
              {asset("body_names", each.names),
               "\"inertia_distribution_params\": " + python_pair(each.range),
               "\"operation\": \"scale\"", "\"diagonal_only\": False"});
  }
}

/// A term draws from the places as they were: all axes of a body in one.
void add_shifts(const DrawnParts& parts, PythonTerms& terms) {
  const std::array<std::string_view, 3> axes = {"\"x\"", "\"y\"", "\"z\""};
  for (const BodyRanges& each : ranges_by_body(parts.center_of_mass_m, axes)) {
    terms.add("center_of_mass", "mdp.randomize_rigid_body_com", "startup",
              {asset("body_names", {each.body}), "\"com_range\": " + each.ranges});
  }
}

void add_joints(const DrawnParts& parts, PythonTerms& terms) {
  for (const PartsRange& each : parts.gain_factor) {
    terms.add("gains", "mdp.randomize_actuator_gains", "startup",
              {asset("joint_names", each.names),
               "\"stiffness_distribution_params\": " + python_pair(each.range),
               "\"damping_distribution_params\": " + python_pair(each.range),
               "\"operation\": \"scale\""});
  }
  for (const PartsRange& each : parts.strength_factor) {
    terms.add("motor_strength", "scale_motor_strength", "startup",
              {asset("joint_names", each.names), "\"strength_range\": " + python_pair(each.range)});
  }
  for (const PartsRange& each : parts.dry_friction_Nm) {
    terms.add("dry_friction", "add_dry_friction", "startup",
              {asset("joint_names", each.names), "\"friction_range\": " + python_pair(each.range)});
  }
  for (const PartsRange& each : parts.start_position_rad) {
    terms.add("start_position", "mdp.reset_joints_by_offset", "reset",
              {asset("joint_names", each.names), "\"position_range\": " + python_pair(each.range),
               "\"velocity_range\": (0.0, 0.0)"});
  }
}

void add_ground(const Randomisation& stated, PythonTerms& terms) {
  if (!stated.friction_coefficient && !stated.restitution) return;
  const Range friction = stated.friction_coefficient.value_or(Range{1.0, 1.0});
  const Range restitution = stated.restitution.value_or(Range{0.0, 0.0});
  terms.add("material", "mdp.randomize_rigid_body_material", "startup",
            {"\"asset_cfg\": SceneEntityCfg(\"robot\", body_names=\".*\")",
             "\"static_friction_range\": " + python_pair(friction),
             "\"dynamic_friction_range\": " + python_pair(friction),
             "\"restitution_range\": " + python_pair(restitution), "\"make_consistent\": True",
             "\"num_buckets\": 64"});
}

EventText write(const DrawnParts& parts, const Robot& robot) {
  const Randomisation& stated = *parts.stated;
  PythonTerms terms;
  add_bodies(parts, robot, terms);
  add_shifts(parts, terms);
  add_joints(parts, terms);
  add_ground(stated, terms);
  EventText written;
  written.text =
      "from isaaclab.envs import mdp\n"
      "from isaaclab.managers import EventTermCfg, SceneEntityCfg\n";
  if (!parts.strength_factor.empty()) written.text += scale_motor_strength(kIsaacLabActuators);
  written.text += parts.dry_friction_Nm.empty() ? "\n" : kAddDryFriction;
  written.text += terms.text();
  std::vector<std::string>& left_out = written.left_out;
  if (stated.total_mass_factor) {
    left_out.emplace_back(
        "total_mass_factor: that all bodies share one number; each draws its own here");
    if (!parts.mass_factor.empty()) {
      left_out.emplace_back(
          "body_mass_factor: a second term on masses would take the place of the first");
    }
  }
  if (stated.bus_voltage_factor) {
    left_out.push_back(fmt::format(
        "bus_voltage_factor {}: DCMotorCfg has no term for it; clip(..., voltage=...) of `actuator "
        "mor --format python` takes it",
        python_pair(*stated.bus_voltage_factor)));
  }
  if (!parts.start_velocity_rad_s.empty()) {
    left_out.emplace_back(
        "initial_joint_velocity_rad_s: velocity_range of reset_joints_by_offset, in which "
        "positions "
        "and velocities belong to one term");
  }
  return written;
}

}  // namespace

const EventWriter isaac_lab_events = {
    .formats = {"isaac-lab", "isaac-lab-remotized"},
    .source =
        "https://github.com/isaac-sim/IsaacLab source/isaaclab/isaaclab/envs/mdp/events.py @ "
        "025ffcd0",
    .advice =
        "for name, term in EVENTS.items(): setattr(cfg.events, name, term). The material is the "
        "robot's: give the ground friction 1 and restitution 1, and combine by \"multiply\". Gains "
        "of stiffness and damping are drawn apart.",
    .write = write,
};

}  // namespace torquewright::hopper::event_writers
