// SPDX-License-Identifier: Apache-2.0
// A robot with another value. Oracles: the robot that is read from documents in which that value
// was written by hand, and the corners of a motor's region in closed form.
#include "hopper/variation/variation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>

#include "actuator/region/joint_region.hpp"
#include "io/faults/spec_error.hpp"
#include "robot/model/robot_spec.hpp"
#include "robot/model/whole_body.hpp"
#include "tests/io/scratch_folder.hpp"

namespace torquewright::hopper {
namespace {

namespace fs = std::filesystem;

constexpr double kRounding = 1e-14;  // of a value: a few roundings of its scaling

/// A copy of the example documents that can be edited.
class Documents {
 public:
  Documents() {
    const fs::path specs = fs::path(TORQUEWRIGHT_SOURCE_DIR) / "specs";
    for (const char* name : {"robot", "actuator", "gearbox"}) {
      fs::copy(specs / name, folder_.path() / name, fs::copy_options::recursive);
    }
  }
  /// Replaces all places that read so.
  Documents& edit(const std::string& file, const std::string& from, const std::string& to) {
    std::ifstream stream(folder_.path() / file);
    std::string text{std::istreambuf_iterator<char>(stream), {}};
    std::size_t count = 0;
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at)) {
      text.replace(at, from.size(), to);
      at += to.size();
      ++count;
    }
    EXPECT_GT(count, 0u) << file << " reads " << from << " nowhere";
    folder_.write(file, text);
    return *this;
  }
  Robot robot(const std::string& name = "hopper") const {
    return read_robot(folder_.path() / "robot" / (name + ".json")).robot;
  }

 private:
  test::ScratchFolder folder_;
};

void expect_near(double one, double other) {
  EXPECT_NEAR(one, other, kRounding * std::max(1.0, std::abs(other)));
}

void expect_same_drive(const actuator::Actuator& one, const actuator::Actuator& other) {
  expect_near(one.motor.resistance_ohm, other.motor.resistance_ohm);
  expect_near(one.motor.torque_constant_Nm_A, other.motor.torque_constant_Nm_A);
  expect_near(one.motor.rotor_inertia_kg_m2, other.motor.rotor_inertia_kg_m2);
  expect_near(one.drive.bus_voltage_V, other.drive.bus_voltage_V);
  expect_near(one.drive.peak_current_A, other.drive.peak_current_A);
  expect_near(one.transmission.ratio, other.transmission.ratio);
  expect_near(one.transmission.inertia_kg_m2, other.transmission.inertia_kg_m2);
  ASSERT_EQ(one.battery.has_value(), other.battery.has_value());
  if (!one.battery) return;
  expect_near(one.battery->cell_resistance_ohm, other.battery->cell_resistance_ohm);
  ASSERT_EQ(one.battery->cell_open_circuit.size(), other.battery->cell_open_circuit.size());
  for (std::size_t i = 0; i < one.battery->cell_open_circuit.size(); ++i) {
    expect_near(one.battery->cell_open_circuit[i].voltage_V,
                other.battery->cell_open_circuit[i].voltage_V);
  }
}

void expect_same(const Robot& one, const Robot& other) {
  ASSERT_EQ(one.tree.bodies.size(), other.tree.bodies.size());
  for (std::size_t i = 0; i < one.tree.bodies.size(); ++i) {
    const dynamics::Body& body = one.tree.bodies[i];
    const dynamics::Body& twin = other.tree.bodies[i];
    SCOPED_TRACE(body.name);
    expect_near(body.inertia.mass_kg, twin.inertia.mass_kg);
    EXPECT_TRUE(body.inertia.inertia_kg_m2.isApprox(twin.inertia.inertia_kg_m2, kRounding));
    EXPECT_TRUE(body.inertia.center_of_mass_m.isApprox(twin.inertia.center_of_mass_m, kRounding));
    expect_near(body.joint.reflected_inertia, twin.joint.reflected_inertia);
    EXPECT_TRUE(body.joint.rotor_spin_kg_m2.isApprox(twin.joint.rotor_spin_kg_m2, kRounding));
  }
  ASSERT_EQ(one.drivetrains.size(), other.drivetrains.size());
  const WholeBody whole(one), twin(other);
  std::size_t drive = 0;
  for (std::size_t i = 0; i < one.drivetrains.size(); ++i) {
    for (std::size_t k = 0; k < one.drivetrains[i].actuators.size(); ++k, ++drive) {
      SCOPED_TRACE(one.drivetrains[i].actuator_names[k]);
      expect_same_drive(one.drivetrains[i].actuators[k], other.drivetrains[i].actuators[k]);
      expect_near(whole.rotor_inertia_kg_m2(drive), twin.rotor_inertia_kg_m2(drive));
    }
  }
}

Robot with(const Robot& robot, const std::string& name, double value) {
  return varied(robot, variable_named(robot, name, "--sweep"), value);
}

TEST(VariedRobot, HasAnotherRatioAsIfItsDocumentSaidSo) {
  const Robot robot = Documents().robot();
  expect_same(
      with(robot, "knee_ratio", 13.5),
      Documents().edit("actuator/d151_knee.json", "\"ratio\": 20", "\"ratio\": 13.5").robot());
  expect_same(
      with(robot, "ankle_ratio", 11),
      Documents().edit("actuator/d110a_ankle.json", "\"ratio\": 8", "\"ratio\": 11").robot());
}

// 10 rad/s and 320 Nm at 20:1 are 12.5 rad/s and 256 Nm of the same motor at 16:1, unless the
// joint's bearings or cables are what limits.
TEST(VariedRobot, LimitsItsJointsAsTheDriveBehindAnotherRatioDoes) {
  Documents documents;
  const auto knee = [](const Robot& robot) {
    const Variable ratio = variable_named(robot, "knee_ratio", "");
    const Robot changed = varied(robot, ratio, 16.0);
    return changed.tree.bodies[*changed.find_joint("knee")].joint.limits;
  };
  const dynamics::JointLimits follow = knee(documents.robot());
  expect_near(follow.speed_max, 12.5);
  expect_near(follow.effort_max, 256.0);
  documents.edit("robot/hopper.json", "\"torque_limit_Nm\": 320",
                 "\"torque_limit_Nm\": 320, \"own_limits\": [\"speed\"]");
  const dynamics::JointLimits own = knee(documents.robot());
  expect_near(own.speed_max, 10.0);
  expect_near(own.effort_max, 256.0);
}

// Its joints hold the rotors: N^2 J at each.
TEST(VariedRobot, HasAnotherRatioWhereJointsHoldTheRotors) {
  const Documents documents;
  Robot two_knees = documents.robot("mini_cheetah");
  two_knees = with(two_knees, "fknee_ratio", 7);
  two_knees = with(two_knees, "rknee_ratio", 7);
  expect_same(
      two_knees,
      Documents().edit("actuator/mini_cheetah_knee.json", "9.33", "7").robot("mini_cheetah"));
}

TEST(VariedRobot, KeepsTheSignOfARatio) {
  Documents documents;
  documents.edit("actuator/d151_knee.json", "\"ratio\": 20", "\"ratio\": -20");
  const Robot changed = with(documents.robot(), "knee_ratio", 10);
  EXPECT_EQ(changed.drivetrains[0].actuators[0].transmission.ratio, -10.0);
}

TEST(VariedRobot, HasAnotherCurrentAsIfItsDocumentSaidSo) {
  expect_same(
      with(Documents().robot(), "current", 30),
      Documents()
          .edit("actuator/d151_knee.json", "\"peak_current_A\": 50", "\"peak_current_A\": 30")
          .edit("actuator/d110a_ankle.json", "\"peak_current_A\": 50", "\"peak_current_A\": 30")
          .robot());
}

TEST(VariedRobot, HasAnotherResistanceAsIfItsDocumentSaidSo) {
  const Robot robot = Documents().robot();
  expect_same(with(robot, "knee_resistance", 0.56),
              Documents().edit("actuator/d151_knee.json", "0.28", "0.56").robot());
  expect_same(with(robot, "resistance_factor", 0.5),
              Documents()
                  .edit("actuator/d151_knee.json", "0.28", "0.14")
                  .edit("actuator/d110a_ankle.json", "0.35", "0.175")
                  .robot());
}

// 16 cells.
TEST(VariedRobot, HasOtherCellsAsIfItsDocumentSaidSo) {
  expect_same(
      with(Documents().robot(), "voltage", 52.8),
      Documents()
          .edit("robot/hopper.json", "\"cell_open_circuit_V\": 4.2", "\"cell_open_circuit_V\": 3.3")
          .edit("actuator/d151_knee.json", "\"bus_voltage_V\": 67.2", "\"bus_voltage_V\": 52.8")
          .edit("actuator/d110a_ankle.json", "\"bus_voltage_V\": 67.2", "\"bus_voltage_V\": 52.8")
          .robot());
}

TEST(VariedRobot, HasAnotherBusWhereThereIsNoBattery) {
  expect_same(
      with(Documents().robot("mini_cheetah"), "voltage", 30),
      Documents()
          .edit("actuator/mini_cheetah_hip.json", "\"bus_voltage_V\": 24", "\"bus_voltage_V\": 30")
          .edit("actuator/mini_cheetah_knee.json", "\"bus_voltage_V\": 24", "\"bus_voltage_V\": 30")
          .robot("mini_cheetah"));
}

// Twice the mass of bodies of the same shape: twice their inertia, as if gravity and all forces
// were doubled; 3.3 + 2 (0.634 + 0.064) = 4.696 kg.
TEST(VariedRobot, IsHeavierInEveryBody) {
  const Robot robot = Documents().robot("mini_cheetah");
  EXPECT_NEAR(variable_named(robot, "mass", "").present, 4.696, 1e-12);
  expect_same(
      with(robot, "mass", 2 * 4.696),
      Documents()
          .edit("robot/mini_cheetah.json", "3.3", "6.6")
          .edit("robot/mini_cheetah.json", "0.634", "1.268")
          .edit("robot/mini_cheetah.json", "0.064", "0.128")
          .edit("robot/mini_cheetah.json", "\"inertia_kg_m2\": 0.036", "\"inertia_kg_m2\": 0.072")
          .edit("robot/mini_cheetah.json", "\"inertia_kg_m2\": 0.002", "\"inertia_kg_m2\": 0.004")
          .edit("robot/mini_cheetah.json", "\"inertia_kg_m2\": 0.00025",
                "\"inertia_kg_m2\": 0.0005")
          .robot("mini_cheetah"));
}

// Oracle: an ideal motor at a stiff bus, `dc`: at rest N Kt I, no torque beyond V / (N Kt), and the
// corner between them at (V - R I) / (N Kt).
TEST(VariedRobot, HasTheRegionOfItsValues) {
  Documents documents;
  documents.edit("robot/hopper.json", ", \"cell_resistance_ohm\": 0.015",
                 ", \"cell_resistance_ohm\": 0");
  const Robot robot = documents.robot();
  struct Case {
    const char* name;
    double value, ratio, volt, ampere, ohm;
  };
  for (const Case& one :
       {Case{"knee_ratio", 12, 12, 67.2, 50, 0.28}, Case{"voltage", 48, 20, 48, 50, 0.28},
        Case{"knee_current", 35, 20, 67.2, 35, 0.28},
        Case{"knee_resistance", 0.5, 20, 67.2, 50, 0.5}, Case{"mass", 30, 20, 67.2, 50, 0.28}}) {
    SCOPED_TRACE(one.name);
    const Robot changed = with(robot, one.name, one.value);
    const actuator::Region region(changed.drivetrains[0].actuators[0], {});
    const double per_ampere = one.ratio * 0.32;
    const double corner_rad_s = (one.volt - one.ohm * one.ampere) / per_ampere;
    const double stall_Nm = per_ampere * one.ampere;
    EXPECT_NEAR(region.at(0.0, 1.0).greatest.torque_Nm, stall_Nm, 1e-9 * stall_Nm);
    EXPECT_NEAR(region.at(0.999 * corner_rad_s).greatest.torque_Nm, stall_Nm, 1e-9 * stall_Nm);
    const double between_rad_s = 0.5 * (corner_rad_s + one.volt / per_ampere);
    EXPECT_NEAR(region.at(between_rad_s).greatest.torque_Nm, 0.5 * stall_Nm, 1e-9 * stall_Nm);
  }
}

TEST(Variables, AreNamedByDriveAndByDrivetrain) {
  const Robot robot = Documents().robot();
  EXPECT_EQ(variable_named(robot, "ankle_left_current", "").drives, std::vector<std::size_t>{1});
  EXPECT_EQ(variable_named(robot, "ankle_ratio", "").drives, (std::vector<std::size_t>{1, 2}));
  EXPECT_EQ(variable_named(robot, "knee_ratio", "").present, 20.0);
  EXPECT_EQ(variable_named(robot, "ratio_factor", "").drives.size(), 3u);
  for (const std::string& name : variable_names(robot)) {
    if (name == "ratio" || name == "resistance") continue;  // differ from drive to drive
    EXPECT_EQ(variable_named(robot, name, "").name, name);
  }
}

std::string refusal(const std::function<void()>& work) {
  try {
    work();
  } catch (const io::SpecError& error) {
    return error.what();
  }
  return "";
}

TEST(Variables, AreRefusedWithThoseThatThereAre) {
  const Robot robot = Documents().robot();
  const std::string unknown = refusal([&] { variable_named(robot, "hip_ratio", "--sweep"); });
  EXPECT_NE(unknown.find("--sweep: \"hip_ratio\""), std::string::npos) << unknown;
  EXPECT_NE(unknown.find("knee_ratio, ankle_left_ratio, ankle_right_ratio, ankle_ratio"),
            std::string::npos)
      << unknown;
  const std::string open = refusal([&] { variable_named(robot, "ratio", "--sweep"); });
  EXPECT_NE(open.find("knee: 20, ankle_left: 8, ankle_right: 8"), std::string::npos) << open;
  EXPECT_NE(open.find("ratio_factor"), std::string::npos) << open;
}

TEST(VariedRobot, IsRefusedWhereTheValueIsNone) {
  const Robot robot = Documents().robot();
  for (const double value : {0.0, -3.0, std::nan(""), HUGE_VAL}) {
    EXPECT_NE(refusal([&] { with(robot, "knee_ratio", value); }), "") << value;
  }
}

// Oracle: the ranges of specs/schema/actuator.json; mass has no document of its own. At 1e308 V the
// region of a motor was searched without end.
TEST(VariedRobot, IsRefusedWhereNoDocumentCouldHoldTheValue) {
  const Robot robot = Documents().robot();
  struct Range {
    const char* name;
    double least, most;
  };
  for (const auto& [name, least, most] : {Range{"voltage", 0.5, 5000},
                                          {"knee_current", 0.01, 5000},
                                          {"knee_resistance", 1e-5, 1000},
                                          {"mass", 1e-6, 1e6},
                                          {"knee_ratio", 1e-4, 1e4}}) {
    EXPECT_EQ(refusal([&] { with(robot, name, least); }), "") << name;
    EXPECT_EQ(refusal([&] { with(robot, name, most); }), "") << name;
    EXPECT_NE(refusal([&] { with(robot, name, 0.999 * least); }), "") << name;
    EXPECT_NE(refusal([&] { with(robot, name, 1.001 * most); }), "") << name;
    EXPECT_NE(refusal([&] { with(robot, name + std::string("_factor"), 1e300); }), "") << name;
  }
}

// What a robot states of a rotor that its actuator knows nothing of has no law by the ratio.
TEST(VariedRobot, IsRefusedWhereNothingSaysWhatTheRotorsBecome) {
  Robot robot = Documents().robot("mini_cheetah");
  for (Drivetrain& drivetrain : robot.drivetrains) {
    drivetrain.actuators.front().motor.rotor_inertia_kg_m2 = 0.0;
  }
  const std::string why = refusal([&] { with(robot, "fknee_ratio", 7); });
  EXPECT_NE(why.find("not known"), std::string::npos) << why;
}

// Two motors on two coupled joints that state what rotors weigh: of one alone nothing is known.
TEST(VariedRobot, IsRefusedForOneOfTwoDrivesWhoseRotorsAreStatedTogether) {
  Robot robot = Documents().robot();
  Drivetrain& ankle = robot.drivetrains[1];
  ankle.rotors_in_tree = true;
  for (const std::size_t joint : ankle.joints) {
    robot.tree.bodies[joint].joint.reflected_inertia = 0.02;
  }
  EXPECT_NE(refusal([&] { with(robot, "ankle_left_ratio", 9); }), "");
  const Robot both = with(robot, "ankle_ratio", 16);
  for (const std::size_t joint : ankle.joints) {
    EXPECT_NEAR(both.tree.bodies[joint].joint.reflected_inertia, 4 * 0.02, 1e-15);
  }
}

}  // namespace
}  // namespace torquewright::hopper
