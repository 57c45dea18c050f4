// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "dynamics/tree.hpp"
#include "hopper/trials/randomisation.hpp"

namespace torquewright::hopper {

/// What stands between noisy sensors and a controller: measured rates carry the last estimate on,
/// measured positions correct it, with the gain of Kalman's filter for white noise of both. One
/// gain each for the base's place, its attitude (gyroscope and gravity) and the joints; after some
/// looks it is T/tau at a period T, tau = noise of the position over noise of the rate. Rates stay
/// as they are measured. docs/randomisation.md, eqs. (4), (5).
class SensorFilter {
 public:
  /// `noise` as the sensors have it. The tree must outlive the filter.
  SensorFilter(const SensorNoiseLevels& noise, const dynamics::Tree& tree);

  /// Replaces a measured position by the estimate at a time later than that of the call before.
  void estimate(double time_s, Eigen::VectorXd& position, const Eigen::VectorXd& velocity);

 private:
  /// Positions of one kind with their rates.
  struct Group {
    Eigen::Index first = 0, size = 0;  ///< Of the velocities.
    double position_noise = 0.0;
    double rate_noise = 0.0;
    double variance = 0.0;

    /// Returns the gain of a look, and what remains uncertain.
    double gain_after(double period_s);
  };

  const dynamics::Tree& tree_;
  std::array<Group, 3> groups_;
  std::optional<double> last_s_;
  Eigen::VectorXd position_, velocity_, correction_;
};

}  // namespace torquewright::hopper
