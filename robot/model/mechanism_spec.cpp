// SPDX-License-Identifier: Apache-2.0
#include "robot/model/mechanism_spec.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <system_error>

#include "actuator/motor/actuator_spec.hpp"
#include "actuator/region/torque_at.hpp"
#include "robot/find_name.hpp"
#include "robot/mechanisms/library_spec.hpp"
#include "robot/model/mechanism_reach.hpp"
#include "robot/model/transmission_limit_spec.hpp"

namespace torquewright::hopper {
namespace {

using nlohmann::json;

class MechanismReader {
 public:
  MechanismReader(Robot& robot, std::vector<io::Document>& documents,
                  std::vector<io::Fault>& faults)
      : robot_(robot),
        documents_(documents),
        faults_(faults),
        file_(documents.front().file),
        root_(documents.front().root) {
    for (const json& joint : root_["joints"]) joint_names_.push_back(joint["name"]);
  }

  void read() {
    const json mechanisms = root_.value("mechanisms", json::array());
    for (std::size_t i = 0; i < mechanisms.size(); ++i) {
      read_one(mechanisms[i], fmt::format("/mechanisms/{}", i));
    }
  }

 private:
  void report(const std::string& path, std::string message) {
    faults_.push_back({file_, path, std::move(message)});
  }

  void read_one(const json& keys, const std::string& path) {
    Drivetrain drivetrain;
    std::vector<std::string> types;
    for (const MechanismType* type : mechanism_types()) types.emplace_back(type->name);
    const auto index =
        find_name(types, keys["type"], "mechanism", {file_, path + "/type", ""}, faults_);
    if (!index) return;
    const MechanismType& type = *mechanism_types()[*index];
    const std::size_t needed = type.joints > 0 ? type.joints : keys["joints"].size();
    for (const char* key : {"joints", "actuators"}) {
      if (keys[key].size() == needed) continue;
      report(fmt::format("{}/{}", path, key),
             fmt::format("must have {}, not {}", needed, keys[key].size()));
    }
    for (std::size_t i = 0; i < keys["joints"].size(); ++i) {
      claim(keys["joints"][i], fmt::format("{}/joints/{}", path, i), drivetrain);
    }
    for (std::size_t i = 0; i < keys["actuators"].size(); ++i) {
      read_actuator(keys["actuators"][i], fmt::format("{}/actuators/{}", path, i), drivetrain);
    }
    read_names(keys, path, drivetrain);
    refuse_repeated_names(drivetrain, path);
    read_inertias(keys, path, "reflected_inertia_kg_m2", drivetrain.stated_rotors_kg_m2);
    read_inertias(keys, path, "crank_inertia_kg_m2", drivetrain.cranks_kg_m2);
    if (keys.contains("mounted_on")) read_mount(keys["mounted_on"], path, drivetrain);
    if (keys.contains("transmission_limit")) {
      drivetrain.transmission_limit =
          read_transmission_limit(keys["transmission_limit"],
                                  {file_, path + "/transmission_limit", ""}, documents_, faults_);
    }
    const MechanismKeys own{keys, robot_.tree, drivetrain.joints, {file_, path, ""}, faults_};
    if (has_right_keys(type, own)) drivetrain.mechanism = type.read(own);
    const std::size_t driven = drivetrain.joints.size();
    if (driven == needed && driven == drivetrain.actuators.size() && drivetrain.mechanism) {
      reflect(drivetrain, path);
      reach_faults(robot_.tree, drivetrain, {file_, path, ""}, faults_);
    }
    robot_.drivetrains.push_back(std::move(drivetrain));
  }

  /// Of one actuator on one joint: the joint's. Else as stated, or the joints' with a number.
  void read_names(const json& keys, const std::string& path, Drivetrain& drivetrain) {
    std::vector<std::string> joints = keys["joints"];
    if (joints.size() == 1) {
      drivetrain.actuator_names = joints;
    } else if (!keys.contains("actuator_names")) {
      for (std::size_t i = 0; i < joints.size(); ++i) {
        drivetrain.actuator_names.push_back(fmt::format("{}_{}", fmt::join(joints, "_"), i + 1));
      }
    } else {
      drivetrain.actuator_names = keys["actuator_names"];
      if (drivetrain.actuator_names.size() != joints.size()) {
        report(path + "/actuator_names", fmt::format("must have {}, not {}", joints.size(),
                                                     drivetrain.actuator_names.size()));
      }
    }
  }

  /// Options and other documents name drives.
  void refuse_repeated_names(const Drivetrain& drivetrain, const std::string& path) {
    for (const std::string& name : drivetrain.actuator_names) {
      if (drive_names_.insert(name).second) continue;
      // A joint with two drives was reported as such.
      if (std::count(driven_.begin(), driven_.end(), name) > 1) continue;
      report(path + (drivetrain.actuator_names.size() > 1 ? "/actuator_names" : "/joints"),
             fmt::format("\"{}\" is the name of another drive already", name));
    }
  }

  /// One per actuator.
  void read_inertias(const json& keys, const std::string& path, const char* key,
                     std::vector<double>& inertias_kg_m2) {
    if (!keys.contains(key)) return;
    inertias_kg_m2 = keys[key].get<std::vector<double>>();
    if (inertias_kg_m2.size() == keys["actuators"].size()) return;
    report(fmt::format("{}/{}", path, key),
           fmt::format("must have {}, not {}", keys["actuators"].size(), inertias_kg_m2.size()));
    inertias_kg_m2.clear();
  }

  void read_mount(const json& keys, const std::string& path, Drivetrain& drivetrain) {
    std::vector<std::string> bodies;
    for (const dynamics::Body& body : robot_.tree.bodies) bodies.push_back(body.name);
    const auto body =
        find_name(bodies, keys["body"], "body", {file_, path + "/mounted_on/body", ""}, faults_);
    const json& place = keys["position_m"];
    if (!body) return;
    drivetrain.mount = dynamics::BodyPoint{
        *body,
        Eigen::Vector3d(place[0].get<double>(), place[1].get<double>(), place[2].get<double>())};
  }

  /// A joint may be driven once.
  void claim(const std::string& name, const std::string& path, Drivetrain& drivetrain) {
    if (!find_name(joint_names_, name, "joint", {file_, path, ""}, faults_)) return;
    if (std::find(driven_.begin(), driven_.end(), name) != driven_.end()) {
      report(path, fmt::format("\"{}\" is driven by another mechanism already", name));
    }
    driven_.push_back(name);
    if (const auto body = robot_.find_joint(name)) drivetrain.joints.push_back(*body);
  }

  void read_actuator(const std::string& name, const std::string& path, Drivetrain& drivetrain) {
    drivetrain.actuator_files.push_back(name);
    const std::filesystem::path file = std::filesystem::path(file_).parent_path() / name;
    std::error_code unknown;
    if (!std::filesystem::exists(file, unknown)) {
      return report(path, fmt::format("\"{}\": no such file, seen from this document", name));
    }
    try {
      io::Document document = io::read_document(file, "actuator");
      // The robot's battery feeds every drive that states none of its own.
      // What is known by its curve takes no current, so that no battery feeds it.
      const bool has_battery =
          document.root.contains("battery") || document.root.contains("envelope");
      if (root_.contains("battery") && !has_battery) document.root["battery"] = root_["battery"];
      drivetrain.on_robots_battery.push_back(!has_battery);
      actuator::ReadActuator read = actuator::read_actuator(std::move(document));
      drivetrain.actuators.push_back(std::move(read.actuator));
      std::move(read.documents.begin(), read.documents.end(), std::back_inserter(documents_));
    } catch (const io::SpecError& error) {
      faults_.insert(faults_.end(), error.faults().begin(), error.faults().end());
    }
  }

  bool states_inertia(const std::string& joint) const {
    const auto found = std::find(joint_names_.begin(), joint_names_.end(), joint);
    const auto index = static_cast<std::size_t>(found - joint_names_.begin());
    const json& keys = root_["joints"][index];
    return keys.contains("reflected_inertia_kg_m2") || keys.contains("reflected_mass_kg");
  }

  /// What the mechanism states of reflected inertia holds, and its joints may have more of their
  /// own; else what joints state. Else that of one actuator at a constant ratio stands in its
  /// joint; what changes with posture, or couples joints, is left to the drivetrain.
  void reflect(Drivetrain& drivetrain, const std::string& path) {
    if (!drivetrain.stated_rotors_kg_m2.empty()) {
      drivetrain.rotors_in_tree = false;
      return;
    }
    for (const std::size_t body : drivetrain.joints) {
      const std::string& joint = robot_.tree.bodies[body].joint.name;
      if (!states_inertia(joint)) continue;
      drivetrain.joints_state_rotors = true;
      if (drivetrain.cranks_kg_m2.empty()) return;
      report(
          path + "/crank_inertia_kg_m2",
          fmt::format("joint \"{}\" states what rotors weigh at it, at which its crank would not "
                      "be counted; state reflected_inertia_kg_m2 here instead",
                      joint));
      return;
    }
    if (!drivetrain.cranks_kg_m2.empty()) {
      drivetrain.rotors_in_tree = false;
      return;
    }
    const auto jacobian = drivetrain.mechanism->constant_jacobian();
    if (!jacobian || drivetrain.joints.size() > 1) {
      drivetrain.rotors_in_tree = false;
      return;
    }
    dynamics::Joint& joint = robot_.tree.bodies[drivetrain.joints.front()].joint;
    const double ratio = (*jacobian)(0, 0);
    joint.reflected_inertia =
        ratio * ratio * actuator::reflected_inertia_kg_m2(drivetrain.actuators.front());
  }

  Robot& robot_;
  std::vector<io::Document>& documents_;
  std::vector<io::Fault>& faults_;
  const std::string file_;  // documents move when they grow in number
  const json root_;
  std::vector<std::string> joint_names_;
  std::vector<std::string> driven_;
  std::set<std::string> drive_names_;
};

}  // namespace

void read_mechanisms(Robot& robot, std::vector<io::Document>& documents,
                     std::vector<io::Fault>& faults) {
  MechanismReader(robot, documents, faults).read();
}

}  // namespace torquewright::hopper
