// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "actuator/exporters/exporter.hpp"

namespace torquewright::actuator {

/// What laws with plateaus are fitted from, the same for both directions of motion.
struct Plateaus {
  double drive_Nm;       ///< Along the motion, just off rest.
  double brake_Nm;       ///< Against it.
  double knee_rad_s;     ///< Up to which the motor alone drives with drive_Nm.
  double no_load_rad_s;  ///< Of the motor alone.
};
Plateaus plateaus_of(const Subject& subject);

}  // namespace torquewright::actuator
