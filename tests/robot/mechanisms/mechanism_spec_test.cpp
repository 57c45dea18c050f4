// SPDX-License-Identifier: Apache-2.0
#include "robot/model/mechanism_spec.hpp"

#include <gtest/gtest.h>

#include "robot/mechanisms/library_spec.hpp"
#include "robot/mjcf/mjcf_reader.hpp"
#include "robot/mjcf/mjcf_writer.hpp"
#include "robot/model/robot_json.hpp"
#include "robot/model/robot_spec.hpp"
#include "robot/urdf/urdf_writer.hpp"
#include "tests/io/scratch_folder.hpp"
#include "tests/robot/mechanisms/ankles.hpp"

namespace torquewright::hopper {
namespace {

using nlohmann::json;
using test::pair_of;

const char* const kHopper = TORQUEWRIGHT_SOURCE_DIR "/specs/robot/hopper.json";

/// The example, its actuators and gears found from anywhere.
json hopper() {
  json document = io::read_document(kHopper, "robot").root;
  for (json& mechanism : document["mechanisms"]) {
    for (json& file : mechanism["actuators"]) {
      file = TORQUEWRIGHT_SOURCE_DIR "/specs/robot/" + file.get<std::string>();
    }
    json& limit = mechanism["transmission_limit"];
    if (!limit.contains("strength")) continue;
    limit["strength"] =
        TORQUEWRIGHT_SOURCE_DIR "/specs/robot/" + limit["strength"].get<std::string>();
  }
  return document;
}

ReadRobot read(const json& document) {
  const test::ScratchFolder folder;
  return read_robot(folder.write("robot.json", document.dump()));
}

std::string faults_of(const json& document) {
  try {
    (void)read(document);
  } catch (const io::SpecError& error) {
    return error.what();
  }
  return "";
}

struct Bad {
  const char* pointer;
  json value;
  const char* message;  // part of it
};

TEST(MechanismSpec, SaysWhatIsWrongAndWhere) {
  const std::vector<Bad> changes{
      {"/mechanisms/0/type", "fourbar", "is not one of"},
      {"/mechanisms/0/crank_length_m", 0.5, "crank of 0.5 m is not shorter"},
      {"/mechanisms/0/crank_length_m", 0, ""},
      {"/mechanisms/0/branch", 0, ""},
      {"/mechanisms/0/crank_inertia_kg_m2", {0.1, 0.2}, "must have 1, not 2"},
      {"/mechanisms/1/reflected_inertia_kg_m2", {0.1, -0.2}, ""},
      {"/mechanisms/1/actuator_names", {"a", "a"}, "\"a\" is the name of another drive"},
      {"/mechanisms/1/actuator_names", {"knee", "b"}, "\"knee\" is the name of another drive"},
      {"/mechanisms/0/jacobian", {{1, 0}, {0, 1}}, "is for parallel mechanisms"},
      {"/mechanisms/0/rod_tilt_limit_rad", 0.5, "is for parallel_ankle mechanisms"},
      {"/mechanisms/1/crank_length_m", 0.5, "is for four_bar mechanisms"},
      {"/mechanisms/0/type", "direct", "is for four_bar mechanisms"},
      {"/mechanisms/0/type", "parallel_ankle", "must have 2, not 1"},
      {"/mechanisms/0/rocker_zero_rad", 0, "knee = 0 rad, or is singular there"},
      {"/mechanisms/0/coupler_length_m", 0.24, "knee = 2.269 rad, or is singular there"},
      {"/mechanisms/1/rods/0/crank_m", {0, 0.1, 0}, "no arm about actuator_axis"},
      {"/mechanisms/1/rods/1/actuator_axis", {0, 0, 0}, "has no direction"},
      {"/mechanisms/1/rods/1/foot_pin_axis", {0, 0, 0}, "has no direction"},
      {"/mechanisms/1/rods/0/rod_length_m", 0.1, "ankle_pitch = 0 rad, or is singular there"},
      {"/mechanisms/1/rods/0/rod_length_m", 0.21, "within the joint's range_rad"},
      {"/mechanisms/1/joints", {"ankle_roll", "ankle_pitch"}, "does not hang on"},
      {"/mechanisms/1/rods", json::array(), ""}};
  for (const Bad& bad : changes) {
    json document = hopper();
    document[json::json_pointer(bad.pointer)] = bad.value;
    const std::string faults = faults_of(document);
    EXPECT_NE(faults, "") << bad.pointer;
    EXPECT_NE(faults.find(bad.message), std::string::npos) << bad.pointer << ": " << faults;
    EXPECT_EQ(faults.find("nan"), std::string::npos);
  }
}

TEST(MechanismSpec, SaysWhatIsMissing) {
  json whole = hopper();
  whole.erase("assumed");  // or its pointers lead nowhere
  for (const char* key : {"crank_length_m", "rocker_zero_rad"}) {
    json document = whole;
    document["mechanisms"][0].erase(key);
    EXPECT_NE(faults_of(document).find(std::string(key) + ": missing"), std::string::npos);
  }
  json document = whole;
  document["mechanisms"][1].erase("rods");
  EXPECT_NE(faults_of(document).find("rods: missing"), std::string::npos);
}

TEST(MechanismSpec, RefusesJointsThatSlide) {
  json document = hopper();
  document["joints"][2]["type"] = "prismatic";
  document["joints"][2].erase("range_rad");
  document["joints"][2].erase("speed_limit_rad_s");
  EXPECT_NE(faults_of(document).find("\"ankle_roll\" slides"), std::string::npos);
}

// Oracle: the document that was written.
TEST(MechanismSpec, ComesBackFromDocuments) {
  const Robot robot = read(hopper()).robot;
  const Robot back = read(robot_json(robot)).robot;
  ASSERT_EQ(back.drivetrains.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    const Drivetrain &one = robot.drivetrains[i], &other = back.drivetrains[i];
    EXPECT_EQ(mechanism_keys(*one.mechanism), mechanism_keys(*other.mechanism));
    EXPECT_EQ(one.mechanism->type(), other.mechanism->type());
    EXPECT_EQ(one.rotors_in_tree, other.rotors_in_tree);
  }
  EXPECT_TRUE(back.drivetrains[0].rotors_in_tree);
  EXPECT_FALSE(back.drivetrains[1].rotors_in_tree);
}

// Oracle: the ranges that are published, -50..40 and +-30 degrees, both together too; and what the
// document states as limits.
TEST(ExampleHopper, ReachesItsRangesWithMargins) {
  const Robot robot = read_robot(kHopper).robot;
  const Mechanism& ankle = *robot.drivetrains[1].mechanism;
  double least_rad = 10;
  for (int i = 0; i <= 30; ++i) {
    for (int j = 0; j <= 20; ++j) {
      const SmallVector q = pair_of((-50 + 3 * i) * M_PI / 180, (-30 + 3 * j) * M_PI / 180);
      ASSERT_TRUE(ankle.transfer(q, pair_of(0, 0)));
      for (const MechanismMargin& margin : ankle.margins(q)) {
        EXPECT_GT(margin.margin, 0) << margin.name << " at " << q.transpose();
        if (margin.unit == "rad") least_rad = std::min(least_rad, margin.margin);
      }
    }
  }
  RecordProperty("least_margin_rad", std::to_string(least_rad));
  const Mechanism& knee = *robot.drivetrains[0].mechanism;
  for (int degrees = 0; degrees <= 130; ++degrees) {
    for (const auto& margin : knee.margins(SmallVector::Constant(1, degrees * M_PI / 180))) {
      EXPECT_GT(margin.margin, 0) << margin.name << " at " << degrees;
    }
  }
}

// Oracle: N^2 J of the actuator's document times the squares of the ratios at zero, by hand.
TEST(ExportedMechanisms, LeaveTheirRotorsInTheJoints) {
  const Robot robot = read_robot(kHopper).robot;
  const Exported mjcf = mjcf_of(robot);
  const test::ScratchFolder folder;
  const Robot back = read_mjcf(folder.write("robot.xml", mjcf.text)).robot;
  const double one = 64 * 0.0002;
  EXPECT_NEAR(back.tree.bodies[2].joint.reflected_inertia, 2 * one * 25 / 36, 1e-12);
  EXPECT_NEAR(back.tree.bodies[3].joint.reflected_inertia, 2 * one * 16 / 36, 1e-12);
  EXPECT_NEAR(back.tree.bodies[1].joint.reflected_inertia, 0.3688, 1e-12);
  for (const std::vector<std::string>& notes : {mjcf.notes, urdf_of(robot).notes}) {
    bool is_said = false;
    for (const std::string& note : notes) {
      is_said = is_said || note.find("the rotors of ankle_pitch, ankle_roll") != std::string::npos;
    }
    EXPECT_TRUE(is_said);
  }
}

}  // namespace
}  // namespace torquewright::hopper
