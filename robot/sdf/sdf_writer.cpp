// SPDX-License-Identifier: Apache-2.0
// Elements: SDFormat 1.9, sdf/1.9/joint.sdf and inertial.sdf of gazebosim/sdformat @ 1a779837: a
// joint's frame is its child's, a limit that is left out or negative is none, spring_stiffness and
// spring_reference stand in <dynamics>. Gazebo: gazebosim/gz-physics, dartsim/src/SDFFeatures.cc @
// f370ea62, CopyStandardJointAxisProperties, hands damping, friction, springs and all limits to
// DART, which clips commands to the effort (GenericJoint::setCommand). Drake:
// multibody/parsing/detail_sdf_parser.cc @ 0cc58dd7: damping and springs of hinges, no friction; an
// effort of 0 is no actuator, and drake:rotor_inertia with drake:gear_ratio is its armature.
#include "robot/sdf/sdf_writer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <tinyxml2.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "robot/draft/rotors_in_joints.hpp"
#include "robot/parts/rotations.hpp"
#include "robot/xml/xml_text.hpp"

namespace torquewright::hopper {
namespace {

using dynamics::Body;
using dynamics::JointKind;

// The least mass and inertia that readers take: both want bodies that weigh something.
constexpr double kLeastMass_kg = 1e-6;
constexpr double kLeastInertia_kg_m2 = 1e-9;
constexpr double kSdfNoRange = 1e16;  // of the format: no limit of a position

void write_text(tinyxml2::XMLPrinter& out, const char* element, const std::string& text) {
  out.OpenElement(element);
  out.PushText(text.c_str());
  out.CloseElement();
}

void write_number(tinyxml2::XMLPrinter& out, const char* element, double value) {
  write_text(out, element, text_of(value));
}

std::string pose_text(const Eigen::Vector3d& p_m, const Eigen::Matrix3d& R) {
  return text_of(p_m) + " " + text_of(rpy_of_rotation(R));
}

bool weighs_nothing(const Body& body) { return body.inertia.mass_kg <= 0.0; }

void write_link_inertial(tinyxml2::XMLPrinter& out, const Body& body) {
  dynamics::RigidInertia inertia = body.inertia;
  if (weighs_nothing(body)) {
    inertia = {kLeastMass_kg, Eigen::Vector3d::Zero(),
               kLeastInertia_kg_m2 * Eigen::Matrix3d::Identity()};
  }
  out.OpenElement("inertial");
  write_text(out, "pose", pose_text(inertia.center_of_mass_m, Eigen::Matrix3d::Identity()));
  write_number(out, "mass", inertia.mass_kg);
  out.OpenElement("inertia");
  const char* names[3][3] = {{"ixx", "ixy", "ixz"}, {"", "iyy", "iyz"}, {"", "", "izz"}};
  for (int i = 0; i < 3; ++i) {
    for (int j = i; j < 3; ++j) write_number(out, names[i][j], inertia.inertia_kg_m2(i, j));
  }
  out.CloseElement();
  out.CloseElement();
}

/// Names of links: links and joints share one scope, and some names are the format's own.
std::vector<std::string> link_names(const dynamics::Tree& tree) {
  std::set<std::string> taken{"world", "world_joint"};
  for (std::size_t i = 1; i < tree.bodies.size(); ++i) taken.insert(tree.bodies[i].joint.name);
  std::vector<std::string> names;
  for (const Body& body : tree.bodies) {
    std::string name = body.name;
    while (name.starts_with("__") || !taken.insert(name).second) {
      name = name.starts_with("__") ? "link" + name : name + "_link";
    }
    names.push_back(name);
  }
  return names;
}

/// Whether the base is the world itself and no link.
bool is_world(const dynamics::Tree& tree) {
  return tree.base == dynamics::BaseKind::kFixed && tree.bodies.front().name == "world";
}

/// Where nobody states an effort, no joint is called passive.
bool some_effort_is_known(const dynamics::Tree& tree) {
  return std::any_of(tree.bodies.begin() + 1, tree.bodies.end(),
                     [](const Body& body) { return std::isfinite(body.joint.limits.effort_max); });
}

class SdfText {
 public:
  SdfText(const Robot& robot, const dynamics::Tree& tree, SdfReader reader)
      : robot_(robot), tree_(tree), reader_(reader), names_(link_names(tree)) {
    if (is_world(tree)) names_.front() = "world";
  }

  void run(tinyxml2::XMLPrinter& out) const {
    out.OpenElement("sdf");
    out.PushAttribute("version", "1.9");
    if (reader_ == SdfReader::kDrake) {
      out.PushAttribute("xmlns:drake", "http://drake.mit.edu");
    }
    out.OpenElement("model");
    out.PushAttribute("name", robot_.name.c_str());
    for (std::size_t i = is_world(tree_) ? 1 : 0; i < tree_.bodies.size(); ++i) write_link(out, i);
    if (tree_.base == dynamics::BaseKind::kFixed && !is_world(tree_)) write_weld(out);
    for (std::size_t i = 1; i < tree_.bodies.size(); ++i) write_joint(out, i);
    out.CloseElement();
    out.CloseElement();
  }

 private:
  void write_link(tinyxml2::XMLPrinter& out, std::size_t index) const {
    out.OpenElement("link");
    out.PushAttribute("name", names_[index].c_str());
    write_pose_of(out, index);
    write_link_inertial(out, tree_.bodies[index]);
    out.CloseElement();
  }

  void write_pose_of(tinyxml2::XMLPrinter& out, std::size_t index) const {
    const Body& body = tree_.bodies[index];
    if (index == 0 && tree_.base != dynamics::BaseKind::kFixed) return;
    Eigen::Vector3d p_m = body.joint.p_PB_m;
    Eigen::Matrix3d R = body.joint.R_PB;
    const bool is_on_world = index > 0 && body.parent == 0 && is_world(tree_);
    if (is_on_world) {  // the model's frame stands in the world's place
      const dynamics::Joint& base = tree_.bodies.front().joint;
      p_m = base.p_PB_m + base.R_PB * p_m;
      R = base.R_PB * R;
    }
    out.OpenElement("pose");
    if (index > 0 && !is_on_world) out.PushAttribute("relative_to", names_[body.parent].c_str());
    out.PushText(pose_text(p_m, R).c_str());
    out.CloseElement();
  }

  void write_weld(tinyxml2::XMLPrinter& out) const {
    out.OpenElement("joint");
    out.PushAttribute("name", "world_joint");
    out.PushAttribute("type", "fixed");
    write_text(out, "parent", "world");
    write_text(out, "child", names_.front());
    out.CloseElement();
  }

  void write_joint(tinyxml2::XMLPrinter& out, std::size_t index) const {
    const Body& body = tree_.bodies[index];
    const bool turns = body.joint.kind == JointKind::kRevolute;
    const bool has_range = std::isfinite(body.joint.limits.position_min);
    out.OpenElement("joint");
    out.PushAttribute("name", body.joint.name.c_str());
    out.PushAttribute("type", !turns ? "prismatic" : (has_range ? "revolute" : "continuous"));
    write_text(out, "parent", names_[body.parent]);
    write_text(out, "child", names_[index]);
    out.OpenElement("axis");
    write_text(out, "xyz", text_of(body.joint.axis));
    write_limits(out, body.joint, has_range);
    write_dynamics(out, body.joint.passive);
    out.CloseElement();
    if (reader_ == SdfReader::kDrake && robot_.states_rotor(index, body.joint)) {
      write_number(out, "drake:rotor_inertia", body.joint.reflected_inertia);
      write_number(out, "drake:gear_ratio", 1);
    }
    out.CloseElement();
  }

  void write_limits(tinyxml2::XMLPrinter& out, const dynamics::Joint& joint, bool has_range) const {
    const dynamics::JointLimits& limits = joint.limits;
    out.OpenElement("limit");
    if (has_range || joint.kind == JointKind::kPrismatic) {
      write_number(out, "lower", has_range ? limits.position_min : -kSdfNoRange);
      write_number(out, "upper", has_range ? limits.position_max : kSdfNoRange);
    }
    if (std::isfinite(limits.effort_max)) {
      write_number(out, "effort", limits.effort_max);
    } else if (reader_ == SdfReader::kDrake && some_effort_is_known(tree_)) {
      write_number(out, "effort", 0);
    }
    if (std::isfinite(limits.speed_max)) write_number(out, "velocity", limits.speed_max);
    out.CloseElement();
  }

  void write_dynamics(tinyxml2::XMLPrinter& out, const dynamics::PassiveForces& passive) const {
    const bool has_friction = reader_ == SdfReader::kGazebo && passive.dry_friction > 0;
    if (passive.damping == 0 && !has_friction && passive.stiffness == 0) return;
    out.OpenElement("dynamics");
    write_number(out, "damping", passive.damping);
    if (has_friction) write_number(out, "friction", passive.dry_friction);
    write_number(out, "spring_reference", passive.rest_position);
    write_number(out, "spring_stiffness", passive.stiffness);
    out.CloseElement();
  }

  const Robot& robot_;
  const dynamics::Tree& tree_;
  SdfReader reader_;
  std::vector<std::string> names_;
};

void note_planar_base(const dynamics::Tree& tree, std::vector<std::string>& notes) {
  if (tree.base == dynamics::BaseKind::kPlanar) {
    notes.emplace_back(
        "SDFormat knows no planar base: this one floats, and whoever loads it must hold it in its "
        "plane");
  }
}

void note_names(const dynamics::Tree& tree, std::vector<std::string>& notes) {
  const std::vector<std::string> names = link_names(tree);
  for (std::size_t i = is_world(tree) ? 1 : 0; i < names.size(); ++i) {
    if (names[i] == tree.bodies[i].name) continue;
    notes.push_back(fmt::format(
        "link {} is called {}: links and joints share their names, and some are the format's own",
        tree.bodies[i].name, names[i]));
  }
}

void note_weightless(const dynamics::Tree& tree, std::vector<std::string>& notes) {
  std::vector<std::string> names;
  for (std::size_t i = is_world(tree) ? 1 : 0; i < tree.bodies.size(); ++i) {
    if (weighs_nothing(tree.bodies[i])) names.push_back(tree.bodies[i].name);
  }
  if (names.empty()) return;
  notes.push_back(fmt::format(
      "{} weigh{} nothing: {} kg and {} kg m2 stand for that, since a link has to weigh something",
      fmt::join(names, ", "), names.size() == 1 ? "s" : "", kLeastMass_kg, kLeastInertia_kg_m2));
}

/// "knee 0.34" of every joint where `of` is some.
template <typename Of>
std::vector<std::string> named_values(const dynamics::Tree& tree, Of of) {
  std::vector<std::string> all;
  for (std::size_t i = 1; i < tree.bodies.size(); ++i) {
    const double value = of(tree.bodies[i].joint);
    if (value > 0) all.push_back(fmt::format("{} {:.4g}", tree.bodies[i].joint.name, value));
  }
  return all;
}

void note_gazebo(const dynamics::Tree& tree, std::vector<std::string>& notes) {
  const auto armatures =
      named_values(tree, [](const dynamics::Joint& joint) { return joint.reflected_inertia; });
  if (armatures.empty()) return;
  notes.push_back(fmt::format(
      "SDFormat has no field for the armature: the joints lack, in kg m2, {}, and each is off by "
      "that times its acceleration in Nm",
      fmt::join(armatures, ", ")));
}

void note_drake(const dynamics::Tree& tree, std::vector<std::string>& notes) {
  const auto frictions =
      named_values(tree, [](const dynamics::Joint& joint) { return joint.passive.dry_friction; });
  if (!frictions.empty()) {
    notes.push_back(fmt::format(
        "joints of Drake have no dry friction: what moves them is off, in Nm (N of slides), by {}",
        fmt::join(frictions, ", ")));
  }
  const auto springs = named_values(tree, [](const dynamics::Joint& joint) {
    return joint.kind == JointKind::kPrismatic ? joint.passive.stiffness : 0.0;
  });
  if (!springs.empty()) {
    notes.push_back(fmt::format(
        "springs of slides ({}) need a Drake that reads them: of 2021 those of hinges alone are",
        fmt::join(springs, ", ")));
  }
  const auto passive = named_values(tree, [](const dynamics::Joint& joint) {
    return std::isfinite(joint.limits.effort_max) ? 0.0 : joint.reflected_inertia;
  });
  if (!passive.empty() && some_effort_is_known(tree)) {
    notes.push_back(fmt::format(
        "Drake's armature is an actuator's: joints without one lack theirs, in kg m2, {}",
        fmt::join(passive, ", ")));
  }
}

}  // namespace

Exported sdf_of(const Robot& robot, SdfReader reader, const DrivesInJoints& drives) {
  Exported exported;
  exported.notes = drives.notes;
  const dynamics::Tree tree = tree_with_rotors(robot, exported.notes);
  note_planar_base(tree, exported.notes);
  note_names(tree, exported.notes);
  note_weightless(tree, exported.notes);
  if (reader == SdfReader::kGazebo) {
    note_gazebo(tree, exported.notes);
  } else {
    note_drake(tree, exported.notes);
  }
  add_passive_notes(robot, true, exported.notes);
  add_common_notes(robot, {.drives = !drives.are_there}, exported.notes);
  tinyxml2::XMLPrinter out;
  write_notes(out, joined(exported.notes, drives.of_actuators));
  SdfText(robot, tree, reader).run(out);
  exported.text = out.CStr();
  return exported;
}

}  // namespace torquewright::hopper
