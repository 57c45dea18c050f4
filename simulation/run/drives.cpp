// SPDX-License-Identifier: Apache-2.0
#include "simulation/run/drives.hpp"

#include <algorithm>

namespace torquewright::simulation {

double between(const std::vector<double>& values, std::size_t knot, double share) {
  const std::size_t next = std::min(knot + 1, values.size() - 1);
  return values[knot] + share * (values[next] - values[knot]);
}

DriveNow drive_at(const JointDrive& joint, std::size_t knot, double share) {
  DriveNow drive{joint.kind, between(joint.value, knot, share), joint.position_gain_1_rad, {}, {},
                 joint.law};
  if (!joint.bus_V.empty()) drive.bus_V = between(joint.bus_V, knot, share);
  if (!joint.enabled.empty() && joint.enabled[knot] < 0.5) {
    drive.kind = DriveKind::kCurrent;
    drive.value = 0.0;
  }
  return drive;
}

std::vector<DriveNow> drives_at(const Excitation& excitation, std::size_t knot, double share) {
  std::vector<DriveNow> drives;
  drives.reserve(excitation.joints.size());
  for (const JointDrive& joint : excitation.joints) drives.push_back(drive_at(joint, knot, share));
  return drives;
}

}  // namespace torquewright::simulation
