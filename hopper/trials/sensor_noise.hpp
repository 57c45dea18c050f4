// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "dynamics/tree.hpp"
#include "hopper/trials/randomisation.hpp"

namespace torquewright::hopper {

/// Noise on what the controller of one trial sees. By (seed, trial, look) alone: no look depends on
/// those before. Keeps the tree by reference.
class SensorNoise {
 public:
  SensorNoise(const SensorNoiseLevels& levels, const dynamics::Tree& tree, std::uint64_t seed,
              std::size_t trial);

  /// Adds it to positions and velocities of the tree as seen at the look of this number (of the
  /// controller's steps, from 0). Noise of the gravity vector tilts the base by the least turn that
  /// makes it what is seen; of the heading it knows nothing.
  void disturb(std::uint64_t look, Eigen::VectorXd& position, Eigen::VectorXd& velocity) const;

 private:
  double drawn(double level, std::uint64_t quantity, std::uint64_t look, Eigen::Index part) const;
  void tilt(std::uint64_t look, Eigen::VectorXd& position) const;

  SensorNoiseLevels levels_;
  const dynamics::Tree& tree_;
  std::uint64_t key_;
};

}  // namespace torquewright::hopper
