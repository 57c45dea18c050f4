// SPDX-License-Identifier: Apache-2.0
#include "tests/hopper/logs/public_hopper.hpp"

#include <cstdlib>
#include <filesystem>
#include <memory>

#include "robot/mechanisms/constant_jacobian.hpp"
#include "robot/mjcf/mjcf_reader.hpp"

namespace torquewright::test {
namespace {

namespace fs = std::filesystem;
using Eigen::Vector3d;

constexpr double kFriction = 0.8;
const char* const kSuite = "mujoco_playground/mujoco_playground/_src/dm_control_suite/xmls/";
const char* const kLocomotion = "mujoco_playground/mujoco_playground/_src/locomotion/";

fs::path robots() {
  const char* variable = std::getenv("TORQUEWRIGHT_DATA");
  const fs::path source = TORQUEWRIGHT_SOURCE_DIR;
  const fs::path data = variable != nullptr ? fs::path(variable) : source / "../shared/data";
  return data / "robots";
}

void add_contact(const std::string& name, const std::string& joint, const Vector3d& p_B_m,
                 hopper::Robot& robot) {
  robot.contacts.push_back({name, {robot.find_joint(joint).value(), p_B_m}, kFriction, 0.0});
}

/// Drives of no inertia: what the file has of it stays in the joints.
void add_drives(hopper::Robot& robot) {
  for (std::size_t body = 1; body < robot.tree.bodies.size(); ++body) {
    hopper::Drivetrain drivetrain;
    drivetrain.mechanism = std::make_shared<hopper::ConstantJacobian>(hopper::direct_drive());
    drivetrain.joints = {body};
    actuator::Actuator actuator;
    actuator.motor.torque_constant_Nm_A = 1.0;
    actuator.motor.resistance_ohm = 0.01;
    actuator.drive = {.bus_voltage_V = 1000, .peak_current_A = 1000, .continuous_current_A = {}};
    actuator.transmission.ratio = 1.0;
    drivetrain.actuators = {actuator};
    drivetrain.actuator_names = {robot.tree.bodies[body].joint.name};
    drivetrain.actuator_files = {"drive.json"};
    robot.drivetrains.push_back(drivetrain);
  }
}

/// Most of these logs are of drives and contacts alone.
void leave_out_passive_forces(hopper::Robot& robot) {
  for (dynamics::Body& body : robot.tree.bodies) body.joint.passive = {};
}

void complete_hopper(PublicHopper& hopper) {
  add_contact("heel", "ankle", {-0.08, 0, -0.04}, hopper.robot);
  add_contact("toe", "ankle", {0.17, 0, -0.04}, hopper.robot);
  hopper.fold = {{"hip", -0.6}, {"knee", 1.1}, {"ankle", -0.5}};
  hopper.crouch = 1.5;
  hopper.stretch = 0.1;
  hopper.spring_Nm_rad = 800;
  hopper.damper_Nm_s_rad = 25;
}

void complete_walker(PublicHopper& hopper) {
  for (const std::string side : {"right", "left"}) {
    add_contact(side + "_heel", side + "_ankle", {-0.04, 0, -0.05}, hopper.robot);
    add_contact(side + "_toe", side + "_ankle", {0.16, 0, -0.05}, hopper.robot);
    const double more = side == "left" ? 1.1 : 1.0;
    hopper.fold.insert({{side + "_hip", 0.6 * more},
                        {side + "_knee", -1.2 * more},
                        {side + "_ankle", 0.6 * more}});
  }
  hopper.crouch = 1.4;
  hopper.stretch = 0.75;
  hopper.spring_Nm_rad = 1200;
  hopper.damper_Nm_s_rad = 40;
}

void complete_cheetah(PublicHopper& hopper) {
  add_contact("back", "bfoot", {0.054, 0, -0.234}, hopper.robot);
  add_contact("front", "ffoot", {0.084, 0, -0.174}, hopper.robot);
  hopper.fold = {{"bthigh", -0.3}, {"bshin", 0.6},  {"bfoot", -0.3},
                 {"fthigh", 0.3},  {"fshin", -0.6}, {"ffoot", 0.3}};
  hopper.crouch = 1.6;
  hopper.stretch = -0.5;
  hopper.spring_Nm_rad = 600;
  hopper.damper_Nm_s_rad = 18;
}

void fold_go1(PublicHopper& hopper) {
  for (const std::string leg : {"FR", "FL", "RR", "RL"}) {
    const double more = leg[0] == 'R' ? 1.05 : 1.0;
    hopper.fold.insert({{leg + "_thigh_joint", 0.9 * more}, {leg + "_calf_joint", -1.8 * more}});
  }
  hopper.crouch = 1.2;
  hopper.stretch = 0.85;
  hopper.spring_Nm_rad = 150;
  hopper.damper_Nm_s_rad = 4;
}

void complete_go1(PublicHopper& hopper) {
  for (const std::string leg : {"FR", "FL", "RR", "RL"}) {
    add_contact(leg, leg + "_calf_joint", {0, 0, -0.23}, hopper.robot);
  }
  fold_go1(hopper);
}

/// Its feet as the file has them: balls that roll.
void complete_go1_balls(PublicHopper& hopper) {
  hopper.robot.contacts = hopper.stated_contacts;
  for (hopper::ContactPoint& contact : hopper.robot.contacts) {
    contact.friction_coefficient = kFriction;
  }
  fold_go1(hopper);
}

void complete_op3(PublicHopper& hopper) {
  for (const std::string side : {"l", "r"}) {
    const double sign = side == "l" ? 1.0 : -1.0;
    for (const double x : {-0.04, 0.087}) {
      for (const double y : {-0.03, 0.03}) {
        const std::string corner =
            side + (x < 0 ? "_heel" : "_toe") + (y * sign > 0 ? "_out" : "_in");
        add_contact(corner, side + "_ank_roll", {x, y, -0.0305}, hopper.robot);
      }
    }
    hopper.fold.insert({{side + "_hip_pitch", -0.58 * sign},
                        {side + "_knee", 1.1 * sign},
                        {side + "_ank_pitch", 0.53 * sign},
                        {side + "_sho_pitch", -0.8 * sign}});
    hopper.stand.insert({side + "_sho_roll", 0.88 * sign});
  }
  hopper.crouch = 1.5;
  hopper.stretch = 0.2;
  hopper.spring_Nm_rad = 200;
  hopper.damper_Nm_s_rad = 5;
}

struct Entry {
  const char* name;
  const char* kind;
  std::string file;
  void (*complete)(PublicHopper&);
};

const std::vector<Entry>& entries() {
  static const std::vector<Entry> all{
      {"hopper", "planar, one leg", std::string(kSuite) + "hopper.xml", complete_hopper},
      {"walker", "planar biped", std::string(kSuite) + "walker.xml", complete_walker},
      {"cheetah", "planar, two legs", std::string(kSuite) + "cheetah.xml", complete_cheetah},
      {"go1", "quadruped", std::string(kLocomotion) + "go1/xmls/go1_mjx_feetonly.xml",
       complete_go1},
      {"go1_balls", "quadruped, feet of 23 mm that roll",
       std::string(kLocomotion) + "go1/xmls/go1_mjx_feetonly.xml", complete_go1_balls},
      {"op3", "biped", std::string(kLocomotion) + "op3/xmls/op3_mjx_feetonly.xml", complete_op3},
  };
  return all;
}

}  // namespace

const std::vector<std::string>& public_hoppers() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> found;
    for (const Entry& entry : entries()) found.emplace_back(entry.name);
    return found;
  }();
  return names;
}

std::optional<PublicHopper> read_public_hopper(const std::string& name, bool keeps_passive) {
  for (const Entry& entry : entries()) {
    if (entry.name != name || !fs::is_regular_file(robots() / entry.file)) continue;
    PublicHopper hopper;
    hopper.name = entry.name;
    hopper.kind = entry.kind;
    hopper.robot = hopper::read_mjcf(robots() / entry.file).robot;
    if (!keeps_passive) leave_out_passive_forces(hopper.robot);
    hopper.stated_contacts = std::move(hopper.robot.contacts);
    hopper.robot.contacts.clear();
    entry.complete(hopper);
    add_drives(hopper.robot);
    return hopper;
  }
  return std::nullopt;
}

}  // namespace torquewright::test
