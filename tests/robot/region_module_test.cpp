// SPDX-License-Identifier: Apache-2.0
// Modules that hold a whole robot to its drives' regions, run with stand-ins of what they call
// (region_module_stand_ins.py). Oracle: each drive's own parallelogram by hand
// (actuator/clip.hpp) at its output, joints by virtual work with the mechanism's own transfer, and
// the composed law of the drives (actuator/region/torque_at.hpp) where the module takes friction
// off.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <random>

#include "actuator/clip.hpp"
#include "actuator/region/gear_losses.hpp"
#include "actuator/region/torque_at.hpp"
#include "robot/model/mechanism_reach.hpp"
#include "robot/simulators/region_module_file.hpp"
#include "tests/actuator/exporters/command_output.hpp"
#include "tests/io/scratch_folder.hpp"
#include "tests/robot/mjcf_friction_robot.hpp"

namespace torquewright::hopper {
namespace {

using actuator::FrictionPlace;
using nlohmann::json;

constexpr double kCoulomb_Nm = 0.3;  // of each drive, at its own output
constexpr double kViscous_Nm_s_rad = 0.06;
constexpr double kOwn_Nm = 0.5;  // of the knee itself
constexpr double kOwn_Nm_s_rad = 0.25;
constexpr double kSpring_Nm_rad = 30.0;
constexpr double kRest_rad = -0.1;
constexpr double kAgreement = 1e-6;  // of the peak torque, as documentation promises
constexpr std::size_t kSamples = 60;

/// The hopper: a knee by a four-bar of ratio 1, two drives that share an ankle, each on a stiff
/// bus, so that its region is the motor's parallelogram.
const Robot& robot() {
  static const Robot made = [] {
    Robot hopper = test::hopper_with_friction(kCoulomb_Nm, kViscous_Nm_s_rad);
    hopper.tree.bodies[*hopper.find_joint("knee")].joint.passive = {kOwn_Nm_s_rad, kOwn_Nm, kOwn_Nm,
                                                                    kSpring_Nm_rad, kRest_rad};
    for (Drivetrain& drivetrain : hopper.drivetrains) {
      for (actuator::Actuator& drive : drivetrain.actuators) drive.battery.reset();
    }
    return hopper;
  }();
  return made;
}

std::vector<std::string> joints() {
  std::vector<std::string> names;
  for (std::size_t i = 1; i < robot().tree.bodies.size(); ++i) {
    names.push_back(robot().tree.bodies[i].joint.name);
  }
  return names;
}

std::size_t place(const std::string& joint) {
  const std::vector<std::string> names = joints();
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), joint) - names.begin());
}

using Rows = std::vector<std::vector<double>>;

/// Torques far past the limits and speeds up to past the last, both ways.
struct Samples {
  Rows torque_Nm, velocity_rad_s, position_rad;
};

const Samples& samples() {
  static const Samples drawn = [] {
    std::mt19937 dice(42);
    const auto rows = [&](double most) {
      std::uniform_real_distribution<double> value(-most, most);
      Rows all(kSamples, std::vector<double>(joints().size()));
      for (auto& row : all) {
        for (double& number : row) number = value(dice);
      }
      return all;
    };
    return Samples{rows(500.0), rows(13.0), rows(1.0)};
  }();
  return drawn;
}

Exported module_of(const char* format, FrictionPlace friction = FrictionPlace::kJoint) {
  return region_module_of(robot(), *find_region_module(format), {"origin"}, friction);
}

bool has_numpy() {
  int status = 0;
  test::output_of(TORQUEWRIGHT_ARRAY_PYTHON " -c 'import numpy' 2>&1", status);
  return status == 0;
}

/// What the stand-ins were given, once.
const json& answer() {
  static const json said = [] {
    const test::ScratchFolder folder;
    folder.write("genesis.py", module_of("genesis").text);
    folder.write("pybullet.py", module_of("pybullet").text);
    folder.write("isaac_gym.py", module_of("isaac-gym").text);
    folder.write("samples.json", json{{"joints", joints()},
                                      {"torque_Nm", samples().torque_Nm},
                                      {"velocity_rad_s", samples().velocity_rad_s},
                                      {"position_rad", samples().position_rad}}
                                     .dump());
    int status = 0;
    const std::string text =
        test::output_of(TORQUEWRIGHT_ARRAY_PYTHON " " TORQUEWRIGHT_SOURCE_DIR
                                                  "/tests/robot/region_module_stand_ins.py " +
                            folder.path().string() + " 2>&1",
                        status);
    EXPECT_EQ(status, 0) << text;
    const json parsed = json::parse(text, nullptr, false);
    EXPECT_FALSE(parsed.is_discarded()) << text;
    return parsed;
  }();
  return said;
}

/// The motor's own line, before any friction, by hand from its document.
actuator::Parallelogram line_of(const actuator::Actuator& drive) {
  const double torque_Nm_A = drive.transmission.ratio * drive.motor.torque_constant_Nm_A;
  const double ratio = drive.transmission.ratio;
  return {torque_Nm_A * drive.drive.bus_voltage_V / drive.motor.resistance_ohm,
          drive.drive.bus_voltage_V / (ratio * drive.motor.back_emf_constant_V_s_rad.value_or(
                                                   drive.motor.torque_constant_Nm_A)),
          torque_Nm_A * drive.drive.peak_current_A};
}

/// What a drive brings to its output of a torque there that its motor is asked for, friction taken
/// off.
double composed_Nm(const actuator::Actuator& drive, double command_Nm, double speed_rad_s) {
  actuator::Instant at;
  at.speed_rad_s = speed_rad_s;
  at.direction = std::copysign(1.0, speed_rad_s);
  const double motor_Nm = actuator::clip(line_of(drive), speed_rad_s, command_Nm);
  return actuator::after_mesh_Nm(drive, motor_Nm + actuator::drag_Nm(drive, at), at.direction);
}

SmallMatrix home_jacobian(const Drivetrain& drivetrain) {
  const SmallVector home = home_posture_rad(robot().tree, drivetrain.joints);
  return drivetrain.mechanism->transfer(home, SmallVector::Zero(home.size()))->jacobian;
}

/// J^T of what each drive has, of the J^-T that it is asked for. `composed`: friction off. The
/// least speed of its drives comes out.
SmallVector expected_Nm(const Drivetrain& drivetrain, std::size_t sample, bool composed,
                        double& slowest_rad_s) {
  const auto of = [&](const Rows& rows) {
    SmallVector vector(static_cast<Eigen::Index>(drivetrain.joints.size()));
    for (Eigen::Index j = 0; j < vector.size(); ++j) {
      vector[j] = rows[sample][drivetrain.joints[static_cast<std::size_t>(j)] - 1];
    }
    return vector;
  };
  const SmallMatrix J = home_jacobian(drivetrain);
  const SmallVector turning_rad_s = J * of(samples().velocity_rad_s);
  const SmallVector asked_Nm = J.transpose().lu().solve(of(samples().torque_Nm));
  SmallVector output_Nm(asked_Nm.size());
  for (Eigen::Index k = 0; k < output_Nm.size(); ++k) {
    const actuator::Actuator& drive = drivetrain.actuators[static_cast<std::size_t>(k)];
    output_Nm[k] = composed ? composed_Nm(drive, asked_Nm[k], turning_rad_s[k])
                            : actuator::clip(line_of(drive), turning_rad_s[k], asked_Nm[k]);
  }
  slowest_rad_s = turning_rad_s.cwiseAbs().minCoeff();
  return J.transpose() * output_Nm;
}

class RegionModules : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_numpy()) GTEST_SKIP() << "python3-numpy is not installed";
  }
};

TEST_F(RegionModules, GiveGenesisEachDrivesRegionWhereDrivesShareJoints) {
  const json& genesis = answer().at("genesis");
  const std::vector<std::string> order = genesis.at("forced");
  EXPECT_EQ(order, genesis.at("driven").get<std::vector<std::string>>());
  for (const Drivetrain& drivetrain : robot().drivetrains) {
    for (std::size_t i = 0; i < kSamples; ++i) {
      double slowest_rad_s = 0.0;
      const SmallVector expected = expected_Nm(drivetrain, i, false, slowest_rad_s);
      for (Eigen::Index j = 0; j < expected.size(); ++j) {
        const std::string& name =
            robot().tree.bodies[drivetrain.joints[static_cast<std::size_t>(j)]].joint.name;
        const auto column =
            static_cast<std::size_t>(std::find(order.begin(), order.end(), name) - order.begin());
        EXPECT_NEAR(genesis.at("force")[i][column].get<double>(), expected[j], kAgreement * 320.0)
            << name << " " << i;
      }
    }
  }
}

// By hand: of the knee the drive's share is 1; of the ankle virtual work through the rods.
TEST_F(RegionModules, WriteFrictionOnceAndOverruleTheFile) {
  const json& written = answer().at("genesis").at("written");
  const json& knee = written.at("knee");
  EXPECT_NEAR(knee.at("frictionloss").get<double>(), kCoulomb_Nm + kOwn_Nm, 1e-12);
  EXPECT_NEAR(knee.at("damping").get<double>(), kViscous_Nm_s_rad + kOwn_Nm_s_rad, 1e-12);
  const SmallMatrix J = home_jacobian(robot().drivetrains[1]);
  const json& pitch = written.at("ankle_pitch");
  EXPECT_NEAR(pitch.at("frictionloss").get<double>(), kCoulomb_Nm * J.col(0).cwiseAbs().sum(),
              1e-12);
  EXPECT_NEAR(pitch.at("damping").get<double>(), kViscous_Nm_s_rad * J.col(0).squaredNorm(), 1e-12);
  const json& bullet = answer().at("pybullet");
  EXPECT_EQ(bullet.at("motors").at("knee"), knee.at("frictionloss"));
  EXPECT_EQ(bullet.at("dynamics").at("knee").at("jointDamping"), knee.at("damping"));
  EXPECT_EQ(bullet.at("dynamics").at("base").at("linearDamping"), 0.0);
  EXPECT_EQ(bullet.at("flags"), 2);
  const json& gym = answer().at("isaac_gym").at("properties").at("knee");
  EXPECT_NEAR(gym.at("damping").get<double>(), kOwn_Nm_s_rad, 1e-7);
  EXPECT_EQ(gym.at("friction"), 0.0);
  EXPECT_EQ(gym.at("stiffness"), 0.0);
  EXPECT_EQ(gym.at("driveMode"), 3);
  EXPECT_EQ(gym.at("velocity"), 1e4);
  EXPECT_GT(gym.at("effort").get<double>(), 320.0);
}

// By hand: kp = I w^2 and kv = 2 z I w, w = 2 pi 10 Hz, z = 2; the knee's rotor 0.3688 kg m^2.
TEST_F(RegionModules, WriteArmatureForceRangeAndGains) {
  const json& genesis = answer().at("genesis");
  const json& knee = genesis.at("written").at("knee");
  const double inertia_kg_m2 = knee.at("armature");
  EXPECT_NEAR(inertia_kg_m2, 0.3688, 1e-9);
  const double w_rad_s = 2.0 * std::numbers::pi * 10.0;
  EXPECT_NEAR(knee.at("kp").get<double>() / (inertia_kg_m2 * w_rad_s * w_rad_s), 1.0, 1e-12);
  EXPECT_NEAR(knee.at("kv").get<double>() / (4.0 * inertia_kg_m2 * w_rad_s), 1.0, 1e-12);
  EXPECT_NEAR(knee.at("greatest").get<double>(), 320.0, 1e-4);
  EXPECT_EQ(knee.at("least").get<double>(), -knee.at("greatest").get<double>());
  const json& morphs = genesis.at("morphs");
  EXPECT_EQ(morphs[0].at("kind"), "MJCF");
  EXPECT_EQ(morphs[1].at("kind"), "URDF");
  EXPECT_TRUE(morphs[0].at("default_armature").is_null());
  EXPECT_NEAR(answer().at("isaac_gym").at("properties").at("knee").at("armature").get<double>(),
              inertia_kg_m2, 1e-6);
  const std::vector<std::string> driven = genesis.at("driven");
  for (std::size_t j = 0; j < driven.size(); ++j) {
    const json& joint = genesis.at("written").at(driven[j]);
    const double velocity_rad_s = samples().velocity_rad_s[3][place(driven[j])];
    EXPECT_NEAR(genesis.at("servo")[3][j].get<double>(),
                joint.at("kp").get<double>() * 0.01 - joint.at("kv").get<double>() * velocity_rad_s,
                1e-9);
  }
}

TEST_F(RegionModules, GivePybulletTheSpringsBesideTheDrives) {
  const json& torques = answer().at("pybullet").at("torques");
  const std::size_t knee = place("knee");
  for (std::size_t i = 0; i < kSamples; ++i) {
    double slowest_rad_s = 0.0;
    const double drive_Nm = expected_Nm(robot().drivetrains[0], i, false, slowest_rad_s)[0];
    const double spring_Nm = -kSpring_Nm_rad * (samples().position_rad[i][knee] - kRest_rad);
    EXPECT_NEAR(torques[i].at("knee").get<double>(), drive_Nm + spring_Nm, kAgreement * 320.0);
  }
}

// From nine times the smoothing on, tanh is 1 to 3e-8.
TEST_F(RegionModules, GiveIsaacGymWhatReachesTheJoints) {
  const json& gym = answer().at("isaac_gym");
  const double far_rad_s = 9.0 * gym.at("smoothing_rad_s").get<double>();
  std::size_t compared = 0;
  for (const Drivetrain& drivetrain : robot().drivetrains) {
    for (std::size_t i = 0; i < kSamples; ++i) {
      double slowest_rad_s = 0.0;
      SmallVector expected = expected_Nm(drivetrain, i, true, slowest_rad_s);
      const bool is_knee = drivetrain.joints.size() == 1;
      const std::size_t knee = place("knee");
      if (is_knee) {
        expected[0] -= std::copysign(kOwn_Nm, samples().velocity_rad_s[i][knee]) +
                       kSpring_Nm_rad * (samples().position_rad[i][knee] - kRest_rad);
      }
      if (slowest_rad_s < far_rad_s) continue;
      ++compared;
      for (Eigen::Index j = 0; j < expected.size(); ++j) {
        const std::size_t joint = drivetrain.joints[static_cast<std::size_t>(j)] - 1;
        EXPECT_NEAR(gym.at("efforts")[i][joint].get<double>(), expected[j], kAgreement * 320.0)
            << joint << " " << i;
      }
    }
  }
  EXPECT_GE(compared, kSamples);
}

TEST(RegionModuleText, SaysWhatIsHeldAndWhatNot) {
  const auto says = [](const Exported& exported, const std::string& piece) {
    return exported.text.find(piece) != std::string::npos;
  };
  const Exported genesis = module_of("genesis");
  EXPECT_TRUE(says(genesis, "ratios that change with posture"));
  EXPECT_TRUE(says(genesis, "springs of joints (knee) are left to the robot's file"));
  EXPECT_TRUE(says(module_of("pybullet"), "springs of joints (knee) act here"));
  EXPECT_TRUE(says(module_of("pybullet"), "no armature"));
  const Exported limits = module_of("pybullet", FrictionPlace::kLimits);
  EXPECT_TRUE(says(limits, "\"dry_Nm\": 0.5,"));  // the knee's own
}

TEST(RegionModuleText, RefusesARobotWithoutDrives) {
  Robot bare = robot();
  bare.drivetrains.clear();
  EXPECT_THROW(region_module_of(bare, *find_region_module("genesis"), {}, FrictionPlace::kJoint),
               io::SpecError);
}

}  // namespace
}  // namespace torquewright::hopper
