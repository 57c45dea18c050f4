// SPDX-License-Identifier: Apache-2.0
// What effects do in a replay that no current evens out. One drive turns a flywheel without
// gravity, in both engines.
// Oracles: closed forms of single motions; conservation of energy and momentum; the law of
// simulation/joint at the current that the drive reports.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "actuator/drive_check/demand.hpp"
#include "hopper/engines/engine.hpp"
#include "hopper/replay/free_rotors.hpp"
#include "hopper/replay/left_out.hpp"
#include "hopper/replay/powered_drives.hpp"
#include "hopper/replay/step_limit.hpp"
#include "io/faults/spec_error.hpp"
#include "robot/model/whole_body.hpp"
#include "simulation/in_engine/joint_in_engine.hpp"
#include "tests/actuator/effect_of_some_size.hpp"
#include "tests/hopper/replay/driven_robot.hpp"

namespace torquewright::hopper {
namespace {

using actuator::Actuator;
using actuator::effect;
using Eigen::VectorXd;

constexpr double kDisc_kg_m2 = 0.3;
constexpr double kTurned_kg_m2 = 0.2;  // at the output, behind a ratio of 10
constexpr double kWheel_kg_m2 = kDisc_kg_m2 + kTurned_kg_m2;

/// A wheel on a fixed axis, turned by a drive of 200 Nm.
Robot flywheel(std::vector<actuator::Effect> effects) {
  Actuator actuator = actuator::round_actuator();
  actuator.motor.rotor_inertia_kg_m2 = kTurned_kg_m2 / 100.0;
  actuator.effects = std::move(effects);
  Robot robot = driven_robot({actuator});
  robot.drivetrains[0].rotors_in_tree = false;
  robot.name = "flywheel";
  robot.tree.gravity_m_s2 = 0.0;
  robot.tree.bodies.resize(2);
  robot.tree.bodies[0].name = "frame";
  robot.tree.bodies[0].inertia.mass_kg = 1.0;
  robot.tree.bodies[0].inertia.inertia_kg_m2 = Eigen::Matrix3d::Identity();
  robot.tree.bodies[1].name = "wheel";
  robot.tree.bodies[1].joint.name = "axle";
  robot.tree.bodies[1].inertia.mass_kg = 1.0;
  robot.tree.bodies[1].inertia.inertia_kg_m2 = kDisc_kg_m2 * Eigen::Matrix3d::Identity();
  return robot;
}

/// A flywheel that a replay's parts move.
class Turning {
 public:
  Turning(const Robot& robot, bool in_mujoco, double speed_rad_s, double step_s = 1e-4)
      : step_s_(step_s),
        moved_(without_free_rotors(robot)),
        engine_(in_mujoco ? mujoco_engine(moved_, {}) : own_engine(moved_, {})),
        drives_(robot, {}),
        body_(moved_) {
    // Nothing is strained before the wheel is set in motion.
    drives_.drive(alone(0.0), alone(0.0), alone(0.0), step_s);
    engine_->start(alone(0.0), alone(speed_rad_s));
  }

  void step(double wanted_Nm) {
    ASSERT_TRUE(body_.set(engine_->position(), engine_->velocity()));
    VectorXd position_rad(1), speed_rad_s(1), force = alone(0.0);
    body_.drive_positions(position_rad);
    body_.speed_changes(engine_->velocity(), speed_rad_s);
    acting_Nm_ = drives_.drive(alone(wanted_Nm), position_rad, speed_rad_s, step_s_).torque_Nm[0];
    body_.add_drive_torques(alone(acting_Nm_), force);
    ASSERT_EQ(engine_->step(force, step_s_), EngineOutcome::kStepped);
    time_s_ += step_s_;
  }

  double time_s() const { return time_s_; }
  double position_rad() const { return engine_->position()[0]; }
  double speed_rad_s() const { return engine_->velocity()[0]; }
  double acting_Nm() const { return acting_Nm_; }

 private:
  static VectorXd alone(double value) { return VectorXd::Constant(1, value); }

  double step_s_;
  Robot moved_;
  std::unique_ptr<Engine> engine_;
  PoweredDrives drives_;
  WholeBody body_;
  double time_s_ = 0.0;
  double acting_Nm_ = 0.0;
};

class FeltEffects : public testing::TestWithParam<bool> {
 protected:
  void SetUp() override {
    if (GetParam() && mujoco_absence()) GTEST_SKIP() << *mujoco_absence();
  }
  Turning turning(std::vector<actuator::Effect> effects, double speed_rad_s) const {
    return {flywheel(std::move(effects)), GetParam(), speed_rad_s};
  }
};

// I w' = T (1 - exp(-t/T_lag)): what moves comes later by the lag's time constant.
TEST_P(FeltEffects, ALagDelaysTheMotionByItsTimeConstant) {
  constexpr double kLag_s = 0.05;
  constexpr double kTorque_Nm = 10.0;
  Turning wheel = turning({effect("torque_lag", {kLag_s})}, 0.0);
  while (wheel.time_s() < 0.3) wheel.step(kTorque_Nm);
  const double since_s = wheel.time_s();
  const double late_s = since_s - wheel.speed_rad_s() * kWheel_kg_m2 / kTorque_Nm;
  // The lag's mean over a step is taken in its middle: off by h^2/24 of the curvature, 8.4e-9 s.
  EXPECT_NEAR(late_s, kLag_s * (1.0 - std::exp(-since_s / kLag_s)), 1e-8);
}

// The spring takes the wheel's energy and gives it back: a quarter of 2 pi sqrt(I/k) to rest, where
// all of I w^2/2 is in k x^2/2.
TEST_P(FeltEffects, ASpringTakesTheWheelsEnergyAndGivesItBack) {
  constexpr double kStiffness_Nm_rad = 200.0;
  Turning wheel = turning({effect("parallel_spring", {kStiffness_Nm_rad, 0.0})}, 3.0);
  const double quarter_s = 0.5 * std::numbers::pi * std::sqrt(kWheel_kg_m2 / kStiffness_Nm_rad);
  while (wheel.speed_rad_s() > 0.0) wheel.step(0.0);
  EXPECT_NEAR(wheel.time_s(), quarter_s, 1e-4);
  const double stored_J = 0.5 * kStiffness_Nm_rad * std::pow(wheel.position_rad(), 2);
  EXPECT_NEAR(stored_J, 0.5 * kWheel_kg_m2 * 9.0, 1e-5 * stored_J);
  while (wheel.position_rad() > 0.0) wheel.step(0.0);
  EXPECT_NEAR(wheel.speed_rad_s(), -3.0, 1e-4);
}

// Half a period of its oscillation against the stop, and it leaves as fast as it came.
TEST_P(FeltEffects, AStopThrowsTheWheelBack) {
  constexpr double kStiffness_Nm_rad = 5000.0;
  for (const char* stop : {"upper_end_stop", "lower_end_stop"}) {
    const double way = stop[0] == 'u' ? 1.0 : -1.0;
    Turning wheel = turning({effect(stop, {kStiffness_Nm_rad, way * 0.1})}, way * 2.0);
    while (way * wheel.speed_rad_s() > 0.0) wheel.step(0.0);
    const double half_period_s = std::numbers::pi * std::sqrt(kWheel_kg_m2 / kStiffness_Nm_rad);
    EXPECT_NEAR(wheel.time_s(), 0.1 / 2.0 + 0.5 * half_period_s, 1e-4);
    while (way * wheel.position_rad() > 0.1) wheel.step(0.0);
    EXPECT_NEAR(way * wheel.speed_rad_s(), -2.0, 1e-3) << stop;
  }
}

// Dahl's friction F = c (1 - exp(-k x/c)) on the way out takes the wheel's energy.
TEST_P(FeltEffects, PreslidingFrictionStopsTheWheelWithinItsTravel) {
  constexpr double kCoulomb_Nm = 5.0, kStiffness_Nm_rad = 2000.0, kSpeed_rad_s = 0.2;
  Turning wheel =
      turning({effect("presliding_friction", {kCoulomb_Nm, kStiffness_Nm_rad})}, kSpeed_rad_s);
  while (wheel.speed_rad_s() > 0.0) wheel.step(0.0);
  const double way_rad = wheel.position_rad();
  const double taken_J =
      kCoulomb_Nm * way_rad - kCoulomb_Nm * kCoulomb_Nm / kStiffness_Nm_rad *
                                  (1.0 - std::exp(-kStiffness_Nm_rad * way_rad / kCoulomb_Nm));
  EXPECT_NEAR(taken_J, 0.5 * kWheel_kg_m2 * kSpeed_rad_s * kSpeed_rad_s, 1e-3 * taken_J);
}

// Rotor and wheel swing against one another: the wheel is at T/(J + I) (t^2/2 - (1 - cos w t)/w^2).
TEST_P(FeltEffects, ACompliantTrainLetsTheRotorSwingAgainstTheWheel) {
  constexpr double kStiffness_Nm_rad = 100.0, kTorque_Nm = 5.0;
  Turning wheel = turning({effect("torsional_compliance", {kStiffness_Nm_rad, 0.0})}, 0.0);
  const double w_1_s = std::sqrt(kStiffness_Nm_rad * (1.0 / kTurned_kg_m2 + 1.0 / kDisc_kg_m2));
  while (wheel.time_s() < 0.5) {
    wheel.step(kTorque_Nm);
    const double t = wheel.time_s();
    const double exact_rad =
        kTorque_Nm / kWheel_kg_m2 * (0.5 * t * t - (1.0 - std::cos(w_1_s * t)) / (w_1_s * w_1_s));
    ASSERT_NEAR(wheel.position_rad(), exact_rad, 1e-6) << t;
  }
}

// The wheel waits until the rotor has crossed half the gap; both together then take the torque's
// whole impulse.
TEST_P(FeltEffects, InAGapTheWheelWaitsForTheRotor) {
  constexpr double kGap_rad = 0.2, kTorque_Nm = 10.0;
  Turning wheel = turning({effect("backlash", {kGap_rad})}, 0.0);
  double waited_s = 0.0;
  while (wheel.time_s() < 0.4) {
    wheel.step(kTorque_Nm);
    if (waited_s == 0.0 && wheel.speed_rad_s() > 0.0) waited_s = wheel.time_s() - 1e-4;
  }
  EXPECT_NEAR(waited_s, std::sqrt(kGap_rad * kTurned_kg_m2 / kTorque_Nm), 2e-4);
  // By then flanks have met for good: one body. Whatever they gave off, momentum is kept.
  EXPECT_NEAR(wheel.speed_rad_s(), kTorque_Nm * wheel.time_s() / kWheel_kg_m2, 1e-3);
}

INSTANTIATE_TEST_SUITE_P(InBothEngines, FeltEffects, testing::Bool(),
                         [](const auto& engine) { return engine.param ? "mujoco" : "own"; });

double way_of(double value) { return value < 0.0 ? -1.0 : 1.0; }

// The current that the drive reports, put into the law of simulation/joint, is the torque that it
// says acts: for every effect of the library, in a motion and under torques that reverse.
TEST(FeltEffectsOfTheLibrary, ActAsTheLawOfTheirJointDoesAtTheirCurrent) {
  for (const actuator::EffectKind* kind : actuator::effect_library()) {
    Actuator actuator = actuator::round_actuator();
    actuator.transmission.forward_efficiency = 0.9;
    actuator.transmission.backward_efficiency = 0.8;
    actuator.motor.rotor_inertia_kg_m2 = kTurned_kg_m2 / 100.0;
    actuator.effects = {actuator::effect_of_some_size(*kind)};
    Robot robot = flywheel({});
    robot.drivetrains[0].actuators[0] = actuator;
    PoweredDrives drives(robot, {});
    simulation::SimulationOptions options;
    options.motor_inertia_kg_m2 =
        is_rotor_free(robot, robot.drivetrains[0], 0) ? kTurned_kg_m2 : 0.0;
    simulation::JointInEngine joint(actuator, options);
    double position_rad = 0.3;
    for (int number = 0; number < 40; ++number) {
      constexpr double kPeriod_s = 1e-3;
      const double speed_rad_s = 2.0 * std::cos(0.37 * number) + 0.01;
      const double wanted_Nm = 60.0 * std::sin(0.23 * number + 0.4);
      const auto one = [](double value) { return VectorXd::Constant(1, value).eval(); };
      const DriveStep& step =
          drives.drive(one(wanted_Nm), one(position_rad), one(speed_rad_s), kPeriod_s);
      simulation::DriveNow drive;
      // Amplitudes have no sign: the motor's torque is that of what is asked of it, friction paid.
      const double motor_rad_s = joint.motor_speed_rad_s(speed_rad_s);
      const double rotor_Nm =
          actuator::rotor_torque_Nm(actuator, 298.15, motor_rad_s, wanted_Nm - step.cut_off_Nm[0]);
      drive.value = way_of(rotor_Nm) * step.current_A[0];
      const double by_law_Nm =
          joint.advance({position_rad, speed_rad_s, kPeriod_s}, drive, way_of(motor_rad_s), 298.15);
      EXPECT_NEAR(step.torque_Nm[0], by_law_Nm, 1e-9 * 200.0) << kind->name << " " << number;
      position_rad += kPeriod_s * speed_rad_s;
    }
  }
}

/// The one thing that is left out of a replay; an empty name: nothing.
std::string left_out_of(const Robot& robot) {
  const std::vector<EffectLeftOut> effects = effects_left_out(robot);
  EXPECT_LE(effects.size(), 1u);
  return effects.empty() ? "" : effects.front().effect;
}

TEST(LeftOutOfAReplay, IsWhatTheRobotsJointsDoNotLetAct) {
  Robot robot = flywheel({effect("backlash", {0.01})});
  EXPECT_EQ(left_out_of(robot), "");
  robot.drivetrains[0].actuators[0].motor.rotor_inertia_kg_m2 = 0.0;
  EXPECT_EQ(left_out_of(robot), "backlash");  // nothing moves in the gap
  robot = flywheel({effect("reflected_inertia", {0.1})});
  EXPECT_EQ(left_out_of(robot), "");
  robot.drivetrains[0].rotors_in_tree = robot.drivetrains[0].joints_state_rotors = true;
  EXPECT_EQ(left_out_of(robot), "reflected_inertia");
  robot.drivetrains[0].actuators[0].effects = {effect("reflected_inertia", {0.0})};
  EXPECT_EQ(left_out_of(robot), "");
}

TEST(LeftOutOfAReplay, IsTheHysteresisOfATrainWithoutASpring) {
  const actuator::Effect loop = effect("strain_wave_hysteresis", {2.0, 0.002});
  EXPECT_EQ(left_out_of(flywheel({loop})), "strain_wave_hysteresis");
  EXPECT_EQ(left_out_of(flywheel({loop, effect("backlash", {0.01})})), "strain_wave_hysteresis");
  EXPECT_EQ(left_out_of(flywheel({loop, effect("torsional_compliance", {900.0, 0.0})})), "");
}

TEST(LeftOutOfAReplay, LeavesARunOpenThatEnded) {
  for (const ReplayVerdict verdict : {ReplayVerdict::kStands, ReplayVerdict::kFell}) {
    ReplayResult result;
    result.outcome.verdict = verdict;
    leave_open({}, result);
    EXPECT_EQ(result.outcome.verdict, verdict);
    leave_open({{"knee", "backlash", "its rotor weighs nothing"}}, result);
    EXPECT_EQ(result.outcome.verdict, ReplayVerdict::kUndecided);
    ASSERT_EQ(result.findings.size(), 1u);
    EXPECT_EQ(result.findings[0].rule, "effect-left-out");
  }
}

// Oracle: the frequency of a wheel on a spring, sqrt(k/I); of a free rotor's wheel without it.
TEST(StepsOfAReplay, AreRefusedWhereAnEffectTurnsFaster) {
  constexpr double kStiffness_Nm_rad = 5000.0;
  const auto longest_s = [](double inertia) {
    return 0.25 / std::sqrt(kStiffness_Nm_rad / inertia);
  };
  const VectorXd rest = VectorXd::Zero(1);
  for (const char* name : {"upper_end_stop", "parallel_spring", "torsional_compliance"}) {
    const Robot robot = flywheel({effect(name, {kStiffness_Nm_rad, 0.0})});
    const bool is_free = name[0] == 't';
    const double limit_s = longest_s(is_free ? kDisc_kg_m2 : kWheel_kg_m2);
    EXPECT_NO_THROW(require_steps_follow_effects(robot, rest, 0.999 * limit_s)) << name;
    EXPECT_THROW(require_steps_follow_effects(robot, rest, 1.001 * limit_s), io::SpecError) << name;
  }
  EXPECT_NO_THROW(require_steps_follow_effects(flywheel({effect("torque_lag", {0.1})}), rest, 1.0));
}

}  // namespace
}  // namespace torquewright::hopper
