// SPDX-License-Identifier: Apache-2.0
#include "actuator/exporters/line_law.hpp"

#include <cmath>

#include "actuator/region/motor_region.hpp"

namespace torquewright::actuator {

Parallelogram parallelogram_of(std::span<const double> shape) {
  return {shape[0], shape[1], shape[2]};
}

Shape line_start(const Subject& subject) {
  const PhaseModel& model = subject.region.model();
  const double ratio = std::abs(subject.ratio());
  const double phase_V = model.phase_volts_per_bus_volt * subject.bus_voltage_V();
  const double stall_Nm = model.torque_constant_Nm_A * phase_V / model.resistance_ohm;
  return {ratio * stall_Nm, no_load_speed_rad_s(model) / ratio, subject.table.peak_torque_Nm};
}

TorqueLimits line_law(std::span<const double> shape, double speed_rad_s) {
  const Interval interval = limits(parallelogram_of(shape), speed_rad_s);
  return {interval.least_Nm, interval.greatest_Nm};
}

}  // namespace torquewright::actuator
