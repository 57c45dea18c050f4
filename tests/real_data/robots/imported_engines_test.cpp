// SPDX-License-Identifier: Apache-2.0
// Public robots in both engines of the replay. Oracle: MuJoCo beside our own time stepping.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>

#include "dynamics/point.hpp"
#include "dynamics/position_step.hpp"
#include "hopper/engines/engine.hpp"
#include "robot/mjcf/mjcf_reader.hpp"
#include "robot/model/touching_point.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::Vector3d;
using Eigen::VectorXd;

std::filesystem::path unitree_file(const std::string& name) {
  const char* variable = std::getenv("TORQUEWRIGHT_DATA");
  const std::filesystem::path data =
      variable != nullptr ? std::filesystem::path(variable)
                          : std::filesystem::path(TORQUEWRIGHT_SOURCE_DIR) / "../shared/data";
  return data / "robots/unitree_mujoco/unitree_robots" / name;
}

class ImportedEngines : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(unitree_file(GetParam()))) {
      GTEST_SKIP() << "needs the public robots, ../shared/data";
    }
    robot_ = read_mjcf(unitree_file(GetParam())).robot;
    position_ = dynamics::zero_position(robot_.tree);
    velocity_ = VectorXd::Zero(robot_.tree.velocity_size());
    joints_ = velocity_.size() - 6;
    for (Index joint = 0; joint < joints_; ++joint) {
      const auto body = static_cast<std::size_t>(joint) + 1;
      const dynamics::JointLimits& limits = robot_.tree.bodies[body].joint.limits;
      position_[7 + joint] = 0.5 * (limits.position_min + limits.position_max);
      velocity_[6 + joint] = joint % 2 == 0 ? 0.5 : -0.3;
    }
    velocity_.head<6>() << 0.3, -0.2, 0.1, 0.4, -0.5, 0.2;
  }

  double lowest_m() const {
    dynamics::TreeState state(robot_.tree);
    state.set(position_, velocity_);
    double lowest = std::numeric_limits<double>::infinity();
    for (const ContactPoint& contact : robot_.contacts) {
      const dynamics::BodyPoint point = touching_point(contact, state);
      lowest = std::min(lowest, dynamics::point_position_m(state, point).z());
    }
    return lowest;
  }

  Robot robot_;
  VectorXd position_, velocity_;
  Index joints_ = 0;
};

// Without what joints have themselves, which makes impulses of every step:
// TwoEngines.FlyAlikeWithPassiveJoints.
TEST_P(ImportedEngines, FlyAlike) {
  constexpr double kApart_rad = 1e-6;
  for (dynamics::Body& body : robot_.tree.bodies) body.joint.passive = {};
  const auto own = own_engine(robot_, {});
  const auto mujoco = mujoco_engine(robot_, {});
  position_[2] = 10.0;
  const VectorXd rest = VectorXd::Zero(velocity_.size());
  for (Engine* engine : {own.get(), mujoco.get()}) {
    engine->start(position_, velocity_);
    for (int i = 0; i < 200; ++i) ASSERT_EQ(engine->step(rest, 1e-3), EngineOutcome::kStepped);
    EXPECT_GT((engine->position() - position_).norm(), 0.1);
  }
  VectorXd apart(velocity_.size());
  dynamics::position_difference(robot_.tree, own->position(), mujoco->position(), apart);
  EXPECT_LT(apart.cwiseAbs().maxCoeff(), kApart_rad);
}

// From 5 cm high onto its feet, joints held by springs: what the ground gave after 0.2 s.
TEST_P(ImportedEngines, TakeTheSameImpulse) {
  constexpr double kShare = 0.05, kHigh_m = 0.05, kStep_s = 5e-4;
  position_[2] += kHigh_m - lowest_m();
  Vector3d impulses_N_s[2] = {Vector3d::Zero(), Vector3d::Zero()};
  for (int which = 0; which < 2; ++which) {
    const auto engine = which == 0 ? own_engine(robot_, {}) : mujoco_engine(robot_, {});
    engine->start(position_, velocity_);
    VectorXd force = VectorXd::Zero(velocity_.size());
    for (int i = 0; i < 400; ++i) {
      force.tail(joints_) = 200.0 * (position_.tail(joints_) - engine->position().tail(joints_)) -
                            5.0 * engine->velocity().tail(joints_);
      ASSERT_EQ(engine->step(force, kStep_s), EngineOutcome::kStepped);
      impulses_N_s[which] += engine->generalised_impulse().head<3>();
    }
  }
  EXPECT_GT(impulses_N_s[0].z(), 1.0);
  EXPECT_LT((impulses_N_s[0] - impulses_N_s[1]).norm(), kShare * impulses_N_s[0].norm());
}

INSTANTIATE_TEST_SUITE_P(Unitree, ImportedEngines,
                         testing::Values("go2/go2.xml", "g1/g1_29dof.xml"));

}  // namespace
}  // namespace torquewright::hopper
