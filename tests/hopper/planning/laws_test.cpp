// SPDX-License-Identifier: Apache-2.0
// Oracles: of derivatives, fourth-order differences of the law on doubles; of values, the whole
// body as `hopper check` reckons with it, and physics by hand (a rotor's momentum, a battery's
// law).
#include "hopper/planning/model/laws.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numeric>
#include <stdexcept>

#include "dynamics/jet_functions.hpp"
#include "hopper/planning/plane/jet_rows.hpp"
#include "hopper/planning/programme/flip_program.hpp"
#include "robot/model/drive_supply.hpp"
#include "tests/hopper/planning/sagittal_states.hpp"

namespace torquewright::hopper {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using optimization::Rows;
using test::difference;
using test::moving_of;
using test::uniform;
using test::uniform_vector;

// h^4/30 of the fifth derivative, which grows by up to 10 per derivative where rods of centimetres
// turn, is 2e-9 of the largest; eps/h is 1e-12.
constexpr double kDifferenceStep = 5e-4;
constexpr double kOfDifferences = 5e-8;

VectorXd joined(const std::vector<VectorXd>& parts) {
  Index size = 0;
  for (const VectorXd& part : parts) size += part.size();
  VectorXd out(size);
  size = 0;
  for (const VectorXd& part : parts) {
    out.segment(size, part.size()) = part;
    size += part.size();
  }
  return out;
}

template <typename Law>
std::unique_ptr<const Rows> rows_of(const Law& law, Index width, Index size) {
  std::vector<int> variables;
  for (Index i = 0; i < width; ++i) variables.push_back(static_cast<int>(i));
  const auto count = static_cast<std::size_t>(size);
  return jet_rows("law", std::move(variables), std::vector<optimization::Bounds>(count),
                  std::vector<double>(count, 1.0), law);
}

VectorXd values(const Rows& rows, const VectorXd& x) {
  VectorXd out = VectorXd::Constant(rows.size(), NAN);
  rows.values(x, out);
  return out;
}
MatrixXd slopes(const Rows& rows, const VectorXd& x) {
  MatrixXd out = MatrixXd::Constant(rows.size(), rows.width(), NAN);
  rows.slopes(x, out);
  return out;
}

template <typename Of>
VectorXd differences(const Of& of, const VectorXd& x, Index i) {
  const VectorXd h = kDifferenceStep * VectorXd::Unit(x.size(), i);
  return (8.0 * (of(x + h) - of(x - h)) - (of(x + 2 * h) - of(x - 2 * h))) /
         (12.0 * kDifferenceStep);
}

void expect_derivatives(const Rows& rows, const VectorXd& x, oracles::Dice& dice) {
  ASSERT_EQ(x.size(), rows.width());
  const VectorXd multipliers = uniform_vector(dice, rows.size(), 1);
  MatrixXd by_values(rows.size(), rows.width()), by_slopes(rows.width(), rows.width());
  for (Index i = 0; i < x.size(); ++i) {
    by_values.col(i) = differences([&](const VectorXd& at) { return values(rows, at); }, x, i);
    by_slopes.col(i) = differences(
        [&](const VectorXd& at) { return VectorXd(slopes(rows, at).transpose() * multipliers); }, x,
        i);
  }
  MatrixXd curvatures = MatrixXd::Constant(rows.width(), rows.width(), NAN);
  rows.curvatures(x, multipliers, curvatures);
  EXPECT_LT(difference(slopes(rows, x), by_values), kOfDifferences);
  EXPECT_LT(difference(curvatures, by_slopes), kOfDifferences);
  EXPECT_EQ((curvatures - curvatures.transpose()).cwiseAbs().maxCoeff(), 0.0);
}

struct Kind {
  const char* name;
  const char* robot;
  Stance stance;
};

std::ostream& operator<<(std::ostream& out, const Kind& one) { return out << one.name; }

/// Behind the battery that drives share cables of 0.05 ohm and more lie between it and each.
std::shared_ptr<const std::vector<PlanSupply>> with_cables(std::vector<PlanSupply> supplies) {
  for (PlanSupply& supply : supplies) {
    for (std::size_t i = 0; i < supply.lines_ohm.size(); ++i) {
      supply.lines_ohm[i] = 0.05 + 0.02 * static_cast<double>(i);
    }
  }
  return std::make_shared<const std::vector<PlanSupply>>(std::move(supplies));
}

class Laws : public testing::TestWithParam<Kind> {
 protected:
  PlanModel model = plan_model(test::documented_robot(GetParam().robot), PlanOptions());
  const SagittalRobot& plane = model.plane;
  Stance stance = GetParam().stance;
  std::shared_ptr<SagittalScratch> scratch = std::make_shared<SagittalScratch>(plane);
  oracles::Dice dice{6};
  Index m = plane.moving_count(), k = m - 3, d = static_cast<Index>(plane.drive_count()),
        f = static_cast<Index>(stance.force_count());

  struct Instant {
    VectorXd q, v, a;
  };
  Instant draw(PlanFrame frame) {
    const TreeMotion rows = frame_motion(plane, frame, test::random_motion(dice, plane));
    return {moving_of(plane, rows.position), moving_of(plane, rows.velocity),
            moving_of(plane, rows.acceleration)};
  }
};

TEST_P(Laws, OfDynamics) {
  const Index held = static_cast<Index>(plane.held.size());
  const auto rows = rows_of(DynamicsLaw{scratch, stance}, 3 * m - 4 + d + f, m + held);
  SagittalDynamicsOf<double> body(plane);
  for (int sample = 0; sample < 3; ++sample) {
    const auto [q, v, a] = draw(stance.frame());
    const VectorXd u = uniform_vector(dice, d, 50), forces = uniform_vector(dice, f, 100);
    const VectorXd x = joined({q.tail(m - 2), v.tail(m - 2), a, u, forces});
    // Where it is and how fast it moves along changes nothing.
    body.set(stance.frame(), q, v);
    std::vector<SoleForceOf<double>> on_points;
    for (std::size_t i = 0; i < stance.points.size(); ++i) {
      on_points.push_back({stance.points[i], 0.0, forces[1 + static_cast<Index>(i)]});
    }
    // One force along the ground, wherever: points of a flat sole are level.
    if (!on_points.empty()) on_points.front().x = forces[0];
    EXPECT_LT(difference(values(*rows, x), body.residual(a, u, on_points)), 1e-12);
    expect_derivatives(*rows, x, dice);
  }
}

TEST_P(Laws, OfContacts) {
  if (stance.is_flight()) return;
  const auto speeds = rows_of(ContactVelocityLaw{scratch, stance}, 2 * m - 2, f);
  const auto rates = rows_of(ContactAccelerationLaw{scratch, stance}, 3 * m - 4, f);
  dynamics::TreeState state(plane.robot.tree);
  for (int sample = 0; sample < 3; ++sample) {
    const auto [q, v, a] = draw(PlanFrame::kSole);
    const VectorXd x = joined({q.tail(m - 2), v});
    const VectorXd y = joined({q.tail(m - 2), v.tail(m - 2), a});
    const TreeMotion tree = tree_motion(plane, PlanFrame::kSole,
                                        {plane.all_rows(q), plane.all_rows(v), plane.all_rows(a)});
    state.set(tree.position, tree.velocity);
    const VectorXd got = values(*speeds, x), got_rates = values(*rates, y);
    for (std::size_t i = 0; i < stance.points.size(); ++i) {
      const dynamics::BodyPoint& point = plane.sole[stance.points[i]].point;
      Eigen::Matrix<double, 3, Eigen::Dynamic> jacobian(3, tree.velocity.size());
      dynamics::point_jacobian(state, point, jacobian);
      const Eigen::Vector3d speed = jacobian * tree.velocity;
      const Eigen::Vector3d rate =
          jacobian * tree.acceleration + dynamics::point_bias_acceleration_m_s2(state, point);
      if (i == 0) {
        EXPECT_NEAR(got[0], speed.x(), 1e-11);
        EXPECT_NEAR(got_rates[0], rate.x(), 1e-9);
      }
      EXPECT_NEAR(got[1 + static_cast<Index>(i)], speed.z(), 1e-11);
      EXPECT_NEAR(got_rates[1 + static_cast<Index>(i)], rate.z(), 1e-9);
    }
    expect_derivatives(*speeds, x, dice);
    expect_derivatives(*rates, y, dice);
  }
}

TEST_P(Laws, OfImpacts) {
  if (stance.is_flight()) return;
  const auto rows = rows_of(ImpactLaw{scratch, stance}, 3 * m - 2 + f, m);
  WholeBody body(plane.robot);
  for (int sample = 0; sample < 3; ++sample) {
    const auto [q, v, w] = draw(PlanFrame::kSole);
    const VectorXd impulses = uniform_vector(dice, f, 10);
    const VectorXd x = joined({q.tail(m - 2), v, w, impulses});
    // M (v+ - v-) - J^T impulses of the tree, whose base moves as the frame and the joints say.
    const VectorXd none = VectorXd::Zero(plane.all_rows(q).size());
    const TreeMotion before =
        tree_motion(plane, PlanFrame::kSole, {plane.all_rows(q), plane.all_rows(v), none});
    const TreeMotion after =
        tree_motion(plane, PlanFrame::kSole, {plane.all_rows(q), plane.all_rows(w), none});
    ASSERT_TRUE(body.set(before.position, before.velocity));
    MatrixXd mass(none.size(), none.size());
    body.mass_matrix(mass);
    VectorXd given = VectorXd::Zero(none.size());
    for (std::size_t i = 0; i < stance.points.size(); ++i) {
      dynamics::add_point_force(
          body.state(), plane.sole[stance.points[i]].point,
          {i == 0 ? impulses[0] : 0.0, 0.0, impulses[1 + static_cast<Index>(i)]}, given);
    }
    const VectorXd expected = mass * (after.velocity - before.velocity) - given;
    EXPECT_LT(difference(values(*rows, x), moving_of(plane, expected)), 1e-12);
    expect_derivatives(*rows, x, dice);
  }
}

TEST_P(Laws, OfPlaces) {
  PlaceLaw law{scratch, stance.frame(), {plane.sole.back().point, {0, {0.1, 0.0, 0.3}}}};
  const auto rows = rows_of(law, m, 2);
  dynamics::TreeState state(plane.robot.tree);
  const TreeMotion tree = test::random_motion(dice, plane);
  state.set(tree.position, tree.velocity);
  const VectorXd q = moving_of(plane, frame_motion(plane, stance.frame(), tree).position);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(values(*rows, q)[static_cast<Index>(i)],
                dynamics::point_position_m(state, law.points[i]).z(), 1e-13);
  }
  expect_derivatives(*rows, q, dice);
}

TEST_P(Laws, OfLinks) {
  const auto rows = rows_of(LinkLaw{scratch}, 4 * m, 2 * m);
  const TreeMotion tree = test::random_motion(dice, plane);
  const TreeMotion sole = frame_motion(plane, PlanFrame::kSole, tree);
  const TreeMotion mass = frame_motion(plane, PlanFrame::kMass, tree);
  const VectorXd x = joined({moving_of(plane, sole.position), moving_of(plane, sole.velocity),
                             moving_of(plane, mass.position), moving_of(plane, mass.velocity)});
  EXPECT_LT(values(*rows, x).cwiseAbs().maxCoeff(), 1e-13);  // One instant.
  expect_derivatives(*rows, x, dice);
  for (Index i = 0; i < 2 * m; ++i) {  // Another's value is another's by as much.
    const VectorXd other = x + 0.25 * VectorXd::Unit(4 * m, 2 * m + i);
    EXPECT_NEAR(values(*rows, other)[i], -0.25, 1e-12);
  }
}

TEST_P(Laws, OfDrives) {
  model.supplies = with_cables(*model.supplies);
  const DriveLaw law{&plane, model.regions, model.supplies, model.rotors_kg_m2};
  Index regions = 0, buses = 0;
  for (const DriveRegion& region : *model.regions) regions += static_cast<Index>(region.rows());
  for (const PlanSupply& supply : *model.supplies) buses += supply.resistance_ohm > 0.0 ? 1 : 0;
  const auto rows = rows_of(law, 3 * k + d + buses, regions + d + k + buses);
  WholeBody body(plane.robot);
  for (int sample = 0; sample < 3; ++sample) {
    const TreeMotion tree = test::random_motion(dice, plane);
    const VectorXd u = uniform_vector(dice, d, 20);
    const VectorXd bus =
        buses > 0 ? VectorXd(VectorXd::Constant(buses, uniform(dice, 50, 60))) : VectorXd();
    const VectorXd x =
        joined({moving_of(plane, tree.position).tail(k), moving_of(plane, tree.velocity).tail(k),
                moving_of(plane, tree.acceleration).tail(k), u, bus});
    const VectorXd got = values(*rows, x);
    ASSERT_TRUE(body.set(tree.position, tree.velocity));
    std::vector<DriveInstant> drives;
    const VectorXd none = VectorXd::Zero(tree.velocity.size());
    body.drives(tree.acceleration, none, drives);
    VectorXd at_joints = none;
    body.add_drive_torques(u, at_joints);
    for (Index i = 0; i < d; ++i) {
      // The gears pass on what the rotor does not take.
      const DriveInstant& drive = drives[static_cast<std::size_t>(i)];
      const double rotor_Nm =
          body.before_gears_kg_m2(static_cast<std::size_t>(i)) * drive.acceleration_rad_s2;
      EXPECT_NEAR(got[regions + i], u[i] - rotor_Nm, 1e-9);
    }
    EXPECT_LT(difference(got.segment(regions + d, k), moving_of(plane, at_joints).tail(k)), 1e-12);
    for (Index i = 0; i < buses; ++i) {
      // E - R I with I = P / V, times V / E: 0 where the battery's law holds.
      const PlanSupply& supply = (*model.supplies)[static_cast<std::size_t>(i)];
      double power_W = 0.0;
      for (std::size_t place = 0; place < supply.drives.size(); ++place) {
        const std::size_t one = supply.drives[place];
        power_W += drawn_power_W(bus[i], supply.lines_ohm[place],
                                 (*model.regions)[one].bus_power_W<double>(
                                     u[static_cast<Index>(one)], drives[one].speed_rad_s, bus[i]));
      }
      const double law_V = supply.open_V - supply.resistance_ohm * power_W / bus[i];
      EXPECT_NEAR(got[regions + d + k + i], (law_V - bus[i]) * bus[i] / supply.open_V, 1e-9);
    }
    expect_derivatives(*rows, x, dice);
  }
}

// Oracle: the circuit itself. Behind a line of 0.2 ohm a drive takes P at V_i = V - R I with I V_i
// = P, found by halving I below the line's greatest power; the battery gives V I.
TEST(LineLoss, IsThatOfACircuit) {
  constexpr double kLine_ohm = 0.2, kBattery_V = 48.0;
  const double most_W = kBattery_V * kBattery_V / (4.0 * kLine_ohm);
  for (const double power_W : {-4000.0, -50.0, 0.0, 80.0, 1200.0, 0.89 * most_W}) {
    double low_A = -kBattery_V / kLine_ohm, high_A = kBattery_V / (2.0 * kLine_ohm);
    for (int i = 0; i < 200; ++i) {
      const double middle_A = 0.5 * (low_A + high_A);
      const bool is_more = (kBattery_V - kLine_ohm * middle_A) * middle_A > power_W;
      (is_more ? high_A : low_A) = middle_A;
    }
    EXPECT_NEAR(drawn_behind_line_W(kBattery_V, kLine_ohm, power_W), kBattery_V * low_A,
                1e-9 * most_W)
        << power_W;
  }
  EXPECT_EQ(drawn_behind_line_W(kBattery_V, 0.0, 700.0), 700.0);
}

// Oracle: differences, across where the law becomes a parabola too.
TEST(LineLoss, IsTwiceContinuouslyDifferentiable) {
  constexpr double h = 1e-5;
  for (const double x : {-3.0, -0.2, 0.0, 0.5, 0.89, 0.9 - 2e-6, 0.9 + 2e-6, 1.0, 4.0}) {
    const Taylor at = line_factor(x), before = line_factor(x - h), after = line_factor(x + h);
    EXPECT_NEAR(at.x, (after.value - before.value) / (2 * h), 1e-7) << x;
    EXPECT_NEAR(at.xx, (after.x - before.x) / (2 * h), 5e-4) << x;
  }
}

/// The centre of mass of the whole tree, which another function than the law's finds.
TEST_P(Laws, OfTheMassBeforeTheHeel) {
  const auto rows = rows_of(LeanLaw{scratch}, m - 2, 1);
  const TreeMotion tree = test::random_motion(dice, plane);
  const TreeMotion sole = frame_motion(plane, PlanFrame::kSole, tree);
  const TreeMotion mass = frame_motion(plane, PlanFrame::kMass, tree);
  const VectorXd x = moving_of(plane, sole.position).tail(m - 2);
  EXPECT_NEAR(values(*rows, x)[0], mass.position[0] - sole.position[0], 1e-12);
  expect_derivatives(*rows, x, dice);
}

/// x + x' sqrt(z/g) of the centre of mass about the sole, by the same function.
TEST_P(Laws, OfTheCapturePointBeforeTheHeel) {
  const auto rows = rows_of(CaptureLaw{scratch}, 2 * (m - 2), 1);
  TreeMotion sole, mass;
  do {  // a mass below the sole has none
    const TreeMotion tree = test::random_motion(dice, plane);
    sole = frame_motion(plane, PlanFrame::kSole, tree);
    mass = frame_motion(plane, PlanFrame::kMass, tree);
  } while (mass.position[1] - sole.position[1] < 0.1);
  VectorXd x(2 * (m - 2));
  x << moving_of(plane, sole.position).tail(m - 2), moving_of(plane, sole.velocity).tail(m - 2);
  const VectorXd from_m = mass.position - sole.position, from_m_s = mass.velocity - sole.velocity;
  const double falls_s = std::sqrt(from_m[1] / plane.robot.tree.gravity_m_s2);
  EXPECT_NEAR(values(*rows, x)[0], from_m[0] + from_m_s[0] * falls_s, 1e-12);
  expect_derivatives(*rows, x, dice);
}

INSTANTIATE_TEST_SUITE_P(, Laws,
                         testing::Values(Kind{"HopperFlat", "hopper", {"flat", {0, 1}}},
                                         Kind{"HopperOnHeel", "hopper", {"heel", {0}}},
                                         Kind{"HopperOnToe", "hopper", {"toe", {1}}},
                                         Kind{"HopperInFlight", "hopper", {"flight", {}}},
                                         Kind{"LegOnItsPoint", "planar_leg", {"flat", {0}}},
                                         Kind{"LegInFlight", "planar_leg", {"flight", {}}}),
                         [](const auto& one) { return std::string(one.param.name); });

struct Product {
  template <typename T>
  void operator()(const dynamics::VectorX<T>& x, dynamics::VectorX<T>& rows) const {
    using std::sin;
    rows[0] = x[0] * x[1] * x[1];
    rows[1] = sin(x[0]) + 3.0;
    rows[2] = T(5.0);
  }
};

/// x y^2, sin x + 3 and a constant: derivatives by hand.
TEST(JetRows, HaveTheDerivativesOfTheirLaw) {
  const auto rows = rows_of(Product(), 2, 3);
  const double x = 0.7, y = -1.3;
  const VectorXd at = Eigen::Vector2d(x, y);
  EXPECT_LT((values(*rows, at) - Eigen::Vector3d(x * y * y, std::sin(x) + 3.0, 5.0)).norm(), 1e-15);
  MatrixXd slope(3, 2);
  slope << y * y, 2 * x * y, std::cos(x), 0, 0, 0;
  EXPECT_LT((slopes(*rows, at) - slope).norm(), 1e-15);
  MatrixXd curvatures = MatrixXd::Constant(2, 2, NAN), expected(2, 2);
  rows->curvatures(at, Eigen::Vector3d(2.0, 3.0, 4.0), curvatures);
  expected << -3.0 * std::sin(x), 4.0 * y, 4.0 * y, 4.0 * x;
  EXPECT_LT((curvatures - expected).norm(), 1e-14);
}

// What a jet has no slope for would be written past its end.
TEST(JetRows, RefuseMoreVariablesThanAJetHasSlopes) {
  const auto first_of = [](const auto& x, auto& rows) { rows[0] = x[0]; };
  const auto rows_of = [&](int count) {
    std::vector<int> variables(static_cast<std::size_t>(count));
    std::iota(variables.begin(), variables.end(), 0);
    return jet_rows("wide", variables, {{0.0, 0.0}}, {1.0}, first_of);
  };
  EXPECT_NO_THROW(rows_of(dynamics::kMostVariables));
  EXPECT_THROW(rows_of(dynamics::kMostVariables + 1), std::invalid_argument);
}

TEST(JetRows, HaveNoCurvatureOfRowsThatCountForNothing) {
  const auto rows = rows_of(Product(), 2, 3);
  MatrixXd curvatures = MatrixXd::Constant(2, 2, NAN);
  rows->curvatures(Eigen::Vector2d(1, 2), Eigen::Vector3d::Zero(), curvatures);
  EXPECT_EQ(curvatures, MatrixXd::Zero(2, 2));
}

}  // namespace
}  // namespace torquewright::hopper
