// SPDX-License-Identifier: Apache-2.0
#include "robot/xml/xml_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "io/text/number_text.hpp"

namespace torquewright::hopper {

std::string text_of(double value) { return io::precise_text(value); }

std::string text_of(const Eigen::Vector3d& vector) {
  return fmt::format("{} {} {}", text_of(vector[0]), text_of(vector[1]), text_of(vector[2]));
}

std::vector<std::string> joined(std::vector<std::string> notes,
                                const std::vector<std::string>& more) {
  notes.insert(notes.end(), more.begin(), more.end());
  return notes;
}

void write_notes(tinyxml2::XMLPrinter& out, const std::vector<std::string>& notes) {
  std::string comment = "\n";
  for (const std::string& note : notes) {
    comment += "  ";
    // Two hyphens would end the comment.
    for (const char letter : note) comment += letter == '-' ? '_' : letter;
    comment += "\n";
  }
  out.PushComment(comment.c_str());
}

void add_passive_notes(const Robot& robot, bool holds_springs, std::vector<std::string>& notes) {
  std::vector<std::string> springs;
  std::vector<std::string> held;
  for (const dynamics::Body& body : robot.tree.bodies) {
    const dynamics::PassiveForces& passive = body.joint.passive;
    if (passive.stiffness > 0) springs.push_back(body.joint.name);
    if (passive.static_friction > passive.dry_friction) held.push_back(body.joint.name);
  }
  if (!springs.empty() && !holds_springs) {
    notes.push_back(
        fmt::format("the file does not hold the springs of {}: its format has no word for them",
                    fmt::join(springs, ", ")));
  }
  if (!held.empty()) {
    notes.push_back(
        fmt::format("at rest {} hold no more than their friction while they move: the "
                    "format has one number for both",
                    fmt::join(held, ", ")));
  }
}

void add_common_notes(const Robot& robot, const LeftOut& left_out,
                      std::vector<std::string>& notes) {
  for (const dynamics::Body& body : robot.tree.bodies) {
    if (body.joint.rotor_spin_kg_m2.isZero(0)) continue;
    notes.emplace_back("the file holds reflected inertia of rotors, not their own spin momentum");
    break;
  }
  if (left_out.contacts && !robot.contacts.empty()) {
    notes.push_back(
        fmt::format("the file does not hold {} contact points, their friction and restitution",
                    robot.contacts.size()));
  }
  if (left_out.drives && !robot.drivetrains.empty()) {
    notes.push_back(fmt::format("the file does not hold {} mechanisms and their actuators",
                                robot.drivetrains.size()));
  }
  if (const double links_kg = robot.links_kg(); left_out.links && links_kg > 0) {
    notes.push_back(fmt::format(
        "links of loops, {:.4g} kg, are left out: MJCF with --closed-loops holds them", links_kg));
  }
}

}  // namespace torquewright::hopper
