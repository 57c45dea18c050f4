// SPDX-License-Identifier: Apache-2.0
// Rabbit's published walking over its impacts. Oracles: the states before and after its impacts,
// and the torques, that its authors stored; two plants that have no line in common; the order that
// seed 003 publishes; and that an impulse leaves the projected velocities alone, which is algebra.
// Where the option does not help is our own finding, held here so that nobody claims more.
#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "dynamics/mass_matrix.hpp"
#include "hopper/tracking/impact_invariant.hpp"
#include "robot/model/robot_spec.hpp"
#include "tests/dynamics/rigid_impact.hpp"
#include "tests/real_data/motions/walk_trial.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kGains_1_s[] = {20.0, 40.0};

class ImpactStudy : public testing::Test {
 protected:
  void SetUp() override {
    const std::filesystem::path folder = test::rabbit_folder();
    if (folder.empty()) GTEST_SKIP() << "needs the published motions, ../shared/data";
    robot_ = read_robot(TORQUEWRIGHT_SOURCE_DIR "/specs/robot/rabbit.json").robot;
    walk_ = test::read_walk(folder);
  }

  /// One walk with each handling: what it is called here.
  struct Three {
    test::WalkResult plain, no_derivative, invariant;
  };
  Three three(test::WalkTrial trial) const {
    const auto with = [&](ImpactHandling handling) {
      trial.control.impact.handling = handling;
      return test::walk(robot_, walk_, trial);
    };
    return {with(ImpactHandling::kDefault), with(ImpactHandling::kNoDerivative),
            with(ImpactHandling::kInvariant)};
  }
  Three on_ground(double height_m, double damping_1_s) const {
    test::WalkTrial trial;
    trial.ground_height_m = height_m;
    trial.control.damping_1_s = damping_1_s;
    return three(trial);
  }
  /// The jump of velocities between two stored modes.
  VectorXd jump(std::size_t before) const {
    return walk_[before + 1].velocities.leftCols<1>() - walk_[before].velocities.rightCols<1>();
  }

  Robot robot_;
  test::Walk walk_;
};

// Impact by both of ours: Coulomb's law, and the closed form without slip. They stop the foot that
// stands in the next mode. Rates of some 5 rad/s are stored as a solver left them that closed its
// impacts to 1e-9.
TEST_F(ImpactStudy, ImpactLeadsToThePublishedNextMode) {
  dynamics::TreeState state(robot_.tree);
  for (std::size_t before = 0; before < 2; ++before) {
    const VectorXd velocity = walk_[before].velocities.rightCols<1>();
    const VectorXd next = walk_[before + 1].velocities.leftCols<1>();
    ASSERT_GT(jump(before).norm(), 1.0);  // With the feet swapped nothing would jump.
    state.set(walk_[before].positions.rightCols<1>(), velocity);
    const ContactPoint& foot = robot_.contacts[walk_[before + 1].stance];

    const test::Contact contact{.point = foot.point, .friction_coefficient = 0.6};
    const test::Impact impact = test::impact(state, {&contact, 1});
    ASSERT_EQ(impact.status, test::ImpactStatus::kSolved);
    const double off_rad_s = (impact.velocity - next).cwiseAbs().maxCoeff();

    MatrixXd mass(test::kWalkVelocities, test::kWalkVelocities);
    dynamics::mass_matrix(state, mass);
    const MatrixXd all = MatrixXd::Identity(test::kWalkVelocities, test::kWalkVelocities);
    const ImpactMap map = impact_map(mass, test::foot_rows(state, foot.point), all);
    const VectorXd plastic = velocity - impact_part(map, ImpactMetric::kInertia, velocity);
    const double without_slip_rad_s = (plastic - next).cwiseAbs().maxCoeff();
    std::printf("impact %zu: off by %.3g and %.3g rad/s\n", before, off_rad_s, without_slip_rad_s);
    EXPECT_LE(off_rad_s, 1e-9);
    EXPECT_LE(without_slip_rad_s, 1e-9);
  }
}

TEST_F(ImpactStudy, ProjectedVelocitiesDoNotJumpWhereTheyJump) {
  dynamics::TreeState state(robot_.tree);
  const MatrixXd all = MatrixXd::Identity(test::kWalkVelocities, test::kWalkVelocities);
  for (std::size_t before = 0; before < 2; ++before) {
    state.set(walk_[before].positions.rightCols<1>(), walk_[before].velocities.rightCols<1>());
    MatrixXd mass(test::kWalkVelocities, test::kWalkVelocities);
    dynamics::mass_matrix(state, mass);
    const auto left = [&](std::size_t foot, const MatrixXd& outputs, const VectorXd& rates,
                          ImpactMetric metric) -> double {
      const MatrixXd rows = test::foot_rows(state, robot_.contacts[foot].point);
      return (rates - impact_part(impact_map(mass, rows, outputs), metric, rates)).norm();
    };
    const VectorXd jumped = jump(before);
    ASSERT_GT(jumped.norm(), 1.0);
    for (const ImpactMetric metric : {ImpactMetric::kEuclidean, ImpactMetric::kInertia}) {
      const std::size_t lands = walk_[before + 1].stance;
      EXPECT_LE(left(lands, all, jumped, metric), 1e-8);
      EXPECT_LE(left(lands, all.bottomRows(4), jumped.tail<4>(), metric), 1e-8);
      EXPECT_GT(left(1 - lands, all, jumped, metric), 0.5);  // The other foot's rows do not do it.
    }
  }
}

// Exactly on its way the controller asks for the stored torques. Its stance foot stands; that of
// the stored accelerations does within its authors' tolerance: what is left accelerates at most the
// whole robot, 31.2 kg, at the length of a leg, 0.8 m. Torques of a few Nm lose 1e-12 of round-off.
TEST_F(ImpactStudy, ControllerAsksForThePublishedTorquesAtTheKnots) {
  constexpr double kMassAtLeg_kg_m = 31.2 * 0.8;
  const MatrixXd inputs =
      test::rabbit_table(test::rabbit_folder(), "input_traj").rightCols(test::kWalkJoints);
  dynamics::TreeState state(robot_.tree);
  int knots = 0;
  for (std::size_t before = 0; before < 2; ++before) {
    test::WalkControl control(robot_, walk_, before, {});
    for (std::size_t index = before; index <= before + 1; ++index) {
      const test::WalkMode& mode = walk_[index];
      const dynamics::BodyPoint& foot = robot_.contacts[mode.stance].point;
      // A mode's last knot before the impact has the next mode's time.
      const Eigen::Index count = mode.positions.cols() - (index == before ? 1 : 0);
      for (Eigen::Index knot = 0; knot < count; ++knot, ++knots) {
        const VectorXd position = mode.positions.col(knot), velocity = mode.velocities.col(knot);
        const VectorXd torque_Nm =
            control.torque_Nm(mode.times_s[static_cast<std::size_t>(knot)], position, velocity);
        const VectorXd stored = inputs.row(9 * static_cast<Eigen::Index>(index) + knot);
        state.set(position, velocity);
        const double left_m_s2 = (test::foot_rows(state, foot) * mode.accelerations.col(knot) +
                                  test::foot_bias_m_s2(state, foot))
                                     .norm();
        EXPECT_LE(left_m_s2, 1e-8);
        EXPECT_LE((torque_Nm - stored).cwiseAbs().maxCoeff(), kMassAtLeg_kg_m * left_m_s2 + 1e-11)
            << index << " " << knot;
      }
    }
  }
  EXPECT_EQ(knots, 38);
}

// Where the ground is where it was planned there is nothing to handle.
TEST_F(ImpactStudy, PlannedContactNeedsNoHandling) {
  for (const double gain : kGains_1_s) {
    const Three walks = on_ground(0.0, gain);
    for (const test::WalkResult* walk : {&walks.plain, &walks.no_derivative, &walks.invariant}) {
      ASSERT_TRUE(walk->has_landed);
      EXPECT_LE(std::abs(walk->contact_s), 2e-4);
      // The greatest stored about the impact is 3.44 N m at a knot, 3.76 at the one after.
      EXPECT_GT(walk->peak_torque_Nm, 3.44);
      EXPECT_LT(walk->peak_torque_Nm, 3.76);
      EXPECT_LE(walk->other_leg_rad_s, 0.01);
      EXPECT_LE(walk->landing_leg_rad_s, 0.01);
    }
  }
}

// Seed 003's order, for the ground 2, 4 and 8 mm lower (6 to 28 ms late).
TEST_F(ImpactStudy, LateContactIsCalmestProjected) {
  for (const double gain : kGains_1_s) {
    for (const double height_m : {-0.002, -0.004, -0.008}) {
      SCOPED_TRACE(testing::Message() << gain << "/s, ground at " << height_m << " m");
      const Three walks = on_ground(height_m, gain);
      ASSERT_GT(walks.invariant.contact_s, 0.005);
      ASSERT_LT(walks.invariant.contact_s, 0.035);
      EXPECT_GT(walks.plain.peak_torque_Nm, 4.0 * walks.no_derivative.peak_torque_Nm);
      EXPECT_GT(walks.no_derivative.peak_torque_Nm, walks.invariant.peak_torque_Nm);
      EXPECT_GT(walks.no_derivative.other_leg_rad_s, walks.invariant.other_leg_rad_s);
      if (height_m > -0.005) {
        EXPECT_GT(walks.plain.other_leg_rad_s, walks.invariant.other_leg_rad_s);
      }
    }
  }
}

// The step of the reference's rates times the gain, which no lateness changes.
TEST_F(ImpactStudy, DefaultPeakIsTheReferencesStep) {
  const double two_mm = on_ground(-0.002, 20.0).plain.peak_torque_Nm;
  EXPECT_NEAR(on_ground(-0.008, 20.0).plain.peak_torque_Nm, two_mm, 0.01 * two_mm);
  EXPECT_NEAR(on_ground(-0.002, 40.0).plain.peak_torque_Nm, 2.0 * two_mm, 0.02 * two_mm);
}

// The leg that lands: the default, which goes on damping, is the better one at the lower gain.
TEST_F(ImpactStudy, LandingLegIsNotHelpedAtTheLowerGain) {
  for (const double height_m : {-0.002, -0.004, -0.008}) {
    const Three walks = on_ground(height_m, 20.0);
    EXPECT_GT(walks.invariant.landing_leg_rad_s, 1.3 * walks.plain.landing_leg_rad_s);
  }
  const Three higher = on_ground(-0.002, 40.0);
  EXPECT_LT(higher.invariant.landing_leg_rad_s, higher.plain.landing_leg_rad_s);
}

// Early contact: hardly less torque than without derivative, and the default, at the price of
// torque, keeps both legs closer to their rates.
TEST_F(ImpactStudy, EarlyContactIsHardlyHelped) {
  for (const double height_m : {0.002, 0.004}) {
    const Three walks = on_ground(height_m, 20.0);
    ASSERT_LT(walks.invariant.contact_s, -0.005);
    EXPECT_NEAR(walks.invariant.peak_torque_Nm, walks.no_derivative.peak_torque_Nm,
                0.05 * walks.no_derivative.peak_torque_Nm);
    EXPECT_GT(walks.plain.peak_torque_Nm, 2.0 * walks.invariant.peak_torque_Nm);
    EXPECT_GT(walks.invariant.other_leg_rad_s, walks.plain.other_leg_rad_s);
    EXPECT_GT(walks.invariant.landing_leg_rad_s, walks.plain.landing_leg_rad_s);
  }
}

// The swinging foot 0.1 m/s slower or faster from the beginning of the walking. Feet that press and
// slip as the ground lets them make the same of it as one that is held. A contact found a step of
// 0.1 ms later is seen up to a control period of 1 ms later: contact within that, torques within
// what the error's rate makes of it, a tenth.
TEST_F(ImpactStudy, PlantsAgree) {
  for (const double push_m_s : {-0.1, 0.1}) {
    test::WalkTrial trial;
    trial.before = 0;
    trial.swing_push_m_s = push_m_s;
    const Three held = three(trial);
    trial.is_stepped = true;
    const Three stepped = three(trial);
    const auto agree = [](const test::WalkResult& one, const test::WalkResult& other) {
      ASSERT_TRUE(one.has_landed && other.has_landed);
      EXPECT_GT(std::abs(one.contact_s), 0.005);
      EXPECT_NEAR(one.contact_s, other.contact_s, 1e-3);
      EXPECT_NEAR(one.peak_torque_Nm, other.peak_torque_Nm, 0.1 * one.peak_torque_Nm);
    };
    agree(held.plain, stepped.plain);
    agree(held.no_derivative, stepped.no_derivative);
    agree(held.invariant, stepped.invariant);
  }
}

}  // namespace
}  // namespace torquewright::hopper
