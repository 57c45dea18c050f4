// SPDX-License-Identifier: Apache-2.0
// An imported robot's limits as its drives. Oracle: statics by hand, 1 kg on an arm of 0.8 m holds
// 9.81 * 0.8 = 7.848 Nm.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cli/workplace.hpp"

namespace torquewright::cli_test {
namespace {

using nlohmann::json;

std::string arm(const std::string& limit) {
  const std::string inertia =
      "<inertia ixx=\"0.01\" iyy=\"0.01\" izz=\"0.01\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/>";
  return fmt::format(
      "<robot name=\"arm\"><link name=\"world\"/>"
      "<link name=\"base\"><inertial><mass value=\"1\"/>{0}</inertial></link>"
      "<joint name=\"fix\" type=\"fixed\"><parent link=\"world\"/><child link=\"base\"/></joint>"
      "<link name=\"arm\"><inertial><origin xyz=\"0.8 0 0\"/><mass "
      "value=\"1\"/>{0}</inertial></link>"
      "<joint name=\"shoulder\" type=\"revolute\"><parent link=\"base\"/><child link=\"arm\"/>"
      "<axis xyz=\"0 1 0\"/><limit lower=\"-2\" upper=\"2\" {1}/></joint></robot>\n",
      inertia, limit);
}

std::string held_still() {
  std::string csv = "time_s,shoulder_position_rad,shoulder_velocity_rad_s\n";
  for (int i = 0; i <= 100; ++i) csv += fmt::format("{:.2f},0,0\n", 0.01 * i);
  return csv;
}

/// The check's report of an arm with that limit, held still.
json report_of(const Workplace& place, const std::string& limit) {
  place.write("arm.urdf", arm(limit));
  place.write("hold.csv", held_still());
  const Outcome imported =
      place.run({"robot", "import", "arm.urdf", "--actuators", ".", "-o", "arm.json"});
  EXPECT_EQ(imported.exit_code, 0) << imported.err;
  return json::parse(place.run({"hopper", "check", "arm.json", "hold.csv", "--json"}).out);
}

TEST(LimitsAreDrives, AnArmIsHeldWithinThem) {
  Workplace place;
  const json report = report_of(place, "effort=\"10\" velocity=\"5\"");
  EXPECT_EQ(report["verdict"], "pass");
  EXPECT_NEAR(report["joints"][0]["margin_Nm"].get<double>(), 10.0 - 7.848, 1e-6);
  EXPECT_TRUE(report["joints"][0]["peak_current_A"].is_null());
}

TEST(LimitsAreDrives, AnArmIsNotHeldBeyondThem) {
  Workplace place;
  const json report = report_of(place, "effort=\"7.5\" velocity=\"5\"");
  EXPECT_EQ(report["verdict"], "fail");
  EXPECT_NEAR(report["joints"][0]["margin_Nm"].get<double>(), 7.5 - 7.848, 1e-6);
  EXPECT_EQ(report["joints"][0]["worst"]["limiter"], "envelope");
}

TEST(LimitsAreDrives, ARobotWithoutThemIsRefusedByName) {
  Workplace place;
  place.write("arm.urdf", arm("effort=\"0\" velocity=\"5\""));
  const Outcome imported =
      place.run({"robot", "import", "arm.urdf", "--actuators", ".", "-o", "arm.json"});
  EXPECT_EQ(imported.exit_code, 2);
  EXPECT_NE(imported.err.find("--actuators: no joint of the robot states a limit of torque"),
            std::string::npos)
      << imported.err;
}

// Oracle: what the folder holds afterwards; nothing where the robot is refused.
TEST(LimitsAreDrives, TheirFolderIsMade) {
  Workplace place;
  place.write("arm.urdf", arm("effort=\"10\" velocity=\"5\""));
  const Outcome imported =
      place.run({"robot", "import", "arm.urdf", "--actuators", "new/drives", "-o", "arm.json"});
  ASSERT_EQ(imported.exit_code, 0) << imported.err;
  const std::string file =
      json::parse(place.files().at("arm.json"))["mechanisms"][0]["actuators"][0];
  EXPECT_EQ(file.find("new/drives/"), 0u) << file;
  EXPECT_TRUE(place.has(file));
  place.write("arm.urdf", arm("effort=\"0\" velocity=\"5\""));
  const Outcome refused =
      place.run({"robot", "import", "arm.urdf", "--actuators", "other", "-o", "other.json"});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_FALSE(place.has("other"));
}

// A velocity of 0 is none that is stated: the torque holds at any speed, which is said.
TEST(LimitsAreDrives, AJointWithoutALimitOfSpeedHasItsTorqueAtAny) {
  Workplace place;
  place.write("arm.urdf", arm("effort=\"10\" velocity=\"0\""));
  const Outcome imported =
      place.run({"robot", "import", "arm.urdf", "--actuators", ".", "-o", "arm.json"});
  EXPECT_EQ(imported.exit_code, 0) << imported.err;
  EXPECT_NE(imported.out.find("state no limit of speed have their torque at any"),
            std::string::npos)
      << imported.out;
}

/// A knee that a crank turns by a rod, both of no weight to speak of, with a motor of that range.
std::string cranked_knee(const std::string& motor) {
  const std::string light = "<inertial pos='0 0 0' mass='1e-4' diaginertia='1e-8 1e-8 1e-8'/>";
  return "<mujoco><compiler angle='radian'/><worldbody><body name='thigh'>"
         "<inertial pos='0 0 0' mass='3' diaginertia='0.1 0.1 0.1'/>"
         "<body name='crank' pos='0.15 0 0'><joint name='c' axis='0 1 0' damping='0.2' "
         "frictionloss='0.3'/>" +
         light + "<body name='rod' pos='0 0 -0.05'><joint name='r' axis='0 1 0'/>" + light +
         "</body></body><body name='shank'><joint name='knee' axis='0 1 0' limited='true' "
         "range='-0.5 0.5'/><inertial pos='0 0 -0.2' mass='2' diaginertia='0.02 0.02 0.01'/></body>"
         "</body></worldbody><equality><connect body1='shank' body2='rod' anchor='0 0 -0.06'/>"
         "</equality><actuator><motor name='knee_motor' joint='c' " +
         motor + "/></actuator></mujoco>";
}

// Oracle: the file's own numbers; nothing is written where the drive states no limit.
TEST(LimitsAreDrives, OfCranksToo) {
  Workplace place;
  place.write("leg.xml", cranked_knee("ctrllimited='true' ctrlrange='-30 30'"));
  const Outcome imported =
      place.run({"robot", "import", "leg.xml", "--actuators", "drives", "-o", "leg.json"});
  ASSERT_EQ(imported.exit_code, 0) << imported.err;
  const json mechanism = json::parse(place.files().at("leg.json"))["mechanisms"][0];
  EXPECT_EQ(mechanism["type"], "four_bar");
  const std::string file = mechanism["actuators"][0];
  const json drive = json::parse(text_of(place.path() / file));
  EXPECT_EQ(drive["envelope"]["peak_torque_Nm"], 30.0);
  EXPECT_EQ(drive["effects"][0]["parameters"]["coulomb_Nm"], 0.3);
  EXPECT_EQ(drive["effects"][1]["parameters"]["viscous_Nm_s_rad"], 0.2);
  place.write("leg.xml", cranked_knee(""));
  const Outcome refused =
      place.run({"robot", "import", "leg.xml", "--actuators", "other", "-o", "other.json"});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_NE(refused.err.find("the drive knee_motor of a loop states no limit of torque"),
            std::string::npos)
      << refused.err;
  EXPECT_FALSE(place.has("other"));
  EXPECT_FALSE(place.has("other.json"));
}

TEST(LimitsAreDrives, SimulatorsGetThem) {
  Workplace place;
  report_of(place, "effort=\"10\" velocity=\"5\"");
  const Outcome isaac =
      place.run({"robot", "export", "arm.json", "--format", "isaac-lab", "--actuators"});
  EXPECT_EQ(isaac.exit_code, 0) << isaac.err;
  // Conservative: inside by rounding.
  const std::string key = "actuator_effort_limit=";
  const std::size_t place_of_limit = isaac.out.find(key);
  ASSERT_NE(place_of_limit, std::string::npos) << isaac.out;
  EXPECT_NEAR(std::stod(isaac.out.substr(place_of_limit + key.size())), 10.0, 1e-6);
  const Outcome mjcf =
      place.run({"robot", "export", "arm.json", "--format", "mjcf", "--actuators"});
  EXPECT_EQ(mjcf.exit_code, 0) << mjcf.err;
  EXPECT_NE(mjcf.out.find("forcerange=\"-10 10\""), std::string::npos) << mjcf.out;
}

}  // namespace
}  // namespace torquewright::cli_test
