// SPDX-License-Identifier: Apache-2.0
// Fields: MuJoCo's XML reference (mujoco.readthedocs.io, XMLreference).
#include "robot/mjcf/mjcf_writer.hpp"

#include <limits>

#include "robot/draft/rotors_in_joints.hpp"
#include "robot/loops/closed_loops.hpp"
#include "robot/mjcf/mjcf_bodies.hpp"
#include "robot/mjcf/mjcf_drives.hpp"
#include "robot/mjcf/mjcf_keyframes.hpp"
#include "robot/xml/xml_text.hpp"

namespace torquewright::hopper {
namespace {

void write_settings(tinyxml2::XMLPrinter& out, const dynamics::Tree& tree) {
  out.OpenElement("compiler");
  out.PushAttribute("angle", "radian");
  out.CloseElement();
  out.OpenElement("option");
  out.PushAttribute("gravity", text_of({0, 0, -tree.gravity_m_s2}).c_str());
  out.CloseElement();
}

/// The pair's friction is the greater one of both, so that the ground's own is none.
void write_ground(tinyxml2::XMLPrinter& out) {
  out.OpenElement("geom");
  out.PushAttribute("name", "ground");
  out.PushAttribute("type", "plane");
  out.PushAttribute("size", "0 0 1");
  out.PushAttribute("friction", "0 0 0");
  out.CloseElement();
}

void add_notes_of_parts(const Robot& robot, const MjcfParts& parts,
                        std::vector<std::string>& notes) {
  if (parts.collisions && !robot.contacts.empty()) {
    notes.emplace_back(
        "contact points without a radius are balls of 1 mm about them, all without restitution");
  }
  if (parts.actuators && !robot.drivetrains.empty()) {
    notes.emplace_back(
        parts.servos
            ? "drives share the battery and warm up: the file holds neither"
            : "controls of drives are voltages in V; the file does not hold that drives share the "
              "battery and warm up, nor what else no line between torque and speed holds");
    notes.emplace_back(
        parts.friction == actuator::FrictionPlace::kJoint
            ? "friction of drives is that of the joint or the tendon that they turn, "
              "beside what joints have themselves; limits are those of the motor's torque there, "
              "before friction"
            : "friction of drives is taken off their limits: a torque below them "
              "arrives whole");
  }
}

/// What a drive moves needs no motor with a torque limit.
void leave_to_drives(const Robot& robot, dynamics::Tree& tree) {
  for (const Drivetrain& drivetrain : robot.drivetrains) {
    for (const std::size_t body : drivetrain.joints) {
      tree.bodies[body].joint.limits.effort_max = std::numeric_limits<double>::infinity();
    }
  }
}

/// In MuJoCo the other body's point is where the rod's is at the file's own posture.
void write_pins(tinyxml2::XMLPrinter& out, const LoopedRobot& looped) {
  out.OpenElement("equality");
  for (const LoopPin& pin : looped.pins) {
    const auto& bodies = looped.robot.tree.bodies;
    out.OpenElement("connect");
    out.PushAttribute("body1", bodies[pin.rod].name.c_str());
    out.PushAttribute("body2", bodies[pin.held].name.c_str());
    out.PushAttribute("anchor", text_of(pin.p_R_m).c_str());
    out.CloseElement();
  }
  out.CloseElement();
}

bool has_joint_friction(const MjcfParts& parts) {
  return parts.actuators && parts.friction == actuator::FrictionPlace::kJoint;
}

void write_all(tinyxml2::XMLPrinter& out, const LoopedRobot& looped, const dynamics::Tree& tree,
               const std::vector<Drive>& drives, const MjcfParts& parts) {
  const Robot& robot = looped.robot;
  out.OpenElement("mujoco");
  out.PushAttribute("model", robot.name.c_str());
  write_settings(out, tree);
  out.OpenElement("worldbody");
  if (parts.ground) write_ground(out);
  write_bodies(out, robot, tree, looped.references, parts.collisions, has_joint_friction(parts));
  out.CloseElement();
  if (!looped.pins.empty()) write_pins(out, looped);
  write_drives(out, robot, drives);
  if (parts.ground) {
    write_keyframes(out, robot, looped.pins.empty() ? std::vector<double>() : looped.references);
  }
  out.CloseElement();
}

}  // namespace

Exported mjcf_of(const Robot& robot, const MjcfParts& parts) {
  Exported exported;
  exported.notes.emplace_back("the file does not hold speed limits of joints");
  LoopedRobot looped =
      parts.closed_loops ? with_closed_loops(robot, exported.notes) : LoopedRobot{robot, {}, {}};
  if (parts.actuators) leave_to_drives(robot, looped.robot.tree);
  dynamics::Tree tree = tree_with_rotors(looped.robot, exported.notes);
  add_passive_notes(robot, true, exported.notes);
  add_common_notes(robot, {!parts.collisions, !parts.actuators, !parts.closed_loops},
                   exported.notes);
  add_notes_of_parts(robot, parts, exported.notes);
  if (parts.ground && !looped.pins.empty()) {
    exported.notes.emplace_back(
        "of keyframes only the one that stands where the file's bodies do is held");
  }
  std::vector<Drive> drives;
  if (parts.actuators) {
    drives = drives_of(looped.robot, parts.friction, parts.servos, exported.notes);
  }
  if (parts.servos) make_servos(robot, tree, drives, exported.notes);
  add_friction(drives, tree);
  tinyxml2::XMLPrinter out;
  write_notes(out, exported.notes);
  write_all(out, looped, tree, drives, parts);
  exported.text = out.CStr();
  return exported;
}

}  // namespace torquewright::hopper
