// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/robot_bench/documents.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <stdexcept>

#include "tests/oracles/robot_bench/missing.hpp"

namespace torquewright::oracles::robot_bench {
namespace {

using mujoco_bench::Draws;

Json list_of(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

/// R = Rz(third) Ry(second) Rx(first).
Eigen::Vector3d roll_pitch_yaw(const Eigen::Quaterniond& q) {
  const Eigen::Matrix3d r = q.normalized().toRotationMatrix();
  const double across = std::hypot(r(0, 0), r(1, 0));
  if (across < 1e-9) return {std::atan2(-r(1, 2), r(1, 1)), std::atan2(-r(2, 0), across), 0};
  return {std::atan2(r(2, 1), r(2, 2)), std::atan2(-r(2, 0), across), std::atan2(r(1, 0), r(0, 0))};
}

Json body_json(const Body& body) {
  Json json = {{"name", body.name}};
  if (body.mass_kg <= 0) return json;
  const Eigen::Matrix3d& i = body.inertia_kg_m2;
  json["mass_kg"] = body.mass_kg;
  json["center_of_mass_m"] = list_of(body.center_m);
  json["inertia_kg_m2"] = {{"xx", i(0, 0)}, {"yy", i(1, 1)}, {"zz", i(2, 2)},
                           {"xy", i(0, 1)}, {"xz", i(0, 2)}, {"yz", i(1, 2)}};
  return json;
}

/// A joint that an actuator document describes has nothing of its own.
Json joint_json(const Joint& joint, bool has_drive) {
  Json json = {{"name", joint.name},
               {"type", "revolute"},
               {"parent", joint.parent},
               {"child", joint.child},
               {"position_m", list_of(joint.position_m)},
               {"rotation_rpy_rad", list_of(roll_pitch_yaw(joint.rotation))},
               {"axis", list_of(joint.axis)}};
  if (has_drive) return json;
  json["reflected_inertia_kg_m2"] = joint.armature_kg_m2;
  json["damping_Nm_s_rad"] = joint.damping_Nm_s_rad;
  json["dry_friction_Nm"] = joint.friction_Nm;
  return json;
}

Json actuator_document(const Situation& it, const std::string& joint) {
  const Drive& drive = it.drives.at(joint);
  const Joint& own = it.stated.robot.joint(joint);
  const Json effects = {
      {{"effect", "coulomb_friction"}, {"parameters", {{"coulomb_Nm", own.friction_Nm}}}},
      {{"effect", "viscous_friction"},
       {"parameters", {{"viscous_Nm_s_rad", own.damping_Nm_s_rad}}}}};
  return {
      {"kind", "actuator"},
      {"version", 1},
      {"name", "drive of " + joint},
      {"motor",
       {{"torque_constant_Nm_A", drive.torque_constant_Nm_A},
        {"torque_constant_convention", "dc"},
        {"resistance_ohm", drive.resistance_ohm},
        {"resistance_convention", "dc"},
        {"rotor_inertia_kg_m2", own.armature_kg_m2 / (drive.ratio * drive.ratio)}}},
      {"drive", {{"bus_voltage_V", drive.bus_voltage_V}, {"peak_current_A", 30}}},
      {"gearbox", {{"ratio", drive.ratio}, {"forward_efficiency", 1}, {"backward_efficiency", 1}}},
      {"effects", effects}};
}

/// Of the first of alike joints, which share one file.
std::string actuator_of(const Situation& it, const std::string& joint) {
  for (const auto& group : it.stated.robot.alike)
    if (std::find(group.begin(), group.end(), joint) != group.end())
      return "actuator_" + group.front() + ".json";
  return "actuator_" + joint + ".json";
}

Json column(const char* quantity, const std::string& joint) {
  return {{"quantity", quantity}, {"joint", joint}};
}

Json columns_of(const Situation& it) {
  Json columns = {{"run", "run"}, {"time_s", "time_s"}};
  const auto add = [&](const std::string& joint) {
    columns["q_" + joint] = column("output_position_rad", joint);
    columns["c_" + joint] = column("commanded_position_rad", joint);
    if (it.format.has_speed) columns["w_" + joint] = column("output_velocity_rad_s", joint);
  };
  if (it.uses_patterns)
    add("{joint}");
  else
    for (const std::string& joint : it.stated.robot.moved()) add(joint);
  return columns;
}

Json controller_json(const Situation& it, const std::string& joint) {
  const Controller& law = it.stated.controllers.at(joint);
  return {{"type", it.servo ? "position_servo" : "pd"},
          {"stiffness_Nm_rad", law.stiffness_Nm_rad * (it.servo ? it.servo_guess : 1)},
          {"damping_Nm_s_rad", law.damping_Nm_s_rad},
          {"torque_limit_Nm", law.torque_limit_Nm},
          {"delay_s", it.stated_delay_s}};
}

/// Pointers to a controller's value are pointers to each joint's.
Json uncertain_of(const Situation& it) {
  Json list = Json::array();
  for (const std::string& pointer : it.uncertain) {
    const std::string common = "/controller/";
    if (pointer.rfind(common, 0) != 0) {
      list.push_back(pointer);
      continue;
    }
    for (const std::string& joint : it.stated.robot.moved())
      list.push_back("/controllers/" + joint + "/" + pointer.substr(common.size()));
  }
  std::vector<Json> unique;
  for (const Json& one : list)
    if (std::find(unique.begin(), unique.end(), one) == unique.end()) unique.push_back(one);
  return unique;
}

Json effects_json(const Situation& it) {
  Json list = Json::array();
  for (std::size_t k = 0; k < it.missing.size(); ++k) {
    const Effect& one = it.missing[k];
    list.push_back({{"effect", one.name},
                    {"joints", one.joints},
                    {"parameters", one.parameters},
                    {"size_floors", it.size_floors[k]},
                    {"accept", accepted_names(one.name)}});
  }
  return list;
}

void write(const std::filesystem::path& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  if (!file.flush()) throw std::runtime_error("cannot write " + path.string());
}

double to_step(double value, double step) {
  return step > 0 ? std::round(value / step) * step : value;
}

/// First order, as a drive's estimate of its speed.
std::vector<double> filtered(const std::vector<double>& speed, double row_s, double time_s) {
  std::vector<double> all = speed;
  const double share = 1 - std::exp(-row_s / time_s);
  for (std::size_t k = 1; k < all.size(); ++k)
    all[k] = all[k - 1] + share * (speed[k] - all[k - 1]);
  return all;
}

}  // namespace

Json robot_document(const Situation& it) {
  const Robot& robot = it.stated.robot;
  Json bodies = Json::array(), joints = Json::array();
  for (const Body& body : robot.bodies) bodies.push_back(body_json(body));
  for (const Joint& joint : robot.joints)
    joints.push_back(joint_json(joint, it.drives.count(joint.name) > 0));
  return {{"kind", "robot"},
          {"version", 1},
          {"name", robot.name},
          {"gravity_m_s2", 9.81},
          {"base", {{"body", robot.base}, {"motion", robot.floats ? "spatial" : "fixed"}}},
          {"bodies", bodies},
          {"joints", joints}};
}

Json rig_document(const Situation& it) {
  Json load = {{"type", "robot"}, {"file", "robot.json"}};
  if (it.stated.robot.floats) load["base"] = "held";
  for (const std::string& joint : it.stated.robot.held) load["held_rad"][joint] = 0;
  Json json = {{"kind", "rig"},
               {"version", 1},
               {"name", it.stated.robot.name},
               {"columns", columns_of(it)},
               {"load", load}};
  for (const std::string& joint : it.stated.robot.moved())
    json["controllers"][joint] = controller_json(it, joint);
  if (!it.stated.robot.alike.empty()) json["alike"] = it.stated.robot.alike;
  if (!it.uncertain.empty()) json["uncertain"] = uncertain_of(it);
  return json;
}

Json truth_document(const Situation& it, std::uint64_t seed) {
  Json json = {{"class", it.kind},
               {"seed", seed},
               {"generator", "robots in mujoco"},
               {"robot", it.stated.robot.name},
               {"joints", it.stated.robot.moved()},
               {"alike", it.stated.robot.alike},
               {"rate_hz", 1 / it.format.row_s},
               {"rows_s", it.runs.front().duration_s() * static_cast<double>(it.runs.size())},
               {"servo", it.servo},
               {"floor_rad", it.format.floor_rad()},
               {"stated_delay_s", it.stated_delay_s},
               {"base_roll_rad", it.truth.roll_rad},
               {"base_pitch_rad", it.truth.pitch_rad},
               {"effects", effects_json(it)},
               {"size_floors", it.size_floors},
               {"floors_by_joint", it.floors_by_joint}};
  if (!it.missing.empty() || !it.load.empty()) json["distinct_floors"] = distinct_floors(it);
  if (!it.load.empty()) json["load"] = it.load;
  if (!it.outside.empty()) json["outside"] = it.outside;
  // A drive's filtered estimate of its speed is late, as a whole or by its filter and half a row.
  if (it.format.has_speed)
    json["tolerated"]["velocity_mismatch"] = 1.5 * it.format.speed_filter_s + it.format.row_s;
  if (it.servo)
    for (const auto& [joint, law] : it.stated.controllers)
      json["true_stiffness_Nm_rad"][joint] = law.stiffness_Nm_rad;
  json["arguments"] = Json::array();
  for (const auto& [joint, drive] : it.drives)
    json["arguments"].push_back({"--actuator", joint, actuator_of(it, joint)});
  return json;
}

std::string log_text(const Situation& it, std::uint64_t seed) {
  Draws draws(seed ^ 0x726F626F74ULL);
  const auto names = it.stated.robot.moved();
  std::string text = "run,time_s";
  for (const std::string& name : names) {
    text += ",q_" + name + ",c_" + name;
    if (it.format.has_speed) text += ",w_" + name;
  }
  text += "\n";
  for (std::size_t run = 0; run < it.runs.size(); ++run) {
    const Record record = play(it.truth, it.runs[run], it.format.row_s);
    std::vector<std::vector<double>> speeds;
    for (const auto& one : record.speed_rad_s)
      speeds.push_back(filtered(one, it.format.row_s, it.format.speed_filter_s));
    for (std::size_t k = 0; k < record.time_s.size(); ++k) {
      fmt::format_to(std::back_inserter(text), "run_{},{:.9g}", run + 1, record.time_s[k]);
      for (std::size_t j = 0; j < names.size(); ++j) {
        const double noisy = record.position_rad[j][k] + it.format.noise_rad * draws.normal();
        fmt::format_to(std::back_inserter(text), ",{:.9g},{:.9g}",
                       to_step(noisy, it.format.encoder_step_rad), record.command_rad[j][k]);
        if (!it.format.has_speed) continue;
        const double speed = speeds[j][k] + 0.002 * draws.normal();
        fmt::format_to(std::back_inserter(text), ",{:.9g}",
                       to_step(speed, it.format.speed_step_rad_s));
      }
      text += "\n";
    }
  }
  return text;
}

void write_all(const Situation& it, std::uint64_t seed, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  write(folder / "log.csv", log_text(it, seed));
  write(folder / "rig.json", rig_document(it).dump(1) + "\n");
  write(folder / "robot.json", robot_document(it).dump(1) + "\n");
  for (const auto& [joint, drive] : it.drives)
    write(folder / actuator_of(it, joint), actuator_document(it, joint).dump(1) + "\n");
  write(folder / "truth.json", truth_document(it, seed).dump(1) + "\n");
}

}  // namespace torquewright::oracles::robot_bench
