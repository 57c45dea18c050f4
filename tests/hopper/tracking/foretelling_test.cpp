// SPDX-License-Identifier: Apache-2.0
// Oracle: the same regulator without latency. Where the model is right, feedback that is foretold
// does from the latency's end on what feedback at once does from then on.
#include <gtest/gtest.h>

#include <deque>

#include "hopper/tracking/error_space.hpp"
#include "hopper/tracking/lqr.hpp"
#include "tests/hopper/tracking/closed_loop.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::VectorXd;

constexpr int kLatePeriods = 200;  ///< 0.1 s
constexpr double kLookPeriod_s = 5e-4;

/// Lets the motion's own torques act for a latency, and then what another controller asks for: at
/// once, or as long after it was asked.
class HeldBack final : public Controller {
 public:
  enum class How { kPromptAfterwards, kLateUntold, kLateForetold };
  HeldBack(Controller& inner, How how) : inner_(inner), how_(how) {}

  std::string_view name() const override { return "held back"; }
  void start() override { inner_.start(); }
  const VectorXd& fed_forward_Nm() const override { return inner_.fed_forward_Nm(); }

  void control(const Observation& seen, VectorXd& torque_Nm) override {
    Observation told = seen;
    if (how_ == How::kLateForetold) told.latency_s = kLatePeriods * kLookPeriod_s;
    inner_.control(told, torque_Nm);
    asked_Nm_.push_back(torque_Nm);
    if (asked_Nm_.size() <= kLatePeriods) {
      torque_Nm = inner_.fed_forward_Nm();
    } else if (how_ != How::kPromptAfterwards) {
      torque_Nm = asked_Nm_[asked_Nm_.size() - 1 - kLatePeriods];
    }
  }

 private:
  Controller& inner_;
  How how_;
  std::deque<VectorXd> asked_Nm_;
};

/// The error over time of a hopper that stands and was pushed a little, after every control
/// period; empty where the engine stops.
std::vector<VectorXd> errors_of(HeldBack::How how) {
  const Robot robot = test::robot_of("hopper.json");
  const Reference reference = test::standing(robot, test::crouch(robot), 0.1);
  LqrOptions options;
  options.foretells = true;
  const LqrResult found = lqr_gains(robot, reference, options);
  const auto regulator = lqr_controller(robot, reference, found.gains, {}, {});
  HeldBack held_back(*regulator, how);
  test::ClosedLoop loop(robot, held_back);
  ReferenceInstant wanted;
  reference.at(0.0, wanted);
  VectorXd velocity = VectorXd::Zero(robot.tree.velocity_size());
  velocity[0] = 0.02;
  loop.start(wanted.position, velocity, 0.0);
  std::vector<VectorXd> errors;
  const bool goes_on = loop.run_until(0.8, [&] {
    errors.push_back(aligned_error(robot.tree, wanted, loop.position(), loop.velocity()).error);
  });
  return goes_on ? errors : std::vector<VectorXd>();
}

double farthest_apart(const std::vector<VectorXd>& a, const std::vector<VectorXd>& b) {
  double farthest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) farthest = std::max(farthest, (a[i] - b[i]).norm());
  return farthest;
}

TEST(Foretelling, LateFeedbackDoesWhatPromptFeedbackDoesFromThenOn) {
  const auto prompt = errors_of(HeldBack::How::kPromptAfterwards);
  const auto foretold = errors_of(HeldBack::How::kLateForetold);
  const auto untold = errors_of(HeldBack::How::kLateUntold);
  ASSERT_FALSE(prompt.empty());
  ASSERT_EQ(foretold.size(), prompt.size());
  ASSERT_EQ(untold.size(), prompt.size());
  double most = 0.0;
  for (const VectorXd& error : prompt) most = std::max(most, error.norm());
  EXPECT_LT(farthest_apart(foretold, prompt), 0.01 * most);
  EXPECT_GT(farthest_apart(untold, prompt), most);
}

}  // namespace
}  // namespace torquewright::hopper
