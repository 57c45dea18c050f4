// SPDX-License-Identifier: Apache-2.0
#include "actuator/exporters/plateau_start.hpp"

#include <algorithm>

#include "actuator/exporters/line_law.hpp"

namespace torquewright::actuator {

Plateaus plateaus_of(const Subject& subject) {
  const Shape line = line_start(subject);
  const JointRange forward = subject.region.at(0.0, 1.0);
  const JointRange backward = subject.region.at(0.0, -1.0);
  // Positive even where friction leaves nothing to drive with: a start has to be.
  const double floor_Nm = 1e-3 * line[2];
  Plateaus plateaus;
  plateaus.drive_Nm =
      std::max(floor_Nm, std::min(forward.greatest.torque_Nm, -backward.least.torque_Nm));
  plateaus.brake_Nm =
      std::max(floor_Nm, std::min(-forward.least.torque_Nm, backward.greatest.torque_Nm));
  plateaus.no_load_rad_s = line[1];
  plateaus.knee_rad_s = line[1] * std::max(1e-3, 1.0 - plateaus.drive_Nm / line[0]);
  return plateaus;
}

}  // namespace torquewright::actuator
