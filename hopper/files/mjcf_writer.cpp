// SPDX-License-Identifier: Apache-2.0
// Fields: MuJoCo's XML reference (mujoco.readthedocs.io, XMLreference).
#include "hopper/files/mjcf_writer.hpp"

#include "hopper/files/mjcf_bodies.hpp"
#include "hopper/files/mjcf_drives.hpp"
#include "hopper/files/mjcf_keyframes.hpp"
#include "hopper/files/rotors_in_joints.hpp"
#include "hopper/files/xml_text.hpp"

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
    notes.emplace_back("contact points are balls of 1 mm about them, without restitution");
  }
  if (parts.actuators && !robot.drivetrains.empty()) {
    notes.emplace_back(
        "controls of drives are voltages in V; each loads the battery alone, and heat "
        "and what else no line between torque and speed holds");
  }
}

}  // namespace

Exported mjcf_of(const Robot& robot, const MjcfParts& parts) {
  Exported exported;
  exported.notes.emplace_back("speed limits of joints are not held");
  const dynamics::Tree tree = tree_with_rotors(robot, exported.notes);
  add_common_notes(robot, {!parts.collisions, !parts.actuators}, exported.notes);
  add_notes_of_parts(robot, parts, exported.notes);
  const std::vector<Drive> drives =
      parts.actuators ? drives_of(robot, exported.notes) : std::vector<Drive>();
  tinyxml2::XMLPrinter out;
  write_notes(out, exported.notes);
  out.OpenElement("mujoco");
  out.PushAttribute("model", robot.name.c_str());
  write_settings(out, tree);
  out.OpenElement("worldbody");
  if (parts.ground) write_ground(out);
  write_bodies(out, robot, tree, parts.collisions);
  out.CloseElement();
  write_drives(out, robot, drives);
  if (parts.ground) write_keyframes(out, robot);
  out.CloseElement();
  exported.text = out.CStr();
  return exported;
}

}  // namespace torquewright::hopper
