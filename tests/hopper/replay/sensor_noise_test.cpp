// SPDX-License-Identifier: Apache-2.0
#include "hopper/trials/sensor_noise.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <functional>

#include "tests/hopper/replay/kolmogorov.hpp"
#include "tests/hopper/replay/randomised_hopper.hpp"

namespace torquewright::hopper {
namespace {

using dynamics::BaseKind;
using Eigen::Index;
using Eigen::Quaterniond;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr std::uint64_t kSeedOfNoise = 8;
constexpr std::size_t kNoisyTrial = 4;
constexpr std::size_t kLooks = 5000;
constexpr double kRoundOff = 1e-12;

/// The hopper on a base of this kind, its ankle rolling by sliding: a joint that noise leaves
/// alone.
dynamics::Tree tree_on(BaseKind base) {
  dynamics::Tree tree = test::hopper().tree;
  tree.base = base;
  tree.bodies[3].joint.kind = dynamics::JointKind::kPrismatic;
  return tree;
}

SensorNoiseLevels all_levels() {
  return {NoiseDistribution::kUniform, 0.07, 0.1, 0.01, 0.2, 0.05, 0.5};
}

VectorXd upright(const dynamics::Tree& tree) {
  VectorXd position = VectorXd::Zero(tree.position_size());
  if (tree.base == BaseKind::kSpatial) position[3] = 1.0;
  return position;
}

struct Seen {
  VectorXd position, velocity;
};

Seen look(const SensorNoiseLevels& levels, const dynamics::Tree& tree, const VectorXd& position,
          std::uint64_t number, std::size_t trial = kNoisyTrial) {
  Seen seen{position, VectorXd::Zero(tree.velocity_size())};
  SensorNoise(levels, tree, kSeedOfNoise, trial).disturb(number, seen.position, seen.velocity);
  return seen;
}

Vector3d gravity_seen(const VectorXd& position) {
  const Quaterniond q_WB(position[3], position[4], position[5], position[6]);
  return q_WB.conjugate() * Vector3d(0.0, 0.0, -1.0);
}

VectorXd turned(const dynamics::Tree& tree, const Quaterniond& q_WB) {
  VectorXd position = upright(tree);
  position.segment<4>(3) << q_WB.w(), q_WB.x(), q_WB.y(), q_WB.z();
  return position;
}

// Oracle: levels of the document as half widths, on the parts they are of, and on no other.
TEST(SensorNoise, IsUniformWithinItsLevels) {
  const dynamics::Tree tree = tree_on(BaseKind::kSpatial);
  struct Part {
    const char* name;
    double level;
    std::function<double(const Seen&)> of;
  };
  for (const Part& part : std::initializer_list<Part>{
           {"place", 0.01, [](const Seen& s) { return s.position[1]; }},
           {"knee", 0.05, [](const Seen& s) { return s.position[7]; }},
           {"velocity", 0.2, [](const Seen& s) { return s.velocity[2]; }},
           {"rate", 0.1, [](const Seen& s) { return s.velocity[3]; }},
           {"knee's rate", 0.5, [](const Seen& s) { return s.velocity[6]; }}}) {
    std::vector<double> sample;
    for (std::size_t i = 0; i < kLooks; ++i) {
      sample.push_back(part.of(look(all_levels(), tree, upright(tree), i)) / part.level);
    }
    EXPECT_LT(
        test::distance_to([](double x) { return std::clamp(0.5 * (x + 1), 0.0, 1.0); }, sample),
        test::distance_bound(kLooks))
        << part.name;
  }
  const Seen seen = look(all_levels(), tree, upright(tree), 0);
  EXPECT_EQ(seen.position[9], 0.0);  // it slides
  EXPECT_EQ(seen.velocity[8], 0.0);
}

// Oracle: the normal distribution by the library's error function.
TEST(SensorNoise, IsNormalWhereTheDocumentSaysSo) {
  const dynamics::Tree tree = tree_on(BaseKind::kSpatial);
  SensorNoiseLevels levels = all_levels();
  levels.distribution = NoiseDistribution::kNormal;
  std::vector<double> sample;
  for (std::size_t i = 0; i < kLooks; ++i) {
    sample.push_back(look(levels, tree, upright(tree), i).velocity[7] / 0.5);
  }
  const auto normal = [](double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); };
  EXPECT_LT(test::distance_to(normal, sample), test::distance_bound(kLooks));
}

/// Noise n of the gravity vector, from what three bases see of it at one look: each sees a multiple
/// of its own gravity plus n, so that n and the multiples solve linear equations, more than there
/// are unknowns.
Vector3d noise_behind(const dynamics::Tree& tree, std::uint64_t number, double& residual) {
  SensorNoiseLevels levels;
  levels.gravity_direction = 0.07;
  const Quaterniond bases[] = {
      Quaterniond::Identity(), Quaterniond(Eigen::AngleAxisd(2.0, Vector3d(1, 2, 3).normalized())),
      Quaterniond(Eigen::AngleAxisd(-1.2, Vector3d(3, -1, 0).normalized()))};
  Eigen::MatrixXd equations = Eigen::MatrixXd::Zero(9, 6);
  VectorXd right(9);
  for (Index i = 0; i < 3; ++i) {
    const VectorXd position = turned(tree, bases[i]);
    equations.block<3, 3>(3 * i, 0) = -Eigen::Matrix3d::Identity();
    equations.block<3, 1>(3 * i, 3 + i) =
        gravity_seen(look(levels, tree, position, number).position);
    right.segment<3>(3 * i) = gravity_seen(position);
  }
  const VectorXd solution = equations.colPivHouseholderQr().solve(right);
  residual = (equations * solution - right).norm();
  return solution.head<3>();
}

// Oracle: eq. (2) and (3) of docs/randomisation.md, three bases at once; a planar base sees the
// same noise along x and z.
TEST(SensorNoise, TiltsTheBaseToTheGravityThatIsSeen) {
  const dynamics::Tree spatial = tree_on(BaseKind::kSpatial);
  const dynamics::Tree planar = tree_on(BaseKind::kPlanar);
  SensorNoiseLevels levels;
  levels.gravity_direction = 0.07;
  double largest = 0.0;
  for (std::uint64_t number = 0; number < 300; ++number) {
    double residual = 0.0;
    const Vector3d noise = noise_behind(spatial, number, residual);
    EXPECT_LT(residual, kRoundOff);
    EXPECT_LE(noise.cwiseAbs().maxCoeff(), 0.07 + kRoundOff);
    largest = std::max(largest, noise.cwiseAbs().maxCoeff());
    for (const double pitch_rad : {0.0, 2.5, -7.0}) {
      VectorXd position = upright(planar);
      position[2] = pitch_rad;
      const double seen = look(levels, planar, position, number).position[2];
      const double x = std::sin(pitch_rad) + noise.x(), z = -std::cos(pitch_rad) + noise.z();
      EXPECT_NEAR(std::sin(seen), x / std::hypot(x, z), kRoundOff);
      EXPECT_NEAR(std::cos(seen), -z / std::hypot(x, z), kRoundOff);
      EXPECT_LT(std::abs(seen - pitch_rad), 0.15);  // no turn is lost
    }
  }
  EXPECT_GT(largest, 0.069);  // of 900 parts
}

// Oracle: the least turn between two directions is about an axis at right angles to both.
TEST(SensorNoise, TurnsAboutNoVerticalAxis) {
  const dynamics::Tree tree = tree_on(BaseKind::kSpatial);
  for (std::uint64_t number = 0; number < 50; ++number) {
    const Quaterniond before(
        Eigen::AngleAxisd(0.03 * static_cast<double>(number), Vector3d(1, 1, -1).normalized()));
    SensorNoiseLevels levels;
    levels.gravity_direction = 0.07;
    const VectorXd seen = look(levels, tree, turned(tree, before), number).position;
    const Quaterniond after(seen[3], seen[4], seen[5], seen[6]);
    EXPECT_NEAR(after.norm(), 1.0, kRoundOff);
    const Quaterniond turn_in_base = before.conjugate() * after;
    EXPECT_NEAR(turn_in_base.vec().dot(gravity_seen(turned(tree, before))), 0.0, kRoundOff);
  }
}

TEST(SensorNoise, DependsOnSeedTrialAndLookAlone) {
  const dynamics::Tree tree = tree_on(BaseKind::kSpatial);
  const SensorNoise noise(all_levels(), tree, kSeedOfNoise, kNoisyTrial);
  std::vector<VectorXd> forward, backward;
  for (std::uint64_t i = 0; i < 20; ++i) {
    for (auto [list, number] : {std::pair{&forward, i}, {&backward, 19 - i}}) {
      VectorXd position = upright(tree), velocity = VectorXd::Zero(tree.velocity_size());
      noise.disturb(number, position, velocity);
      list->push_back(velocity);
    }
  }
  for (std::size_t i = 0; i < 20; ++i) EXPECT_EQ(forward[i], backward[19 - i]);
  EXPECT_NE(forward[3], forward[4]);
  EXPECT_NE(look(all_levels(), tree, upright(tree), 3, kNoisyTrial + 1).velocity, forward[3]);
  // A level more moves no other's noise.
  SensorNoiseLevels one;
  one.joint_velocity_rad_s = 0.5;
  EXPECT_EQ(look(one, tree, upright(tree), 3).velocity.tail(3), forward[3].tail(3));
}

TEST(SensorNoise, OfLevelsZeroChangesNoBit) {
  for (const BaseKind base : {BaseKind::kFixed, BaseKind::kPlanar, BaseKind::kSpatial}) {
    const dynamics::Tree tree = tree_on(base);
    VectorXd position = VectorXd::LinSpaced(tree.position_size(), 0.1, 0.7);
    const Seen seen = look({}, tree, position, 1);
    EXPECT_EQ(seen.position, position);
    EXPECT_EQ(seen.velocity, VectorXd::Zero(tree.velocity_size()));
  }
}

// A fixed base is where it is; its joints are seen through noise.
TEST(SensorNoise, LeavesAFixedBaseAlone) {
  const dynamics::Tree tree = tree_on(BaseKind::kFixed);
  const Seen seen = look(all_levels(), tree, upright(tree), 2);
  ASSERT_EQ(seen.position.size(), 3);
  EXPECT_NE(seen.position[0], 0.0);
  EXPECT_LE(std::abs(seen.position[0]), 0.05);
  EXPECT_EQ(seen.position[2], 0.0);
}

TEST(SensorNoise, RefusesVectorsOfAnotherTree) {
  const dynamics::Tree tree = tree_on(BaseKind::kSpatial);
  VectorXd position = upright(tree), velocity = VectorXd::Zero(3);
  EXPECT_THROW(SensorNoise({}, tree, 1, 1).disturb(0, position, velocity), std::invalid_argument);
}

}  // namespace
}  // namespace torquewright::hopper
