// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <map>

#include "identification/log/delayed.hpp"
#include "identification/rig/joint_actuator_json.hpp"
#include "identification/rig/rig.hpp"
#include "identification/rig/stated_robot_spec.hpp"
#include "io/documents/document.hpp"
#include "io/text/column_patterns.hpp"
#include "io/text/name_pattern.hpp"
#include "tests/actuator/check/refusal.hpp"
#include "tests/identification/robot/leg.hpp"
#include "tests/io/scratch_folder.hpp"

namespace torquewright::identification {
namespace {

using nlohmann::json;

json robot() { return test::leg_json({{0.01, 0.2, 0.1}, {0.01, 0.2, 0.1}, {0.02, 0.2, 0.1}}); }

Rig read(const json& rig, const json& of = robot()) {
  const test::ScratchFolder folder;
  folder.write("leg.json", of.dump());
  return read_rig(io::read_document(folder.write("rig.json", rig.dump()), "rig"));
}

std::string refusal_of(const json& rig, const json& of = robot()) {
  const test::ScratchFolder folder;
  folder.write("leg.json", of.dump());
  const auto file = folder.write("rig.json", rig.dump());
  return test::refusal([&] { (void)read_rig(io::read_document(file, "rig")); }, folder.path());
}

// Oracle: the words of the pattern, written out by hand.
TEST(ColumnPatterns, PutThePartOfTheJointsNameIntoTheColumns) {
  const std::vector<std::string> joints = {"FL_hip_joint", "FL_calf_joint", "tail"};
  const auto columns = io::columns_of_pattern("{leg}_rad", "{leg}_joint", joints);
  ASSERT_EQ(columns.size(), 2u);
  EXPECT_EQ(columns[1].column, "FL_calf_rad");
  EXPECT_EQ(columns[1].joint, "FL_calf_joint");
  EXPECT_EQ(io::columns_of_pattern("q {joint}", "{joint}", joints).back().column, "q tail");
  EXPECT_TRUE(io::columns_of_pattern("{leg}_rad", "{joint}", joints).empty());
  EXPECT_TRUE(io::columns_of_pattern("{leg}_rad", "{leg}_knee", joints).empty());
}

TEST(NamePattern, TakesAnyLettersForAStar) {
  EXPECT_TRUE(io::fits_pattern("FL_calf_joint", "*_calf_joint"));
  EXPECT_TRUE(io::fits_pattern("FL_calf_joint", "*calf*"));
  EXPECT_TRUE(io::fits_pattern("knee", "knee"));
  EXPECT_TRUE(io::fits_pattern("", "*"));
  EXPECT_FALSE(io::fits_pattern("FL_calf_joint", "*_hip_joint"));
  EXPECT_FALSE(io::fits_pattern("FL_calf_joint", "*calf"));
}

TEST(RobotRig, HasTheJointsOfTheRobotInItsOrder) {
  const Rig rig = read(test::leg_rig_json());
  EXPECT_EQ(rig.joints, test::kLegJoints);
  ASSERT_EQ(rig.controllers.size(), 3u);
  EXPECT_EQ(rig.controllers[2]->law.stiffness_Nm_rad, 20.0);
  EXPECT_EQ(rig.load.robot->bodies, (std::vector<std::size_t>{1, 2, 3}));
  // What the drives do is theirs: the load is bodies alone.
  EXPECT_EQ(rig.load.robot->tree.bodies[3].joint.reflected_inertia, 0.0);
  EXPECT_TRUE(rig.load.robot->tree.bodies[3].joint.passive.is_none());
  EXPECT_EQ(rig.load.robot->joints[2].reflected_inertia, 0.02);
}

TEST(RobotRig, TakesTheLawOfAPatternBeforeTheOneOfAll) {
  json rig = test::leg_rig_json();
  rig["controllers"]["*calf*"] = {{"type", "pd"}, {"stiffness_Nm_rad", 35}};
  const Rig found = read(rig);
  EXPECT_EQ(found.controllers[0]->law.stiffness_Nm_rad, 20.0);
  EXPECT_EQ(found.controllers[2]->law.stiffness_Nm_rad, 35.0);
  EXPECT_EQ(found.controllers[2]->law.damping_Nm_s_rad, 0.0);
}

TEST(RobotRig, SaysWhatIsToBeFoundOfControllers) {
  json rig = test::leg_rig_json();
  rig["controller"]["delay_s"] = 0.01;
  rig["controllers"]["*calf*"] = {{"type", "position_servo"}};
  rig["uncertain"] = {"/controller/damping_Nm_s_rad"};
  const Rig found = read(rig);
  EXPECT_FALSE(found.controllers[0]->finds_stiffness);
  EXPECT_TRUE(found.controllers[0]->finds_damping);
  EXPECT_FALSE(found.controllers[0]->finds_delay);
  EXPECT_EQ(found.controllers[0]->delay_s, 0.01);
  EXPECT_TRUE(found.controllers[2]->finds_stiffness);
  EXPECT_FALSE(found.controllers[2]->states_stiffness);
  EXPECT_TRUE(found.controllers[2]->finds_delay);
  rig["uncertain"] = {"/controllers/*calf*/stiffness_Nm"};
  EXPECT_NE(refusal_of(rig).find("did you mean /controllers/*calf*/stiffness_Nm_rad?"),
            std::string::npos)
      << refusal_of(rig);
  rig.erase("uncertain");
  rig["controller"].erase("stiffness_Nm_rad");
  EXPECT_NE(refusal_of(rig).find("/controller/stiffness_Nm_rad: missing; a gain that is not known"),
            std::string::npos)
      << refusal_of(rig);
}

// Oracle: the same rig with its columns written out.
TEST(RobotRig, PatternsPassByWhatIsHeld) {
  json rig = test::leg_rig_json();
  rig["load"]["held_rad"] = {{"hip_joint", 0.1}};
  const Rig found = read(rig);
  EXPECT_EQ(found.joints, (std::vector<std::string>{"thigh_joint", "calf_joint"}));
  EXPECT_EQ(found.load.robot->bodies, (std::vector<std::size_t>{2, 3}));
  EXPECT_EQ(found.columns.size(), 1u + 2u * 2u);
}

// Oracle: the same rig with the load written into it.
TEST(StatedRobot, IsTheLoadOfARigThatSaysNone) {
  const test::ScratchFolder folder;
  std::filesystem::create_directories(folder.path() / "imported");
  const auto robot_file = folder.write("leg.json", robot().dump());
  json rig = test::leg_rig_json();
  const auto whole = folder.write("rig.json", rig.dump());
  rig.erase("load");
  const auto bare = folder.write("imported/rig.json", rig.dump());
  EXPECT_NE(test::refusal([&] {
              (void)read_rig(io::read_document(bare, "rig"));
            }).find("of a robot --robot FILE says it too"),
            std::string::npos);
  const Rig stated = read_rig(io::read_document(whole, "rig"));
  for (const std::filesystem::path& named : {robot_file, std::filesystem::proximate(robot_file)}) {
    io::Document document = io::read_document(bare, "rig");
    state_robot(named, document);
    const Rig found = read_rig(document);
    EXPECT_EQ(found.joints, stated.joints);
    EXPECT_EQ(found.load.robot->bodies, stated.load.robot->bodies);
    EXPECT_EQ(found.load.robot->tree.bodies[3].inertia.mass_kg,
              stated.load.robot->tree.bodies[3].inertia.mass_kg);
  }
  io::Document document = io::read_document(whole, "rig");
  EXPECT_EQ(test::refusal([&] { state_robot(robot_file, document); }, folder.path()),
            "--robot: the rig says itself what was moved, rig.json#/load; leave one out");
}

// Oracle: a straight line, late; what was before the first sample is the first.
TEST(DelayedChannel, IsWhatWasBefore) {
  const std::vector<double> time_s = {0.0, 0.1, 0.2, 0.4};
  const std::vector<double> values = {1.0, 2.0, 3.0, 5.0};
  const std::vector<double> late = delayed(time_s, values, 0.05);
  const std::vector<double> expected = {1.0, 1.5, 2.5, 4.5};
  for (std::size_t i = 0; i < late.size(); ++i) EXPECT_NEAR(late[i], expected[i], 1e-12) << i;
  EXPECT_EQ(delayed(time_s, values, 0.0), values);
}

TEST(RobotRig, RefusesWhatIsNotTheRobots) {
  json rig = test::leg_rig_json();
  rig["load"].erase("base");
  EXPECT_NE(refusal_of(rig).find("/load/base: missing; the robot's base floats"),
            std::string::npos);
  rig = test::leg_rig_json();
  rig["columns"]["x"] = {{"quantity", "output_velocity_rad_s"}, {"joint", "calv_joint"}};
  EXPECT_NE(refusal_of(rig).find("no joint \"calv_joint\"; did you mean \"calf_joint\"?"),
            std::string::npos);
  rig = test::leg_rig_json();
  rig["columns"]["{limb}_Nm"] = {{"quantity", "reported_torque_Nm"}, {"joint", "{limb}_wing"}};
  EXPECT_NE(refusal_of(rig).find("fits no joint"), std::string::npos);
  rig = test::leg_rig_json();
  rig["controllers"]["*_wing"] = {{"type", "pd"}, {"stiffness_Nm_rad", 35}};
  EXPECT_NE(refusal_of(rig).find("fits no joint of the log; they are hip_joint"),
            std::string::npos);
  rig = test::leg_rig_json();
  rig["load"]["held_rad"] = {{"hip_joint", 0.0}};
  rig["columns"]["hip_rad"] = {{"quantity", "output_position_rad"}, {"joint", "hip_joint"}};
  EXPECT_NE(refusal_of(rig).find("is in the log as well"), std::string::npos);
}

TEST(RobotRig, AsksWhereJointsStandThatTheLogDoesNotHold) {
  json rig = test::leg_rig_json();
  rig["columns"] = {{"time_s", "time_s"},
                    {"q", {{"quantity", "output_position_rad"}, {"joint", "calf_joint"}}},
                    {"c", {{"quantity", "commanded_position_rad"}, {"joint", "calf_joint"}}}};
  EXPECT_NE(refusal_of(rig).find("no column is of hip_joint, thigh_joint;"), std::string::npos)
      << refusal_of(rig);
  rig["load"]["held_rad"] = {{"hip_joint", 0.1}, {"thigh_joint", 0.7}};
  const Rig found = read(rig);
  EXPECT_EQ(found.joints, std::vector<std::string>{"calf_joint"});
  EXPECT_EQ(found.load.robot->held_rad.at(2), 0.7);
}

// Oracle: the numbers of the robot's document.
TEST(RobotRig, MakesADriveOfWhatItsJointDoes) {
  json springy = robot();
  springy["joints"][2]["stiffness_Nm_rad"] = 3.5;
  springy["joints"][2]["spring_rest_rad"] = -1.2;
  const test::ScratchFolder folder;
  folder.write("leg.json", springy.dump());
  const Rig rig =
      read_rig(io::read_document(folder.write("rig.json", test::leg_rig_json().dump()), "rig"));
  const actuator::Actuator calf = actuator_of_joint(rig, 2).actuator;
  EXPECT_EQ(calf.motor.rotor_inertia_kg_m2, 0.02);
  std::map<std::string, std::vector<double>> effects;
  for (const actuator::Effect& effect : calf.effects) {
    effects[std::string(effect.kind->name)] = effect.values;
  }
  EXPECT_EQ(effects,
            (std::map<std::string, std::vector<double>>{{"viscous_friction", {0.2}},
                                                        {"coulomb_friction", {0.1}},
                                                        {"parallel_spring", {3.5, -1.2}}}));
}

TEST(RobotRig, RefusesToMakeADriveOfAJointThatHoldsMoreAtRest) {
  json holds = robot();
  holds["joints"][2]["static_friction_Nm"] = 0.4;
  const Rig rig = read(test::leg_rig_json(), holds);
  EXPECT_NE(test::refusal([&] {
              (void)actuator_of_joint(rig, 2);
            }).find("calf_joint holds 0.4 Nm at rest where it takes 0.1 moving"),
            std::string::npos);
  EXPECT_EQ(test::refusal([&] { (void)actuator_of_joint(rig, 1); }), "");
}

TEST(RobotRig, RefusesAJointThatSlides) {
  json slides = robot();
  json& calf = slides["joints"][2];
  calf = {{"name", "calf_joint"},
          {"type", "prismatic"},
          {"parent", "thigh"},
          {"child", "calf"},
          {"axis", {0, 0, 1}}};
  EXPECT_NE(refusal_of(test::leg_rig_json(), slides).find("\"calf_joint\" slides"),
            std::string::npos);
}

}  // namespace
}  // namespace torquewright::identification
