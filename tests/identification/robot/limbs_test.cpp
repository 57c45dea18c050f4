// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "identification/reading/robot_commands.hpp"
#include "identification/rig/joint_actuator_json.hpp"
#include "identification/robot/alike.hpp"
#include "identification/robot/base_motion.hpp"
#include "identification/robot/trade_offs.hpp"
#include "identification/rollout/rollout.hpp"
#include "identification/simulated/rig_plant.hpp"
#include "io/documents/document.hpp"
#include "simulation/run/simulate.hpp"
#include "tests/actuator/check/refusal.hpp"
#include "tests/identification/robot/legs.hpp"
#include "tests/io/scratch_folder.hpp"

namespace torquewright::identification {
namespace {

constexpr double kSamplesPer_s = 200.0;

Rig two_legs_rig() {
  const test::ScratchFolder folder;
  nlohmann::json rig = test::leg_rig_json();
  rig["columns"] = {
      {"time_s", "time_s"},
      {"{part}_command", {{"quantity", "commanded_position_rad"}, {"joint", "{part}_joint"}}},
      {"{part}_rad", {{"quantity", "output_position_rad"}, {"joint", "{part}_joint"}}}};
  rig["load"]["file"] = "legs.json";
  rig["alike"] = {{"*_calf_joint"}, {"left_hip_joint", "right_hip_joint"}};
  folder.write("legs.json",
               test::two_legs_json({{0.01, 0.2, 0.1}, {0.01, 0.2, 0.1}, {0.02, 0.2, 0.1}}).dump());
  return read_rig(io::read_document(folder.write("rig.json", rig.dump()), "rig"));
}

RobotModel model_of_rig(const Rig& rig) {
  std::vector<actuator::ReadActuator> read;
  std::vector<const actuator::Actuator*> drives;
  for (std::size_t i = 0; i < rig.joints.size(); ++i) read.push_back(actuator_of_joint(rig, i));
  for (const auto& each : read) drives.push_back(&each.actuator);
  return robot_model(rig, drives);
}

/// Two seconds of commands and of positions that follow them some way behind.
Run moving_run(std::size_t joints) {
  Run run;
  run.name = "a";
  for (int i = 0; i < 400; ++i) run.time_s.push_back(i / kSamplesPer_s);
  run.masked.assign(run.time_s.size(), 0);
  for (std::size_t joint = 0; joint < joints; ++joint) {
    Channels& channels = run.joints.emplace_back();
    for (const double time_s : run.time_s) {
      const double phase = 3.0 * time_s + static_cast<double>(joint);
      channels[Quantity::kCommandedPosition].push_back(0.4 * std::sin(phase));
      channels[Quantity::kOutputPosition].push_back(0.38 * std::sin(phase - 0.1));
    }
  }
  return run;
}

// Oracle: the document; joints come side by side from the base on.
TEST(Limbs, AreTheLegsOfARobotThatIsHeld) {
  const Rig rig = two_legs_rig();
  const std::vector<Limb> limbs = limbs_of(rig.load);
  ASSERT_EQ(limbs.size(), 2u);
  EXPECT_EQ(limbs[0].joints, (std::vector<std::size_t>{0, 2, 4}));
  EXPECT_EQ(limbs[1].joints, (std::vector<std::size_t>{1, 3, 5}));
  EXPECT_EQ(limbs[1].load.robot->tree.bodies.size(), 4u);
}

// Oracle: the whole robot in one simulation. The base is held, so the legs know nothing of each
// other; the stepper's parts of a step, which a stop of any joint begins anew, differ, and with
// them the error of the second order of a step of 1 ms.
TEST(Limbs, MoveAsTheyDoInTheWholeRobot) {
  const Rig rig = two_legs_rig();
  const RobotModel model = model_of_rig(rig);
  const identification::Run run = moving_run(rig.joints.size());
  const Window window{0, 1, 398};
  Limb whole{{0, 1, 2, 3, 4, 5}, rig.load};
  const auto together = limb_errors_rad(model, whole, run, window, 1e-3);
  ASSERT_EQ(together.size(), 6u);
  for (const Limb& limb : limbs_of(rig.load)) {
    const auto alone = limb_errors_rad(model, limb, run, window, 1e-3);
    ASSERT_EQ(alone.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < alone[i].size(); ++k) {
        ASSERT_NEAR(alone[i][k], together[limb.joints[i]][k], 1e-4) << i << " " << k;
      }
    }
  }
}

// A loop that pushes away from its command, by any number that there is: an outcome, no exception
// and nothing that is no number.
TEST(Limbs, OfAnUnstableLoopHaveNoErrors) {
  const Rig rig = two_legs_rig();
  RobotModel model = model_of_rig(rig);
  const identification::Run run = moving_run(rig.joints.size());
  for (JointController& each : model.controllers) {
    each.law.stiffness_Nm_rad = -1e4;
    each.law.torque_limit_Nm = std::numeric_limits<double>::infinity();
  }
  for (actuator::Actuator& each : model.drives) {
    each.drive.peak_current_A = each.drive.bus_voltage_V = std::numeric_limits<double>::max();
  }
  Log log;
  log.runs.push_back(run);
  for (const Limb& limb : limbs_of(rig.load)) {
    EXPECT_TRUE(limb_errors_rad(model, limb, run, {0, 1, 398}, 2e-3).empty());
  }
  const Rollout rollout = roll_out(log, model, {1.0, 0.0, 10, false});
  EXPECT_GT(rollout.train.diverged, 0u);
  EXPECT_EQ(rollout.train.diverged, rollout.train.windows);
  EXPECT_TRUE(fit_values(log, model, free_values(model)).values.empty());
}

TEST(Limbs, WindowsGoAroundWhatIsMasked) {
  Log log;
  identification::Run run = moving_run(1);
  run.masked[200] = 1;
  log.runs.push_back(run);
  const std::vector<Window> whole = windows_of(log, 100.0);
  ASSERT_EQ(whole.size(), 2u);
  EXPECT_EQ(whole[0].first, 1u);
  EXPECT_EQ(whole[0].last, 199u);
  EXPECT_EQ(whole[1].first, 201u);
  EXPECT_EQ(whole[1].last, 398u);
  // Half seconds of 100 samples; a rest that is shorter is left out.
  EXPECT_EQ(windows_of(log, 0.5).size(), 2u);
}

TEST(AlikeJoints, AreNamedInTheRigByPattern) {
  const Rig rig = two_legs_rig();
  EXPECT_EQ(rig.alike, (std::vector<std::vector<std::size_t>>{{4, 5}, {0, 1}}));
}

/// A fit that has found these values of dry friction at four joints, each to 0.01 Nm.
ValueFit fit_of_friction(const std::vector<double>& friction_Nm) {
  ValueFit fit;
  fit.covariance = 1e-4 * Eigen::MatrixXd::Identity(4, 4);
  fit.information = fit.covariance.inverse();
  for (std::size_t joint = 0; joint < friction_Nm.size(); ++joint) {
    fit.model.drives.emplace_back();
    fit.model.offset_rad.push_back(0.0);
  }
  add_plain_friction(fit.model);
  for (std::size_t joint = 0; joint < friction_Nm.size(); ++joint) {
    FreeValue which;
    which.of = FreeValue::Of::kEffect;
    which.joint = joint;
    which.effect = "coulomb_friction";
    which.name = "coulomb_Nm";
    which.size = 0.1;
    set_value(fit.model, which, friction_Nm[joint]);
    fit.values.push_back({which, 0.0, friction_Nm[joint], 0.01, false, false});
  }
  return fit;
}

std::vector<UnlikeJoint> unlike_in(const std::vector<double>& friction_Nm) {
  Log log;
  log.runs.push_back(moving_run(4));
  const auto found = compare_alike(log, fit_of_friction(friction_Nm), {{0, 1, 2, 3}});
  EXPECT_EQ(found.size(), 1u);  // it is the same everywhere
  return found.empty() ? std::vector<UnlikeJoint>() : found.front().unlike;
}

// Oracle: arithmetic. The sisters of the last have a mean of 1.0 to 0.01/sqrt(3); it is 0.9 beyond
// the greatest of them, they differ by 0.2.
TEST(AlikeJoints, OneIsUnlikeItsSisters) {
  const std::vector<UnlikeJoint> unlike = unlike_in({1.0, 1.1, 0.9, 2.0});
  ASSERT_EQ(unlike.size(), 1u);
  EXPECT_EQ(unlike[0].own.joint, 3u);
  EXPECT_NEAR(unlike[0].own.value, 2.0, 1e-12);
  EXPECT_NEAR(unlike[0].own.standard_error, 0.01, 1e-6);
  EXPECT_NEAR(unlike[0].sigmas, 1.0 / (0.01 * std::sqrt(4.0 / 3.0)), 1e-3);
}

// The same distance from the mean, where they differ by as much among themselves: just inside.
TEST(AlikeJoints, NoneIsUnlikeWhereAllDiffer) {
  EXPECT_TRUE(unlike_in({1.0, 1.5, 0.5, 2.49}).empty());
  EXPECT_EQ(unlike_in({1.0, 1.5, 0.5, 2.51}).size(), 1u);
}

// Beyond its sisters, but by less than the errors of the fit.
TEST(AlikeJoints, NoneIsUnlikeWithinItsError) {
  EXPECT_TRUE(unlike_in({1.0, 1.001, 0.999, 1.05}).empty());
  EXPECT_EQ(unlike_in({1.0, 1.001, 0.999, 1.07}).size(), 1u);
}

/// The log of one joint that moves and one that does not, commands of the first `times` as large.
Log log_of_commands(const Rig& rig, double times) {
  Log log;
  identification::Run run = moving_run(rig.joints.size());
  for (double& each : run.joints[1][Quantity::kOutputPosition]) each = 0.2 + 1e-3 * each;
  for (double& each : run.joints[0][Quantity::kCommandedPosition]) each *= times;
  log.runs.push_back(std::move(run));
  return log;
}

TEST(RobotMotion, OfAJointThatNeverMovesIsSaid) {
  const Rig rig = two_legs_rig();
  Log log = log_of_commands(rig, 1.0);
  EXPECT_EQ(moving_joints(rig, log), (std::vector<bool>{true, false, true, true, true, true}));
  check_robot_motion(rig, log);
  ASSERT_EQ(log.findings.size(), 1u);
  EXPECT_EQ(log.findings[0].sentence,
            "right_hip_joint never moves: what does not move is not judged");
}

// Just inside and just outside of 1.4 times a degree's radians, about the loop's own 0.95.
TEST(RobotMotion, CommandsInDegreesAreRefused) {
  const Rig rig = two_legs_rig();
  const auto refusal_at = [&](double times) {
    Log log = log_of_commands(rig, times);
    return test::refusal([&] { check_robot_motion(rig, log); });
  };
  EXPECT_NE(refusal_at(180.0 / 3.141592653589793)
                .find("commanded_position_rad of left_hip_joint changes 60 times as much as its "
                      "position: they are degrees; say \"unit\": \"deg\""),
            std::string::npos)
      << refusal_at(180.0 / 3.141592653589793);
  EXPECT_EQ(refusal_at(38.0), "");
  EXPECT_NE(refusal_at(40.0), "");
  EXPECT_NE(refusal_at(75.0), "");
  EXPECT_EQ(refusal_at(79.0), "");
}

/// Half a minute of two legs whose joints' commands are what their drives need to move so, where
/// the base sways by this much and drives have another rotor than the model's. The right leg feels
/// the left one's sway times `common`, and beside it another of its own times `own`.
Log swaying_log(const Rig& rig, const RobotModel& model, double sway_rad, double rotor_error,
                double common = 1.0, double own = 0.0) {
  const std::size_t joints = rig.joints.size();
  identification::Run run;
  for (int i = 0; i < 6000; ++i) run.time_s.push_back(i / kSamplesPer_s);
  run.masked.assign(run.time_s.size(), 0);
  run.joints.resize(joints);
  const auto count = static_cast<Eigen::Index>(joints);
  for (const double time_s : run.time_s) {
    Eigen::VectorXd position(count), speed(count), acceleration(count), bias(count);
    for (Eigen::Index i = 0; i < count; ++i) {
      const double rate = 2.0 + 0.37 * static_cast<double>(i);
      const double phase = rate * time_s + static_cast<double>(i);
      position[i] = 0.5 * std::sin(phase);
      speed[i] = 0.5 * rate * std::cos(phase);
      acceleration[i] = -0.5 * rate * rate * std::sin(phase);
    }
    Load load = model.load;
    load.pitch_rad += sway_rad * std::sin(7.3 * time_s);
    load.roll_rad += sway_rad * std::sin(4.1 * time_s);
    const auto plant = plant_of(load);
    Eigen::MatrixXd mass(count, count);
    plant->mass_matrix(position, mass);
    plant->bias(position, speed, bias);
    Load load_of_right = model.load;
    load_of_right.pitch_rad +=
        sway_rad * (common * std::sin(7.3 * time_s) + own * std::sin(5.3 * time_s));
    load_of_right.roll_rad +=
        sway_rad * (common * std::sin(4.1 * time_s) + own * std::sin(3.1 * time_s));
    Eigen::VectorXd bias_of_right(count);
    plant_of(load_of_right)->bias(position, speed, bias_of_right);
    for (const Eigen::Index right : {1, 3, 5}) bias[right] = bias_of_right[right];
    const Eigen::VectorXd torque = bias + mass * acceleration;
    for (Eigen::Index i = 0; i < count; ++i) {
      const auto joint = static_cast<std::size_t>(i);
      const double rotor = model.drives[joint].motor.rotor_inertia_kg_m2 + rotor_error;
      const double friction = 0.2 * speed[i] + std::copysign(0.1, speed[i]);
      const double drive = torque[i] + rotor * acceleration[i] + friction + 0.5 * speed[i];
      run.joints[joint][Quantity::kOutputPosition].push_back(position[i]);
      run.joints[joint][Quantity::kCommandedPosition].push_back(position[i] + drive / 20.0);
    }
  }
  Log log;
  log.runs.push_back(std::move(run));
  return log;
}

// Oracle: the sway that was put in; torques of the law's other side, written out above. What a
// wrong rotor leaves at all joints is no sway.
TEST(BaseMotion, IsSeenInBothLegs) {
  const Rig rig = two_legs_rig();
  const RobotModel model = model_of_rig(rig);
  const BaseMotion sways = base_motion(swaying_log(rig, model, 0.06, 0.0), model);
  EXPECT_TRUE(sways.moves()) << sways.correlation << " " << sways.share;
  // Root mean square of two sinusoids, less what the ridge and the parabola keep.
  EXPECT_NEAR(sways.tilt_rad, 0.06, 0.02);
  const BaseMotion held = base_motion(swaying_log(rig, model, 0.0, 0.01), model);
  EXPECT_FALSE(held.moves()) << held.correlation << " " << held.share << " " << held.tilt_rad;
  EXPECT_FALSE(base_motion(swaying_log(rig, model, 0.0, 0.0), model).moves());
  // What pulls at one leg alone is no base.
  const BaseMotion pulled = base_motion(swaying_log(rig, model, 0.2, 0.0, 0.0), model);
  EXPECT_GT(pulled.share, 0.3);
  EXPECT_FALSE(pulled.moves()) << pulled.correlation << " " << pulled.share;
  // Nor is what pulls at each by itself, with a fourth of it in common.
  const BaseMotion apart = base_motion(swaying_log(rig, model, 0.1, 0.0, 0.25, 0.97), model);
  EXPECT_NEAR(apart.correlation, 0.25, 0.15);
  EXPECT_GT(apart.share, 0.3);
  EXPECT_GT(apart.tilt_rad, 0.02);
  EXPECT_FALSE(apart.moves());
}

/// A gain of 20 that the log tells to `gain_error`, and a rotor that is 0.002 of it to one in a
/// hundred: their errors go together.
ValueFit fit_of_gain(double gain_error) {
  ValueFit fit;
  FreeValue gain, rotor;
  gain.of = FreeValue::Of::kStiffness;
  gain.name = "controller_stiffness_Nm_rad";
  rotor.name = "rotor_inertia_kg_m2";
  rotor.size = 0.01;
  const double own = 0.04 * 0.01, shared = 0.002 * gain_error;
  fit.covariance.resize(2, 2);
  fit.covariance << gain_error * gain_error, 0.002 * gain_error * gain_error,
      0.002 * gain_error * gain_error, shared * shared + own * own;
  fit.values = {{gain, 20.0, 20.0, gain_error, false, false},
                {rotor, 0.04, 0.04, std::hypot(shared, own), false, false}};
  return fit;
}

// Oracle: arithmetic of errors that go together. The quotient keeps the part that is the rotor's
// own, 0.0004/20.
TEST(TradeOffs, OfAGainThatIsNotToldAreNamedWithTheirRatio) {
  ValueFit fit = fit_of_gain(8.0);
  const std::vector<TradeOff> found = find_trade_offs(fit);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_TRUE(found[0].is_scale);
  ASSERT_EQ(found[0].values.size(), 2u);
  EXPECT_NEAR(found[0].values[1].ratio, 0.002, 1e-12);
  EXPECT_NEAR(found[0].values[1].ratio_error, 0.0004 / 20.0, 1e-9);
  EXPECT_FALSE(fit.values[0].is_told());
  EXPECT_FALSE(fit.values[1].is_told());
  const std::string said = sentence_of(found[0], {"wrist"});
  EXPECT_NE(said.find("wrist: controller_stiffness_Nm_rad (20 ± 8) and rotor_inertia_kg_m2 scale "
                      "together"),
            std::string::npos)
      << said;
}

// Just inside and just outside of a tenth of the gain.
TEST(TradeOffs, AGainThatIsToldHasNone) {
  ValueFit told = fit_of_gain(1.99);
  EXPECT_TRUE(find_trade_offs(told).empty());
  EXPECT_TRUE(told.values[1].is_told());
  ValueFit open = fit_of_gain(2.01);
  EXPECT_EQ(find_trade_offs(open).size(), 1u);
}

// Oracle: the groups, counted by hand.
TEST(FreeValues, OfAlikeJointsAreOne) {
  const Rig rig = two_legs_rig();
  const RobotModel model = model_of_rig(rig);
  std::vector<FreeValue> values = free_values(model);
  EXPECT_EQ(values.size(), 24u);  // rotor, viscous, Coulomb, encoder of six joints
  tie({{4, 5}}, values);
  EXPECT_EQ(values.size(), 21u);  // encoders stay their own
  const auto rotor = std::find_if(values.begin(), values.end(), [](const FreeValue& each) {
    return each.of == FreeValue::Of::kRotor && each.joint == 4;
  });
  ASSERT_NE(rotor, values.end());
  RobotModel changed = model;
  set_value(changed, *rotor, 0.07);
  EXPECT_EQ(changed.drives[4].motor.rotor_inertia_kg_m2, 0.07);
  EXPECT_EQ(changed.drives[5].motor.rotor_inertia_kg_m2, 0.07);
  EXPECT_EQ(changed.drives[3].motor.rotor_inertia_kg_m2, 0.01);
  EXPECT_TRUE(rotor->is_of(5));
  EXPECT_FALSE(rotor->is_of(3));
}

}  // namespace
}  // namespace torquewright::identification
