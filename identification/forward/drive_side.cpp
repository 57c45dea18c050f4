// SPDX-License-Identifier: Apache-2.0
#include "identification/forward/drive_side.hpp"

#include <algorithm>

#include "actuator/region/torque_at.hpp"
#include "actuator/region/winding.hpp"
#include "identification/signals/signal.hpp"

namespace torquewright::identification {
namespace {

using actuator::Instant;

constexpr double kLeastSlope = 0.05;  ///< Of the stated one.
constexpr double kSlopeStep = 1e-3;   ///< Of the peak current, or of what the bus would drive.

double torque_at_current_Nm(const actuator::Actuator& actuator, double current_A, Instant& at) {
  at.current_A = current_A;
  return actuator::motor_torque_Nm(actuator, at);
}

/// Of what a sensor says.
Currents true_currents(const LogErrors& log, const std::vector<double>& measured_A) {
  Currents currents;
  for (const double each_A : measured_A) {
    const double current_A = each_A - log.current_offset_A;
    const double gain = current_A < 0.0 ? log.negative_current_gain : log.positive_current_gain;
    currents.current_A.push_back(current_A / gain);
    currents.per_unit.push_back(1.0 / gain);
  }
  return currents;
}

}  // namespace

DriveSide::DriveSide(const Bench& bench, const Hypothesis& hypothesis, const Signals& signals,
                     const std::vector<double>& drive, const std::vector<Instant>& at,
                     double late_s)
    : actuator_(hypothesis.actuator), is_voltage_(bench.drive == Drive::kVoltage) {
  const actuator::Actuator& stated = bench.actuator();
  stated_slope_ = stated.transmission.ratio * stated.motor.torque_constant_Nm_A;
  if (!is_voltage_) {
    step_A_ = kSlopeStep * stated.drive.peak_current_A;
    currents_ = true_currents(hypothesis.log, drive);
    return;
  }
  const double stated_ohm = actuator::winding_of(stated).resistance_ohm;
  stated_slope_ /= stated_ohm;
  step_A_ = kSlopeStep * stated.drive.bus_voltage_V / stated_ohm;
  currents_ = winding_currents(bench, actuator_, signals, drive, at, late_s);
  if (hypothesis.winding_late_s > 0.0) {
    currents_.current_A = advanced(currents_.current_A, -hypothesis.winding_late_s, signals.step_s);
  }
}

double DriveSide::motor_Nm(std::size_t i, Instant& at) const {
  return torque_at_current_Nm(actuator_, currents_.current_A[i], at);
}

double DriveSide::stated_over_own_slope(std::size_t i, Instant at) const {
  const double own_A = currents_.current_A[i];
  const double above_Nm = torque_at_current_Nm(actuator_, own_A + step_A_, at);
  const double below_Nm = torque_at_current_Nm(actuator_, own_A - step_A_, at);
  const double per_A = 0.5 * (above_Nm - below_Nm) / step_A_;
  const double share = per_A * currents_.per_unit[i] / stated_slope_;
  // The bridge's dead band yields nothing; that says nothing of the rest.
  return 1.0 / std::max(share, is_voltage_ ? kLeastSlope : kLeastSlope * kLeastSlope);
}

}  // namespace torquewright::identification
