// SPDX-License-Identifier: Apache-2.0
// Fields: MuJoCo's XML reference (mujoco.readthedocs.io, XMLreference), "body", "joint",
// "inertial".
#include "hopper/files/mjcf_writer.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>

#include "hopper/files/rotors_in_joints.hpp"
#include "hopper/files/xml_text.hpp"

namespace torquewright::hopper {
namespace {

using dynamics::BaseKind;
using dynamics::Body;
using dynamics::JointKind;

std::string quaternion_text(const Eigen::Matrix3d& R) {
  const Eigen::Quaterniond q(R);
  return fmt::format("{} {} {} {}", q.w(), q.x(), q.y(), q.z());
}

/// By principal axes: of a full inertia MuJoCo finds them to some nine digits only.
void write_inertial(tinyxml2::XMLPrinter& out, const dynamics::RigidInertia& inertia) {
  if (!(inertia.mass_kg > 0)) return;
  out.OpenElement("inertial");
  out.PushAttribute("pos", text_of(inertia.center_of_mass_m).c_str());
  out.PushAttribute("mass", text_of(inertia.mass_kg).c_str());
  Eigen::Vector3d moments = inertia.inertia_kg_m2.diagonal();
  if (inertia.inertia_kg_m2 != Eigen::Matrix3d(moments.asDiagonal())) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(inertia.inertia_kg_m2);
    Eigen::Matrix3d R = axes.eigenvectors();
    if (R.determinant() < 0) R.col(0) *= -1;
    moments = axes.eigenvalues();
    out.PushAttribute("quat", quaternion_text(R).c_str());
  }
  out.PushAttribute("diaginertia", text_of(moments).c_str());
  out.CloseElement();
}

void write_base_joint(tinyxml2::XMLPrinter& out, const char* name, const char* type,
                      const char* axis) {
  out.OpenElement("joint");
  out.PushAttribute("name", name);
  out.PushAttribute("type", type);
  out.PushAttribute("axis", axis);
  out.CloseElement();
}

void write_base(tinyxml2::XMLPrinter& out, BaseKind base) {
  if (base == BaseKind::kSpatial) {
    out.OpenElement("freejoint");
    out.CloseElement();
  } else if (base == BaseKind::kPlanar) {
    write_base_joint(out, "base_x", "slide", "1 0 0");
    write_base_joint(out, "base_z", "slide", "0 0 1");
    write_base_joint(out, "base_pitch", "hinge", "0 1 0");
  }
}

void write_joint(tinyxml2::XMLPrinter& out, const dynamics::Joint& joint) {
  out.OpenElement("joint");
  out.PushAttribute("name", joint.name.c_str());
  out.PushAttribute("type", joint.kind == JointKind::kRevolute ? "hinge" : "slide");
  out.PushAttribute("axis", text_of(joint.axis).c_str());
  if (joint.reflected_inertia > 0) {
    out.PushAttribute("armature", text_of(joint.reflected_inertia).c_str());
  }
  if (std::isfinite(joint.limits.position_min)) {
    out.PushAttribute("limited", "true");
    out.PushAttribute(
        "range",
        fmt::format("{} {}", joint.limits.position_min, joint.limits.position_max).c_str());
  }
  out.CloseElement();
}

void write_body(tinyxml2::XMLPrinter& out, const dynamics::Tree& tree,
                const std::vector<ContactPoint>& contacts, std::size_t index) {
  const std::vector<Body>& bodies = tree.bodies;
  const Body& body = bodies[index];
  out.OpenElement("body");
  out.PushAttribute("name", body.name.c_str());
  if (index > 0 || tree.base == BaseKind::kFixed) {
    out.PushAttribute("pos", text_of(body.joint.p_PB_m).c_str());
    out.PushAttribute("quat", quaternion_text(body.joint.R_PB).c_str());
  }
  if (index == 0) {
    write_base(out, tree.base);
  } else {
    write_joint(out, body.joint);
  }
  write_inertial(out, body.inertia);
  for (const ContactPoint& contact : contacts) {
    if (contact.point.body != index) continue;
    out.OpenElement("site");
    out.PushAttribute("name", contact.name.c_str());
    out.PushAttribute("pos", text_of(contact.point.p_B_m).c_str());
    out.CloseElement();
  }
  for (std::size_t i = index + 1; i < bodies.size(); ++i) {
    if (bodies[i].parent == index) write_body(out, tree, contacts, i);
  }
  out.CloseElement();
}

void write_motors(tinyxml2::XMLPrinter& out, const dynamics::Tree& tree) {
  out.OpenElement("actuator");
  for (std::size_t i = 1; i < tree.bodies.size(); ++i) {
    const dynamics::Joint& joint = tree.bodies[i].joint;
    if (!std::isfinite(joint.limits.effort_max)) continue;
    out.OpenElement("motor");
    out.PushAttribute("name", joint.name.c_str());
    out.PushAttribute("joint", joint.name.c_str());
    out.PushAttribute("forcelimited", "true");
    const double greatest = joint.limits.effort_max;
    out.PushAttribute("forcerange", fmt::format("{} {}", -greatest, greatest).c_str());
    out.CloseElement();
  }
  out.CloseElement();
}

}  // namespace

Exported mjcf_of(const Robot& robot) {
  Exported exported;
  exported.notes.emplace_back("speed limits of joints are not held");
  const dynamics::Tree tree = tree_with_rotors(robot, exported.notes);
  add_common_notes(robot, exported.notes);
  tinyxml2::XMLPrinter out;
  write_notes(out, exported.notes);
  out.OpenElement("mujoco");
  out.PushAttribute("model", robot.name.c_str());
  out.OpenElement("compiler");
  out.PushAttribute("angle", "radian");
  out.CloseElement();
  out.OpenElement("option");
  out.PushAttribute("gravity", text_of({0, 0, -tree.gravity_m_s2}).c_str());
  out.CloseElement();
  out.OpenElement("worldbody");
  write_body(out, tree, robot.contacts, 0);
  out.CloseElement();
  write_motors(out, tree);
  out.CloseElement();
  exported.text = out.CStr();
  return exported;
}

}  // namespace torquewright::hopper
