// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "identification/rig/joint_actuator_json.hpp"
#include "identification/robot/alike.hpp"
#include "identification/rollout/rollout.hpp"
#include "identification/simulated/rig_plant.hpp"
#include "io/documents/document.hpp"
#include "simulation/run/simulate.hpp"
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
    fit.values.push_back({which, 0.0, friction_Nm[joint], 0.01, false});
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

}  // namespace
}  // namespace torquewright::identification
