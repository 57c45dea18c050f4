// SPDX-License-Identifier: Apache-2.0
#include "hopper/trials/sensor_noise.hpp"

#include <Eigen/Geometry>
#include <stdexcept>

#include "hopper/trials/counted_random.hpp"

namespace torquewright::hopper {
namespace {

using dynamics::BaseKind;
using Eigen::Index;
using Eigen::Vector3d;

constexpr double kNoGravity = 1e-9;  // a vector so short that it points nowhere

/// What noise is on: part of the key of each draw, so never to be renumbered.
enum NoisyQuantity : std::uint64_t {
  kOfGravity = 1,
  kOfBaseRate,
  kOfBasePosition,
  kOfBaseVelocity,
  kOfJointPosition,
  kOfJointVelocity,
};

}  // namespace

SensorNoise::SensorNoise(const SensorNoiseLevels& levels, const dynamics::Tree& tree,
                         std::uint64_t seed, std::size_t trial)
    : levels_{levels},
      tree_{tree},
      key_{mixed_in(mixed_in(seed, static_cast<std::uint64_t>(trial)), "sensor_noise")} {}

double SensorNoise::drawn(double level, std::uint64_t quantity, std::uint64_t look,
                          Index part) const {
  if (level == 0.0) return 0.0;
  const std::uint64_t key =
      mixed_in(mixed_in(mixed_in(key_, quantity), look), static_cast<std::uint64_t>(part));
  if (levels_.distribution == NoiseDistribution::kNormal) return level * normal_of(key);
  return level * (2.0 * uniform_of(key) - 1.0);
}

void SensorNoise::tilt(std::uint64_t look, Eigen::VectorXd& position) const {
  if (levels_.gravity_direction == 0.0 || tree_.base == BaseKind::kFixed) return;
  const auto noise = [&](Index axis) {
    return drawn(levels_.gravity_direction, kOfGravity, look, axis);
  };
  // docs/randomisation.md, eqs. (2), (3): a turn that makes gravity, down in the base's axes, what
  // is seen of it.
  if (tree_.base == BaseKind::kPlanar) {
    const double sine = std::sin(position[2]), cosine = std::cos(position[2]);
    const double seen_x = sine + noise(0), seen_z = -cosine + noise(2);
    if (std::hypot(seen_x, seen_z) < kNoGravity) return;
    position[2] += std::atan2(seen_x * cosine + seen_z * sine, seen_x * sine - seen_z * cosine);
    return;
  }
  const Eigen::Quaterniond q_WB =
      Eigen::Quaterniond(position[3], position[4], position[5], position[6]).normalized();
  const Vector3d down = q_WB.conjugate() * Vector3d(0.0, 0.0, -1.0);
  const Vector3d seen = down + Vector3d(noise(0), noise(1), noise(2));
  if (seen.norm() < kNoGravity) return;
  const Eigen::Quaterniond turned = q_WB * Eigen::Quaterniond::FromTwoVectors(seen, down);
  position.segment<4>(3) << turned.w(), turned.x(), turned.y(), turned.z();
}

void SensorNoise::disturb(std::uint64_t look, Eigen::VectorXd& position,
                          Eigen::VectorXd& velocity) const {
  if (position.size() != tree_.position_size() || velocity.size() != tree_.velocity_size()) {
    throw std::invalid_argument("SensorNoise::disturb: vectors of another tree");
  }
  tilt(look, position);
  const Index places = tree_.base == BaseKind::kSpatial  ? 3
                       : tree_.base == BaseKind::kPlanar ? 2
                                                         : 0;
  const Index base_size = tree_.base_velocity_size();
  for (Index i = 0; i < places; ++i) {
    position[i] += drawn(levels_.base_position_m, kOfBasePosition, look, i);
    velocity[i] += drawn(levels_.base_velocity_m_s, kOfBaseVelocity, look, i);
  }
  for (Index i = places; i < base_size; ++i) {
    velocity[i] += drawn(levels_.base_rate_rad_s, kOfBaseRate, look, i - places);
  }
  const Index first_position = tree_.position_size() - (tree_.velocity_size() - base_size);
  for (std::size_t body = 1; body < tree_.bodies.size(); ++body) {
    if (tree_.bodies[body].joint.kind != dynamics::JointKind::kRevolute) continue;
    const auto joint = static_cast<Index>(body) - 1;
    position[first_position + joint] +=
        drawn(levels_.joint_position_rad, kOfJointPosition, look, joint);
    velocity[base_size + joint] +=
        drawn(levels_.joint_velocity_rad_s, kOfJointVelocity, look, joint);
  }
}

}  // namespace torquewright::hopper
