// SPDX-License-Identifier: Apache-2.0
#include "robot/model/robot_spec.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "dynamics/momentum.hpp"
#include "robot/model/robot_json.hpp"
#include "tests/io/scratch_folder.hpp"

namespace torquewright::hopper {
namespace {

using nlohmann::json;

json leg() {
  return json::parse(R"({"kind": "robot", "version": 1, "name": "leg",
    "base": {"body": "hip", "motion": "planar"},
    "bodies": [
      {"name": "shin", "mass_kg": 1, "center_of_mass_m": [0, 0, -0.2], "inertia_kg_m2": 0.01},
      {"name": "hip", "mass_kg": 3, "center_of_mass_m": [0, 0, 0],
       "inertia_kg_m2": {"xx": 0.1, "yy": 0.2, "zz": 0.25, "xy": 0.01}},
      {"name": "foot", "mass_kg": 0.2, "center_of_mass_m": [0, 0, 0], "inertia_kg_m2": 0.001}],
    "joints": [
      {"name": "toe", "type": "prismatic", "parent": "shin", "child": "foot", "axis": [0, 0, -2],
       "range_m": [0, 0.1], "reflected_mass_kg": 0.5},
      {"name": "knee", "type": "revolute", "parent": "hip", "child": "shin", "axis": [0, 1, 0],
       "position_m": [0, 0, -0.3], "rotation_rpy_rad": [0.1, 0.2, 0.3], "range_rad": [-1, 2],
       "speed_limit_rad_s": 8, "torque_limit_Nm": 90, "rotor_spin_kg_m2": [0, 0.01, 0]}],
    "contacts": [{"name": "tip", "body": "foot", "position_m": [0, 0, -0.1],
      "friction_coefficient": 0.6}],
    "mechanisms": [{"type": "direct", "joints": ["knee"], "actuators": ["knee.json"]}]})");
}

class RobotSpec : public ::testing::Test {
 protected:
  RobotSpec() {
    std::filesystem::copy_file(TORQUEWRIGHT_SOURCE_DIR "/specs/actuator/d151_knee.json",
                               folder_.path() / "knee.json");
  }
  std::string written(const json& document) {
    return folder_.write("robot.json", document.dump()).string();
  }
  std::vector<io::Fault> faults_of(const json& document) {
    try {
      (void)read_robot(written(document));
    } catch (const io::SpecError& error) {
      return error.faults();
    }
    return {};
  }
  test::ScratchFolder folder_;
};

TEST_F(RobotSpec, PutsParentsFirstAndKeepsEveryNumber) {
  const ReadRobot read = read_robot(written(leg()));
  const auto& bodies = read.robot.tree.bodies;
  ASSERT_EQ(bodies.size(), 3u);
  EXPECT_EQ(bodies[0].name, "hip");
  EXPECT_EQ(bodies[1].name, "shin");
  EXPECT_EQ(bodies[2].name, "foot");
  EXPECT_EQ(bodies[2].parent, 1u);
  EXPECT_EQ(bodies[0].inertia.inertia_kg_m2(1, 0), 0.01);
  EXPECT_EQ(bodies[1].joint.name, "knee");
  EXPECT_EQ(bodies[1].joint.limits.position_max, 2);
  EXPECT_EQ(bodies[1].joint.limits.speed_max, 8);
  EXPECT_EQ(bodies[1].joint.limits.effort_max, 90);
  EXPECT_EQ(bodies[1].joint.rotor_spin_kg_m2.y(), 0.01);
  EXPECT_EQ(bodies[2].joint.axis, Eigen::Vector3d(0, 0, -1));
  EXPECT_EQ(bodies[2].joint.reflected_inertia, 0.5);
  EXPECT_EQ(read.robot.contacts[0].point.body, 2u);
  EXPECT_EQ(read.robot.drivetrains[0].joints[0], 1u);
  EXPECT_EQ(read.documents.size(), 2u);
  EXPECT_NO_THROW(dynamics::require_tree(read.robot.tree));
}

// Oracle: Rz(0.3) Ry(0.2) Rx(0.1) written out by the textbook.
// Each key to its number, of both kinds of joint, and back into a document.
TEST_F(RobotSpec, KeepsPassiveForcesAndWhoseLimitsAre) {
  json document = leg();
  document["joints"][1].update({{"damping_Nm_s_rad", 0.5},
                                {"dry_friction_Nm", 1.5},
                                {"static_friction_Nm", 2},
                                {"stiffness_Nm_rad", 30},
                                {"spring_rest_rad", -0.25},
                                {"own_limits", {"torque"}}});
  document["joints"][0].update({{"damping_N_s_m", 5},
                                {"dry_friction_N", 6},
                                {"static_friction_N", 7},
                                {"stiffness_N_m", 8},
                                {"spring_rest_m", 0.09}});
  const Robot robot = read_robot(written(document)).robot;
  const dynamics::Joint& knee = robot.tree.bodies[1].joint;
  EXPECT_EQ(knee.passive.damping, 0.5);
  EXPECT_EQ(knee.passive.dry_friction, 1.5);
  EXPECT_EQ(knee.passive.static_friction, 2);
  EXPECT_EQ(knee.passive.stiffness, 30);
  EXPECT_EQ(knee.passive.rest_position, -0.25);
  EXPECT_TRUE(knee.limits.owns_effort);
  EXPECT_FALSE(knee.limits.owns_speed);
  const dynamics::PassiveForces& toe = robot.tree.bodies[2].joint.passive;
  EXPECT_EQ(toe.damping, 5);
  EXPECT_EQ(toe.dry_friction, 6);
  EXPECT_EQ(toe.static_friction, 7);
  EXPECT_EQ(toe.stiffness, 8);
  EXPECT_EQ(toe.rest_position, 0.09);
  const nlohmann::ordered_json again = robot_json(robot);
  for (const json& stated : document["joints"]) {
    const auto found = std::find_if(again["joints"].begin(), again["joints"].end(),
                                    [&](const auto& one) { return one["name"] == stated["name"]; });
    ASSERT_NE(found, again["joints"].end());
    for (const auto& [key, value] : stated.items()) {
      if (key.find("friction") != key.npos || key.find("damping") != key.npos ||
          key.find("s") == 0 || key == "own_limits") {
        EXPECT_EQ(json((*found)[key]), value) << key;
      }
    }
  }
}

TEST_F(RobotSpec, RefusesFrictionThatHoldsLessAtRest) {
  json document = leg();
  document["joints"][1].update({{"dry_friction_Nm", 1.5}, {"static_friction_Nm", 1}});
  const auto faults = faults_of(document);
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].path, "/joints/1/static_friction_Nm");
  EXPECT_NE(faults[0].message.find("1 is less than the joint's dry friction of 1.5"),
            std::string::npos);
}

TEST_F(RobotSpec, TurnsByRollThenPitchThenYaw) {
  const Eigen::Matrix3d R = read_robot(written(leg())).robot.tree.bodies[1].joint.R_PB;
  const double a = 0.1, b = 0.2, c = 0.3;
  EXPECT_NEAR(R(0, 0), std::cos(c) * std::cos(b), 1e-15);
  EXPECT_NEAR(R(1, 0), std::sin(c) * std::cos(b), 1e-15);
  EXPECT_NEAR(R(2, 0), -std::sin(b), 1e-15);
  EXPECT_NEAR(R(2, 1), std::cos(b) * std::sin(a), 1e-15);
  EXPECT_NEAR(R(0, 1), std::cos(c) * std::sin(b) * std::sin(a) - std::sin(c) * std::cos(a), 1e-15);
}

// Oracle: N^2 J of the actuator's own document, 20^2 0.000922 (0.369 of the reference).
TEST_F(RobotSpec, TakesTheActuatorsReflectedInertiaUnlessTheJointStatesOne) {
  json document = leg();
  EXPECT_NEAR(read_robot(written(document)).robot.tree.bodies[1].joint.reflected_inertia, 0.3688,
              1e-12);
  document["joints"][1]["reflected_inertia_kg_m2"] = 0.1;
  EXPECT_EQ(read_robot(written(document)).robot.tree.bodies[1].joint.reflected_inertia, 0.1);
}

// The same N^2 J, in kg, where N is the rotor's turn over the slide's way.
TEST_F(RobotSpec, ASlideTakesItsActuatorsRotorToo) {
  json document = leg();
  document["joints"][0].erase("reflected_mass_kg");
  document["mechanisms"][0]["joints"] = {"toe"};
  EXPECT_NEAR(read_robot(written(document)).robot.tree.bodies[2].joint.reflected_inertia, 0.3688,
              1e-12);
}

struct Bad {
  const char* pointer;  // what is changed, and where the fault is found
  json value;
  const char* message;  // part of it
};

TEST_F(RobotSpec, SaysWhatIsWrongAndWhere) {
  const std::vector<Bad> changes{
      {"/base/body", "hips", "did you mean \"hip\""},
      {"/base/position_m", json::array({0, 0, 1}), "fixed base only"},
      {"/joints/0/parent", "shinn", "did you mean \"shin\""},
      {"/joints/1/child", "foot", "closed loop"},
      {"/joints/1/child", "hip", "is the base"},
      {"/joints/1/parent", "foot", ""},
      {"/bodies/2/name", "hip", "another body"},
      {"/joints/1/name", "toe", "another joint"},
      {"/bodies/0/inertia_kg_m2", {{"xx", 0.1}, {"yy", 0.1}, {"zz", 0.3}}, "sum of the other two"},
      {"/bodies/0/inertia_kg_m2", {{"xx", 0.1}, {"yy", 0.1}, {"zz", 0.1}, {"xy", 0.2}}, "positive"},
      {"/bodies/0/inertia_kg_m2", {{"xx", 0}, {"yy", 0}, {"zz", 0}}, "positive"},
      {"/bodies/0/mass_kg", 0, ""},
      {"/joints/1/range_rad", json::array({2, -1}), "not below"},
      {"/joints/1/range_m", json::array({0, 1}), "prismatic"},
      {"/joints/1/damping_N_s_m", 3, "prismatic"},
      {"/joints/0/dry_friction_Nm", 3, "revolute"},
      {"/joints/0/torque_limit_Nm", 3, "revolute"},
      {"/joints/1/axis", json::array({0, 0, 0}), "no direction"},
      {"/contacts/0/body", "food", "did you mean \"foot\""},
      {"/mechanisms/0/joints/0", "kne", "did you mean \"knee\""},
      {"/mechanisms/0/jacobian", json::array({json::array({1, 0}), json::array({0, 1})}),
       "parallel"},
      {"/mechanisms/0/actuators", json::array({"knee.json", "knee.json"}), "must have 1"},
      {"/mechanisms/0/typ", "direct", ""},
      {"/gravity_m_s2", -9.81, ""}};
  for (const Bad& bad : changes) {
    json document = leg();
    document[json::json_pointer(bad.pointer)] = bad.value;
    const std::vector<io::Fault> faults = faults_of(document);
    ASSERT_FALSE(faults.empty()) << bad.pointer;
    bool is_named = false;
    for (const io::Fault& fault : faults) {
      const bool near =
          fault.path.starts_with(bad.pointer) || std::string(bad.pointer).starts_with(fault.path);
      if (near && fault.message.find(bad.message) != std::string::npos) is_named = true;
    }
    EXPECT_TRUE(is_named) << bad.pointer << ": " << faults[0].path << " " << faults[0].message;
  }
}

TEST_F(RobotSpec, NamesBodiesThatHangOnNothingOrOnThemselves) {
  json document = leg();
  document["bodies"].push_back(
      {{"name", "crate"}, {"mass_kg", 1}, {"center_of_mass_m", {0, 0, 0}}, {"inertia_kg_m2", 1}});
  ASSERT_EQ(faults_of(document).size(), 1u);
  EXPECT_EQ(faults_of(document)[0].message, "\"crate\" hangs on no joint");
  document["joints"].push_back({{"name", "own"},
                                {"type", "revolute"},
                                {"parent", "crate"},
                                {"child", "crate"},
                                {"axis", {0, 0, 1}}});
  ASSERT_EQ(faults_of(document).size(), 1u);
  EXPECT_EQ(faults_of(document)[0].message, "is the child itself");
}

TEST_F(RobotSpec, SaysAllAtOnceAlsoOfTheActuator) {
  json document = leg();
  document["base"]["body"] = "x";
  document["contacts"][0]["body"] = "y";
  document["mechanisms"][0]["actuators"][0] = "absent.json";
  document["mechanisms"].push_back(
      {{"type", "parallel"},
       {"joints", {"knee", "toe"}},
       {"actuators", {"knee.json", "knee.json"}},
       {"jacobian", json::array({json::array({1, 1}), json::array({2, 2})})}});
  // Base, contact, missing file, a joint driven twice, a singular Jacobian.
  EXPECT_EQ(faults_of(document).size(), 5u);
}

TEST_F(RobotSpec, NeedsNoMassOfAFixedBaseOnly) {
  json document = leg();
  document["bodies"][1].erase("mass_kg");
  ASSERT_EQ(faults_of(document).size(), 1u);
  EXPECT_EQ(faults_of(document)[0].path, "/bodies/1/mass_kg");
  document["bodies"][1] = {{"name", "hip"}};
  document["base"]["motion"] = "fixed";
  EXPECT_TRUE(faults_of(document).empty());
  document["bodies"][2].erase("inertia_kg_m2");
  EXPECT_EQ(faults_of(document).size(), 1u);
}

// Oracle: the published masses, 7.60 + 3.89 + 0.96 = 12.45 kg.
TEST(ExampleRobots, HaveThePublishedMass) {
  const ReadRobot hopper = read_robot(TORQUEWRIGHT_SOURCE_DIR "/specs/robot/hopper.json");
  dynamics::TreeState state(hopper.robot.tree);
  EXPECT_NEAR(dynamics::centroid(state).mass_kg, 12.45, 1e-12);
  EXPECT_NEAR(hopper.robot.tree.bodies[1].joint.reflected_inertia, 0.3688, 1e-12);
  EXPECT_EQ(hopper.robot.drivetrains.size(), 2u);
  EXPECT_FALSE(hopper.robot.assumed.empty());
}

}  // namespace
}  // namespace torquewright::hopper
