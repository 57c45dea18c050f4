// SPDX-License-Identifier: Apache-2.0
#include "hopper/trials/randomisation_spec.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <ostream>

#include "hopper/trials/causes.hpp"
#include "tests/hopper/replay/randomised_hopper.hpp"

namespace torquewright::hopper {
namespace {

using nlohmann::json;
using test::hopper;
using test::seeds_tables;

void expect_range(const std::optional<Range>& range, double least, double greatest) {
  ASSERT_TRUE(range);
  EXPECT_EQ(range->least, least);
  EXPECT_EQ(range->greatest, greatest);
}

void expect_range(const NamedRange& range, double least, double greatest,
                  const std::vector<std::string>& names) {
  expect_range(std::optional(range.range), least, greatest);
  EXPECT_EQ(range.names, names);
}

// Oracle: tables 2 and 3 of seed 000.
TEST(RandomisationSpec, ReadsTheSeedsTables) {
  const Randomisation& read = seeds_tables();
  expect_range(read.total_mass_factor, 0.85, 1.15);
  EXPECT_TRUE(read.body_mass_factor.empty());
  expect_range(read.body_inertia_factor.at(0), 0.85, 1.15, {});
  const ShiftRange& shift = read.center_of_mass_shift_m.at(0);
  expect_range(shift.of_bodies, -0.03, 0.03, {"thigh", "calf", "foot"});
  EXPECT_EQ(shift.along, (std::array<bool, 3>{true, true, true}));
  expect_range(read.controller_gain_factor.at(0), 0.9, 1.1, {});
  expect_range(read.further_friction_Nm.at(0), 0.0, 0.7, {"knee"});
  expect_range(read.further_friction_Nm.at(1), 0.0, 1.0, {"ankle_left", "ankle_right"});
  EXPECT_EQ(read.further_friction_Nm.at(1).path, "/further_friction_Nm/1");
  expect_range(read.friction_coefficient, 0.5, 0.9);
  expect_range(read.restitution, 0.0, 0.2);
  EXPECT_EQ(read.noise.distribution, NoiseDistribution::kUniform);
  EXPECT_EQ(read.noise.gravity_direction, 0.07);
  EXPECT_EQ(read.noise.base_rate_rad_s, 0.1);
  EXPECT_EQ(read.noise.joint_position_rad, 0.05);
  EXPECT_EQ(read.noise.joint_velocity_rad_s, 0.5);
  EXPECT_EQ(read.noise.base_position_m, 0.0);
  EXPECT_FALSE(read.state_of_charge);
  EXPECT_TRUE(read.bus_voltage_factor);
  EXPECT_TRUE(read.winding_temperature_K);
  EXPECT_FALSE(read.assumed.empty());
  EXPECT_NO_THROW(require_fits(read, hopper()));
}

json with(json keys) {
  keys["kind"] = "randomisation";
  keys["version"] = 1;
  return keys;
}

Randomisation read(const json& keys) {
  return randomisation_of(io::check_document(with(keys), "randomisation", "spread.json", ""))
      .randomisation;
}

// Oracle: the document.
TEST(RandomisationSpec, ReadsEveryOtherKey) {
  const Randomisation all = read(json::parse(R"({
    "body_mass_factor": [{"bodies": ["foot"], "least": 0.5, "greatest": 0.6}],
    "center_of_mass_shift_m": [{"along": ["z", "x"], "least": 0, "greatest": 0.1}],
    "ground_height_m": {"least": -0.1, "greatest": 0.2},
    "latency_s": {"least": 0.001, "greatest": 0.002},
    "state_of_charge": {"least": 0.25, "greatest": 0.75},
    "initial_joint_position_rad": [{"joints": ["knee"], "least": -0.25, "greatest": 0.5}],
    "initial_joint_velocity_rad_s": [{"least": -1.5, "greatest": 1}],
    "sensor_noise": {"distribution": "normal", "base_position_m": 0.125, "base_velocity_m_s": 0.5}
  })"));
  expect_range(all.body_mass_factor.at(0), 0.5, 0.6, {"foot"});
  EXPECT_EQ(all.center_of_mass_shift_m.at(0).along, (std::array<bool, 3>{true, false, true}));
  expect_range(all.ground_height_m, -0.1, 0.2);
  expect_range(all.latency_s, 0.001, 0.002);
  expect_range(all.state_of_charge, 0.25, 0.75);
  expect_range(all.initial_joint_position_rad.at(0), -0.25, 0.5, {"knee"});
  expect_range(all.initial_joint_velocity_rad_s.at(0), -1.5, 1.0, {});
  EXPECT_EQ(all.noise.distribution, NoiseDistribution::kNormal);
  EXPECT_EQ(all.noise.base_position_m, 0.125);
  EXPECT_EQ(all.noise.base_velocity_m_s, 0.5);
  EXPECT_EQ(all.noise.joint_position_rad, 0.0);
}

/// A document that is refused: at which place, and with what words.
struct Refusal {
  std::string name;
  std::string keys;
  std::string path;
  std::string words;
};

void PrintTo(const Refusal& refusal, std::ostream* stream) { *stream << refusal.keys; }

void expect_refused(const std::function<void()>& work, const Refusal& refusal) {
  try {
    work();
  } catch (const io::SpecError& error) {
    ASSERT_EQ(error.faults().size(), 1u) << error.what();
    const io::Fault& fault = error.faults().front();
    EXPECT_EQ(fault.file, "spread.json");
    EXPECT_EQ(fault.path, refusal.path);
    EXPECT_NE(fault.message.find(refusal.words), std::string::npos) << fault.message;
    return;
  }
  FAIL() << refusal.keys << " was taken";
}

class RefusedDocument : public testing::TestWithParam<Refusal> {};

TEST_P(RefusedDocument, SaysWhereAndWhy) {
  expect_refused([] { (void)read(json::parse(GetParam().keys)); }, GetParam());
}

const std::vector<Refusal> kRefusedDocuments = {
    {"UnknownKey", R"({"restitutoin": {"least": 0, "greatest": 1}})", "/restitutoin",
     "restitution"},
    {"UnknownEnd", R"({"restitution": {"least": 0, "greatest": 1, "mean": 0.5}})",
     "/restitution/mean", ""},
    {"NoEnd", R"({"restitution": {"least": 0}})", "/restitution/greatest", "missing"},
    {"MassOfNothing", R"({"total_mass_factor": {"least": 0, "greatest": 1}})",
     "/total_mass_factor/least", "0.01"},
    {"NegativeMass", R"({"body_mass_factor": [{"least": -1, "greatest": 1}]})",
     "/body_mass_factor/0/least", "0.01"},
    {"InertiaOfNothing", R"({"body_inertia_factor": [{"least": 0, "greatest": 1}]})",
     "/body_inertia_factor/0/least", "0.01"},
    {"NoRange", R"({"body_inertia_factor": []})", "/body_inertia_factor", ""},
    {"FarShift", R"({"center_of_mass_shift_m": [{"least": -30, "greatest": 3}]})",
     "/center_of_mass_shift_m/0/least", "-10"},
    {"NoAxis", R"({"center_of_mass_shift_m": [{"along": ["w"], "least": 0, "greatest": 1}]})",
     "/center_of_mass_shift_m/0/along/0", "x"},
    {"NoGain", R"({"controller_gain_factor": [{"least": 0, "greatest": 1}]})",
     "/controller_gain_factor/0/least", "0.01"},
    {"NoStrength", R"({"motor_strength_factor": [{"least": 0, "greatest": 1}]})",
     "/motor_strength_factor/0/least", "0.01"},
    {"DrivingFriction", R"({"further_friction_Nm": [{"least": -0.1, "greatest": 1}]})",
     "/further_friction_Nm/0/least", "0"},
    {"PullingGround", R"({"friction_coefficient": {"least": -0.1, "greatest": 1}})",
     "/friction_coefficient/least", "0"},
    {"RestitutionAboveOne", R"({"restitution": {"least": 0, "greatest": 1.2}})",
     "/restitution/greatest", "1"},
    {"HighGround", R"({"ground_height_m": {"least": 0, "greatest": 11}})",
     "/ground_height_m/greatest", "10"},
    {"SeesAhead", R"({"latency_s": {"least": -0.01, "greatest": 0}})", "/latency_s/least", "0"},
    {"MoreThanFull", R"({"state_of_charge": {"least": 0.5, "greatest": 1.1}})",
     "/state_of_charge/greatest", "1"},
    {"NoVoltage", R"({"bus_voltage_factor": {"least": 0, "greatest": 1}})",
     "/bus_voltage_factor/least", "0.01"},
    {"Celsius", R"({"winding_temperature_K": {"least": 20, "greatest": 300}})",
     "/winding_temperature_K/least", "150"},
    {"FarStart", R"({"initial_joint_position_rad": [{"least": -90, "greatest": 9}]})",
     "/initial_joint_position_rad/0/least", "-10"},
    {"FastStart", R"({"initial_joint_velocity_rad_s": [{"least": 0, "greatest": 2000}]})",
     "/initial_joint_velocity_rad_s/0/greatest", "1000"},
    {"NoDistribution", R"({"sensor_noise": {"joint_position_rad": 0.05}})",
     "/sensor_noise/distribution", "missing"},
    {"OtherDistribution", R"({"sensor_noise": {"distribution": "gaussian"}})",
     "/sensor_noise/distribution", "normal"},
    {"NegativeNoise", R"({"sensor_noise": {"distribution": "normal", "base_rate_rad_s": -1}})",
     "/sensor_noise/base_rate_rad_s", "0"},
    {"UnknownNoise", R"({"sensor_noise": {"distribution": "normal", "joint_position": 1}})",
     "/sensor_noise/joint_position", "joint_position_rad"},
    {"UpsideDown", R"({"restitution": {"least": 0.5, "greatest": 0.25}})", "/restitution",
     "least, 0.5, is above greatest, 0.25"},
    {"UpsideDownInAList",
     R"({"further_friction_Nm": [{"least": 0, "greatest": 1}, {"least": 2, "greatest": 1}]})",
     "/further_friction_Nm/1", "least, 2, is above greatest, 1"},
    {"ShiftUpsideDown", R"({"center_of_mass_shift_m": [{"least": 0.1, "greatest": -0.1}]})",
     "/center_of_mass_shift_m/0", "least, 0.1, is above greatest, -0.1"},
    {"AssumesWhatItDoesNotState", R"({"assumed": ["/latency_s"]})", "/assumed/0", "latency_s"},
};

INSTANTIATE_TEST_SUITE_P(RandomisationSpec, RefusedDocument, testing::ValuesIn(kRefusedDocuments),
                         [](const auto& test) { return test.param.name; });

/// The hopper whose knee has thermal data, whose cross of the ankle weighs nothing and whose ankle
/// rolls by sliding.
Robot altered_hopper() {
  Robot robot = hopper();
  actuator::Thermal thermal;
  thermal.winding_limit_K = 393.15;
  robot.drivetrains[0].actuators[0].thermal = thermal;
  robot.tree.bodies[2].inertia = {};
  robot.tree.bodies[3].joint.kind = dynamics::JointKind::kPrismatic;
  return robot;
}

class RefusedRobot : public testing::TestWithParam<Refusal> {};

TEST_P(RefusedRobot, SaysWhereAndWhy) {
  const Randomisation asked = read(json::parse(GetParam().keys));
  expect_refused([&] { require_fits(asked, altered_hopper()); }, GetParam());
}

const std::vector<Refusal> kRefusedRobots = {
    {"UnknownBody",
     R"({"body_mass_factor": [{"bodies": ["calf", "thihg"], "least": 1, "greatest": 1}]})",
     "/body_mass_factor/0/bodies/1", "no body is named \"thihg\"; did you mean \"thigh\"?"},
    {"UnknownBodyOfAShift",
     R"({"center_of_mass_shift_m": [{"bodies": ["foto"], "least": 0, "greatest": 1}]})",
     "/center_of_mass_shift_m/0/bodies/0", "did you mean \"foot\"?"},
    {"UnknownDrive",
     R"({"further_friction_Nm": [{"drives": ["ankle_lefd"], "least": 0, "greatest": 1}]})",
     "/further_friction_Nm/0/drives/0", "did you mean \"ankle_left\"?"},
    {"JointForADrive",
     R"({"controller_gain_factor": [{"drives": ["hip"], "least": 1, "greatest": 1}]})",
     "/controller_gain_factor/0/drives/0", "there are knee, ankle_left, ankle_right"},
    {"NoDriveOfThatStrength",
     R"({"motor_strength_factor": [{"drives": ["ankle_lefd"], "least": 1, "greatest": 1}]})",
     "/motor_strength_factor/0/drives/0", "did you mean \"ankle_left\"?"},
    {"UnknownJoint",
     R"({"initial_joint_velocity_rad_s": [{"joints": ["kne"], "least": 0, "greatest": 1}]})",
     "/initial_joint_velocity_rad_s/0/joints/0", "did you mean \"knee\"?"},
    {"Massless",
     R"({"body_inertia_factor": [{"bodies": ["ankle_cross"], "least": 1, "greatest": 1}]})",
     "/body_inertia_factor/0/bodies/0", "\"ankle_cross\" has no mass"},
    {"Sliding",
     R"({"initial_joint_position_rad": [{"joints": ["ankle_roll"], "least": 0, "greatest": 1}]})",
     "/initial_joint_position_rad/0/joints/0", "\"ankle_roll\" slides"},
    {"Twice",
     R"({"further_friction_Nm": [{"drives": ["ankle_left"], "least": 0, "greatest": 1},
         {"drives": ["knee", "ankle_left"], "least": 0, "greatest": 1}]})",
     "/further_friction_Nm/1", "drive \"ankle_left\" has a range already"},
    {"AllAndOne",
     R"({"body_mass_factor": [{"least": 1, "greatest": 1},
         {"bodies": ["foot"], "least": 1, "greatest": 1}]})",
     "/body_mass_factor/1", "body \"foot\" has a range already"},
    {"AxisTwice",
     R"({"center_of_mass_shift_m": [
         {"bodies": ["foot"], "along": ["x", "y"], "least": 0, "greatest": 1},
         {"bodies": ["foot"], "along": ["y", "z"], "least": 0, "greatest": 1}]})",
     "/center_of_mass_shift_m/1", "body \"foot\" has a range already"},
    {"Hot", R"({"winding_temperature_K": {"least": 300, "greatest": 400}})",
     "/winding_temperature_K/greatest",
     "400 K is above what the winding of \"knee\" bears, 393.15"},
};

INSTANTIATE_TEST_SUITE_P(RandomisationSpec, RefusedRobot, testing::ValuesIn(kRefusedRobots),
                         [](const auto& test) { return test.param.name; });

// Each drive says it: none of the hopper's batteries has a curve.
TEST(RandomisationSpec, RefusesAChargeWhereNoBatteryHasACurve) {
  try {
    require_fits(read(json::parse(R"({"state_of_charge": {"least": 0.5, "greatest": 1}})")),
                 hopper());
    FAIL() << "it was taken";
  } catch (const io::SpecError& error) {
    ASSERT_EQ(error.faults().size(), 3u);
    EXPECT_EQ(error.faults()[0].path, "/state_of_charge");
    EXPECT_NE(error.faults()[0].message.find("drive \"knee\": a state of charge needs"),
              std::string::npos);
  }
}

// Each range and each noise alone makes trials differ; without a width none does.
TEST(RandomisationSpec, VariesWhereARangeHasAWidthOrSensorsHaveNoise) {
  const auto varied = [](const std::string& text) {
    return !causes_of(read(json::parse(text))).empty();
  };
  EXPECT_FALSE(varied("{}"));
  const json point = {{"least", 1}, {"greatest", 1}};
  const json wide = {{"least", 0.5}, {"greatest", 1}};
  for (const char* key : {"total_mass_factor", "friction_coefficient", "restitution",
                          "ground_height_m", "state_of_charge", "bus_voltage_factor"}) {
    EXPECT_FALSE(varied(json{{key, point}}.dump())) << key;
    EXPECT_TRUE(varied(json{{key, wide}}.dump())) << key;
  }
  for (const char* key : {"body_mass_factor", "body_inertia_factor", "center_of_mass_shift_m",
                          "controller_gain_factor", "motor_strength_factor", "further_friction_Nm",
                          "initial_joint_position_rad", "initial_joint_velocity_rad_s"}) {
    EXPECT_FALSE(varied(json{{key, {point}}}.dump())) << key;
    EXPECT_TRUE(varied(json{{key, {wide}}}.dump())) << key;
  }
  EXPECT_TRUE(varied(R"({"latency_s": {"least": 0, "greatest": 0.01}})"));
  EXPECT_TRUE(varied(R"({"winding_temperature_K": {"least": 300, "greatest": 310}})"));
  for (const char* key : {"gravity_direction", "base_rate_rad_s", "base_position_m",
                          "base_velocity_m_s", "joint_position_rad", "joint_velocity_rad_s"}) {
    const json noise = {{"distribution", "uniform"}, {key, 0.01}};
    EXPECT_TRUE(varied(json{{"sensor_noise", noise}}.dump())) << key;
  }
}

// Shifts of one body along different axes do not meet; what all means leaves out what draws
// nothing.
TEST(RandomisationSpec, TakesRangesThatDoNotMeet) {
  EXPECT_NO_THROW(require_fits(read(json::parse(R"({
    "center_of_mass_shift_m": [
      {"bodies": ["foot"], "along": ["x"], "least": 0, "greatest": 1},
      {"bodies": ["foot"], "along": ["y", "z"], "least": 0, "greatest": 1}],
    "body_mass_factor": [{"least": 1, "greatest": 1}],
    "initial_joint_position_rad": [{"least": 0, "greatest": 1}]})")),
                               altered_hopper()));
}

}  // namespace
}  // namespace torquewright::hopper
