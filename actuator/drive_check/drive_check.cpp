// SPDX-License-Identifier: Apache-2.0
#include "actuator/drive_check/drive_check.hpp"

#include <algorithm>
#include <cmath>

#include "actuator/region/torque_at.hpp"

namespace torquewright::actuator {

DriveCheck::DriveCheck(const CheckedDrive& drive, const DriveOptions& options)
    : name_(drive.name),
      options_(options),
      conditions_(drive.conditions),
      basis_(*drive.actuator, drive.conditions),
      armature_kg_m2_(reflected_inertia_kg_m2(*drive.actuator)),
      interpretation_(basis_, !options.only_verdict),
      left_out_(*drive.actuator, options.part) {
  const bool is_open = options.inertia == InertiaConvention::kUnstated && armature_kg_m2_ > 0.0;
  if (is_open && options.has_torque) with_inertia_.emplace(basis_, !options.only_verdict);
  report_.name = drive.name;
  report_.actuator = drive.actuator->name;
  report_.armature_kg_m2 = armature_kg_m2_;
  report_.has_torque = options.has_torque;
  report_.inertia = options.inertia;
  report_.no_load_speed_rad_s =
      no_load_speed_rad_s(basis_.lookup.model()) / std::abs(drive.actuator->transmission.ratio);
  report_.left_out = left_out(*drive.actuator, options.part);
  report_.assumed = drive.actuator->assumed;
}

void DriveCheck::set_bus_voltage_V(double voltage_V) {
  if (!held_) held_ = held_region(basis_, conditions_);
  const RegionLookup lookup(held_, voltage_V, basis_.temperature_K);
  interpretation_.use(lookup);
  if (with_inertia_) with_inertia_->use(lookup);
}

void DriveCheck::add(double time_s, std::optional<double> position_rad, double speed_rad_s,
                     double torque_Nm, double acceleration_rad_s2) {
  if (report_.samples++ == 0) report_.from_s = time_s;
  report_.until_s = time_s;
  report_.peak_speed_rad_s = std::max(report_.peak_speed_rad_s, std::abs(speed_rad_s));
  if (!options_.has_torque) return note_speed(time_s, speed_rad_s);
  const double rotor_Nm = armature_kg_m2_ * acceleration_rad_s2;
  const bool is_excluded = options_.inertia == InertiaConvention::kExcluded;
  const double read_Nm = is_excluded ? torque_Nm + rotor_Nm : torque_Nm;
  const bool is_outside = interpretation_.add(time_s, speed_rad_s, read_Nm, acceleration_rad_s2);
  left_out_.add({time_s, position_rad, speed_rad_s, read_Nm, acceleration_rad_s2});
  if (with_inertia_) {
    with_inertia_->add(time_s, speed_rad_s, torque_Nm + rotor_Nm, acceleration_rad_s2);
  }
  if (options_.keep_trace) trace_.add({time_s, speed_rad_s, read_Nm, is_outside});
}

/// Without torque only a speed at which nothing is possible can be told.
void DriveCheck::note_speed(double time_s, double speed_rad_s) {
  if (!basis_.lookup.near(speed_rad_s).is_empty) return;
  ++report_.impossible_speeds;
  if (report_.limiting_speed_rad_s &&
      std::abs(*report_.limiting_speed_rad_s) >= std::abs(speed_rad_s)) {
    return;
  }
  report_.limiting_speed_rad_s = speed_rad_s;
  report_.limiting_time_s = time_s;
}

DriveReport DriveCheck::finish() const {
  DriveReport report = report_;
  if (!options_.has_torque) {
    report.verdict = report.impossible_speeds > 0 ? Verdict::kFail : Verdict::kUndecided;
    return report;
  }
  report.interpretation = interpretation_.finish(options_.runs, options_.pause_s);
  const bool as_it_stands = fails(report.interpretation);
  report.verdict = as_it_stands ? Verdict::kFail : Verdict::kPass;
  report.effects_left_out = left_out_.finish();
  if (some_outweigh(report.effects_left_out, report.interpretation)) {
    report.verdict = Verdict::kUndecided;
  }
  if (!with_inertia_) return report;
  report.with_inertia = with_inertia_->finish(options_.runs, options_.pause_s);
  if (fails(*report.with_inertia) != as_it_stands) report.verdict = Verdict::kUndecided;
  return report;
}

}  // namespace torquewright::actuator
