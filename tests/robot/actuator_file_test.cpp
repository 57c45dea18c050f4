// SPDX-License-Identifier: Apache-2.0
// Oracles: numbers by hand, J^-T of two rods, and the file that one drive has of its own.
#include "robot/simulators/actuator_file.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <filesystem>
#include <iterator>
#include <regex>
#include <sstream>

#include "actuator/effects/library.hpp"
#include "actuator/exporters/every_exporter.hpp"
#include "actuator/exporters/line_law.hpp"
#include "io/faults/spec_error.hpp"
#include "robot/model/robot_spec.hpp"

namespace torquewright::hopper {
namespace {

constexpr double kPrinted = 1e-6;  // of a number: shortest decimals of a conservative fit's search

Robot robot_in(const char* file) {
  return read_robot(std::filesystem::path(TORQUEWRIGHT_SOURCE_DIR) / "specs/robot" / file).robot;
}

/// The line of a drive's own, as `actuator mor` would write it.
actuator::Parallelogram line_of(const actuator::Actuator& stated) {
  const actuator::Region region(stated, {});
  const actuator::MorTable table = actuator::mor_table(region);
  const actuator::Subject subject{stated, {}, region, table};
  return actuator::parallelogram_of(actuator::exporters::isaac_lab.shape(subject));
}

/// The argument of the entry that stands under a name.
double argument(const std::string& text, const std::string& entry, const std::string& name) {
  const std::size_t begin = text.find("\n" + entry + " = ");
  EXPECT_NE(begin, std::string::npos) << entry;
  if (begin == std::string::npos) return 0.0;
  const std::string call = text.substr(begin, text.find("\n)\n", begin) - begin);
  std::smatch found;
  EXPECT_TRUE(std::regex_search(call, found, std::regex(name + "=([-0-9.e+]+),"))) << call;
  return found.empty() ? 0.0 : std::stod(found[1]);
}

bool has_note(const Exported& exported, const std::string& piece) {
  for (const std::string& note : exported.notes) {
    if (note.find(piece) != std::string::npos) return true;
  }
  return false;
}

// The ankle nearest to zero: J = [[5/6, 2/3], [5/6, -2/3]] (docs/robot_documents.md's hopper).
// Pitch alone asks 1/(2 5/6) = 0.6 of its torque of each rod, roll alone 1/(2 2/3) = 0.75; each
// actuator has 8 0.44 50 = 176 Nm and weighs 64 0.0002 = 0.0128 kg m^2.
TEST(ActuatorFile, HoldsWhatACoupledJointHasAlone) {
  const Robot robot = robot_in("hopper.json");
  const Exported exported = actuators_of(robot, actuator::exporters::isaac_lab, {"origin"});
  const auto actuator = line_of(robot.drivetrains[1].actuators[0]);
  EXPECT_NEAR(actuator.greatest_torque_Nm, 176.0, kPrinted * 176.0);
  const double ratios[2] = {5.0 / 6.0, 2.0 / 3.0};
  const char* names[2] = {"ankle_pitch", "ankle_roll"};
  for (int j = 0; j < 2; ++j) {
    const double both = 2.0 * ratios[j];
    const auto near = [&](const char* name, double expected) {
      EXPECT_NEAR(argument(exported.text, names[j], name), expected, kPrinted * expected)
          << names[j] << " " << name;
    };
    near("actuator_effort_limit", 176.0 * both);
    near("saturation_effort", actuator.stall_torque_Nm * both);
    near("actuator_velocity_limit", actuator.no_load_speed_rad_s / ratios[j]);
    near("armature", 2.0 * ratios[j] * ratios[j] * 0.0128);
  }
  EXPECT_TRUE(has_note(exported,
                       "ankle_pitch, ankle_roll are coupled (parallel_ankle, driven by "
                       "ankle_left, ankle_right)"));
  EXPECT_TRUE(has_note(exported, "would ask an actuator for 2 times its torque"));
  EXPECT_TRUE(has_note(exported, "ankle_pitch turns at a ratio that changes with posture"));
  // The knee's four-bar is a parallelogram: it turns as its drive does, in every posture.
  EXPECT_FALSE(has_note(exported, "knee turns at a ratio"));
  for (const std::string& note : exported.notes) {
    EXPECT_NE(exported.text.find("# " + note + "\n"), std::string::npos) << note;
  }
}

// By virtual work, by hand: pitch turns each rod's drive with 5/6, so that of 0.3 Nm and 0.06 Nm
// s/rad of each it feels 2 5/6 0.3 = 0.5 Nm and 2 (5/6)^2 0.06 = 0.0833 Nm s/rad; the knee has its
// own.
TEST(ActuatorFile, HasTheFrictionOfTheJoint) {
  Robot robot = robot_in("hopper.json");
  for (Drivetrain& drivetrain : robot.drivetrains) {
    for (actuator::Actuator& drive : drivetrain.actuators) {
      actuator::Effect dry = actuator::neutral(*actuator::find_effect("coulomb_friction"));
      actuator::Effect viscous = actuator::neutral(*actuator::find_effect("viscous_friction"));
      dry.values = {0.3};
      viscous.values = {0.06};
      drive.effects = {dry, viscous};
    }
  }
  const std::string text = actuators_of(robot, actuator::exporters::isaac_lab, {"origin"},
                                        actuator::FrictionPlace::kJoint)
                               .text;
  const auto near = [&](const char* joint, const char* field, double expected) {
    EXPECT_NEAR(argument(text, joint, field), expected, 1e-9) << joint << " " << field;
  };
  for (const char* field : {" friction", "dynamic_friction"}) {
    near("ankle_pitch", field, 2.0 * 5.0 / 6.0 * 0.3);
    near("ankle_roll", field, 2.0 * 2.0 / 3.0 * 0.3);
  }
  near("ankle_pitch", "viscous_friction", 2.0 * 25.0 / 36.0 * 0.06);
  near("ankle_roll", "viscous_friction", 2.0 * 4.0 / 9.0 * 0.06);
  // The limits are the motors': as without friction.
  near("ankle_pitch", "actuator_effort_limit", 2.0 * 5.0 / 6.0 * 176.0);
  const std::string limits = actuators_of(robot, actuator::exporters::isaac_lab, {"origin"}).text;
  EXPECT_EQ(argument(limits, "ankle_pitch", "dynamic_friction"), 0.0);
  EXPECT_LT(argument(limits, "ankle_pitch", "actuator_effort_limit"), 2.0 * 5.0 / 6.0 * 175.8);
}

// By hand: of Cassie's ten drives the left and the right are alike, and so are hip pitch and knee.
// What joints have themselves stands beside it, once.
TEST(ActuatorFile, HasTheJointsOwnFrictionToo) {
  Robot robot = robot_in("hopper.json");
  robot.tree.bodies[*robot.find_joint("ankle_roll")].joint.passive = {0.25, 0.5, 0.75, 0.0, 0.0};
  const auto at = [&](const char* field) {
    return argument(actuators_of(robot, actuator::exporters::isaac_lab, {"origin"},
                                 actuator::FrictionPlace::kJoint)
                        .text,
                    "ankle_roll", field);
  };
  EXPECT_NEAR(at("dynamic_friction"), 0.5, 1e-12);
  EXPECT_NEAR(at(" friction"), 0.75, 1e-12);
  EXPECT_NEAR(at("viscous_friction"), 0.25, 1e-12);
  EXPECT_TRUE(has_note(actuators_of(robot, actuator::exporters::isaac_lab, {"origin"}),
                       "(ankle_roll) are left to the robot's file"));
}

TEST(ActuatorFile, GathersDrivesThatAreAlike) {
  const Robot robot = robot_in("cassie.json");
  const Exported exported = actuators_of(robot, actuator::exporters::mjlab, {"origin"});
  const auto knee = line_of(robot.drivetrains[2].actuators[0]);
  const std::regex entry("= DcMotorActuatorCfg\\(");
  const auto entries =
      std::distance(std::sregex_iterator(exported.text.begin(), exported.text.end(), entry),
                    std::sregex_iterator());
  std::size_t joints = 0;
  for (const Drivetrain& drivetrain : robot.drivetrains) {
    for (const std::size_t body : drivetrain.joints) {
      const std::string name = "\"" + robot.tree.bodies[body].joint.name + "\"";
      EXPECT_EQ(exported.text.find(name), exported.text.rfind(name)) << name;
      EXPECT_NE(exported.text.find(name), std::string::npos) << name;
      ++joints;
    }
  }
  EXPECT_EQ(joints, 10U);
  EXPECT_LE(entries, 5);
  EXPECT_NE(
      exported.text.find("effort_limit=" + std::to_string(knee.greatest_torque_Nm).substr(0, 5)),
      std::string::npos);
}

// A drive's own file and the robot's say the same of a joint that it turns directly.
TEST(ActuatorFile, IsTheDrivesOwnWhereItTurnsAJointDirectly) {
  const Robot robot = robot_in("mini_cheetah.json");
  const Exported exported = actuators_of(robot, actuator::exporters::newton, {"origin"});
  for (const Drivetrain& drivetrain : robot.drivetrains) {
    const auto line = line_of(drivetrain.actuators[0]);
    for (const double value :
         {line.stall_torque_Nm, line.no_load_speed_rad_s, line.greatest_torque_Nm}) {
      std::ostringstream digits;
      digits.precision(8);
      digits << value;
      EXPECT_NE(exported.text.find(digits.str().substr(0, 6)), std::string::npos) << value;
    }
    EXPECT_NE(
        exported.text.find("\"" + robot.tree.bodies[drivetrain.joints[0]].joint.name + "\": add_"),
        std::string::npos);
  }
}

/// The rows of an entry's table of postures.
std::vector<std::vector<double>> lookup(const std::string& text, const std::string& entry) {
  const std::size_t begin = text.find("joint_parameter_lookup=", text.find("\n" + entry + " = "));
  const std::string table = text.substr(begin, text.find("\n    ]", begin) - begin);
  const std::regex row(R"(\[([-0-9.e]+), ([-0-9.e]+), ([-0-9.e]+)\])");
  std::vector<std::vector<double>> rows;
  for (std::sregex_iterator found(table.begin(), table.end(), row), end; found != end; ++found) {
    rows.push_back({std::stod((*found)[1]), std::stod((*found)[2]), std::stod((*found)[3])});
  }
  return rows;
}

// Oracle: virtual work at each row's own posture. Of that torque on the joint alone the rods'
// drives carry J^-T of it, the more loaded one just its own greatest.
TEST(ActuatorFile, HasTheTorqueOfEachAngleWhereALinkageChangesIt) {
  const Robot robot = robot_in("hopper.json");
  const actuator::Exporter& exporter = actuator::exporters::isaac_lab_remotized;
  const Exported exported = actuators_of(robot, exporter, {"origin"});
  const Drivetrain& ankle = robot.drivetrains[1];
  const actuator::ExportedDrive drive(ankle.actuators[0], exporter, {});
  const double own_Nm = exporter.shape(drive.subject())[0];
  for (int j = 0; j < 2; ++j) {
    const auto rows = lookup(exported.text, j == 0 ? "ankle_pitch" : "ankle_roll");
    ASSERT_EQ(rows.size(), 33U);
    const auto& limits = robot.tree.bodies[ankle.joints[static_cast<std::size_t>(j)]].joint.limits;
    EXPECT_EQ(rows.front()[0], limits.position_min);
    EXPECT_EQ(rows.back()[0], limits.position_max);
    for (const auto& row : rows) {
      SmallVector posture = SmallVector::Zero(2);
      posture[j] = row[0];
      const SmallMatrix J = ankle.mechanism->transfer(posture, SmallVector::Zero(2))->jacobian;
      SmallVector torque_Nm = SmallVector::Zero(2);
      torque_Nm[j] = row[2];
      const SmallVector carried_Nm = J.transpose().inverse() * torque_Nm;
      EXPECT_NEAR(carried_Nm.cwiseAbs().maxCoeff(), own_Nm, 1e-9 * own_Nm) << row[0];
      EXPECT_NEAR(row[1], J.col(j).cwiseAbs().maxCoeff(), 1e-12);
    }
  }
  // The knee's four-bar is a parallelogram: two rows, of its own torque.
  EXPECT_NE(exported.text.find("joint_parameter_lookup=[[-3.14"), std::string::npos);
}

TEST(ActuatorFile, RefusesARobotWithoutDrives) {
  EXPECT_THROW(actuators_of(robot_in("rabbit.json"), actuator::exporters::isaac_lab, {}),
               io::SpecError);
}

}  // namespace
}  // namespace torquewright::hopper
