// SPDX-License-Identifier: Apache-2.0
// The exported modules for simulators that are called, run with stand-ins of what they call
// (simulator_calls.py). Oracle: actuator/clip.hpp on the parallelogram of the motor, by hand;
// where a module takes friction off, the composed law of the actuator
// (actuator/region/torque_at.hpp and gear_losses.hpp); DC motors of Newton by the two lines that
// its own class states.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

#include "actuator/clip.hpp"
#include "actuator/exporters/every_exporter.hpp"
#include "actuator/exporters/exporter.hpp"
#include "actuator/exporters/simulator_file.hpp"
#include "actuator/region/gear_losses.hpp"
#include "actuator/region/torque_at.hpp"
#include "tests/actuator/exporters/command_output.hpp"
#include "tests/actuator/exporters/example_actuators.hpp"
#include "tests/io/scratch_folder.hpp"

namespace torquewright::actuator {
namespace {

using test::output_of;

using nlohmann::json;

constexpr double kPeak_Nm = 38.4;                              // dry_drive's, by hand
const Parallelogram kMotor{329.142857142857, 25.0, kPeak_Nm};  // before any friction
constexpr double kAgreement_Nm = 1e-6 * kPeak_Nm;              // as documentation promises
constexpr double kSingle_Nm = 5e-6 * kPeak_Nm;  // of single precision (region_file_test.cpp)
constexpr double kFarFromRest = 9.0;            // smoothing speeds: 1 - tanh is 3e-8 there

struct Samples {
  std::vector<double> torque_Nm{60.0, -60.0, 5.0, 20.0};
  std::vector<double> velocity_rad_s{0.0, 0.0, 0.0, -24.0};
};

/// Up to 1.1 of the no-load speed, both ways; that of the DC motor of other numbers is 10 rad/s.
const Samples& samples() {
  static const Samples drawn = [] {
    std::mt19937 dice(11);
    std::uniform_real_distribution<double> speed(-27.5, 27.5);
    std::uniform_real_distribution<double> torque(-1.5 * kPeak_Nm, 1.5 * kPeak_Nm);
    Samples all;
    for (int i = 0; i < 400; ++i) {
      all.torque_Nm.push_back(torque(dice));
      all.velocity_rad_s.push_back(speed(dice));
    }
    return all;
  }();
  return drawn;
}

std::string module_text(const Actuator& actuator, const Exporter& exporter,
                        FrictionPlace friction = FrictionPlace::kJoint) {
  const ExportedDrive drive(actuator, exporter, {.fit = LawFit::kBest, .friction = friction});
  return simulator_file(drive.subject(), exporter, {"origin"}).text;
}

/// The other drive of a robot, whose module is there beside the first's.
Actuator other_drive() {
  Actuator actuator = dry_drive();
  actuator.name = "other drive";
  actuator.drive.peak_current_A = 15.0;  // 28.8 Nm
  actuator.effects.clear();
  return actuator;
}

/// What simulator_calls.py says, once.
const json& answer() {
  static const json said = [] {
    const test::ScratchFolder folder;
    folder.write("pybullet.py", module_text(dry_drive(), exporters::pybullet));
    folder.write("isaac_gym.py", module_text(loaded_drive(), exporters::isaac_gym));
    folder.write("genesis.py", module_text(dry_drive(), exporters::genesis));
    folder.write("playground.py", module_text(dry_drive(), exporters::playground));
    folder.write("native.py", module_text(loaded_drive(), exporters::python));
    folder.write("other.py", module_text(other_drive(), exporters::python));
    folder.write("samples.json", json{{"torque_Nm", samples().torque_Nm},
                                      {"velocity_rad_s", samples().velocity_rad_s}}
                                     .dump());
    int status = 0;
    const std::string text =
        output_of(TORQUEWRIGHT_ARRAY_PYTHON " " TORQUEWRIGHT_SOURCE_DIR
                                            "/tests/actuator/exporters/simulator_calls.py " +
                      folder.path().string() + " 2>&1",
                  status);
    EXPECT_EQ(status, 0) << text;
    const json parsed = json::parse(text, nullptr, false);
    EXPECT_FALSE(parsed.is_discarded()) << text;
    return parsed;
  }();
  return said;
}

/// Clipped as the motor is, then through friction and gear.
double composed_Nm(const Actuator& actuator, double command_Nm, double speed_rad_s) {
  Instant at;
  at.speed_rad_s = speed_rad_s;
  at.direction = std::copysign(1.0, speed_rad_s);
  const double before_Nm = clip(kMotor, speed_rad_s, command_Nm) + drag_Nm(actuator, at);
  return after_mesh_Nm(actuator, before_Nm, at.direction);
}

class SimulatorCalls : public testing::Test {
 protected:
  void SetUp() override {
    int status = 0;
    output_of(TORQUEWRIGHT_ARRAY_PYTHON " -c 'import numpy' 2>&1", status);
    if (status != 0) GTEST_SKIP() << "python3-numpy is not installed";
  }

  /// At rest bounds do not jump: the motor's have no friction in them.
  static void expect_clipped(const json& torques_Nm) {
    ASSERT_EQ(torques_Nm.size(), samples().torque_Nm.size());
    for (std::size_t i = 0; i < torques_Nm.size(); ++i) {
      const double speed_rad_s = samples().velocity_rad_s[i];
      EXPECT_NEAR(torques_Nm[i].get<double>(), clip(kMotor, speed_rad_s, samples().torque_Nm[i]),
                  kAgreement_Nm)
          << speed_rad_s;
    }
  }

  static void expect_composed(const json& of, double tolerance_Nm) {
    const Actuator actuator = loaded_drive();
    const double far_rad_s = kFarFromRest * of.at("smoothing_rad_s").get<double>();
    std::size_t compared = 0;
    for (std::size_t i = 0; i < samples().torque_Nm.size(); ++i) {
      const double speed_rad_s = samples().velocity_rad_s[i];
      if (std::abs(speed_rad_s) < far_rad_s) continue;
      ++compared;
      EXPECT_NEAR(of.at("torque_Nm")[i].get<double>(),
                  composed_Nm(actuator, samples().torque_Nm[i], speed_rad_s), tolerance_Nm)
          << samples().torque_Nm[i] << " Nm at " << speed_rad_s << " rad/s";
    }
    EXPECT_GE(compared, 350U);
  }
};

TEST_F(SimulatorCalls, GivePybulletTheMotorsTorqueAndTheJointItsFriction) {
  const json& bullet = answer().at("pybullet");
  expect_clipped(bullet.at("torque_Nm"));
  EXPECT_EQ(bullet.at("motor"), json::parse("[7, 0, 0.0, 0.4]"));
  EXPECT_EQ(bullet.at("damping").size(), samples().torque_Nm.size());
  EXPECT_EQ(bullet.at("damping").at("3"), 0.02);
}

// By hand: armature 36 1e-4 kg m^2; what drags is in the efforts, and not in the fields.
TEST_F(SimulatorCalls, GiveIsaacGymWhatReachesTheJoint) {
  const json& gym = answer().at("isaac_gym");
  expect_composed(gym, kAgreement_Nm);
  const auto field = [&](const char* name, int dof) {
    return gym.at("properties").at(name)[static_cast<std::size_t>(dof)].get<double>();
  };
  EXPECT_EQ(field("driveMode", 1), 3.0);
  EXPECT_EQ(field("driveMode", 2), 0.0);
  EXPECT_NEAR(field("armature", 3), 36e-4, 1e-9);
  EXPECT_EQ(field("friction", 1), 0.0);
  EXPECT_EQ(field("friction", 0), 0.5);
  EXPECT_EQ(field("damping", 3), 0.0);
  EXPECT_GE(field("effort", 1), 38.8 / (0.85 * 0.96));  // it brakes with what the gear adds
  EXPECT_GE(field("velocity", 1), 2.0 * 25.0);
}

TEST_F(SimulatorCalls, GiveGenesisForceRangeArmatureAndFriction) {
  const json& calls = answer().at("genesis");
  expect_clipped(calls.at("force"));
  EXPECT_EQ(calls.at("frictionloss"), json::parse("[[0.4, 0.4], [6, 7]]"));
  EXPECT_EQ(calls.at("damping"), json::parse("[[0.02, 0.02], [6, 7]]"));
  ASSERT_EQ(calls.at("force_range")[1].size(), 2U);
  EXPECT_NEAR(calls.at("force_range")[1][0].get<double>(), kPeak_Nm, kAgreement_Nm);
  EXPECT_NEAR(calls.at("force_range")[0][1].get<double>(), -kPeak_Nm, kAgreement_Nm);
  EXPECT_NEAR(calls.at("armature")[0][1].get<double>(), 36e-4, 1e-12);
}

// By hand: two substeps at 23.5 and -24 rad/s, where the line falls, then at 24.5 and -23; the
// control between stays its own.
TEST_F(SimulatorCalls, ClipInEachSubstepOfPlayground) {
  const json& playground = answer().at("playground");
  expect_clipped(playground.at("torque_Nm"));
  ASSERT_EQ(playground.at("given").size(), 2U);
  for (std::size_t step = 0; step < 2; ++step) {
    const json& given = playground.at("given")[step];
    const auto later = static_cast<double>(step);
    EXPECT_NEAR(given[0].get<double>(), clip(kMotor, 23.5 + later, 100.0), kAgreement_Nm);
    EXPECT_EQ(given[1], 6.0);
    EXPECT_NEAR(given[2].get<double>(), clip(kMotor, -24.0 + later, -100.0), kAgreement_Nm);
  }
  EXPECT_NE(playground.at("mjcf").get<std::string>().find("<mujoco model=\"dry_drive\">"),
            std::string::npos);
}

TEST_F(SimulatorCalls, HaveNewtonReadIsaacLabsDcMotorAsTheRegion) {
  const json& native = answer().at("native");
  EXPECT_EQ(native.at("registered"), json::parse(R"([["NewtonDCMotorClampingAPI", "clamping"]])"));
  expect_composed(native, kSingle_Nm);
  // The class stays Isaac Lab's own, without which its native path refuses a configuration.
  EXPECT_EQ(native.at("class"), "DCMotor");
  const json& fields = native.at("fields");
  EXPECT_EQ(fields.at("stiffness"), 20.0);
  EXPECT_EQ(fields.at("viscous_friction"), 0.0);
  EXPECT_GE(fields.at("joint_effort_limit").get<double>(), 38.8 / (0.85 * 0.96));
  EXPECT_NE(native.at("refused").get<std::string>().find("cannot tell their regions apart"),
            std::string::npos);
}

TEST_F(SimulatorCalls, LeaveNewtonsOtherDcMotorsWhatTheyWere) {
  const json& native = answer().at("native");
  const Parallelogram other{329.142857142857, 25.0, 28.8};
  for (std::size_t i = 0; i < samples().torque_Nm.size(); ++i) {
    const double speed_rad_s = samples().velocity_rad_s[i];
    const double torque_Nm = samples().torque_Nm[i];
    EXPECT_NEAR(native.at("other_Nm")[i].get<double>(), clip(other, speed_rad_s, torque_Nm),
                kSingle_Nm);
    const double most_Nm = std::min(100.0 * (1.0 - speed_rad_s / 10.0), 50.0);
    const double least_Nm = std::max(100.0 * (-1.0 - speed_rad_s / 10.0), -50.0);
    EXPECT_NEAR(native.at("plain_Nm")[i].get<double>(),
                std::min(std::max(torque_Nm, least_Nm), most_Nm), 1e-6 * 400.0);
  }
}

// With friction off the limits nothing of it is anywhere else.
TEST(SimulatorText, HasNoFrictionBesideLimitsThatHaveIt) {
  for (const Exporter* exporter :
       {&exporters::pybullet, &exporters::genesis, &exporters::isaac_gym}) {
    const std::string text = module_text(dry_drive(), *exporter, FrictionPlace::kLimits);
    for (const char* piece : {"jointDamping=", "set_dofs_frictionloss", "add_friction"}) {
      EXPECT_EQ(text.find(piece), std::string::npos) << exporter->name << " " << piece;
    }
  }
  EXPECT_NE(module_text(dry_drive(), exporters::pybullet, FrictionPlace::kLimits)
                .find("targetVelocity=0.0, force=0"),
            std::string::npos);
}

}  // namespace
}  // namespace torquewright::actuator
