// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <nlohmann/json.hpp>

#include "robot/mechanisms/every_mechanism.hpp"
#include "robot/mechanisms/parallel_ankle.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Vector3d;
using nlohmann::json;
using nlohmann::ordered_json;

constexpr double kNoDirection = 1e-6;
constexpr double kTransmissionLimit = 0.52;  // 30 degrees, as of a four-bar
constexpr std::string_view kNeeds[] = {"rods", "rod_tilt_limit_rad"};
constexpr std::string_view kMayState[] = {"transmission_angle_limit_rad", "lever_limit_m"};

Vector3d vector_of(const json& list) {
  return {list[0].get<double>(), list[1].get<double>(), list[2].get<double>()};
}

ordered_json list_of(const Vector3d& v) { return {v[0], v[1], v[2]}; }

/// A unit vector; without a direction a fault.
Vector3d axis_of(const MechanismKeys& keys, const std::string& path, const json& list) {
  const Vector3d axis = vector_of(list);
  if (axis.norm() > kNoDirection) return axis.normalized();
  keys.report(path, "has no direction");
  return Vector3d::UnitY();
}

AnkleRod read_rod(const MechanismKeys& keys, std::size_t index, const Vector3d& pitch_axis) {
  const json& stated = keys.keys["rods"][index];
  const std::string path = fmt::format("/rods/{}", index);
  AnkleRod rod;
  rod.actuator_axis = axis_of(keys, path + "/actuator_axis", stated["actuator_axis"]);
  rod.actuator_center_m = vector_of(stated["actuator_center_m"]);
  rod.crank_m = vector_of(stated["crank_m"]);
  rod.rod_length_m = stated["rod_length_m"];
  rod.foot_attachment_m = vector_of(stated["foot_attachment_m"]);
  rod.foot_pin_axis = stated.contains("foot_pin_axis")
                          ? axis_of(keys, path + "/foot_pin_axis", stated["foot_pin_axis"])
                          : pitch_axis;
  rod.branch = stated.value("branch", 1);
  const double arm = rod.actuator_axis.cross(rod.crank_m).norm();
  if (!(arm > kNoDirection)) {
    keys.report(path + "/crank_m", "has no arm about actuator_axis: the crank moves nothing");
  }
  return rod;
}

/// The calf carries the cross and the cross the foot.
bool is_chain(const MechanismKeys& keys) {
  const auto& bodies = keys.tree.bodies;
  if (bodies[keys.joints[1]].parent == keys.joints[0]) return true;
  keys.report("/joints",
              fmt::format("\"{}\" does not hang on \"{}\": a universal joint is two "
                          "joints, the first one's child carrying the second",
                          bodies[keys.joints[1]].joint.name, bodies[keys.joints[0]].joint.name));
  return false;
}

std::shared_ptr<const Mechanism> read(const MechanismKeys& keys) {
  const std::size_t before = keys.faults.size();
  if (keys.joints.size() != 2 || !keys.turn_only() || !is_chain(keys)) return nullptr;
  ParallelAnkleGeometry ankle;
  ankle.first = keys.tree.bodies[keys.joints[0]].joint;
  ankle.second = keys.tree.bodies[keys.joints[1]].joint;
  const Vector3d pitch_in_foot = ankle.second.R_PB.transpose() * ankle.first.axis;
  for (std::size_t i = 0; i < 2; ++i) ankle.rods[i] = read_rod(keys, i, pitch_in_foot);
  ankle.rod_tilt_limit_rad = keys.number("rod_tilt_limit_rad");
  ankle.transmission_limit_rad = keys.number("transmission_angle_limit_rad", kTransmissionLimit);
  ankle.lever_limit_m = keys.number("lever_limit_m");
  if (keys.faults.size() != before) return nullptr;
  return std::make_shared<ParallelAnkle>(ankle);
}

ordered_json write(const Mechanism& mechanism) {
  const ParallelAnkleGeometry& geometry = dynamic_cast<const ParallelAnkle&>(mechanism).geometry();
  ordered_json keys;
  for (const AnkleRod& rod : geometry.rods) {
    keys["rods"].push_back({{"actuator_axis", list_of(rod.actuator_axis)},
                            {"actuator_center_m", list_of(rod.actuator_center_m)},
                            {"crank_m", list_of(rod.crank_m)},
                            {"rod_length_m", rod.rod_length_m},
                            {"foot_attachment_m", list_of(rod.foot_attachment_m)},
                            {"foot_pin_axis", list_of(rod.foot_pin_axis)},
                            {"branch", rod.branch}});
  }
  keys["rod_tilt_limit_rad"] = geometry.rod_tilt_limit_rad;
  keys["transmission_angle_limit_rad"] = geometry.transmission_limit_rad;
  keys["lever_limit_m"] = geometry.lever_limit_m;
  return keys;
}

}  // namespace

namespace mechanisms {

const MechanismType parallel_ankle = {.name = "parallel_ankle",
                                      .joints = 2,
                                      .needs = kNeeds,
                                      .may_state = kMayState,
                                      .read = read,
                                      .write = write};

}  // namespace mechanisms
}  // namespace torquewright::hopper
