// SPDX-License-Identifier: Apache-2.0
#include "robot/model/robot_spec.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "io/text/one_line.hpp"
#include "robot/find_name.hpp"
#include "robot/model/mechanism_spec.hpp"
#include "robot/model/passive_keys.hpp"
#include "robot/model/plausible_inertia.hpp"
#include "robot/model/posture_spec.hpp"
#include "robot/model/rotations.hpp"
#include "robot/model/tree_order.hpp"

namespace torquewright::hopper {
namespace {

using dynamics::BaseKind;
using dynamics::JointKind;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using nlohmann::json;

constexpr double kNoDirection = 1e-6;
constexpr std::array kInertiaKeys{"mass_kg", "center_of_mass_m", "inertia_kg_m2"};
constexpr std::array kRevoluteKeys{"range_rad", "speed_limit_rad_s", "torque_limit_Nm",
                                   "reflected_inertia_kg_m2"};
constexpr std::array kPrismaticKeys{"range_m", "speed_limit_m_s", "force_limit_N",
                                    "reflected_mass_kg"};

dynamics::PassiveForces passive_of(const json& joint, bool turns) {
  dynamics::PassiveForces passive;
  for (const PassiveKey& key : kPassiveKeys) {
    passive.*key.value = joint.value(turns ? key.of_revolute : key.of_prismatic, 0.0);
  }
  return passive;
}

Vector3d vector_of(const json& keys, const char* key) {
  if (!keys.contains(key)) return Vector3d::Zero();
  const json& list = keys[key];
  return {list[0].get<double>(), list[1].get<double>(), list[2].get<double>()};
}

Matrix3d rotation_of(const json& keys) {
  return rotation_of_rpy(vector_of(keys, "rotation_rpy_rad"));
}

Matrix3d inertia_of(const json& value) {
  if (value.is_number()) return value.get<double>() * Matrix3d::Identity();
  const auto at = [&](const char* key) { return value.value(key, 0.0); };
  Matrix3d inertia;
  inertia << at("xx"), at("xy"), at("xz"), at("xy"), at("yy"), at("yz"), at("xz"), at("yz"),
      at("zz");
  return inertia;
}

/// Reads the keys of one document; faults gather until all of it is read.
class RobotReader {
 public:
  explicit RobotReader(io::Document document) : documents_{std::move(document)} {}

  ReadRobot read() {
    robot_.name = root().value("name", io::stem_in_text(document().file));
    robot_.tree.gravity_m_s2 = root().value("gravity_m_s2", robot_.tree.gravity_m_s2);
    robot_.assumed = root().value("assumed", robot_.assumed);
    body_names_ = names("bodies", "body");
    joint_names_ = names("joints", "joint");
    build_tree();
    if (root().contains("battery")) robot_.battery = root()["battery"].dump();
    read_contacts();
    read_spheres();
    read_mechanisms(robot_, documents_, faults_);
    read_postures(document(), robot_, faults_);
    if (!faults_.empty()) throw io::SpecError(std::move(faults_));
    return {std::move(robot_), std::move(documents_)};
  }

 private:
  const io::Document& document() const { return documents_.front(); }
  const json& root() const { return document().root; }
  json list(const char* key) const { return root().value(key, json::array()); }

  void report(const std::string& path, std::string message) {
    faults_.push_back({document().file, path, std::move(message)});
  }

  std::vector<std::string> names(const char* key, const char* what) {
    std::vector<std::string> found;
    for (const json& entry : list(key)) {
      const std::string name = entry["name"];
      if (name.find_first_not_of(' ') == std::string::npos) {
        report(fmt::format("/{}/{}/name", key, found.size()),
               fmt::format("\"{}\" is blank, must hold a character", name));
      }
      if (std::find(found.begin(), found.end(), name) != found.end()) {
        report(fmt::format("/{}/{}/name", key, found.size()),
               fmt::format("\"{}\" is the name of another {} already", name, what));
      }
      found.push_back(name);
    }
    return found;
  }

  std::optional<std::size_t> find_body(const std::string& name, const std::string& path) {
    return find_name(body_names_, name, "body", {document().file, path, ""}, faults_);
  }

  void build_tree() {
    const json& base = root()["base"];
    const std::string motion = base["motion"];
    robot_.tree.base = motion == "fixed"    ? BaseKind::kFixed
                       : motion == "planar" ? BaseKind::kPlanar
                                            : BaseKind::kSpatial;
    if (robot_.tree.base != BaseKind::kFixed) {
      for (const char* key : {"position_m", "rotation_rpy_rad"}) {
        if (base.contains(key)) report(fmt::format("/base/{}", key), "is for a fixed base only");
      }
    }
    const auto base_body = find_body(base["body"], "/base/body");
    const std::vector<Ends> ends = read_ends();
    const bool is_fixed = robot_.tree.base == BaseKind::kFixed;
    for (std::size_t i = 0; i < body_names_.size(); ++i) {
      check_inertia(i, !(is_fixed && base_body == i));
    }
    for (std::size_t i = 0; i < ends.size(); ++i) check_joint(ends[i]);
    if (!base_body) return;
    for (const Place& place : tree_order(body_names_, *base_body, ends, document().file, faults_)) {
      add_body(place);
    }
  }

  std::vector<Ends> read_ends() {
    std::vector<Ends> ends;
    for (std::size_t i = 0; i < joint_names_.size(); ++i) {
      const json& joint = root()["joints"][i];
      const std::string path = fmt::format("/joints/{}", i);
      const auto parent = find_body(joint["parent"], path + "/parent");
      const auto child = find_body(joint["child"], path + "/child");
      if (parent && child) ends.push_back({joint_names_[i], path, *parent, *child});
    }
    return ends;
  }

  void check_inertia(std::size_t index, bool is_needed) {
    const json& body = root()["bodies"][index];
    const std::string path = fmt::format("/bodies/{}", index);
    int stated = 0;
    for (const char* key : kInertiaKeys) stated += body.contains(key) ? 1 : 0;
    for (const char* key : kInertiaKeys) {
      if (body.contains(key) || stated == 0) continue;
      if (is_needed) report(fmt::format("{}/{}", path, key), "missing");
    }
    if (is_needed && stated == 0 && !carries_another(body_names_[index])) {
      report(path + "/mass_kg", "missing: only a body that carries another may have no mass");
    }
    if (!body.contains("inertia_kg_m2")) return;
    if (const auto objection = inertia_objection(inertia_of(body["inertia_kg_m2"]))) {
      report(path + "/inertia_kg_m2", *objection);
    }
  }

  /// By a joint.
  bool carries_another(const std::string& body) const {
    const json joints = list("joints");
    return std::any_of(joints.begin(), joints.end(),
                       [&](const json& joint) { return joint["parent"] == body; });
  }

  const json& joint_at(const Ends& ends) const { return root().at(json::json_pointer(ends.path)); }

  void check_joint(const Ends& ends) {
    const json& joint = joint_at(ends);
    if (vector_of(joint, "axis").norm() < kNoDirection) {
      report(ends.path + "/axis", "has no direction");
    }
    const bool turns = joint["type"] == "revolute";
    for (const char* key : turns ? kPrismaticKeys : kRevoluteKeys) {
      if (joint.contains(key)) report_other_kind(ends, key, turns);
    }
    for (const PassiveKey& key : kPassiveKeys) {
      const char* name = turns ? key.of_prismatic : key.of_revolute;
      if (joint.contains(name)) report_other_kind(ends, name, turns);
    }
    check_friction(ends, joint, turns);
    const char* range = turns ? "range_rad" : "range_m";
    if (joint.contains(range) && !(joint[range][0] < joint[range][1])) {
      report(fmt::format("{}/{}", ends.path, range),
             fmt::format("{} is not below {}: least position first", joint[range][0].dump(),
                         joint[range][1].dump()));
    }
  }

  void report_other_kind(const Ends& ends, const char* key, bool turns) {
    report(fmt::format("{}/{}", ends.path, key),
           fmt::format("is for {} joints", turns ? "prismatic" : "revolute"));
  }

  void check_friction(const Ends& ends, const json& joint, bool turns) {
    const dynamics::PassiveForces passive = passive_of(joint, turns);
    const char* key = turns ? "static_friction_Nm" : "static_friction_N";
    if (!joint.contains(key) || passive.static_friction >= passive.dry_friction) return;
    report(fmt::format("{}/{}", ends.path, key),
           fmt::format("{:g} is less than the joint's dry friction of {:g}, which holds at rest "
                       "too; state as much or leave it out",
                       passive.static_friction, passive.dry_friction));
  }

  void add_body(const Place& place) {
    const json& keys = root()["bodies"][place.body];
    dynamics::Body body;
    body.name = body_names_[place.body];
    body.inertia.mass_kg = keys.value("mass_kg", 0.0);
    body.inertia.center_of_mass_m = vector_of(keys, "center_of_mass_m");
    if (keys.contains("inertia_kg_m2"))
      body.inertia.inertia_kg_m2 = inertia_of(keys["inertia_kg_m2"]);
    if (place.joint == nullptr) {
      body.joint.p_PB_m = vector_of(root()["base"], "position_m");
      body.joint.R_PB = rotation_of(root()["base"]);
    } else {
      body.parent = *tree_index(place.joint->parent);
      body.joint = joint_of(*place.joint);
      const json& joint = joint_at(*place.joint);
      const bool states_rotor =
          joint.contains("reflected_inertia_kg_m2") || joint.contains("reflected_mass_kg");
      if (states_rotor && body.joint.reflected_inertia == 0) {
        robot_.without_rotor.push_back(robot_.tree.bodies.size());
      }
    }
    robot_.tree.bodies.push_back(std::move(body));
  }

  std::optional<std::size_t> tree_index(std::size_t body) const {
    const auto& bodies = robot_.tree.bodies;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (bodies[i].name == body_names_[body]) return i;
    }
    return std::nullopt;
  }

  dynamics::Joint joint_of(const Ends& ends) const {
    const json& keys = joint_at(ends);
    const bool turns = keys["type"] == "revolute";
    dynamics::Joint joint;
    joint.name = ends.joint;
    joint.kind = turns ? JointKind::kRevolute : JointKind::kPrismatic;
    joint.p_PB_m = vector_of(keys, "position_m");
    joint.R_PB = rotation_of(keys);
    const Vector3d axis = vector_of(keys, "axis");
    if (axis.norm() >= kNoDirection) joint.axis = axis.normalized();
    joint.rotor_spin_kg_m2 = vector_of(keys, "rotor_spin_kg_m2");
    joint.reflected_inertia =
        keys.value(turns ? "reflected_inertia_kg_m2" : "reflected_mass_kg", 0.0);
    joint.passive = passive_of(keys, turns);
    dynamics::JointLimits& limits = joint.limits;
    const char* range = turns ? "range_rad" : "range_m";
    // What is no range was reported.
    if (keys.contains(range) && keys[range][0] < keys[range][1]) {
      limits.position_min = keys[range][0];
      limits.position_max = keys[range][1];
    }
    limits.speed_max =
        keys.value(turns ? "speed_limit_rad_s" : "speed_limit_m_s", limits.speed_max);
    limits.effort_max = keys.value(turns ? "torque_limit_Nm" : "force_limit_N", limits.effort_max);
    for (const std::string own : keys.value("own_limits", json::array())) {
      (own == "speed" ? limits.owns_speed : limits.owns_effort) = true;
    }
    return joint;
  }

  void read_contacts() {
    (void)names("contacts", "contact");
    const json contacts = list("contacts");
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      const auto body = find_body(contacts[i]["body"], fmt::format("/contacts/{}/body", i));
      if (!body) continue;
      const auto index = tree_index(*body);
      if (!index) continue;  // reported as a fault of the tree
      robot_.contacts.push_back({contacts[i]["name"],
                                 {*index, vector_of(contacts[i], "position_m")},
                                 contacts[i]["friction_coefficient"],
                                 contacts[i].value("restitution", 0.0),
                                 contacts[i].value("radius_m", 0.0)});
    }
  }

  void read_spheres() {
    const json spheres = list("collision_spheres");
    for (std::size_t i = 0; i < spheres.size(); ++i) {
      const auto body = find_body(spheres[i]["body"], fmt::format("/collision_spheres/{}/body", i));
      if (!body) continue;
      const auto index = tree_index(*body);
      if (!index) continue;
      robot_.spheres.push_back(
          {{*index, vector_of(spheres[i], "center_m")}, spheres[i]["radius_m"]});
    }
  }

  std::vector<io::Document> documents_;
  Robot robot_;
  std::vector<std::string> body_names_;
  std::vector<std::string> joint_names_;
  std::vector<io::Fault> faults_;
};

}  // namespace

ReadRobot read_robot(const std::filesystem::path& file) {
  return robot_of(io::read_document(file, "robot"));
}

ReadRobot robot_of(io::Document document) { return RobotReader(std::move(document)).read(); }

}  // namespace torquewright::hopper
