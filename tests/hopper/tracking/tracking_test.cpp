// SPDX-License-Identifier: Apache-2.0
// Oracles: the engine, which knows no controller and no linearisation (does it stand, does it land
// where the plan does), symmetry, and robots that nothing can hold.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <limits>

#include "dynamics/point.hpp"
#include "dynamics/position_step.hpp"
#include "hopper/tracking/drive_loops.hpp"
#include "hopper/tracking/error_space.hpp"
#include "hopper/tracking/gain_schedule.hpp"
#include "hopper/tracking/lqr.hpp"
#include "hopper/tracking/pd.hpp"
#include "hopper/tracking/tipping_torque.hpp"
#include "tests/hopper/tracking/closed_loop.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr ImpactOptions kPlain{ImpactHandling::kDefault};

class Standing : public testing::Test {
 protected:
  std::unique_ptr<Controller> regulator(const LqrOptions& options = {}) {
    const LqrResult found = lqr_gains(robot, reference, options);
    EXPECT_EQ(found.outcome, GainOutcome::kFound) << sentence_of(found);
    return lqr_controller(robot, reference, found.gains, {}, kPlain);
  }
  double error(const test::ClosedLoop& loop) const {
    return aligned_error(robot.tree, wanted, loop.position(), loop.velocity()).error.norm();
  }

  Robot robot = test::robot_of("hopper.json");
  Reference reference = test::standing(robot, test::crouch(robot), 0.1);
  ReferenceInstant wanted;

  void SetUp() override { reference.at(0.0, wanted); }
};

TEST_F(Standing, StandsStill) {
  const auto lqr = regulator();
  test::ClosedLoop loop(robot, *lqr);
  loop.start(wanted.position, wanted.velocity, 0.0);
  double worst = 0.0;
  ASSERT_TRUE(loop.run_until(2.0, [&] { worst = std::max(worst, error(loop)); }));
  EXPECT_LT(worst, 1e-4);
  EXPECT_TRUE(loop.touches().any());
}

// Thrown off by 0.1 m/s of the base ahead, back or sideways, its foot following the ground at once.
TEST_F(Standing, RecoversFromAPush) {
  const auto lqr = regulator();
  for (const Index direction : {0, 1}) {
    for (const double side : {1.0, -1.0}) {
      test::ClosedLoop loop(robot, *lqr);
      VectorXd velocity = VectorXd::Zero(9);
      velocity[direction] = 0.1 * side;
      loop.start(wanted.position, velocity, 0.0);
      double worst = 0.0;
      ASSERT_TRUE(loop.run_until(3.0, [&] { worst = std::max(worst, error(loop)); }));
      EXPECT_GT(worst, 0.05) << direction << side;
      EXPECT_LT(error(loop), 0.02 * worst) << direction << side;
    }
  }
}

// Set down on the edge of its foot, from which the ground is to hold the foot flat.
TEST_F(Standing, LaysDownAFootThatIsOnItsEdge) {
  LqrOptions slack;
  slack.lifted_rad = 1e6;
  VectorXd position = wanted.position;
  position[9] += 0.3;
  position = test::on_ground(robot, position);
  for (const bool lies_down : {true, false}) {
    const auto lqr = regulator(lies_down ? LqrOptions() : slack);
    test::ClosedLoop loop(robot, *lqr);
    loop.start(position, VectorXd::Zero(9), 0.0);
    (void)loop.run_until(1.0);
    EXPECT_EQ(error(loop) < 0.01, lies_down) << error(loop);
  }
}

// Gains of a foot that is off the ground know nothing of what the ground leaves free, and are the
// drives' own loops, at an error of so much, of what it takes out.
TEST_F(Standing, GainsOfALiftedFootAreTheDrivesOwnOfWhatTheGroundTakesOut) {
  LqrOptions options;
  options.lifted_rad = 0.7;
  const LqrResult found = lqr_gains(robot, reference, options);
  ASSERT_TRUE(found.gains);
  const MatrixXd& gain = found.gains->at(0, 0.05).of_lifted;
  PdOptions own;
  own.full_torque_error_rad = 0.7;
  const PdGains loops = pd_gains(robot, reference, own);
  WholeBody body(robot);
  const auto space =
      error_space(body, wanted.position, wanted.velocity, TouchingPoints::Constant(4, true));
  ASSERT_TRUE(space);
  EXPECT_LT((gain * space->from_free).norm(), 1e-9 * gain.norm());
  ASSERT_TRUE(body.set(wanted.position, wanted.velocity));
  const VectorXd some = VectorXd::LinSpaced(18, -1.0, 1.3);
  const VectorXd taken = some - space->from_free * space->to_free * some;
  VectorXd drives_rad(3), drives_rad_s(3);
  body.speed_changes(taken.head(9), drives_rad);
  body.speed_changes(taken.tail(9), drives_rad_s);
  const VectorXd expected_Nm = loops.stiffness_Nm_rad.cwiseProduct(drives_rad) +
                               loops.damping_Nm_s_rad.cwiseProduct(drives_rad_s);
  EXPECT_LT((gain * some - expected_Nm).norm(), 1e-9 * expected_Nm.norm());
}

// Without feedback it falls: what holds it above is the gains.
TEST_F(Standing, FallsWithoutGains) {
  PdOptions none;
  none.stiffness_Nm_rad = none.damping_Nm_s_rad = VectorXd::Zero(3);
  const auto open = pd_controller(robot, reference, none, {}, kPlain);
  test::ClosedLoop loop(robot, *open);
  VectorXd velocity = VectorXd::Zero(9);
  velocity[0] = 0.1;
  loop.start(wanted.position, velocity, 0.0);
  (void)loop.run_until(1.0);
  EXPECT_GT(error(loop), 0.5);
}

TEST_F(Standing, GainsDoNotCareWhereItStandsAndWhereItLooks) {
  const auto lqr = regulator();
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(2.5, Eigen::Vector3d::UnitZ()));
  VectorXd way(9), position(10), velocity = VectorXd::LinSpaced(9, -0.1, 0.2);
  way << 0.01, -0.02, 0.01, 0.02, -0.01, 0.0, 0.03, -0.02, 0.01;
  dynamics::step_position(robot.tree, wanted.position, way, 1.0, position);
  const TouchingPoints all = TouchingPoints::Constant(4, true);
  VectorXd here_Nm, there_Nm;
  lqr->start();
  lqr->control({0.0, 0.0, 0.0, position, velocity, all}, here_Nm);
  const Eigen::Quaterniond base =
      turn * Eigen::Quaterniond(position[3], position[4], position[5], position[6]);
  position.segment<4>(3) << base.w(), base.x(), base.y(), base.z();
  position.head<2>() += Eigen::Vector2d(5.0, -7.0);
  velocity.head<3>() = (turn * Eigen::Vector3d(velocity.head<3>())).eval();
  lqr->start();
  lqr->control({0.0, 0.0, 0.0, position, velocity, all}, there_Nm);
  EXPECT_GT((here_Nm - wanted.drive_Nm).norm(), 1.0);
  EXPECT_LT((there_Nm - here_Nm).norm(), 1e-9 * here_Nm.norm());
}

// The hopper is its own mirror image but for the heights of its ankle's motors, which the rods take
// up: in its plane and across it are two loops.
TEST_F(Standing, RollHasALoopOfItsOwn) {
  const LqrResult found = lqr_gains(robot, reference, {});
  ASSERT_EQ(found.outcome, GainOutcome::kFound);
  const MatrixXd& gain = found.gains->at(0, 0.05).of_error;
  // Of y, roll, yaw, ankle roll and their rates.
  for (const Index across : {1, 3, 5, 8}) {
    for (const Index column : {across, across + 9}) {
      EXPECT_NEAR(gain(0, column), 0.0, 1e-3 * gain.row(0).norm()) << column;
      EXPECT_NEAR(gain(1, column), -gain(2, column), 1e-2 * gain.row(1).norm()) << column;
    }
  }
  EXPECT_GT(std::abs(gain(1, 3)), 1.0);
}

// A bit of scale: twice as dear torque, and twice as dear errors, are the same question.
TEST_F(Standing, OnlyRatiosOfWeightsCount) {
  LqrOptions twice;
  for (double* one :
       {&twice.place_m, &twice.tilt_rad, &twice.joint_rad, &twice.speed_m_s, &twice.turn_rate_rad_s,
        &twice.joint_rate_rad_s, &twice.torque_share, &twice.tipping_share}) {
    *one *= 2.0;
  }
  const LqrResult first = lqr_gains(robot, reference, {});
  const LqrResult second = lqr_gains(robot, reference, twice);
  ASSERT_TRUE(first.gains && second.gains);
  const MatrixXd& gain = first.gains->at(0, 0.0).of_error;
  EXPECT_LT((second.gains->at(0, 0.0).of_error - gain).norm(), 1e-6 * gain.norm());
}

TEST_F(Standing, RefusesWeightsThatAreNone) {
  LqrOptions bad;
  bad.tilt_rad = 0.0;
  EXPECT_THROW((void)lqr_gains(robot, reference, bad), std::invalid_argument);
  bad = {};
  bad.control_period_s = -1e-3;
  EXPECT_THROW((void)lqr_gains(robot, reference, bad), std::invalid_argument);
  bad = {};
  bad.torque_Nm = VectorXd::Ones(2);
  EXPECT_THROW((void)lqr_gains(robot, reference, bad), std::invalid_argument);
  EXPECT_THROW((void)lqr_controller(robot, reference, nullptr, {}, {}), std::invalid_argument);
}

/// One row that is held for a time, with torques at its begin and end.
Reference held(const Robot& robot, const VectorXd& position, bool touches, double duration_s,
               const MatrixXd& drives_Nm) {
  Motion motion;
  motion.times_s = {0.0, duration_s};
  motion.positions = position.replicate(1, 2);
  motion.velocities = motion.accelerations = MatrixXd::Zero(robot.tree.velocity_size(), 2);
  ContactSchedule contacts;
  contacts.touches = Touching::Constant(static_cast<Index>(robot.contacts.size()), 2, touches);
  return {robot, motion, contacts, drives_Nm};
}

Reference held(const Robot& robot, const VectorXd& position, bool touches, double duration_s) {
  Index drives = 0;
  for (const Drivetrain& one : robot.drivetrains) {
    drives += static_cast<Index>(one.actuators.size());
  }
  return held(robot, position, touches, duration_s, MatrixXd::Zero(drives, 2));
}

// One period in which the drives begin with half of what stands: the foot bears less then, and what
// tips it counts. Oracle: the same torques stated by hand; the cost behind knows no torque.
TEST_F(Standing, TorqueCountsByWhatTipsTheFootThenAndAtTheEnd) {
  LqrOptions options;
  options.end = LqrEnd::kWeights;
  options.weighs = true;
  const TouchingPoints all = TouchingPoints::Constant(4, true);
  const VectorXd rest = VectorXd::Zero(9), half_Nm = 0.5 * wanted.drive_Nm;
  MatrixXd drives_Nm(3, 2);
  drives_Nm << half_Nm, wanted.drive_Nm;
  const Reference slack = held(robot, wanted.position, true, options.control_period_s, drives_Nm);
  WholeBody body(robot);
  const auto then_Nm = tipping_torques_Nm(body, {wanted.position, rest, half_Nm}, all);
  const auto at_end_Nm = tipping_torques_Nm(body, {wanted.position, rest, wanted.drive_Nm}, all);
  ASSERT_TRUE(then_Nm && at_end_Nm);
  ASSERT_LT((*then_Nm)[1], 0.9 * (*at_end_Nm)[1]);
  LqrOptions stated = options;
  stated.torque_Nm =
      (0.05 * peak_torques_Nm(robot)).cwiseMin(0.5 * *then_Nm).cwiseMin(0.5 * *at_end_Nm);
  const LqrResult found = lqr_gains(robot, slack, options);
  const LqrResult expected = lqr_gains(robot, slack, stated);
  ASSERT_TRUE(found.gains && expected.gains);
  const MatrixXd& gain = expected.gains->at(0, 0.0).of_error;
  EXPECT_LT((found.gains->at(0, 0.0).of_error - gain).norm(), 1e-9 * gain.norm());
}

// In the air nothing holds the height; for a tenth of a second that is no matter.
TEST_F(Standing, NothingHoldsItInTheAir) {
  VectorXd high = wanted.position;
  high[2] += 1.0;
  const Reference hovering = held(robot, high, false, 0.1);
  const LqrResult none = lqr_gains(robot, hovering, {});
  EXPECT_EQ(none.outcome, GainOutcome::kNoSteadyState);
  EXPECT_EQ(none.time_s, 0.1);
  EXPECT_FALSE(none.gains);
  EXPECT_EQ(none.instant.position, high);
  const std::string words = sentence_of(none);
  EXPECT_NE(words.find("t = 0.1 s"), std::string::npos) << words;
  EXPECT_NE(words.find("no torque holds"), std::string::npos) << words;
  LqrOptions weights;
  weights.end = LqrEnd::kWeights;
  const LqrResult some = lqr_gains(robot, hovering, weights);
  ASSERT_EQ(some.outcome, GainOutcome::kFound);
  EXPECT_TRUE(some.gains->at(0, 0.0).of_error.allFinite());
}

TEST_F(Standing, SaysWhichPostureNoMechanismReaches) {
  VectorXd bent = wanted.position;
  bent[9] = 1.5;
  const LqrResult none = lqr_gains(robot, held(robot, bent, false, 0.1), {});
  EXPECT_EQ(none.outcome, GainOutcome::kUnreached);
  EXPECT_NE(sentence_of(none).find("does not reach"), std::string::npos);
}

// A short rod on its end, upright: errors grow by e^(sqrt(g/l) t), l 1 mm, 99/s, and no drive
// moves it. Costs grow with their square: beyond 1e308 within 3.6 s.
TEST(Regulator, EndsWithTimeAndStateWhereCostsOverflow) {
  Robot rod;
  rod.tree.base = dynamics::BaseKind::kPlanar;
  dynamics::Body body;
  body.name = "rod";
  body.inertia = {1.0, {0, 0, 1e-3}, Eigen::Vector3d::Constant(1e-12).asDiagonal()};
  rod.tree.bodies = {body};
  rod.contacts = {{"tip", {0, Eigen::Vector3d::Zero()}, 1.0, 0.0, 0.0}};
  LqrOptions options;
  options.end = LqrEnd::kWeights;
  options.control_period_s = 2e-3;
  const VectorXd upright = VectorXd::Zero(3);
  const LqrResult short_one = lqr_gains(rod, held(rod, upright, true, 1.0), options);
  EXPECT_EQ(short_one.outcome, GainOutcome::kFound) << sentence_of(short_one);
  const LqrResult found = lqr_gains(rod, held(rod, upright, true, 5.0), options);
  ASSERT_EQ(found.outcome, GainOutcome::kBlownUp);
  EXPECT_NEAR(found.time_s, 5.0 - 308.0 * std::log(10.0) / (2.0 * std::sqrt(9.80665e3)), 0.2);
  EXPECT_FALSE(found.gains);
  EXPECT_TRUE(found.instant.position.allFinite());
  EXPECT_NE(sentence_of(found).find("blow up"), std::string::npos);
}

class Flip : public testing::Test {
 protected:
  /// Pitch error against the plan at the first touch of landing, and the whole error at the end.
  struct Landing {
    bool has_run = false;
    double pitch_rad = std::numeric_limits<double>::infinity();
    double end = std::numeric_limits<double>::infinity();
  };
  Landing fly(Controller& controller, test::Timing timing = {}) const {
    const double impact_s = planned.reference->modes()[3].from_s;
    ReferenceInstant at;
    planned.reference->at(0.0, at);
    test::ClosedLoop loop(planned.robot, controller, timing);
    loop.start(at.position, at.velocity, 0.0);
    Landing landing;
    const auto error = [&](double time_s) -> VectorXd {
      planned.reference->at(time_s, at);
      return aligned_error(planned.robot.tree, at, loop.position(), loop.velocity()).error;
    };
    landing.has_run = loop.run_until(planned.reference->ends_s() + 1.0, [&] {
      const bool lands = loop.time_s() > impact_s - 0.1 && loop.touches().any();
      if (lands && std::isinf(landing.pitch_rad)) landing.pitch_rad = error(impact_s)[4];
    });
    landing.end = error(planned.reference->ends_s()).norm();
    return landing;
  }

  test::PlannedMotion planned{"hopper.json", "hopper_flip.csv"};
};

// Without torque limits. The regulator brings it over and it stands a second later, touch-down
// within 2 degrees of the plan (steps of engine and control make some 0.7).
TEST_F(Flip, RegulatorLandsAndStands) {
  const LqrResult found = lqr_gains(planned.robot, *planned.reference, {});
  ASSERT_EQ(found.outcome, GainOutcome::kFound) << sentence_of(found);
  for (const ImpactHandling handling :
       {ImpactHandling::kDefault, ImpactHandling::kNoDerivative, ImpactHandling::kInvariant}) {
    const auto lqr = lqr_controller(planned.robot, *planned.reference, found.gains, {}, {handling});
    const Landing landing = fly(*lqr);
    EXPECT_TRUE(landing.has_run);
    EXPECT_LT(std::abs(landing.pitch_rad), 2.0 / 57.3);
    EXPECT_LT(landing.end, 0.05);
  }
}

TEST_F(Flip, GainsAreFiniteAndTheSameAgain) {
  const LqrResult first = lqr_gains(planned.robot, *planned.reference, {});
  const LqrResult second = lqr_gains(planned.robot, *planned.reference, {});
  ASSERT_TRUE(first.gains && second.gains);
  for (std::size_t mode = 0; mode < 4; ++mode) {
    const auto& gains = first.gains->by_mode()[mode].gains;
    ASSERT_GT(gains.size(), 50u);
    for (std::size_t i = 0; i < gains.size(); ++i) {
      ASSERT_TRUE(gains[i].of_error.allFinite());
      ASSERT_EQ(gains[i].of_error, second.gains->by_mode()[mode].gains[i].of_error);
    }
  }
}

/// How far the edge on which it is to land is from level at its first touch, of a body that rolls
/// by 0.3 rad/s in flight.
double uneven_m(const test::PlannedMotion& planned, const LqrOptions& options) {
  const LqrResult found = lqr_gains(planned.robot, *planned.reference, options);
  const auto lqr = lqr_controller(planned.robot, *planned.reference, found.gains, {}, kPlain);
  const ContactMode& landing = planned.reference->modes()[3];
  const double from_s = landing.from_s - 0.25;
  ReferenceInstant at;
  planned.reference->at(from_s, at);
  at.velocity[3] += 0.3;
  test::ClosedLoop loop(planned.robot, *lqr);
  loop.start(at.position, at.velocity, from_s);
  dynamics::TreeState state(planned.robot.tree);
  double least_m = 0.0, greatest_m = 0.0;
  (void)loop.run_until(from_s + 0.35, [&] {
    if (loop.touches().any() && greatest_m > least_m) return;
    state.set(loop.position(), loop.velocity());
    least_m = std::numeric_limits<double>::infinity();
    greatest_m = -least_m;
    for (Index i = 0; i < landing.touches.size(); ++i) {
      if (!landing.touches[i]) continue;
      const auto& point = planned.robot.contacts[static_cast<std::size_t>(i)].point;
      const double height_m = dynamics::point_position_m(state, point).z();
      least_m = std::min(least_m, height_m);
      greatest_m = std::max(greatest_m, height_m);
    }
  });
  return greatest_m - least_m;
}

TEST_F(Flip, LandsTheMoreLevelTheLessMayBeUneven) {
  LqrOptions any;
  any.uneven_m = 10.0;
  const double usual_m = uneven_m(planned, {}), careless_m = uneven_m(planned, any);
  EXPECT_LT(usual_m, LqrOptions().uneven_m);
  EXPECT_GT(careless_m, 2.0 * usual_m);
}

// Looks count until the impact, each for the period that ends there.
TEST_F(Flip, IsWeighedUntilTheImpact) {
  LqrOptions options;
  options.weighs = true;
  const LqrResult found = lqr_gains(planned.robot, *planned.reference, options);
  ASSERT_TRUE(found.gains);
  for (std::size_t mode = 0; mode < planned.reference->modes().size(); ++mode) {
    const GainStretch& stretch = found.gains->by_mode()[mode];
    const double look_s = stretch.from_s + 7.1 * stretch.step_s;
    const auto period = found.gains->weighed_before(mode, look_s);
    ASSERT_EQ(period.has_value(), mode < 3) << mode;
    if (!period) continue;
    EXPECT_EQ(&period->model, &stretch.models[6]);
    EXPECT_EQ(&period->gain, &stretch.weighing[6]);
  }
  const LqrResult still = lqr_gains(
      planned.robot, test::standing(planned.robot, test::crouch(planned.robot), 0.1), options);
  ASSERT_TRUE(still.gains);
  EXPECT_TRUE(still.gains->weighed_before(0, 0.1));
  EXPECT_FALSE(still.gains->weighed_before(0, 0.1 + options.control_period_s));
}

// Of errors along the motion the gain in front of the impact sees nothing: to be early or late is
// for the clock to mend. What is left is the cost of the one period before it.
TEST_F(Flip, GainsBeforeTheImpactDoNotSeeTheMoment) {
  const LqrResult found = lqr_gains(planned.robot, *planned.reference, {});
  ASSERT_TRUE(found.gains);
  const double impact_s = planned.reference->modes()[3].from_s;
  ReferenceInstant at;
  planned.reference->at(std::nextafter(impact_s, 0.0), at);
  VectorXd flow(18);
  flow << at.velocity, at.acceleration;
  flow[0] = flow[1] = 0.0;
  const MatrixXd& gain = found.gains->at(2, impact_s).of_error;
  double seen = 0.0, all = 0.0;
  for (Index drive = 0; drive < 3; ++drive) {
    seen = std::max(seen, std::abs(gain.row(drive).dot(flow)));
    all = std::max(all, gain.row(drive).cwiseAbs().dot(flow.cwiseAbs()));
  }
  EXPECT_LT(seen, 0.05 * all);
}

}  // namespace
}  // namespace torquewright::hopper
