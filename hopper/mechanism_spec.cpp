// SPDX-License-Identifier: Apache-2.0
#include "hopper/mechanism_spec.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "actuator/actuator_spec.hpp"
#include "hopper/find_name.hpp"

namespace torquewright::hopper {
namespace {

using nlohmann::json;

constexpr double kSingular = 1e-9;  // determinant of a Jacobian scaled to 1

class MechanismReader {
 public:
  MechanismReader(Robot& robot, std::vector<io::Document>& documents, std::vector<io::Fault>& faults)
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
    Mechanism mechanism;
    const bool direct = keys["type"] == "direct";
    mechanism.kind = direct ? MechanismKind::kDirect : MechanismKind::kParallel;
    const std::size_t needed = direct ? 1 : 2;
    for (const char* key : {"joints", "actuators"}) {
      if (keys[key].size() == needed) continue;
      report(fmt::format("{}/{}", path, key),
             fmt::format("must have {}, not {}", needed, keys[key].size()));
    }
    for (std::size_t i = 0; i < keys["joints"].size(); ++i) {
      claim(keys["joints"][i], fmt::format("{}/joints/{}", path, i), mechanism);
    }
    for (const json& file : keys["actuators"]) read_actuator(file, mechanism);
    if (keys.contains("jacobian") == direct) {
      report(path + "/jacobian", direct ? "is for parallel mechanisms" : "missing");
    } else if (!direct) {
      read_jacobian(keys["jacobian"], path + "/jacobian", mechanism);
    }
    if (direct && mechanism.joints.size() == 1 && mechanism.actuators.size() == 1) {
      reflect(mechanism);
    }
    robot_.mechanisms.push_back(std::move(mechanism));
  }

  /// A joint may be driven once.
  void claim(const std::string& name, const std::string& path, Mechanism& mechanism) {
    if (!find_name(joint_names_, name, "joint", {file_, path, ""}, faults_)) return;
    if (std::find(driven_.begin(), driven_.end(), name) != driven_.end()) {
      report(path, fmt::format("\"{}\" is driven by another mechanism already", name));
    }
    driven_.push_back(name);
    if (const auto body = robot_.find_joint(name)) mechanism.joints.push_back(*body);
  }

  void read_actuator(const std::string& name, Mechanism& mechanism) {
    mechanism.actuator_files.push_back(name);
    try {
      actuator::ReadActuator read =
          actuator::read_actuator(std::filesystem::path(file_).parent_path() / name);
      mechanism.actuators.push_back(std::move(read.actuator));
      std::move(read.documents.begin(), read.documents.end(), std::back_inserter(documents_));
    } catch (const io::SpecError& error) {
      faults_.insert(faults_.end(), error.faults().begin(), error.faults().end());
    }
  }

  void read_jacobian(const json& rows, const std::string& path, Mechanism& mechanism) {
    Eigen::Matrix2d& jacobian = mechanism.jacobian;
    jacobian << rows[0][0].get<double>(), rows[0][1].get<double>(), rows[1][0].get<double>(),
        rows[1][1].get<double>();
    const double scale = jacobian.cwiseAbs().maxCoeff();
    if (!(std::abs(jacobian.determinant()) > kSingular * scale * scale)) {
      report(path, "is singular: some motion of the joints moves no actuator");
    }
  }

  void reflect(const Mechanism& mechanism) {
    dynamics::Joint& joint = robot_.tree.bodies[mechanism.joints.front()].joint;
    const auto index = static_cast<std::size_t>(
        std::find(joint_names_.begin(), joint_names_.end(), joint.name) - joint_names_.begin());
    if (root_["joints"][index].contains("reflected_inertia_kg_m2")) return;
    if (joint.kind == dynamics::JointKind::kPrismatic) return;  // of a screw no lead is known
    const actuator::Actuator& of = mechanism.actuators.front();
    const double ratio = of.transmission.ratio;
    joint.reflected_inertia =
        ratio * ratio * of.motor.rotor_inertia_kg_m2 + of.transmission.inertia_kg_m2;
  }

  Robot& robot_;
  std::vector<io::Document>& documents_;
  std::vector<io::Fault>& faults_;
  const std::string file_;  // documents move when they grow in number
  const json root_;
  std::vector<std::string> joint_names_;
  std::vector<std::string> driven_;
};

}  // namespace

void read_mechanisms(Robot& robot, std::vector<io::Document>& documents,
                     std::vector<io::Fault>& faults) {
  MechanismReader(robot, documents, faults).read();
}

}  // namespace torquewright::hopper
