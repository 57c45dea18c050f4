// SPDX-License-Identifier: Apache-2.0
// Fields: the URDF XML specification (wiki.ros.org/urdf/XML), and Drake's <drake:rotor_inertia>,
// <drake:gear_ratio> in a transmission's actuator (drake.mit.edu, "Notes on parsing").
#include "hopper/files/urdf_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "dynamics/rigid_inertia.hpp"
#include "hopper/files/xml.hpp"
#include "hopper/find_name.hpp"
#include "hopper/robot/rotations.hpp"
#include "hopper/robot/tree_order.hpp"

namespace torquewright::hopper {
namespace {

using dynamics::JointKind;
using Eigen::Vector3d;
using tinyxml2::XMLElement;

class UrdfReader {
 public:
  explicit UrdfReader(const std::filesystem::path& file)
      : file_(file.string()), xml_(file, "robot") {}

  Imported read() {
    imported_.robot.name = attribute(xml_.root(), "name");
    links_ = children(xml_.root(), "link");
    for (const XMLElement* link : links_) link_names_.push_back(xml_.needed(*link, "name"));
    if (links_.empty()) xml_.report(xml_.root(), "holds no link");
    xml_.refuse_faults();
    read_ends();
    const std::vector<Place> order = tree_order(link_names_, root_link(), ends_, file_, faults_);
    if (!faults_.empty()) throw io::SpecError(faults_);
    read_transmissions();
    std::vector<DraftBody> draft;
    std::map<std::size_t, std::size_t> places;
    for (const Place& place : order) {
      places[place.body] = draft.size();
      draft.push_back(drafted(place, places));
    }
    xml_.refuse_faults();
    imported_.robot.tree.bodies = without_welds(draft);
    const bool is_world = draft.front().body.name == "world";
    imported_.robot.tree.base =
        is_world ? dynamics::BaseKind::kFixed : dynamics::BaseKind::kSpatial;
    note_what_is_left();
    return std::move(imported_);
  }

 private:
  void read_ends() {
    joints_ = children(xml_.root(), "joint");
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      const XMLElement& joint = *joints_[i];
      const std::string name = xml_.needed(joint, "name");
      const std::string where = fmt::format("line {}, joint \"{}\"", joint.GetLineNum(), name);
      std::optional<std::size_t> link[2];
      for (int side = 0; side < 2; ++side) {
        const char* which = side == 0 ? "parent" : "child";
        const XMLElement* element = joint.FirstChildElement(which);
        const std::string wanted = element == nullptr ? "" : attribute(*element, "link");
        link[side] = find_name(link_names_, wanted, "link", {where, "", ""}, name_faults_);
        if (!link[side]) xml_.report(joint, name_faults_.back().message);
      }
      if (link[0] && link[1]) ends_.push_back({name, "", *link[0], *link[1]});
      joint_of_[name] = &joint;
    }
    for (const Ends& ends : ends_) {
      if (std::count_if(ends_.begin(), ends_.end(),
                        [&](const Ends& other) { return other.joint == ends.joint; }) > 1) {
        xml_.report(*joint_of_[ends.joint], "its name stands twice");
      }
    }
    xml_.refuse_faults();
  }

  /// That no joint carries; the first of several, the others are faults of the tree.
  std::size_t root_link() {
    for (std::size_t i = 0; i < link_names_.size(); ++i) {
      const bool is_carried = std::any_of(ends_.begin(), ends_.end(),
                                          [&](const Ends& ends) { return ends.child == i; });
      if (!is_carried) return i;
    }
    xml_.report(xml_.root(), "every link is carried by a joint: a closed loop is no tree");
    xml_.refuse_faults();
    return 0;
  }

  DraftBody drafted(const Place& place, const std::map<std::size_t, std::size_t>& places) {
    DraftBody draft;
    draft.body.name = link_names_[place.body];
    draft.body.inertia = inertia_of(*links_[place.body]);
    if (place.joint == nullptr) return draft;
    draft.body.parent = places.at(place.joint->parent);
    read_joint(*joint_of_[place.joint->joint], draft);
    return draft;
  }

  dynamics::RigidInertia inertia_of(const XMLElement& link) {
    dynamics::RigidInertia inertia;
    const XMLElement* inertial = link.FirstChildElement("inertial");
    if (inertial == nullptr) return inertia;
    const XMLElement* mass = inertial->FirstChildElement("mass");
    const XMLElement* moments = inertial->FirstChildElement("inertia");
    if (mass == nullptr || moments == nullptr) {
      xml_.report(*inertial, "needs <mass> and <inertia>");
      return inertia;
    }
    inertia.mass_kg = xml_.number(*mass, "value", 0);
    if (inertia.mass_kg < 0) xml_.report(*mass, "is negative");
    const auto at = [&](const char* key) { return xml_.number(*moments, key, 0); };
    const double xy = at("ixy");
    const double xz = at("ixz");
    const double yz = at("iyz");
    inertia.inertia_kg_m2 << at("ixx"), xy, xz, xy, at("iyy"), yz, xz, yz, at("izz");
    const XMLElement* origin = inertial->FirstChildElement("origin");
    if (origin == nullptr) return inertia;
    return dynamics::moved(inertia, rotation_of_rpy(xml_.vector(*origin, "rpy", Vector3d::Zero())),
                           xml_.vector(*origin, "xyz", Vector3d::Zero()));
  }

  void read_joint(const XMLElement& element, DraftBody& draft) {
    dynamics::Joint& joint = draft.body.joint;
    const std::string type = attribute(element, "type");
    joint.name = attribute(element, "name");
    draft.is_welded = type == "fixed";
    joint.kind = type == "prismatic" ? JointKind::kPrismatic : JointKind::kRevolute;
    if (type != "revolute" && type != "continuous" && type != "prismatic" && type != "fixed") {
      xml_.report(element, fmt::format("type \"{}\" must be revolute, continuous, prismatic or "
                                       "fixed",
                                       type));
    }
    if (const XMLElement* origin = element.FirstChildElement("origin")) {
      joint.p_PB_m = xml_.vector(*origin, "xyz", Vector3d::Zero());
      joint.R_PB = rotation_of_rpy(xml_.vector(*origin, "rpy", Vector3d::Zero()));
    }
    joint.axis = Vector3d::UnitX();  // URDF's
    if (const XMLElement* axis = element.FirstChildElement("axis")) {
      const Vector3d along = xml_.vector(*axis, "xyz", Vector3d::UnitX());
      if (along.norm() < 1e-6 && !draft.is_welded) xml_.report(*axis, "has no direction");
      if (along.norm() >= 1e-6) joint.axis = along.normalized();
    }
    if (const XMLElement* limit = element.FirstChildElement("limit")) {
      read_limits(*limit, type != "continuous", joint);
    }
    if (element.FirstChildElement("mimic") != nullptr) {
      imported_.notes.push_back(fmt::format(
          "joint \"{}\" mimics another: it is free here; state a mechanism", joint.name));
    }
    const auto reflected = reflected_.find(joint.name);
    if (reflected != reflected_.end()) joint.reflected_inertia = reflected->second;
  }

  void read_limits(const XMLElement& element, bool has_range, dynamics::Joint& joint) {
    dynamics::JointLimits& limits = joint.limits;
    if (has_range) {
      limits.position_min = xml_.number(element, "lower", 0);
      limits.position_max = xml_.number(element, "upper", 0);
      if (!(limits.position_min < limits.position_max)) {
        xml_.report(element, fmt::format("lower {} is not below upper {}", limits.position_min,
                                         limits.position_max));
      }
    }
    // Zero stands for "not known" in most files.
    const double effort = xml_.number(element, "effort", 0);
    const double speed = xml_.number(element, "velocity", 0);
    if (effort > 0) limits.effort_max = effort;
    if (speed > 0) limits.speed_max = speed;
  }

  void read_transmissions() {
    for (const XMLElement* transmission : children(xml_.root(), "transmission")) {
      const XMLElement* joint = transmission->FirstChildElement("joint");
      const XMLElement* motor = transmission->FirstChildElement("actuator");
      if (joint == nullptr || motor == nullptr) continue;
      const XMLElement* inertia = motor->FirstChildElement("drake:rotor_inertia");
      const XMLElement* ratio = motor->FirstChildElement("drake:gear_ratio");
      if (inertia == nullptr) continue;
      const double N = ratio == nullptr ? 1 : xml_.number(*ratio, "value", 1);
      reflected_[attribute(*joint, "name")] = N * N * xml_.number(*inertia, "value", 0);
    }
  }

  void note_what_is_left() {
    std::size_t shapes = 0;
    for (const XMLElement* link : links_) {
      shapes += children(*link, "visual").size() + children(*link, "collision").size();
    }
    if (shapes > 0) {
      imported_.notes.push_back(
          fmt::format("{} shapes were left behind (no mesh was opened); contact points are to be "
                      "stated",
                      shapes));
    }
    const bool has_losses = std::any_of(
        joints_.begin(), joints_.end(),
        [](const XMLElement* joint) { return joint->FirstChildElement("dynamics") != nullptr; });
    if (has_losses) {
      imported_.notes.emplace_back(
          "damping and friction of joints were left behind: they are "
          "effects of an actuator");
    }
  }

  std::string file_;
  Xml xml_;
  Imported imported_;
  std::vector<const XMLElement*> links_;
  std::vector<const XMLElement*> joints_;
  std::vector<std::string> link_names_;
  std::vector<Ends> ends_;
  std::map<std::string, const XMLElement*> joint_of_;
  std::map<std::string, double> reflected_;
  std::vector<io::Fault> faults_;
  std::vector<io::Fault> name_faults_;
};

}  // namespace

Imported read_urdf(const std::filesystem::path& file) { return UrdfReader(file).read(); }

}  // namespace torquewright::hopper
