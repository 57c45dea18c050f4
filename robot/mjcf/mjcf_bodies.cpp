// SPDX-License-Identifier: Apache-2.0
// Fields: MuJoCo's XML reference (mujoco.readthedocs.io, XMLreference), "body", "joint",
// "inertial", "geom".
#include "robot/mjcf/mjcf_bodies.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "actuator/exporters/text.hpp"
#include "robot/xml/xml_text.hpp"

namespace torquewright::hopper {
namespace {

using dynamics::BaseKind;
using dynamics::Body;
using dynamics::JointKind;
using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kContactBall_m = 1e-3;  // a point that MuJoCo can let touch

std::string quaternion_text(const Matrix3d& R) {
  const Eigen::Quaterniond q(R);
  return fmt::format("{} {} {} {}", q.w(), q.x(), q.y(), q.z());
}

struct Pose {
  Matrix3d R = Matrix3d::Identity();
  Vector3d p_m = Vector3d::Zero();
};

Pose operator*(const Pose& one, const Pose& other) {
  return {one.R * other.R, one.p_m + one.R * other.p_m};
}

Pose pose_of_body(const Body& body) { return {body.joint.R_PB, body.joint.p_PB_m}; }

class BodyWriter {
 public:
  BodyWriter(tinyxml2::XMLPrinter& out, const Robot& robot, const dynamics::Tree& tree,
             const std::vector<double>& references, bool collides, bool has_stiff_friction)
      : out_(out),
        robot_(robot),
        tree_(tree),
        references_(references),
        collides_(collides),
        has_stiff_friction_(has_stiff_friction) {}

  void write() {
    const Body& base = tree_.bodies.front();
    const bool is_world =
        tree_.base == BaseKind::kFixed && !(base.inertia.mass_kg > 0) && !holds_points(0);
    if (is_world) {
      write_children(0, pose_of_body(base));
    } else {
      write_body({0}, {});
    }
  }

 private:
  bool holds_points(std::size_t index) const {
    const auto is_here = [&](const auto& point) { return point.body == index; };
    return std::any_of(robot_.contacts.begin(), robot_.contacts.end(),
                       [&](const ContactPoint& next) { return is_here(next.point); }) ||
           std::any_of(robot_.spheres.begin(), robot_.spheres.end(),
                       [&](const CollisionSphere& next) { return is_here(next.center); });
  }

  std::vector<std::size_t> carried_by(std::size_t index) const {
    std::vector<std::size_t> carried;
    for (std::size_t i = index + 1; i < tree_.bodies.size(); ++i) {
      if (tree_.bodies[i].parent == index) carried.push_back(i);
    }
    return carried;
  }

  void write_children(std::size_t index, const Pose& at) {
    for (const std::size_t first : carried_by(index)) write_body(chain_from(first), at);
  }

  /// The body, before it those without mass that carry nothing but the next.
  std::vector<std::size_t> chain_from(std::size_t first) const {
    std::vector<std::size_t> chain{first};
    for (;;) {
      const std::size_t last = chain.back();
      const auto carried = carried_by(last);
      const bool is_link = !(tree_.bodies[last].inertia.mass_kg > 0) && !holds_points(last);
      if (!is_link || carried.size() != 1) return chain;
      chain.push_back(carried.front());
    }
  }

  /// `around`: where what carries the chain stands in the element that is being written.
  void write_body(const std::vector<std::size_t>& chain, const Pose& around) {
    const std::size_t index = chain.back();
    const Body& body = tree_.bodies[index];
    out_.OpenElement("body");
    out_.PushAttribute("name", name_of(body).c_str());
    if (index > 0 || tree_.base == BaseKind::kFixed) {
      Pose pose = around;
      for (const std::size_t next : chain) pose = pose * pose_of_body(tree_.bodies[next]);
      out_.PushAttribute("pos", text_of(pose.p_m).c_str());
      out_.PushAttribute("quat", quaternion_text(pose.R).c_str());
    }
    if (index == 0) write_base();
    if (index > 0) write_joints(chain);
    write_inertial(body.inertia);
    write_points(index);
    write_children(index, {});
    out_.CloseElement();
  }

  /// MuJoCo keeps this name for itself.
  std::string name_of(const Body& body) const {
    std::string name = body.name;
    if (name != "world") return name;
    const auto is_taken = [&](const Body& other) { return other.name == name; };
    while (std::any_of(tree_.bodies.begin(), tree_.bodies.end(), is_taken)) name += "_";
    return name;
  }

  void write_joints(const std::vector<std::size_t>& chain) {
    for (std::size_t i = 0; i < chain.size(); ++i) {
      Pose last;  // the chain's last body in this one
      for (std::size_t k = i + 1; k < chain.size(); ++k) {
        last = last * pose_of_body(tree_.bodies[chain[k]]);
      }
      const dynamics::Joint& joint = tree_.bodies[chain[i]].joint;
      open_joint(joint, last.R.transpose() * joint.axis, -(last.R.transpose() * last.p_m));
      if (robot_.states_rotor(chain[i], joint)) {
        out_.PushAttribute("armature", text_of(joint.reflected_inertia).c_str());
      }
      const double reference = references_.empty() ? 0 : references_[chain[i]];
      if (reference != 0) out_.PushAttribute("ref", text_of(reference).c_str());
      close_joint(joint);
    }
  }

  void open_joint(const dynamics::Joint& joint, const Vector3d& axis, const Vector3d& place_m) {
    out_.OpenElement("joint");
    out_.PushAttribute("name", joint.name.c_str());
    out_.PushAttribute("type", joint.kind == JointKind::kRevolute ? "hinge" : "slide");
    out_.PushAttribute("axis", text_of(axis).c_str());
    if (!place_m.isZero(0)) out_.PushAttribute("pos", text_of(place_m).c_str());
  }

  void close_joint(const dynamics::Joint& joint) {
    write_passive(joint.passive);
    if (std::isfinite(joint.limits.position_min)) {
      out_.PushAttribute("limited", "true");
      out_.PushAttribute(
          "range",
          fmt::format("{} {}", joint.limits.position_min, joint.limits.position_max).c_str());
    }
    out_.CloseElement();
  }

  /// What MuJoCo's friction holds at rest is as much as while the joint moves.
  void write_passive(const dynamics::PassiveForces& passive) {
    const auto write = [&](const char* key, double value) {
      if (value != 0) out_.PushAttribute(key, text_of(value).c_str());
    };
    write("damping", passive.damping);
    write("frictionloss", passive.dry_friction);
    if (has_stiff_friction_ && passive.dry_friction != 0) {
      out_.PushAttribute("solreffriction", std::string(actuator::kFrictionConstraint).c_str());
    }
    write("stiffness", passive.stiffness);
    write("springref", passive.rest_position);
  }

  /// By principal axes: of a full inertia MuJoCo finds them to some nine digits only.
  void write_inertial(const dynamics::RigidInertia& inertia) {
    if (!(inertia.mass_kg > 0)) return;
    out_.OpenElement("inertial");
    out_.PushAttribute("pos", text_of(inertia.center_of_mass_m).c_str());
    out_.PushAttribute("mass", text_of(inertia.mass_kg).c_str());
    Vector3d moments = inertia.inertia_kg_m2.diagonal();
    if (inertia.inertia_kg_m2 != Matrix3d(moments.asDiagonal())) {
      const Eigen::SelfAdjointEigenSolver<Matrix3d> axes(inertia.inertia_kg_m2);
      Matrix3d R = axes.eigenvectors();
      if (R.determinant() < 0) R.col(0) *= -1;
      moments = axes.eigenvalues();
      out_.PushAttribute("quat", quaternion_text(R).c_str());
    }
    out_.PushAttribute("diaginertia", text_of(moments).c_str());
    out_.CloseElement();
  }

  void write_base_joint(const char* name, const char* type, const char* axis) {
    out_.OpenElement("joint");
    out_.PushAttribute("name", name);
    out_.PushAttribute("type", type);
    out_.PushAttribute("axis", axis);
    out_.CloseElement();
  }

  void write_base() {
    if (tree_.base == BaseKind::kSpatial) {
      out_.OpenElement("freejoint");
      out_.CloseElement();
    } else if (tree_.base == BaseKind::kPlanar) {
      write_base_joint("base_x", "slide", "1 0 0");
      write_base_joint("base_z", "slide", "0 0 1");
      write_base_joint("base_pitch", "hinge", "0 1 0");
    }
  }

  void write_points(std::size_t index) {
    for (const ContactPoint& contact : robot_.contacts) {
      if (contact.point.body != index) continue;
      out_.OpenElement("site");
      out_.PushAttribute("name", contact.name.c_str());
      out_.PushAttribute("pos", text_of(contact.point.p_B_m).c_str());
      out_.CloseElement();
      if (!collides_) continue;
      // With the ground alone, and its friction is that of the pair: the greater of both.
      const double radius_m = contact.radius_m > 0 ? contact.radius_m : kContactBall_m;
      write_ball(contact.name, contact.point.p_B_m, radius_m, {0, 1}, contact.friction_coefficient);
    }
    for (const CollisionSphere& sphere : robot_.spheres) {
      if (!collides_ || sphere.center.body != index) continue;
      write_ball("", sphere.center.p_B_m, sphere.radius_m, {2, 2}, 0);
    }
  }

  struct Meets {
    int type;
    int affinity;
  };
  void write_ball(const std::string& name, const Vector3d& place_m, double radius_m, Meets meets,
                  double friction) {
    out_.OpenElement("geom");
    if (!name.empty()) out_.PushAttribute("name", name.c_str());
    out_.PushAttribute("type", "sphere");
    out_.PushAttribute("size", text_of(radius_m).c_str());
    out_.PushAttribute("pos", text_of(place_m).c_str());
    out_.PushAttribute("mass", "0");
    out_.PushAttribute("contype", meets.type);
    out_.PushAttribute("conaffinity", meets.affinity);
    out_.PushAttribute("friction", fmt::format("{} 0 0", friction).c_str());
    out_.CloseElement();
  }

  tinyxml2::XMLPrinter& out_;
  const Robot& robot_;
  const dynamics::Tree& tree_;
  const std::vector<double>& references_;
  bool collides_;
  bool has_stiff_friction_;
};

void number(const dynamics::Tree& tree, std::size_t index, std::vector<std::size_t>& order) {
  order.push_back(index);
  for (std::size_t i = index + 1; i < tree.bodies.size(); ++i) {
    if (tree.bodies[i].parent == index) number(tree, i, order);
  }
}

}  // namespace

void write_bodies(tinyxml2::XMLPrinter& out, const Robot& robot, const dynamics::Tree& tree,
                  const std::vector<double>& references, bool collides, bool has_stiff_friction) {
  BodyWriter(out, robot, tree, references, collides, has_stiff_friction).write();
}

std::vector<std::size_t> mjcf_order(const dynamics::Tree& tree) {
  std::vector<std::size_t> order;
  number(tree, 0, order);
  return order;
}

}  // namespace torquewright::hopper
