// SPDX-License-Identifier: Apache-2.0
// Terms: mjlab, src/mjlab/envs/mdp/dr/joint.py, actuator.py @ 76106be4, body.py @ 415cec74 and
// _core.py @ 01b98a31: each starts from the values as compiled, so that no two terms may have the
// same field of the same thing; shared_random draws one number for all; body_mass leaves the
// inertia; pd_gains goes by groups of actuators, not by joints.
#include "hopper/randomised_files/every_event_writer.hpp"
#include "hopper/randomised_files/python_terms.hpp"

namespace torquewright::hopper::event_writers {
namespace {

constexpr ActuatorsInPython kMjlabActuators = {
    "asset.actuators", "getattr(actuator, \"target_names\", None) or actuator._actuated_names",
    "        return plain(*arguments, **named) * actuator.motor_strength\n"};

void add_masses(const DrawnParts& parts, const Robot& robot, PythonTerms& terms) {
  const std::optional<Range>& total = parts.stated->total_mass_factor;
  if (total) {
    std::vector<std::string> all;
    for (const dynamics::Body& body : robot.tree.bodies) {
      if (body.inertia.mass_kg > 0.0) all.push_back(body.name);
    }
    terms.add("total_mass", "dr.body_mass", "startup",
              {asset("body_names", all), "\"ranges\": " + python_pair(*total),
               "\"operation\": \"scale\"", "\"shared_random\": True"});
    return;
  }
  for (const PartsRange& each : parts.mass_factor) {
    terms.add("mass", "dr.body_mass", "startup",
              {asset("body_names", each.names), "\"ranges\": " + python_pair(each.range),
               "\"operation\": \"scale\""});
  }
}

/// All axes of a body in one term: a second would begin anew.
void add_shifts(const DrawnParts& parts, PythonTerms& terms) {
  for (const BodyRanges& each : ranges_by_body(parts.center_of_mass_m, {"0", "1", "2"})) {
    terms.add(
        "center_of_mass", "dr.body_com_offset", "startup",
        {asset("body_names", {each.body}), "\"ranges\": " + each.ranges, "\"operation\": \"add\""});
  }
}

void add_joints(const DrawnParts& parts, PythonTerms& terms) {
  if (parts.gain_factor.size() == 1) {
    const std::string pair = python_pair(parts.gain_factor.front().range);
    terms.add("gains", "dr.pd_gains", "startup",
              {"\"asset_cfg\": SceneEntityCfg(\"robot\")", "\"kp_range\": " + pair,
               "\"kd_range\": " + pair, "\"operation\": \"scale\""});
  }
  for (const PartsRange& each : parts.strength_factor) {
    terms.add("motor_strength", "scale_motor_strength", "startup",
              {asset("joint_names", each.names), "\"strength_range\": " + python_pair(each.range)});
  }
  for (const PartsRange& each : parts.dry_friction_Nm) {
    terms.add("dry_friction", "dr.joint_friction", "startup",
              {asset("joint_names", each.names), "\"ranges\": " + python_pair(each.range),
               "\"operation\": \"add\""});
  }
  for (const PartsRange& each : parts.start_position_rad) {
    terms.add("start_position", "mdp.reset_joints_by_offset", "reset",
              {asset("joint_names", each.names), "\"position_range\": " + python_pair(each.range),
               "\"velocity_range\": (0.0, 0.0)"});
  }
}

void note_left_out(const DrawnParts& parts, std::vector<std::string>& left_out) {
  const Randomisation& stated = *parts.stated;
  if (stated.total_mass_factor && !parts.mass_factor.empty()) {
    left_out.emplace_back(
        "body_mass_factor: a second term on masses would take the place of the first");
  }
  if (!parts.inertia_factor.empty()) {
    left_out.emplace_back(
        "body_inertia_factor: no term changes an inertia alone; pseudo_inertia changes mass with "
        "it");
  }
  if (parts.gain_factor.size() > 1) {
    left_out.emplace_back(
        "controller_gain_factor: pd_gains goes by groups of actuators, and the ranges differ by "
        "joint: a term each with actuator_names");
  }
  if (stated.bus_voltage_factor) {
    left_out.push_back(fmt::format(
        "bus_voltage_factor {}: no term for it; clip(..., voltage=...) of `actuator mor --format "
        "python` takes it",
        python_pair(*stated.bus_voltage_factor)));
  }
  if (stated.restitution) {
    left_out.emplace_back("restitution: MuJoCo's contacts have solref and solimp in its place");
  }
  if (!parts.start_velocity_rad_s.empty()) {
    left_out.emplace_back(
        "initial_joint_velocity_rad_s: velocity_range of reset_joints_by_offset, in which "
        "positions "
        "and velocities belong to one term");
  }
}

EventText write(const DrawnParts& parts, const Robot& robot) {
  PythonTerms terms;
  add_masses(parts, robot, terms);
  add_shifts(parts, terms);
  add_joints(parts, terms);
  if (parts.stated->friction_coefficient) {
    terms.add("ground_friction", "dr.geom_friction", "startup",
              {"\"asset_cfg\": SceneEntityCfg(\"robot\", geom_names=(\".*\",))",
               "\"ranges\": " + python_pair(*parts.stated->friction_coefficient),
               "\"operation\": \"abs\"", "\"shared_random\": True"});
  }
  EventText written;
  written.text =
      "from mjlab.envs import mdp\n"
      "from mjlab.envs.mdp import dr\n"
      "from mjlab.managers.event_manager import EventTermCfg\n"
      "from mjlab.managers.scene_entity_config import SceneEntityCfg\n" +
      (parts.strength_factor.empty() ? "\n" : scale_motor_strength(kMjlabActuators)) + terms.text();
  note_left_out(parts, written.left_out);
  return written;
}

}  // namespace

const EventWriter mjlab_events = {
    .formats = {"mjlab"},
    .source =
        "https://github.com/mujocolab/mjlab src/mjlab/envs/mdp/dr/joint.py @ 76106be4, actuator.py "
        "@ 76106be4, body.py @ 415cec74",
    .advice =
        "cfg.events.update(EVENTS). Friction of contacts is the greater of both geoms': the "
        "ground's has to be less than these. kp and kd are drawn apart.",
    .write = write,
};

}  // namespace torquewright::hopper::event_writers
