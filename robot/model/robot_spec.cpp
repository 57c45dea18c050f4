// SPDX-License-Identifier: Apache-2.0
#include "robot/model/robot_spec.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "io/text/one_line.hpp"
#include "robot/find_name.hpp"
#include "robot/model/follower_spec.hpp"
#include "robot/model/mechanism_spec.hpp"
#include "robot/model/posture_spec.hpp"
#include "robot/model/tree_order.hpp"
#include "robot/parts/body_keys.hpp"
#include "robot/parts/plausible_inertia.hpp"

namespace torquewright::hopper {
namespace {

using dynamics::BaseKind;
using nlohmann::json;

constexpr std::array kInertiaKeys{"mass_kg", "center_of_mass_m", "inertia_kg_m2"};
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
    read_followers(document(), robot_, faults_);
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
    if (const auto objection = inertia_objection(inertia_of(body).inertia_kg_m2)) {
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
    for (JointObjection& objection : joint_objections(joint_at(ends))) {
      report(fmt::format("{}/{}", ends.path, objection.key), std::move(objection.message));
    }
  }

  void add_body(const Place& place) {
    const json& keys = root()["bodies"][place.body];
    dynamics::Body body;
    body.name = body_names_[place.body];
    body.inertia = inertia_of(keys);
    if (place.joint == nullptr) {
      body.joint.p_PB_m = vector_of(root()["base"], "position_m");
      body.joint.R_PB = rotation_of(root()["base"]);
    } else {
      body.parent = *tree_index(place.joint->parent);
      const json& joint = joint_at(*place.joint);
      body.joint = joint_of(joint);
      body.joint.name = place.joint->joint;
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
