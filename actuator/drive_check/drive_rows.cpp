// SPDX-License-Identifier: Apache-2.0
#include "actuator/drive_check/drive_rows.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/faults/refusal.hpp"
#include "io/text/nearest.hpp"

namespace torquewright::actuator {
namespace {

std::size_t drive_index(const std::vector<CheckedDrive>& drives, const std::string& name) {
  std::vector<std::string> names;
  for (const CheckedDrive& drive : drives) names.push_back(drive.name);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  const std::optional<std::string> near = io::nearest(name, names);
  io::refuse("--jacobian",
             fmt::format("its actuator \"{0}\" has no document; say --joint {0}=FILE{1}", name,
                         near ? " (not " + *near + ")" : ""));
}

}  // namespace

DriveRows::DriveRows(const std::vector<CheckedDrive>& drives, std::vector<ParallelDrive> parallels,
                     std::string file)
    : file_(std::move(file)), drive_count_(drives.size()) {
  std::vector<bool> is_taken(drives.size(), false);
  for (ParallelDrive& parallel : parallels) {
    Pair pair;
    for (std::size_t i = 0; i < 2; ++i) {
      pair.drives[i] = drive_index(drives, parallel.actuators[i]);
      pair.joints[i] = joint_index(parallel.joints[i]);
      if (is_taken[pair.drives[i]]) {
        io::refuse("--jacobian",
                   fmt::format("two of them move the joints by the same actuator, \"{}\"",
                               parallel.actuators[i]));
      }
      is_taken[pair.drives[i]] = true;
    }
    pair.parallel = std::move(parallel);
    pairs_.push_back(std::move(pair));
  }
  for (std::size_t i = 0; i < drives.size(); ++i) {
    if (!is_taken[i]) singles_.push_back({joint_index(drives[i].name), i});
  }
}

std::size_t DriveRows::joint_index(const std::string& name) {
  const auto found = std::find(joints_.begin(), joints_.end(), name);
  const auto index = static_cast<std::size_t>(found - joints_.begin());
  if (found == joints_.end()) joints_.push_back(name);
  return index;
}

std::vector<std::size_t> DriveRows::joints_of(std::size_t drive) const {
  for (const Single& single : singles_) {
    if (single.drive == drive) return {single.joint};
  }
  for (const Pair& pair : pairs_) {
    if (pair.drives[0] == drive || pair.drives[1] == drive) {
      return {pair.joints[0], pair.joints[1]};
    }
  }
  return {};
}

void DriveRows::require_positions(const TrajectoryReader& reader) const {
  for (const Pair& pair : pairs_) {
    if (pair.parallel.is_constant()) continue;
    for (const std::size_t joint : pair.joints) {
      if (reader.columns(joint).position) continue;
      io::refuse(file_,
                 fmt::format("joint \"{0}\" has no {0}_position_rad, which the Jacobian \"{1}\" "
                             "is a table over",
                             joints_[joint], pair.parallel.name));
    }
  }
}

void DriveRows::convert(const Row& joints, Row& drives) const {
  drives.time_s = joints.time_s;
  drives.values.assign(kDrivePlaces * drive_count_, 0.0);
  for (const Single& single : singles_) {
    const double* from = &joints.values[kPlaces * single.joint];
    double* to = &drives.values[kDrivePlaces * single.drive];
    to[kDrivePositionAt] = from[kPositionAt];
    to[kDriveSpeedAt] = from[kVelocityAt];
    to[kDriveTorqueAt] = from[kTorqueAt];
  }
  for (const Pair& pair : pairs_) convert_pair(pair, joints, drives);
}

void DriveRows::convert_pair(const Pair& pair, const Row& joints, Row& drives) const {
  const auto both = [&](Place place) {
    return std::array<double, 2>{joints.values[kPlaces * pair.joints[0] + place],
                                 joints.values[kPlaces * pair.joints[1] + place]};
  };
  const auto [first_rad, second_rad] = both(kPositionAt);
  const std::optional<Matrix2> jacobian = jacobian_at(pair.parallel, first_rad, second_rad);
  const auto at_angles = [&, first_rad = first_rad, second_rad = second_rad] {
    return fmt::format("at {} s, where {} is at {:.6g} rad and {} at {:.6g} rad", joints.time_s,
                       pair.parallel.joints[0], first_rad, pair.parallel.joints[1], second_rad);
  };
  if (!jacobian) {
    io::refuse(file_,
               fmt::format("the table of the Jacobian \"{}\" ends before the motion does: {}",
                           pair.parallel.name, at_angles()));
  }
  const auto torques_Nm = actuator_torques(*jacobian, both(kTorqueAt));
  if (!torques_Nm) {
    io::refuse(file_,
               fmt::format("the Jacobian \"{}\" is singular {}", pair.parallel.name, at_angles()));
  }
  const std::array<double, 2> speeds_rad_s = actuator_speeds(*jacobian, both(kVelocityAt));
  for (std::size_t i = 0; i < 2; ++i) {
    drives.values[kDrivePlaces * pair.drives[i] + kDriveSpeedAt] = speeds_rad_s[i];
    drives.values[kDrivePlaces * pair.drives[i] + kDriveTorqueAt] = (*torques_Nm)[i];
  }
}

}  // namespace torquewright::actuator
