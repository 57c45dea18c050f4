// SPDX-License-Identifier: Apache-2.0
#include "actuator/exporters/line_law.hpp"

#include <algorithm>
#include <cmath>

#include "actuator/region/motor_region.hpp"

namespace torquewright::actuator {

Parallelogram parallelogram_of(std::span<const double> shape) {
  return {shape[0], shape[1], shape[2]};
}

namespace {

/// The line of a curve: full torque up to its corner, then straight to where it ends; no steeper
/// than over a thousandth of its speeds.
Shape line_of_curve(const Subject& subject) {
  constexpr double kFull = 1.0 - 1e-3;  // of the peak: up to the corner
  constexpr double kSteepest = 1e-3;    // of the last speed
  const double end_rad_s = subject.region.greatest_speed_rad_s();
  const double peak_Nm = subject.table.peak_torque_Nm;
  double corner_rad_s = 0.0;
  for (const MorRow& row : subject.table.rows) {
    const bool is_full = !row.range.is_empty && row.range.greatest.torque_Nm >= kFull * peak_Nm;
    if (is_full) corner_rad_s = std::max(corner_rad_s, row.speed_rad_s);
  }
  const double falling_rad_s = std::max(end_rad_s - corner_rad_s, kSteepest * end_rad_s);
  return {peak_Nm * end_rad_s / falling_rad_s, end_rad_s, peak_Nm};
}

}  // namespace

Shape line_start(const Subject& subject) {
  const PhaseModel& model = subject.region.model();
  if (model.envelope) return line_of_curve(subject);
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
