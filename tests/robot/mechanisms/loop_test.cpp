// SPDX-License-Identifier: Apache-2.0
// Loops closed by numbers. Oracles: the closed forms of the four-bar and of the parallel ankle on
// the same links, which share no line with them; identities between a mechanism's own outputs.
#include "robot/mechanisms/loop.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "robot/mechanisms/four_bar.hpp"
#include "robot/mechanisms/parallel_ankle.hpp"
#include "tests/robot/mechanisms/ankles.hpp"
#include "tests/robot/mechanisms/derivatives.hpp"
#include "tests/robot/mechanisms/four_bars.hpp"

namespace torquewright::hopper {
namespace {

using dynamics::Jet2;
using Eigen::Index;
using Eigen::Vector3d;
using oracles::Dice;
using test::pair_of;
using test::uniform;

// Newton's method leaves 1e-14 of a length; levers of a fifth of it, and once more for a rate.
constexpr double kAsClosedForm = 1e-10;

std::size_t add(LoopGeometry& loop, std::size_t parent, const Vector3d& place_m,
                const Vector3d& axis) {
  dynamics::Body body;
  body.name = body.joint.name = "b" + std::to_string(loop.tree.bodies.size());
  body.parent = parent;
  body.joint.p_PB_m = place_m;
  body.joint.axis = axis;
  loop.tree.bodies.push_back(body);
  return loop.tree.bodies.size() - 1;
}

/// A four-bar's rocker as the robot's own joint, its crank and coupler as links, closed where the
/// joint is at zero. Empty where it does not reach that.
std::optional<LoopGeometry> loop_of(const FourBarGeometry& bar) {
  const SmallVector zero = SmallVector::Zero(1);
  const auto start = FourBar(bar).transfer(zero, zero);
  if (!start) return std::nullopt;
  const auto out = [](double length_m, double angle_rad) {
    return Vector3d(length_m * std::cos(angle_rad), length_m * std::sin(angle_rad), 0);
  };
  LoopGeometry loop;
  loop.tree.bodies.emplace_back();
  const Vector3d pivot_m(bar.ground_m, 0, 0), pin_m = out(bar.rocker_m, bar.rocker_zero_rad);
  const double crank_rad = start->actuator_position_rad[0];
  const Vector3d crank_m = out(bar.crank_m, bar.crank_zero_rad);
  const Eigen::AngleAxisd turned(bar.crank_direction * crank_rad, Vector3d::UnitZ());
  const std::size_t rocker = add(loop, 0, pivot_m, bar.rocker_direction * Vector3d::UnitZ());
  const std::size_t crank = add(loop, 0, Vector3d::Zero(), bar.crank_direction * Vector3d::UnitZ());
  const std::size_t coupler = add(loop, crank, crank_m, Vector3d::UnitZ());
  const Vector3d coupler_m = turned.inverse() * (pivot_m + pin_m - turned * crank_m);
  loop.closures.push_back({dynamics::BodyPoint{coupler, coupler_m}, {rocker, pin_m}});
  loop.turned = {crank};
  loop.start = Eigen::Vector3d(0, crank_rad, 0);
  return loop;
}

void expect_alike(const Transfer& one, const Transfer& other) {
  for (Index k = 0; k < one.actuator_position_rad.size(); ++k) {
    const double apart = one.actuator_position_rad[k] - other.actuator_position_rad[k];
    EXPECT_NEAR(std::remainder(apart, 2 * M_PI), 0, kAsClosedForm);
  }
  const double scale = 1 + other.jacobian.squaredNorm() + other.jacobian_rate_1_s.squaredNorm();
  EXPECT_LE((one.jacobian - other.jacobian).cwiseAbs().maxCoeff(), kAsClosedForm * scale);
  EXPECT_LE((one.jacobian_rate_1_s - other.jacobian_rate_1_s).cwiseAbs().maxCoeff(),
            kAsClosedForm * scale);
}

/// Whether a linkage is so far from where it opens or is in line that rounding is all that differs.
bool is_far(const Mechanism& mechanism, const SmallVector& q) {
  for (const MechanismMargin& margin : mechanism.margins(q)) {
    const double far = margin.unit == "m" ? 0.01 : 0.3;
    if (margin.name != "least_lever" && margin.margin < far) return false;
  }
  return true;
}

TEST(Loop, OfAFourBarIsItsClosedForm) {
  Dice dice(61);
  int compared = 0;
  for (int i = 0; i < 300; ++i) {
    FourBarGeometry bar;
    do {
      bar.crank_m = uniform(dice, 0.4, 2);
      bar.coupler_m = uniform(dice, 0.4, 2);
      bar.rocker_m = uniform(dice, 0.4, 2);
      bar.ground_m = uniform(dice, 0.4, 2);
    } while (four_bar_objection(bar));
    test::mount_anyhow(dice, bar);
    auto geometry = loop_of(bar);
    if (!geometry || !is_far(FourBar(bar), SmallVector::Zero(1))) continue;
    geometry->tree.bodies[1].joint.limits.position_min = -1;
    geometry->tree.bodies[1].joint.limits.position_max = 1;
    ASSERT_EQ(ClosedLinks::objection(*geometry), "");
    const Loop loop(*geometry);
    for (int sample = 0; sample < 5; ++sample) {
      // Near enough to zero that the way there crosses no other branch.
      const SmallVector q = SmallVector::Constant(1, uniform(dice, -1, 1));
      const SmallVector v = SmallVector::Constant(1, uniform(dice, -3, 3));
      bool is_way_far = true;
      for (double share = 0; share <= 1; share += 0.05) {
        is_way_far = is_way_far && is_far(FourBar(bar), share * q);
      }
      if (!is_way_far) continue;
      const auto found = loop.transfer(q, v);
      ASSERT_TRUE(found);
      expect_alike(*found, *FourBar(bar).transfer(q, v));
      ++compared;
    }
  }
  EXPECT_GT(compared, 200);
}

/// Cranks on the calf, and on each a rod by a ball joint, which is three hinges.
LoopGeometry loop_of(const ParallelAnkleGeometry& ankle) {
  const SmallVector zero = SmallVector::Zero(2);
  const auto start = ParallelAnkle(ankle).transfer(zero, zero).value();
  LoopGeometry loop;
  loop.joints = 2;
  loop.tree.bodies.emplace_back();
  for (const dynamics::Joint& joint : {ankle.first, ankle.second}) {
    const std::size_t body =
        add(loop, loop.tree.bodies.size() - 1, Vector3d::Zero(), Vector3d::UnitX());
    const std::string name = loop.tree.bodies[body].joint.name;
    loop.tree.bodies[body].joint = joint;
    loop.tree.bodies[body].joint.name = name;
  }
  std::vector<double> at{0, 0};
  for (std::size_t i = 0; i < 2; ++i) {
    const AnkleRod& rod = ankle.rods[i];
    const double crank_rad = start.actuator_position_rad[static_cast<Index>(i)];
    const Vector3d foot_m =
        ankle.first.p_PB_m +
        ankle.first.R_PB * (ankle.second.p_PB_m + ankle.second.R_PB * rod.foot_attachment_m);
    const Eigen::AngleAxisd turned(crank_rad, rod.actuator_axis);
    const Vector3d rod_m =
        turned.inverse() * Vector3d(foot_m - rod.actuator_center_m - turned * rod.crank_m);
    const std::size_t crank = add(loop, 0, rod.actuator_center_m, rod.actuator_axis);
    std::size_t ball = add(loop, crank, rod.crank_m, Vector3d::UnitX());
    ball = add(loop, ball, Vector3d::Zero(), Vector3d::UnitY());
    ball = add(loop, ball, Vector3d::Zero(), Vector3d::UnitZ());
    loop.closures.push_back(
        {dynamics::BodyPoint{ball, rod_m}, dynamics::BodyPoint{2, rod.foot_attachment_m}});
    loop.turned.push_back(crank);
    at.insert(at.end(), {crank_rad, 0, 0, 0});
  }
  loop.start = Eigen::Map<const Eigen::VectorXd>(at.data(), static_cast<Index>(at.size()));
  return loop;
}

TEST(Loop, OfAParallelAnkleIsItsClosedForm) {
  Dice dice(62);
  int compared = 0;
  for (int i = 0; i < 8; ++i) {
    ParallelAnkleGeometry ankle = test::askew_ankle(dice);
    ankle.rod_tilt_limit_rad = 1.5;
    ankle.transmission_limit_rad = 0;
    for (dynamics::Joint* joint : {&ankle.first, &ankle.second}) {
      joint->limits.position_min = -0.5;
      joint->limits.position_max = 0.5;
    }
    if (!is_far(ParallelAnkle(ankle), pair_of(0, 0))) continue;
    const LoopGeometry geometry = loop_of(ankle);
    ASSERT_EQ(ClosedLinks::objection(geometry), "");
    const Loop loop(geometry);
    for (int sample = 0; sample < 20; ++sample) {
      const SmallVector q = pair_of(uniform(dice, -0.5, 0.5), uniform(dice, -0.3, 0.3));
      const SmallVector v = pair_of(uniform(dice, -3, 3), uniform(dice, -3, 3));
      if (!is_far(ParallelAnkle(ankle), q)) continue;
      const auto found = loop.transfer(q, v);
      ASSERT_TRUE(found);
      expect_alike(*found, *ParallelAnkle(ankle).transfer(q, v));
      ++compared;
    }
  }
  EXPECT_GT(compared, 20);
}

// Oracle: identities, which hold but for rounding: slopes of positions are the Jacobian, its slopes
// times the speeds its rate, curvatures of positions slopes of the Jacobian.
TEST(Loop, CarriesDerivatives) {
  Dice dice(63);
  ParallelAnkleGeometry ankle = test::askew_ankle(dice);
  for (dynamics::Joint* joint : {&ankle.first, &ankle.second}) {
    joint->limits.position_min = -0.3;
    joint->limits.position_max = 0.3;
  }
  const Loop loop(loop_of(ankle));
  const SmallVector q = pair_of(0.1, -0.05), v = pair_of(2, -1.5);
  SmallVectorOf<Jet2> joint_rad(2), joint_rad_s(2);
  for (int j = 0; j < 2; ++j) {
    joint_rad[j] = Jet2::variable(q[j], j);
    joint_rad_s[j] = Jet2::variable(v[j], 2 + j);
  }
  const auto plain = loop.transfer(q, v);
  const auto at = loop.transfer_with_curvatures(joint_rad, joint_rad_s);
  ASSERT_TRUE(plain && at);
  for (int i = 0; i < 2; ++i) {
    EXPECT_NEAR(at->actuator_position_rad[i].value(), plain->actuator_position_rad[i], 1e-13);
    for (int j = 0; j < 2; ++j) {
      double rate = 0;
      EXPECT_NEAR(at->actuator_position_rad[i].slope(j), plain->jacobian(i, j), kAsClosedForm);
      for (int l = 0; l < 2; ++l) {
        rate += at->jacobian(i, j).slope(l) * v[l];
        EXPECT_NEAR(at->actuator_position_rad[i].curvature(j, l), at->jacobian(i, j).slope(l),
                    kAsClosedForm);
        EXPECT_NEAR(at->jacobian_rate_1_s(i, j).slope(2 + l), at->jacobian(i, j).slope(l),
                    kAsClosedForm);
        // Of second order the one is found by the gaps' third derivatives, the other by their
        // second ones.
        EXPECT_NEAR(at->jacobian(i, j).curvature(l, 0), at->jacobian(i, 0).curvature(l, j), 1e-8);
      }
      EXPECT_NEAR(at->jacobian_rate_1_s(i, j).value(), rate, kAsClosedForm);
    }
  }
  test::expect_derivatives(loop, q, v);
}

TEST(Loop, SaysWhyItIsNone) {
  FourBarGeometry bar;
  bar.crank_m = 0.05;
  bar.coupler_m = 0.2;
  bar.rocker_m = 0.06;
  bar.ground_m = 0.19;
  bar.rocker_zero_rad = 1.2;
  const LoopGeometry sound = loop_of(bar).value();
  ASSERT_EQ(ClosedLinks::objection(sound), "");
  LoopGeometry loop = sound;
  loop.closures.front()[0].p_B_m *= 3;
  EXPECT_NE(ClosedLinks::objection(loop).find("does not close"), std::string::npos);
  loop = sound;
  loop.closures.clear();
  EXPECT_NE(ClosedLinks::objection(loop).find("nothing closes it"), std::string::npos);
  loop = sound;  // a second hinge on the crank's pivot turns the whole
  add(loop, 2, Vector3d(0.01, 0, 0), Vector3d::UnitZ());
  loop.tree.bodies[3].parent = 3;
  std::swap(loop.tree.bodies[3], loop.tree.bodies[4]);
  loop.tree.bodies[3].parent = 2;
  loop.tree.bodies[4].parent = 3;
  loop.closures.front()[0].body = 4;
  loop.closures.front()[0].p_B_m -= Vector3d(0.01, 0, 0);
  loop.start.conservativeResize(4);
  loop.start[3] = 0;
  EXPECT_NE(ClosedLinks::objection(loop).find("free"), std::string::npos)
      << ClosedLinks::objection(loop);
  // It ends where crank and coupler are in line.
  const Loop whole(sound);
  EXPECT_FALSE(whole.transfer(SmallVector::Constant(1, 1.9), SmallVector::Zero(1)));
  EXPECT_FALSE(whole.transfer(SmallVector::Constant(1, std::nan("")), SmallVector::Zero(1)));
}

}  // namespace
}  // namespace torquewright::hopper
