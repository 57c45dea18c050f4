// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/robot_bench/robots.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>

#include "tests/oracles/robot_bench/model_file.hpp"

namespace torquewright::oracles::robot_bench {
namespace {

namespace fs = std::filesystem;

const char* const kGo2 = "robots/unitree_mujoco/unitree_robots/go2/go2.xml";
const char* const kSo101 = "logs/so101_arm/so101.xml";
const char* const kIiwa = "robots/bullet3/data/kuka_iiwa/model.urdf";
const char* const kG1 = "robots/unitree_mujoco/unitree_robots/g1/g1_29dof.xml";

Eigen::Matrix3d rod_inertia(double mass_kg, double length_m) {
  const double across = mass_kg * length_m * length_m / 12 + 1e-5;
  return Eigen::Vector3d(across, across, 0.1 * across).asDiagonal();
}

/// Hangs down from its joint.
Body rod(const std::string& name, double mass_kg, double length_m, double center_share) {
  return {name, mass_kg, {0, 0, -center_share * length_m}, rod_inertia(mass_kg, length_m)};
}

Robot public_robot(const fs::path& file, const std::string& name) {
  return robot_of(*compile_without_shapes(file), name);
}

Robot go2(const fs::path& data) {
  Robot robot = public_robot(data / kGo2, "go2");
  for (const char* part : {"hip", "thigh", "calf"}) {
    std::vector<std::string> group;
    for (const char* leg : {"FL", "FR", "RL", "RR"})
      group.push_back(fmt::format("{}_{}_joint", leg, part));
    robot.alike.push_back(group);
  }
  return robot;
}

/// Legs of a humanoid; arms and waist do not move.
Robot g1_legs(const fs::path& data, bool both) {
  Robot robot = public_robot(data / kG1, both ? "g1 legs" : "g1 left leg");
  const std::vector<std::string> parts = {"hip_pitch", "hip_roll",    "hip_yaw",
                                          "knee",      "ankle_pitch", "ankle_roll"};
  std::vector<std::string> moved;
  for (const std::string& part : parts) {
    moved.push_back("left_" + part + "_joint");
    if (!both) continue;
    moved.push_back("right_" + part + "_joint");
    robot.alike.push_back({"left_" + part + "_joint", "right_" + part + "_joint"});
  }
  for (const Joint& joint : robot.joints)
    if (std::find(moved.begin(), moved.end(), joint.name) == moved.end())
      robot.held.push_back(joint.name);
  return robot;
}

Robot so101(const fs::path& data) {
  Robot robot = public_robot(data / kSo101, "so101");
  robot.alike.push_back(robot.moved());
  return robot;
}

fs::path document(const char* name) {
  return fs::path(TORQUEWRIGHT_SOURCE_DIR) / "specs" / "robot" / name;
}

Robot read_document(const char* name) {
  std::ifstream file(document(name));
  return robot_of_document(nlohmann::json::parse(file));
}

Eigen::Vector3d vector_in(const nlohmann::json& json, const char* key) {
  if (!json.contains(key)) return Eigen::Vector3d::Zero();
  const auto& list = json.at(key);
  return {list.at(0).get<double>(), list.at(1).get<double>(), list.at(2).get<double>()};
}

Eigen::Matrix3d inertia_in(const nlohmann::json& json) {
  if (json.is_number()) return json.get<double>() * Eigen::Matrix3d::Identity();
  const auto of = [&](const char* key) { return json.value(key, 0.0); };
  Eigen::Matrix3d all;
  all << of("xx"), of("xy"), of("xz"), of("xy"), of("yy"), of("yz"), of("xz"), of("yz"), of("zz");
  return all;
}

Robot quadruped(Draws& draws, const fs::path& data) {
  if (fs::exists(data / kGo2) && draws.chance(0.75)) return go2(data);
  return drawn_legs(draws, 4, 3);
}

Robot arm(Draws& draws, const fs::path& data) {
  const std::size_t which = draws.below(3);
  if (which == 0 && fs::exists(data / kSo101)) return so101(data);
  if (which == 1 && fs::exists(data / kIiwa)) return public_robot(data / kIiwa, "iiwa");
  return drawn_arm(draws, 3 + static_cast<int>(draws.below(4)));
}

Robot leg(Draws& draws, const fs::path& data, bool both) {
  if (fs::exists(data / kG1) && draws.chance(0.7)) return g1_legs(data, both);
  return drawn_legs(draws, both ? 2 : 1, both ? 4 : 6);
}

}  // namespace

fs::path data_folder() {
  if (const char* folder = std::getenv("TORQUEWRIGHT_DATA")) return folder;
  return fs::path(TORQUEWRIGHT_SOURCE_DIR) / ".." / "shared" / "data";
}

Robot draw_robot(Draws& draws, const Wanted& wanted, const fs::path& data) {
  if (wanted.alike) return draws.chance(0.6) ? quadruped(draws, data) : leg(draws, data, true);
  if (wanted.floats) return draws.chance(0.7) ? quadruped(draws, data) : leg(draws, data, true);
  switch (draws.below(4)) {
    case 0:
      return quadruped(draws, data);
    case 1:
      return arm(draws, data);
    case 2:
      return leg(draws, data, draws.chance(0.3));
    default:
      return read_document(draws.chance(0.5) ? "hopper.json" : "planar_leg.json");
  }
}

Robot robot_of_document(const nlohmann::json& document) {
  Robot robot;
  robot.name = document.at("name");
  robot.base = document.at("base").at("body");
  robot.floats = document.at("base").at("motion") != "fixed";
  for (const auto& body : document.at("bodies"))
    robot.bodies.push_back({body.at("name"), body.value("mass_kg", 0.0),
                            vector_in(body, "center_of_mass_m"),
                            inertia_in(body.at("inertia_kg_m2"))});
  for (const auto& one : document.at("joints")) {
    Joint joint;
    joint.name = one.at("name");
    joint.parent = one.at("parent");
    joint.child = one.at("child");
    joint.position_m = vector_in(one, "position_m");
    joint.axis = vector_in(one, "axis");
    if (one.contains("range_rad")) {
      joint.low_rad = one.at("range_rad").at(0);
      joint.high_rad = one.at("range_rad").at(1);
    }
    robot.joints.push_back(joint);
  }
  return robot;
}

Robot drawn_legs(Draws& draws, int legs, int joints_per_leg) {
  Robot robot;
  robot.name = fmt::format("drawn, {} x {} joints", legs, joints_per_leg);
  robot.base = "trunk";
  robot.floats = true;
  const double trunk_kg = draws.uniform(3, 12);
  robot.bodies.push_back(
      {"trunk", trunk_kg, {0, 0, 0.02}, trunk_kg * 0.02 * Eigen::Matrix3d::Identity()});
  const std::vector<Eigen::Vector3d> axes = {Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY(),
                                             Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitY(),
                                             Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitX()};
  std::vector<double> length_m, mass_kg, share;
  for (int j = 0; j < joints_per_leg; ++j) {
    length_m.push_back(j == 0 || j == 2 ? draws.uniform(0.03, 0.09) : draws.uniform(0.15, 0.32));
    mass_kg.push_back(draws.uniform(0.3, 1.5) * (j + 1 == joints_per_leg ? 0.3 : 1));
    share.push_back(draws.uniform(0.3, 0.6));
  }
  robot.alike.resize(legs > 1 ? static_cast<std::size_t>(joints_per_leg) : 0);
  for (int leg = 0; leg < legs; ++leg) {
    std::string parent = "trunk";
    for (int j = 0; j < joints_per_leg; ++j) {
      const auto k = static_cast<std::size_t>(j);
      Joint joint;
      joint.name = fmt::format("leg{}_joint{}", leg, j);
      joint.parent = parent;
      joint.child = fmt::format("leg{}_link{}", leg, j);
      joint.position_m = j == 0 ? Eigen::Vector3d(0.2 * (leg % 2 == 0 ? 1 : -1),
                                                  0.1 * (leg / 2 % 2 == 0 ? 1 : -1), 0)
                                : Eigen::Vector3d(0, 0, -length_m[k - 1]);
      joint.axis = axes[k];
      joint.low_rad = j == 1 ? -0.6 : -1.1;
      joint.high_rad = j == 1 ? 1.4 : 0.9;
      robot.joints.push_back(joint);
      robot.bodies.push_back(rod(joint.child, mass_kg[k], length_m[k], share[k]));
      if (legs > 1) robot.alike[k].push_back(joint.name);
      parent = joint.child;
    }
  }
  return robot;
}

Robot drawn_arm(Draws& draws, int joints) {
  Robot robot;
  robot.name = fmt::format("drawn arm, {} joints", joints);
  robot.base = "stand";
  robot.bodies.push_back({"stand", 2, {0, 0, 0}, 0.01 * Eigen::Matrix3d::Identity()});
  std::string parent = "stand";
  double length_m = -0.1;
  for (int j = 0; j < joints; ++j) {
    Joint joint;
    joint.name = fmt::format("joint{}", j + 1);
    joint.parent = parent;
    joint.child = fmt::format("link{}", j + 1);
    joint.position_m = {0, 0, -length_m};
    joint.axis = j == 0 ? Eigen::Vector3d::UnitZ()
                        : (draws.chance(0.7) ? Eigen::Vector3d::UnitY() : Eigen::Vector3d::UnitX());
    joint.low_rad = -1.4;
    joint.high_rad = 1.4;
    // The first link stands, the others reach out from it.
    if (j == 1) joint.rotation = Eigen::AngleAxisd(-1.2, Eigen::Vector3d::UnitY());
    length_m = j == 0 ? -0.08 : draws.uniform(0.08, 0.3);
    robot.joints.push_back(joint);
    robot.bodies.push_back(rod(joint.child, draws.uniform(0.2, 1.5) / (j + 1), std::abs(length_m),
                               draws.uniform(0.3, 0.6)));
    parent = joint.child;
  }
  return robot;
}

}  // namespace torquewright::oracles::robot_bench
