// SPDX-License-Identifier: Apache-2.0
// Oracles: properties that define the projection (docs/derivations/impact_invariance.md, eqs. (3)
// and (4)), for any impulse; test::impact(), a rigid impact with Coulomb's law that knows nothing
// of it; the closed forms of full rank; the published system of equations, solved as it stands.
#include "hopper/tracking/impact_invariant.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <stdexcept>

#include "dynamics/mass_matrix.hpp"
#include "robot/model/robot_spec.hpp"
#include "tests/dynamics/random_numbers.hpp"
#include "tests/dynamics/rigid_impact.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using test::uniform_vector;

constexpr ImpactMetric kBoth[] = {ImpactMetric::kEuclidean, ImpactMetric::kInertia};
// Numbers of some 1; M^-1 of a condition below 1e4 loses four digits.
constexpr double kExact = 1e-11;

MatrixXd random_matrix(oracles::Dice& dice, Index rows, Index columns) {
  MatrixXd matrix(rows, columns);
  for (Index column = 0; column < columns; ++column) {
    matrix.col(column) = uniform_vector(dice, rows, 1.0);
  }
  return matrix;
}

/// Symmetric, eigenvalues from 0.1 on.
MatrixXd random_mass(oracles::Dice& dice, Index size) {
  const MatrixXd root = random_matrix(dice, size, size);
  return root.transpose() * root + 0.1 * MatrixXd::Identity(size, size);
}

/// P: what it leaves of each unit error.
MatrixXd projection(const ImpactMap& map, ImpactMetric metric) {
  const Index size = map.output_change.rows();
  MatrixXd left = MatrixXd::Identity(size, size);
  const ImpactOptions options{ImpactHandling::kInvariant, metric, 1.0, 1e-3};
  for (Index i = 0; i < size; ++i) handle_impact(options, 0.0, map, left.col(i));
  return left;
}

MatrixXd identity(Index size) { return MatrixXd::Identity(size, size); }

/// A robot of the specs in a posture with a moving foot.
struct Landing {
  explicit Landing(const char* spec)
      : robot(read_robot(std::string(TORQUEWRIGHT_SOURCE_DIR "/specs/robot/") + spec).robot),
        state(robot.tree) {
    const Index size = robot.tree.velocity_size();
    VectorXd position = dynamics::zero_position(robot.tree);
    position.tail(size - robot.tree.base_velocity_size()).setConstant(0.3);
    oracles::Dice dice(5);
    velocity = uniform_vector(dice, size, 1.0);
    velocity[2] = robot.tree.base == dynamics::BaseKind::kSpatial ? -2.0 : velocity[2];
    state.set(position, velocity);
    mass.resize(size, size);
    dynamics::mass_matrix(state, mass);
  }
  MatrixXd jacobian(const std::vector<std::size_t>& points) {
    MatrixXd rows(3 * static_cast<Index>(points.size()), mass.cols());
    Eigen::Matrix<double, 3, Eigen::Dynamic> own(3, mass.cols());
    for (std::size_t i = 0; i < points.size(); ++i) {
      dynamics::point_jacobian(state, robot.contacts[points[i]].point, own);
      rows.middleRows<3>(3 * static_cast<Index>(i)) = own;
    }
    return rows;
  }

  Robot robot;
  dynamics::TreeState state;
  VectorXd velocity;
  MatrixXd mass;
};

TEST(ImpactInvariant, IsAProjectionThatLeavesNothingOfAnyImpulse) {
  oracles::Dice dice(1);
  for (int trial = 0; trial < 20; ++trial) {
    const MatrixXd mass = random_mass(dice, 9);
    const MatrixXd jacobian = random_matrix(dice, 4, 9);
    const MatrixXd change = mass.ldlt().solve(jacobian.transpose());
    const ImpactMap map = impact_map(mass, jacobian, identity(9));
    for (const ImpactMetric metric : kBoth) {
      const MatrixXd left = projection(map, metric);
      const double scale = left.norm();
      EXPECT_LE((left * left - left).norm(), kExact * scale);
      EXPECT_LE((left * change).norm(), kExact * scale * change.norm());
      EXPECT_NEAR(left.trace(), 5.0, kExact * scale);  // Its rank: 9 velocities less 4 rows.

      const VectorXd before = uniform_vector(dice, 9, 1.0);
      const VectorXd after = before + change * uniform_vector(dice, 4, 10.0);
      ASSERT_GT((after - before).norm(), 0.1);
      EXPECT_LE((left * after - left * before).norm(), kExact * scale * (after - before).norm());
    }
  }
}

// Closed forms of full rank: eq. (4) with the Euclidean metric, as seed 003 prints it in words, and
// with the inertia metric the plastic impact itself.
TEST(ImpactInvariant, HasTheClosedFormsOfFullRank) {
  oracles::Dice dice(2);
  const MatrixXd mass = random_mass(dice, 7);
  const MatrixXd jacobian = random_matrix(dice, 2, 7);
  const MatrixXd change = mass.inverse() * jacobian.transpose();
  const ImpactMap map = impact_map(mass, jacobian, identity(7));
  const MatrixXd euclidean =
      identity(7) - change * (change.transpose() * change).inverse() * change.transpose();
  EXPECT_LE((projection(map, ImpactMetric::kEuclidean) - euclidean).norm(), kExact);
  const MatrixXd plastic = identity(7) - change * (jacobian * change).inverse() * jacobian;
  EXPECT_LE((projection(map, ImpactMetric::kInertia) - plastic).norm(), kExact * plastic.norm());
}

// Four points of one foot: 12 rows, of which 6 are independent, leave 3 of 9 velocities. The
// oracle's impulses keep Coulomb's law, with slip.
TEST(ImpactInvariant, DoesNotSeeAWholeFootLand) {
  Landing landing("hopper.json");
  const MatrixXd jacobian = landing.jacobian({0, 1, 2, 3});
  std::vector<test::Contact> contacts;
  for (const ContactPoint& contact : landing.robot.contacts) {
    contacts.push_back({.point = contact.point, .friction_coefficient = 0.6});
  }
  const test::Impact impact = test::impact(landing.state, contacts);
  ASSERT_EQ(impact.status, test::ImpactStatus::kSolved);
  const VectorXd jump = impact.velocity - landing.velocity;
  ASSERT_GT(jump.norm(), 1.0);
  const ImpactMap map = impact_map(landing.mass, jacobian, identity(9));
  for (const ImpactMetric metric : kBoth) {
    const MatrixXd left = projection(map, metric);
    EXPECT_NEAR(left.trace(), 3.0, 1e-8);
    EXPECT_LE((left * jump).norm(), 1e-8 * left.norm() * jump.norm());
    EXPECT_GT(left.norm(), 1.0);
  }
}

// Rows that follow from others say nothing new: the result is that of the others alone.
TEST(ImpactInvariant, IsTheSameForRowsSaidTwice) {
  Landing landing("rabbit.json");
  const MatrixXd once = landing.jacobian({0});
  MatrixXd twice(2 * once.rows() + 1, once.cols());
  twice << once, once, once.row(0) + 2.0 * once.row(2);
  for (const ImpactMetric metric : kBoth) {
    const MatrixXd left = projection(impact_map(landing.mass, twice, identity(7)), metric);
    const MatrixXd own = projection(impact_map(landing.mass, once, identity(7)), metric);
    EXPECT_NEAR(own.trace(), 5.0, kExact);  // Rabbit's foot in its plane: two rows of three count.
    EXPECT_LE((left - own).norm(), 1e-10 * own.norm());
  }
}

// Outputs that are not all velocities: only their part of the impulses' changes counts.
TEST(ImpactInvariant, DoesNotSeeImpulsesInTheJointsAlone) {
  Landing landing("rabbit.json");
  const MatrixXd joints = identity(7).bottomRows(4);
  const MatrixXd jacobian = landing.jacobian({0});
  const ImpactMap map = impact_map(landing.mass, jacobian, joints);
  const MatrixXd change = joints * landing.mass.inverse() * jacobian.transpose();
  ASSERT_GT(change.norm(), 0.1);
  for (const ImpactMetric metric : kBoth) {
    const MatrixXd left = projection(map, metric);
    EXPECT_LE((left * left - left).norm(), kExact * left.norm());
    EXPECT_LE((left * change).norm(), kExact * left.norm() * change.norm());
    EXPECT_NEAR(left.trace(), 2.0, kExact * left.norm());
  }
}

// A mechanism's rows: what is taken out leaves them at rest, and is what the published system of
// equations gives with the sign that does.
TEST(ImpactInvariant, KeepsAMechanismTogether) {
  oracles::Dice dice(3);
  const MatrixXd mass = random_mass(dice, 8);
  const MatrixXd jacobian = random_matrix(dice, 3, 8);
  const MatrixXd held = random_matrix(dice, 2, 8);
  const VectorXd velocity = uniform_vector(dice, 8, 1.0);
  const VectorXd error = uniform_vector(dice, 8, 1.0);
  const ImpactMap map = impact_map(mass, jacobian, identity(8), held, velocity);
  for (const ImpactMetric metric : kBoth) {
    const VectorXd part = impact_part(map, metric, error);
    EXPECT_LE((held * (velocity + part)).norm(), kExact);

    MatrixXd rows(5, 8);
    rows << jacobian, held;
    const MatrixXd change = mass.inverse() * rows.transpose();
    const MatrixXd weight = metric == ImpactMetric::kInertia ? mass : identity(8);
    MatrixXd system = MatrixXd::Zero(7, 7);
    system.topLeftCorner(5, 5) = change.transpose() * weight * change;
    system.topRightCorner(5, 2) = (held * change).transpose();
    system.bottomLeftCorner(2, 5) = held * change;
    VectorXd right_side(7);
    right_side << change.transpose() * weight * error, -held * velocity;
    const VectorXd impulses = system.fullPivLu().solve(right_side).head(5);
    EXPECT_LE((part - change * impulses).norm(), 1e-9);  // The squares of A cost as many digits.
  }
}

// An impact in which a mechanism's rods pull too: v+ keeps its rows, and the difference to v- is
// not seen.
TEST(ImpactInvariant, DoesNotSeeAnImpactOfAMechanism) {
  oracles::Dice dice(4);
  const MatrixXd mass = random_mass(dice, 8);
  const MatrixXd held = random_matrix(dice, 2, 8);
  MatrixXd rows(5, 8);
  rows << random_matrix(dice, 3, 8), held;
  const MatrixXd change = mass.inverse() * rows.transpose();
  // At rest in the held rows before, and by least squares of the kinetic energy after.
  VectorXd before = uniform_vector(dice, 8, 1.0);
  before -= held.transpose() * (held * held.transpose()).inverse() * held * before;
  const VectorXd after = before - change * (rows * change).inverse() * rows * before;
  ASSERT_LE((held * before).norm(), kExact);
  ASSERT_LE((held * after).norm(), kExact);
  ASSERT_GT((after - before).norm(), 0.1);
  const ImpactMap map = impact_map(mass, rows.topRows(3), identity(8), held, before);
  const VectorXd wanted = uniform_vector(dice, 8, 1.0);
  for (const ImpactMetric metric : kBoth) {
    const VectorXd early = wanted - before, late = wanted - after;
    const VectorXd left_early = early - impact_part(map, metric, early);
    const VectorXd left_late = late - impact_part(map, metric, late);
    EXPECT_LE((left_early - left_late).norm(), 1e-10);
    EXPECT_GT(left_early.norm(), 0.1);
  }
}

// v' = T v changes nothing of the physics: M' = T^-T M T^-1, J' = J T^-1, e' = T e.
TEST(ImpactInvariant, DependsOnCoordinatesOnlyInTheEuclideanMetric) {
  Landing landing("rabbit.json");
  oracles::Dice dice(6);
  const MatrixXd jacobian = landing.jacobian({1});
  const VectorXd error = uniform_vector(dice, 7, 1.0);
  // Joints' speeds from the world's upright instead of from the parent, and metres as millimetres.
  MatrixXd other = identity(7);
  other.block(3, 2, 4, 1).setOnes();
  other(5, 3) = other(6, 4) = 1.0;
  other.topRows(2) *= 1e3;
  const MatrixXd back = other.inverse();
  const ImpactMap map = impact_map(landing.mass, jacobian, identity(7));
  const ImpactMap changed =
      impact_map(back.transpose() * landing.mass * back, jacobian * back, identity(7));
  const auto difference = [&](ImpactMetric metric) -> double {
    const VectorXd own = impact_part(map, metric, error);
    const VectorXd foreign = back * impact_part(changed, metric, other * error);
    return (own - foreign).norm() / own.norm();
  };
  // Units of mm: mass and mobility spread by 1e6 more.
  EXPECT_LE(difference(ImpactMetric::kInertia), 1e-9);
  EXPECT_GT(difference(ImpactMetric::kEuclidean), 0.1);
}

TEST(ImpactBlend, ComesAndGoesAsTheLogisticFunctionSays) {
  const ImpactOptions options{.window_s = 0.05, .blend_s = 0.005};
  EXPECT_DOUBLE_EQ(impact_blend(options, 0.0), 1.0 / (1.0 + std::exp(-10.0)));
  for (const double side : {-1.0, 1.0}) {
    EXPECT_NEAR(impact_blend(options, side * 0.045), 1.0 / (1.0 + std::exp(-1.0)), 1e-14);
    EXPECT_DOUBLE_EQ(impact_blend(options, side * 0.05), 0.5);
    EXPECT_NEAR(impact_blend(options, side * 0.055), 1.0 / (1.0 + std::exp(1.0)), 1e-14);
    // At the cut it steps by 1/(1 + e^5) = 0.0067.
    EXPECT_NEAR(impact_blend(options, side * (0.075 - 1e-12)), 1.0 / (1.0 + std::exp(5.0)), 1e-11);
    EXPECT_EQ(impact_blend(options, side * (0.075 + 1e-12)), 0.0);
    EXPECT_EQ(impact_blend(options, side * 10.0), 0.0);
  }
  EXPECT_EQ(impact_blend({.window_s = 0.0}, 0.0), 0.0);
  EXPECT_EQ(impact_blend({.window_s = 1.0, .blend_s = 1e-300}, 1.2), 0.0);
}

TEST(ImpactBlend, RefusesATimeConstantOfNothing) {
  EXPECT_THROW(std::ignore = impact_blend({.blend_s = 0.0}, 0.0), std::invalid_argument);
  EXPECT_THROW(std::ignore = impact_blend({.blend_s = -1.0}, 0.0), std::invalid_argument);
}

TEST(HandleImpact, DoesWhatItsOptionsSay) {
  oracles::Dice dice(7);
  const ImpactMap map = impact_map(random_mass(dice, 5), random_matrix(dice, 2, 5), identity(5));
  const VectorXd error = uniform_vector(dice, 5, 1.0);
  const double blend = 1.0 / (1.0 + std::exp(-2.0));  // 10 ms inside the window
  const auto handled = [&](ImpactOptions options, double time_s) -> VectorXd {
    VectorXd left = error;
    handle_impact(options, time_s, map, left);
    return left;
  };
  EXPECT_EQ(handled({.handling = ImpactHandling::kDefault}, 0.0), error);
  const VectorXd blended = handled({.handling = ImpactHandling::kNoDerivative}, -0.04);
  EXPECT_LE((blended - (1.0 - blend) * error).norm(), 1e-14);
  for (const ImpactMetric metric : kBoth) {
    const ImpactOptions invariant{ImpactHandling::kInvariant, metric};
    const VectorXd part = impact_part(map, metric, error);
    ASSERT_GT(part.norm(), 0.1);
    EXPECT_LE((handled(invariant, 0.04) - (error - blend * part)).norm(), 1e-13);
    EXPECT_EQ(handled(invariant, 0.08), error);
    EXPECT_EQ(handled(invariant, -0.08), error);
  }
}

TEST(HandleImpact, LeavesAnErrorThatNoImpulseCouldMake) {
  oracles::Dice dice(8);
  const MatrixXd mass = random_mass(dice, 5);
  const ImpactMap map = impact_map(mass, MatrixXd::Zero(0, 5), identity(5));
  const VectorXd error = uniform_vector(dice, 5, 1.0);
  VectorXd left = error;
  handle_impact({}, 0.0, map, left);
  EXPECT_EQ(left, error);
}

TEST(ImpactMap, RefusesSizesThatDoNotFitAndNoMass) {
  EXPECT_THROW(std::ignore = impact_map(identity(5), identity(4), identity(5)),
               std::invalid_argument);
  EXPECT_THROW(std::ignore = impact_map(-identity(5), identity(5), identity(5)),
               std::invalid_argument);
  const ImpactMap map = impact_map(identity(5), identity(5), identity(5));
  EXPECT_THROW(std::ignore = impact_part(map, ImpactMetric::kEuclidean, VectorXd::Zero(4)),
               std::invalid_argument);
}

}  // namespace
}  // namespace torquewright::hopper
