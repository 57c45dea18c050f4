// SPDX-License-Identifier: Apache-2.0
// Fields: as in urdf_reader.cpp.
#include "robot/urdf/urdf_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "robot/draft/rotors_in_joints.hpp"
#include "robot/parts/rotations.hpp"
#include "robot/xml/xml_text.hpp"

namespace torquewright::hopper {
namespace {

using dynamics::Body;
using dynamics::JointKind;

void write_pose(tinyxml2::XMLPrinter& out, const Eigen::Vector3d& p_m, const Eigen::Matrix3d& R) {
  out.OpenElement("origin");
  out.PushAttribute("xyz", text_of(p_m).c_str());
  out.PushAttribute("rpy", text_of(rpy_of_rotation(R)).c_str());
  out.CloseElement();
}

void write_value(tinyxml2::XMLPrinter& out, const char* element, double value) {
  out.OpenElement(element);
  out.PushAttribute("value", text_of(value).c_str());
  out.CloseElement();
}

void write_link(tinyxml2::XMLPrinter& out, const Body& body) {
  out.OpenElement("link");
  out.PushAttribute("name", body.name.c_str());
  if (body.inertia.mass_kg > 0) {
    const Eigen::Matrix3d& inertia = body.inertia.inertia_kg_m2;
    out.OpenElement("inertial");
    write_pose(out, body.inertia.center_of_mass_m, Eigen::Matrix3d::Identity());
    write_value(out, "mass", body.inertia.mass_kg);
    out.OpenElement("inertia");
    const char* names[3][3] = {{"ixx", "ixy", "ixz"}, {"", "iyy", "iyz"}, {"", "", "izz"}};
    for (int i = 0; i < 3; ++i) {
      for (int j = i; j < 3; ++j) out.PushAttribute(names[i][j], text_of(inertia(i, j)).c_str());
    }
    out.CloseElement();
    out.CloseElement();
  }
  out.CloseElement();
}

void write_limits(tinyxml2::XMLPrinter& out, const dynamics::JointLimits& limits, bool has_range) {
  out.OpenElement("limit");
  if (has_range) {
    out.PushAttribute("lower", text_of(limits.position_min).c_str());
    out.PushAttribute("upper", text_of(limits.position_max).c_str());
  }
  // The format demands both.
  out.PushAttribute("effort", text_of(std::min(limits.effort_max, kNoLimit)).c_str());
  out.PushAttribute("velocity", text_of(std::min(limits.speed_max, kNoLimit)).c_str());
  out.CloseElement();
}

void write_drag(tinyxml2::XMLPrinter& out, const dynamics::PassiveForces& passive) {
  if (passive.damping == 0 && passive.dry_friction == 0) return;
  out.OpenElement("dynamics");
  out.PushAttribute("damping", text_of(passive.damping).c_str());
  out.PushAttribute("friction", text_of(passive.dry_friction).c_str());
  out.CloseElement();
}

void write_joint(tinyxml2::XMLPrinter& out, const Body& body, const std::string& parent) {
  const dynamics::Joint& joint = body.joint;
  dynamics::JointLimits limits = joint.limits;
  const bool turns = joint.kind == JointKind::kRevolute;
  const bool has_range = std::isfinite(limits.position_min);
  if (!has_range && !turns) limits.position_min = -kNoRange, limits.position_max = kNoRange;
  out.OpenElement("joint");
  out.PushAttribute("name", joint.name.c_str());
  out.PushAttribute("type", !turns ? "prismatic" : (has_range ? "revolute" : "continuous"));
  write_pose(out, joint.p_PB_m, joint.R_PB);
  for (const bool is_parent : {true, false}) {
    out.OpenElement(is_parent ? "parent" : "child");
    out.PushAttribute("link", (is_parent ? parent : body.name).c_str());
    out.CloseElement();
  }
  out.OpenElement("axis");
  out.PushAttribute("xyz", text_of(joint.axis).c_str());
  out.CloseElement();
  write_limits(out, limits, has_range || !turns);
  write_drag(out, joint.passive);
  out.CloseElement();
}

void write_transmission(tinyxml2::XMLPrinter& out, const dynamics::Joint& joint) {
  out.OpenElement("transmission");
  out.PushAttribute("name", (joint.name + "_transmission").c_str());
  out.OpenElement("type");
  out.PushText("transmission_interface/SimpleTransmission");
  out.CloseElement();
  out.OpenElement("joint");
  out.PushAttribute("name", joint.name.c_str());
  out.CloseElement();
  out.OpenElement("actuator");
  out.PushAttribute("name", (joint.name + "_actuator").c_str());
  write_value(out, "drake:rotor_inertia", joint.reflected_inertia);
  write_value(out, "drake:gear_ratio", 1);
  out.CloseElement();
  out.CloseElement();
}

/// A fixed base stands where it does in a link called "world".
void write_world(tinyxml2::XMLPrinter& out, const Body& base) {
  if (base.name == "world") return;
  out.OpenElement("link");
  out.PushAttribute("name", "world");
  out.CloseElement();
  out.OpenElement("joint");
  out.PushAttribute("name", "world_joint");
  out.PushAttribute("type", "fixed");
  write_pose(out, base.joint.p_PB_m, base.joint.R_PB);
  for (const bool is_parent : {true, false}) {
    out.OpenElement(is_parent ? "parent" : "child");
    out.PushAttribute("link", is_parent ? "world" : base.name.c_str());
    out.CloseElement();
  }
  out.CloseElement();
}

void note_unknown_limits(const Robot& robot, std::vector<std::string>& notes) {
  std::size_t count = 0;
  for (std::size_t i = 1; i < robot.tree.bodies.size(); ++i) {
    const dynamics::JointLimits& limits = robot.tree.bodies[i].joint.limits;
    if (std::isinf(limits.effort_max) || std::isinf(limits.speed_max)) ++count;
  }
  if (count == 0) return;
  notes.push_back(fmt::format(
      "effort or velocity of {} joint{} is not known: {} stands for no limit, since readers take 0 "
      "for no force",
      count, count == 1 ? "" : "s", text_of(kNoLimit)));
}

std::vector<std::string> notes_of(const Robot& robot, const DrivesInJoints& drives) {
  std::vector<std::string> notes = drives.notes;
  const bool is_fixed = robot.tree.base == dynamics::BaseKind::kFixed;
  if (!is_fixed) {
    notes.emplace_back(robot.tree.base == dynamics::BaseKind::kPlanar
                           ? "URDF knows no planar base: whoever loads it must hold it in its plane"
                           : "URDF does not say that the base floats: whoever loads it must");
  }
  note_unknown_limits(robot, notes);
  notes.emplace_back(
      "reflected inertia stands as drake:rotor_inertia with gear ratio 1; readers "
      "other than Drake ignore it");
  add_passive_notes(robot, false, notes);
  add_common_notes(robot, {.drives = !drives.are_there}, notes);
  return notes;
}

}  // namespace

Exported urdf_of(const Robot& robot, const DrivesInJoints& drives) {
  Exported exported;
  exported.notes = notes_of(robot, drives);
  const dynamics::Tree tree = tree_with_rotors(robot, exported.notes);
  tinyxml2::XMLPrinter out;
  write_notes(out, joined(exported.notes, drives.of_actuators));
  out.OpenElement("robot");
  out.PushAttribute("name", robot.name.c_str());
  out.PushAttribute("xmlns:drake", "https://drake.mit.edu");
  const std::vector<Body>& bodies = tree.bodies;
  if (tree.base == dynamics::BaseKind::kFixed) write_world(out, bodies.front());
  for (const Body& body : bodies) write_link(out, body);
  for (std::size_t i = 1; i < bodies.size(); ++i) {
    write_joint(out, bodies[i], bodies[bodies[i].parent].name);
  }
  for (std::size_t i = 1; i < bodies.size(); ++i) {
    if (robot.states_rotor(i, bodies[i].joint)) write_transmission(out, bodies[i].joint);
  }
  out.CloseElement();
  exported.text = out.CStr();
  return exported;
}

}  // namespace torquewright::hopper
