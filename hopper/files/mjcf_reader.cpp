// SPDX-License-Identifier: Apache-2.0
// Fields: MuJoCo's XML reference (mujoco.readthedocs.io, XMLreference).
#include "hopper/files/mjcf_reader.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <numbers>

#include "dynamics/rigid_inertia.hpp"
#include "hopper/files/mjcf_defaults.hpp"
#include "hopper/files/xml.hpp"

namespace torquewright::hopper {
namespace {

using dynamics::BaseKind;
using dynamics::JointKind;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using tinyxml2::XMLElement;

class MjcfReader {
 public:
  explicit MjcfReader(const std::filesystem::path& file)
      : xml_(file, "mujoco"), defaults_(xml_.root()) {}

  Imported read() {
    Robot& robot = imported_.robot;
    robot.name = attribute(xml_.root(), "model");
    if (robot.name.empty()) robot.name = "robot";
    read_options();
    refuse_loops();
    const XMLElement* top = only_tree();
    xml_.refuse_faults();
    robot.tree.base = base_of(*top);
    if (robot.tree.base == BaseKind::kFixed && !joints_in(*top).empty()) {
      draft_.emplace_back();
      draft_.back().body.name = "world";
      read_body(*top, 0, "");
    } else {
      read_base(*top);
    }
    xml_.refuse_faults();
    robot.tree.bodies = without_welds(draft_);
    imported_.notes.emplace_back(
        "shapes, damping, friction and actuators were left behind (no mesh "
        "was opened); contact points are to be stated");
    return std::move(imported_);
  }

 private:
  void read_options() {
    for (const XMLElement* compiler : children(xml_.root(), "compiler")) {
      if (attribute(*compiler, "angle") == "radian") per_degree_ = 1;
      if (attribute(*compiler, "coordinate") == "global") {
        xml_.report(*compiler, "coordinate must be local");
      }
      const std::string order = attribute(*compiler, "eulerseq");
      if (!order.empty() && order != "xyz") xml_.report(*compiler, "eulerseq must be xyz");
    }
    for (const XMLElement* option : children(xml_.root(), "option")) {
      const Vector3d gravity = xml_.vector(*option, "gravity", {0, 0, -9.81});
      if (gravity.x() != 0 || gravity.y() != 0 || gravity.z() > 0) {
        xml_.report(*option, "gravity must point along -z");
      }
      imported_.robot.tree.gravity_m_s2 = -gravity.z();
    }
  }

  void refuse_loops() {
    const XMLElement* equality = xml_.root().FirstChildElement("equality");
    if (equality == nullptr) return;
    for (const auto* one = equality->FirstChildElement(); one != nullptr;
         one = one->NextSiblingElement()) {
      xml_.report(*one,
                  "closes a loop or couples joints, which a tree does not; leave it out and "
                  "state a mechanism");
    }
  }

  const XMLElement* only_tree() {
    const XMLElement* world = xml_.root().FirstChildElement("worldbody");
    if (world == nullptr) {
      xml_.report(xml_.root(), "holds no worldbody");
      return nullptr;
    }
    const auto bodies = children(*world, "body");
    if (bodies.size() != 1) {
      xml_.report(*world, fmt::format("holds {} bodies; one robot, one tree", bodies.size()));
    }
    return bodies.empty() ? nullptr : bodies.front();
  }

  std::vector<const XMLElement*> joints_in(const XMLElement& body) {
    auto joints = children(body, "joint");
    for (const XMLElement* free : children(body, "freejoint")) joints.push_back(free);
    return joints;
  }

  BaseKind base_of(const XMLElement& top) {
    const std::string childclass = attribute(top, "childclass");
    std::string kinds;
    for (const XMLElement* joint : joints_in(top)) {
      const XMLElement& full = defaults_.completed(*joint, childclass);
      const std::string type = attribute(full, "type");
      const Vector3d axis = xml_.vector(full, "axis", Vector3d::UnitZ());
      if (std::string(full.Name()) == "freejoint" || type == "free") return BaseKind::kSpatial;
      if (type == "slide" && axis == Vector3d::UnitX()) kinds += 'x';
      if (type == "slide" && axis == Vector3d::UnitZ()) kinds += 'z';
      if (type != "slide" && axis == Vector3d::UnitY()) kinds += 'p';
    }
    return kinds == "xzp" && joints_in(top).size() == 3 ? BaseKind::kPlanar : BaseKind::kFixed;
  }

  /// The top body is the base itself: it floats, or no joint carries it.
  void read_base(const XMLElement& top) {
    DraftBody base;
    base.body.name = name_of(top);
    if (imported_.robot.tree.base == BaseKind::kFixed) read_pose(top, base.body.joint);
    base.body.inertia = inertia_of(top, imported_.robot.tree.base != BaseKind::kFixed);
    draft_.push_back(std::move(base));
    read_children(top, 0, attribute(top, "childclass"));
  }

  void read_children(const XMLElement& element, std::size_t index, const std::string& childclass) {
    for (const XMLElement* child : children(element, "body")) read_body(*child, index, childclass);
  }

  void read_body(const XMLElement& element, std::size_t parent, const std::string& around) {
    const std::string own = attribute(element, "childclass");
    const std::string& childclass = own.empty() ? around : own;
    const auto joints = joints_in(element);
    DraftBody draft;
    draft.body.name = name_of(element);
    draft.body.parent = parent;
    draft.is_welded = joints.empty();
    read_pose(element, draft.body.joint);
    draft.body.inertia = inertia_of(element, !draft.is_welded);
    Vector3d shift_m = Vector3d::Zero();
    if (joints.size() > 1) {
      xml_.report(element, "has several joints; give each but the last a body of its own");
    } else if (!joints.empty()) {
      shift_m = read_joint(defaults_.completed(*joints.front(), childclass), draft.body.joint);
    }
    // Our frames sit at the joint: the body is seen from there.
    draft.body.joint.p_PB_m += draft.body.joint.R_PB * shift_m;
    draft.body.inertia.center_of_mass_m -= shift_m;
    const std::size_t index = draft_.size();
    draft_.push_back(std::move(draft));
    const std::size_t before = draft_.size();
    read_children(element, index, childclass);
    for (std::size_t i = before; i < draft_.size(); ++i) {
      if (draft_[i].body.parent == index) draft_[i].body.joint.p_PB_m -= shift_m;
    }
  }

  /// Where the joint sits in the body.
  Vector3d read_joint(const XMLElement& element, dynamics::Joint& joint) {
    const std::string type = attribute(element, "type");
    if (!type.empty() && type != "hinge" && type != "slide") {
      xml_.report(element, fmt::format("type \"{}\" must be hinge or slide here", type));
    }
    joint.name = attribute(element, "name");
    if (joint.name.empty()) joint.name = fmt::format("joint_{}", draft_.size());
    joint.kind = type == "slide" ? JointKind::kPrismatic : JointKind::kRevolute;
    const Vector3d axis = xml_.vector(element, "axis", Vector3d::UnitZ());
    if (axis.norm() < 1e-6) {
      xml_.report(element, "the axis has no direction");
    } else {
      joint.axis = axis.normalized();
    }
    joint.reflected_inertia = xml_.number(element, "armature", 0);
    if (joint.reflected_inertia < 0) xml_.report(element, "the armature is negative");
    const std::string limited = attribute(element, "limited");
    const auto range = xml_.numbers(element, "range", 2);
    if (range && limited != "false") {
      const double unit = joint.kind == JointKind::kRevolute ? per_degree_ : 1;
      joint.limits.position_min = unit * range->front();
      joint.limits.position_max = unit * range->back();
      if (!(range->front() < range->back())) {
        xml_.report(element, "the range's first number is not below its second");
      }
    }
    return xml_.vector(element, "pos", Vector3d::Zero());
  }

  void read_pose(const XMLElement& element, dynamics::Joint& joint) {
    joint.p_PB_m = xml_.vector(element, "pos", Vector3d::Zero());
    joint.R_PB = rotation_of(element);
  }

  Matrix3d rotation_of(const XMLElement& element) {
    for (const char* other : {"xyaxes", "zaxis"}) {
      if (element.Attribute(other) == nullptr) continue;
      xml_.report(element, fmt::format("{} is not read; write quat, axisangle or euler", other));
    }
    if (const auto q = xml_.numbers(element, "quat", 4)) {
      const Eigen::Quaterniond quaternion((*q)[0], (*q)[1], (*q)[2], (*q)[3]);
      if (quaternion.norm() > 1e-6) return quaternion.normalized().toRotationMatrix();
      xml_.report(element, "the quaternion is zero");
    }
    if (const auto a = xml_.numbers(element, "axisangle", 4)) {
      const Vector3d axis((*a)[0], (*a)[1], (*a)[2]);
      if (axis.norm() > 1e-6) return turn(per_degree_ * (*a)[3], axis.normalized());
      xml_.report(element, "axisangle has no direction");
    }
    const Vector3d euler = per_degree_ * xml_.vector(element, "euler", Vector3d::Zero());
    return turn(euler[0], Vector3d::UnitX()) * turn(euler[1], Vector3d::UnitY()) *
           turn(euler[2], Vector3d::UnitZ());
  }

  static Matrix3d turn(double angle_rad, const Vector3d& axis) {
    return Eigen::AngleAxisd(angle_rad, axis).toRotationMatrix();
  }

  dynamics::RigidInertia inertia_of(const XMLElement& body, bool is_needed) {
    dynamics::RigidInertia inertia;
    const XMLElement* element = body.FirstChildElement("inertial");
    if (element == nullptr) {
      const bool has_shapes = body.FirstChildElement("geom") != nullptr;
      if (is_needed || has_shapes) {
        xml_.report(body, "states no <inertial>; MuJoCo writes it when it saves the model");
      }
      return inertia;
    }
    inertia.mass_kg = xml_.number(*element, "mass", 0);
    if (inertia.mass_kg < 0) xml_.report(*element, "the mass is negative");
    inertia.center_of_mass_m = xml_.vector(*element, "pos", Vector3d::Zero());
    if (const auto full = xml_.numbers(*element, "fullinertia", 6)) {
      const std::vector<double>& I = *full;
      inertia.inertia_kg_m2 << I[0], I[3], I[4], I[3], I[1], I[5], I[4], I[5], I[2];
      return inertia;
    }
    const Matrix3d R = rotation_of(*element);
    const Vector3d moments = xml_.vector(*element, "diaginertia", Vector3d::Zero());
    const Matrix3d turned = R * moments.asDiagonal() * R.transpose();
    inertia.inertia_kg_m2 = 0.5 * (turned + turned.transpose());
    return inertia;
  }

  std::string name_of(const XMLElement& body) {
    const std::string name = attribute(body, "name");
    return name.empty() ? fmt::format("body_{}", draft_.size()) : name;
  }

  Xml xml_;
  JointDefaults defaults_;
  Imported imported_;
  std::vector<DraftBody> draft_;
  double per_degree_ = std::numbers::pi / 180;
};

}  // namespace

Imported read_mjcf(const std::filesystem::path& file) { return MjcfReader(file).read(); }

}  // namespace torquewright::hopper
