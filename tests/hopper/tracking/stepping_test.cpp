// SPDX-License-Identifier: Apache-2.0
// Oracle: the law's recurrence, worked out by hand for a robot that faces another way than the
// motion and goes at a speed of its own, whatever it is told.
#include "hopper/tracking/stepping/stepping.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "hopper/tracking/every_controller.hpp"
#include "io/faults/spec_error.hpp"
#include "tests/hopper/tracking/closed_loop.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double kPlanned_m_s = 0.4;
constexpr double kCommanded_m_s = 0.5;
constexpr double kGoes_m_s = 0.7;
constexpr double kFaces_rad = 0.3;
constexpr double kLook_s = 1e-3;

/// Remembers what it is shown, and asks for nothing.
class Regulator final : public Controller {
 public:
  explicit Regulator(VectorXd& shown) : shown_(&shown) {}
  std::string_view name() const override { return "remembers"; }
  void start() override {}
  void control(const Observation& seen, VectorXd& torque_Nm) override {
    *shown_ = seen.velocity;
    torque_Nm = none_Nm_;
  }
  const VectorXd& fed_forward_Nm() const override { return none_Nm_; }

 private:
  VectorXd* shown_;
  VectorXd none_Nm_ = VectorXd::Zero(3);
};

/// Hops of half a second, in the air for the last 0.2 s of each, at an even speed; then a stance.
Reference hops(const Robot& robot, int count) {
  Motion motion;
  ContactSchedule contacts;
  const Index samples = 50 * count + 30;
  motion.positions.setZero(10, samples);
  motion.velocities.setZero(9, samples);
  motion.accelerations.setZero(9, samples);
  contacts.touches.resize(4, samples);
  for (Index i = 0; i < samples; ++i) {
    motion.times_s.push_back(0.01 * static_cast<double>(i));
    motion.positions.col(i).head<4>() << kPlanned_m_s * motion.times_s.back(), 0.0, 1.0, 1.0;
    contacts.touches.col(i).setConstant(i % 50 < 30);
  }
  return Reference(robot, motion, contacts, Eigen::MatrixXd::Zero(3, samples));
}

Observation seen_at(double time_s) {
  Observation seen;
  seen.time_s = time_s;
  seen.position = VectorXd::Zero(10);
  const double way_m = kGoes_m_s * time_s;
  seen.position.head<3>() << way_m * std::cos(kFaces_rad), way_m * std::sin(kFaces_rad), 1.0;
  seen.position[3] = std::cos(0.5 * kFaces_rad);
  seen.position[6] = std::sin(0.5 * kFaces_rad);
  seen.velocity = VectorXd::Zero(9);
  seen.touches = TouchingPoints::Constant(4, std::fmod(time_s, 0.5) < 0.3);
  return seen;
}

TEST(Stepping, AsksEachHopForAShareOfTheSpeedThatTheLastOneLacked) {
  const Robot robot = test::robot_of("hopper.json");
  const Reference reference = hops(robot, 3);
  EXPECT_NEAR(hopping_speed_m_s(robot, reference), kPlanned_m_s, 1e-12);
  VectorXd shown, torque_Nm;
  const auto stepping =
      stepping_controller(robot, reference, {}, kCommanded_m_s, std::make_unique<Regulator>(shown));
  const double first = kSpeedShare * (kCommanded_m_s - kPlanned_m_s);
  const double second = first + kSpeedShare * (kCommanded_m_s - kGoes_m_s);
  for (int run = 0; run < 2; ++run) {  // of which the second knows nothing of the first
    stepping->start();
    for (int look = 0; look < 1700; ++look) {
      const double time_s = kLook_s * look;
      stepping->control(seen_at(time_s), torque_Nm);
      const double faster = look < 500 || look >= 1500 ? 0.0 : look < 1000 ? first : second;
      if (look % 500 < 2) continue;  // the look at which it lands, rounded
      EXPECT_NEAR(shown[0], -faster * std::cos(kFaces_rad), 1e-3 * kSpeedShare) << time_s;
      EXPECT_NEAR(shown[1], -faster * std::sin(kFaces_rad), 1e-3 * kSpeedShare) << time_s;
    }
  }
}

std::string refusal(const Reference& reference, const Robot& robot,
                    std::optional<double> forward_m_s) {
  TrackingOptions options;
  options.forward_m_s = forward_m_s;
  try {
    (void)controllers::stepping.prepare(robot, reference, options);
  } catch (const io::SpecError& error) {
    return error.what();
  }
  return "none";
}

TEST(Stepping, SaysWhichSpeedsAMotionsStepsReach) {
  const Robot robot = test::robot_of("hopper.json");
  const Reference two = hops(robot, 2);
  EXPECT_NE(refusal(two, robot, {}).find("--forward says which"), std::string::npos);
  const std::string far = refusal(two, robot, 1.5);
  EXPECT_NE(far.find("--forward"), std::string::npos) << far;
  EXPECT_NE(far.find("1.5 m/s is 1.1 m/s from the 0.4 m/s"), std::string::npos) << far;
  EXPECT_NE(refusal(hops(robot, 1), robot, 0.4).find("lands once"), std::string::npos);
}

}  // namespace
}  // namespace torquewright::hopper
