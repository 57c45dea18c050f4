// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "actuator/drive_check/drive_check.hpp"
#include "actuator/trajectory/jacobian.hpp"
#include "actuator/trajectory/slope_filter.hpp"
#include "actuator/trajectory/trajectory_reader.hpp"

namespace torquewright::actuator {

/// Places in a row of drives, counted from kDrivePlaces times the drive's index.
enum DrivePlace : std::size_t {
  kDrivePositionAt,  ///< Position of a single joint; drives through a Jacobian have none.
  kDriveSpeedAt,
  kDriveTorqueAt,
  kDriveAccelerationAt,
  kDrivePlaces
};

/// Converts rows of joints to rows of drives: one by one, or two by two through a Jacobian.
class DriveRows {
 public:
  /// Throws io::SpecError where a Jacobian's actuators are not among the drives, or are already
  /// another's. `file` is the trajectory's, for messages.
  DriveRows(const std::vector<CheckedDrive>& drives, std::vector<ParallelDrive> parallels,
            std::string file);

  /// Returns the joints that the trajectory has to hold, in the order of its rows.
  const std::vector<std::string>& joints() const { return joints_; }

  /// Returns the indices of the joints that a drive depends on.
  std::vector<std::size_t> joints_of(std::size_t drive) const;

  /// Throws io::SpecError where a Jacobian over angles lacks the positions of its joints.
  void require_positions(const TrajectoryReader& reader) const;

  /// Converts a row; accelerations are left at 0. Throws io::SpecError where a Jacobian's table
  /// ends or is singular.
  void convert(const Row& joints, Row& drives) const;

 private:
  struct Single {
    std::size_t joint;
    std::size_t drive;
  };
  struct Pair {
    ParallelDrive parallel;
    std::array<std::size_t, 2> joints;
    std::array<std::size_t, 2> drives;
  };
  std::size_t joint_index(const std::string& name);
  void convert_pair(const Pair& pair, const Row& joints, Row& drives) const;

  std::string file_;
  std::size_t drive_count_;
  std::vector<std::string> joints_;
  std::vector<Single> singles_;
  std::vector<Pair> pairs_;
};

}  // namespace torquewright::actuator
