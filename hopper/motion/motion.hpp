// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "actuator/trajectory/clock.hpp"
#include "robot/model/robot.hpp"
#include "simulation/contact/ground_profile.hpp"

namespace torquewright::hopper {

/// Source of a quantity of a motion.
enum class Origin {
  kAbsent,
  kGiven,
  kDerived,  ///< Derived from the quantity that it is the rate of, as slopes.hpp says.
};

/// An angle that the file keeps within one turn, and how many jumps were removed.
struct UnwrappedAngle {
  std::string column;
  std::size_t count = 0;
  double first_s = 0.0;
};

/// A whole-body motion: one column of each table per sample. Rows are those of the tree's positions
/// and velocities (docs/notation.md).
struct Motion {
  std::vector<double> times_s;  ///< Times, ascending; two alike are before and after an impact.
  Eigen::MatrixXd positions;
  Eigen::MatrixXd velocities;
  Eigen::MatrixXd accelerations;
  Eigen::MatrixXd efforts;  ///< Efforts of joints, where has_effort says so.
  /// Contact forces where given: three rows for each contact point, world's axes.
  Eigen::MatrixXd forces_N;
  Eigen::MatrixXd touching;  ///< Contact flags where given: one row for each contact point, 0 or 1.
  bool has_base = true;      ///< False: the base floats and nothing says how.
  std::vector<bool> has_effort;  ///< Whether efforts are given, by joint.
  /// Forces of all contact points that have a column are given; the others have none.
  bool has_forces = false;
  bool has_touching = false;
  /// Given forces only tell how touching points share what the motion asks for, because
  /// accelerations are derived and spread a touch-down over samples where the forces know it at an
  /// instant.
  bool forces_guide = false;
  Origin velocity_origin = Origin::kGiven;
  Origin acceleration_origin = Origin::kGiven;
  /// Number of samples on either side of each that derived rates were fitted to; 0: none is
  /// derived.
  Eigen::Index reach = 0;
  /// Standard deviation of derived accelerations by the noise of what they are derived from, by
  /// coordinate; empty: none is derived, or the log is too short to tell.
  Eigen::VectorXd acceleration_noise;
  /// (velocity rows x 1): step to which that is rounded what rates are derived from, in its unit;
  /// 0: to none. Empty: nobody has looked. hopper/motion/rounding_steps.hpp.
  Eigen::VectorXd steps;
  /// (velocity rows x samples): how far derived accelerations may be off by rounding and noise, and
  /// by what narrower windows show that theirs hides. Empty where steps and noise do not decide the
  /// window. hopper/motion/least_doubt.hpp.
  Eigen::MatrixXd acceleration_doubt;
  /// Samples whose velocity does not continue that of the sample before: an impact lies between.
  std::vector<Eigen::Index> breaks;
  std::vector<UnwrappedAngle> unwrapped;
  simulation::GroundProfile ground;  ///< What it moves over, if that is not flat.
  actuator::Clock clock;             ///< Clock of the file; `times_s` count from its origin.
  std::string file;
  std::string sha256;

  Eigen::Index samples() const { return static_cast<Eigen::Index>(times_s.size()); }
  double time_s(Eigen::Index sample) const { return times_s[static_cast<std::size_t>(sample)]; }
  bool is_break(Eigen::Index sample) const;
  /// Returns the time from that sample to the next one, in s; 0 for the last.
  double step_s(Eigen::Index sample) const;
  double duration_s() const { return times_s.back() - times_s.front(); }
};

}  // namespace torquewright::hopper
