// SPDX-License-Identifier: Apache-2.0
#include "identification/reading/against_actuator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "actuator/motor/convention.hpp"
#include "actuator/region/torque_at.hpp"
#include "identification/log/largest_values.hpp"
#include "identification/log/log.hpp"
#include "identification/reading/agreement.hpp"
#include "identification/reading/channel.hpp"
#include "identification/reading/remedy.hpp"
#include "io/faults/spec_error.hpp"

namespace torquewright::identification {
namespace {

constexpr double kRadPerDegree = std::numbers::pi / 180.0;
/// A few samples may be anything.
constexpr double kUpperEnd = 0.999;
/// No drive's current is so far beyond its limit; a log in mA is, unless it shows less than 2 %.
constexpr double kMilliamperes = 20.0;
constexpr double kBeyondPeak = 1.5;
/// What a test bench or field weakening may reach; rpm read as rad/s goes beyond it from 21 % of
/// the no-load speed on.
constexpr double kBeyondNoLoad = 2.0;
/// Field weakening or a falling load do not reach so far beyond the no-load speed; degrees do,
/// unless the log shows less than 9 %.
constexpr double kDegrees = 5.0;
constexpr double kClear = 0.8;
constexpr double kSuspect = 0.5;
/// Between what drives and how fast it turns: on a swing they may be a quarter period apart.
constexpr double kSuspectDrive = 0.3;
constexpr std::size_t kFewestWindows = 50;

/// Of the joint, from the bus voltage and the back-EMF alone.
double no_load_speed_rad_s(const actuator::Actuator& actuator) {
  const actuator::CurrentConvention convention = actuator.motor.torque_constant_convention;
  const double phase_V = actuator.drive.bus_voltage_V *
                         actuator::phase_volts_per_bus_volt(convention, actuator.drive.modulation);
  const double back_emf_V_s_rad = actuator::back_emf_constant_V_s_rad(actuator) *
                                  actuator::phase_volts_per_winding_volt(convention);
  return phase_V / back_emf_V_s_rad / std::abs(actuator.transmission.ratio);
}

class Comparison {
 public:
  Comparison(Log& log, const Rig& rig) : log_(log), rig_(rig) {}

  void joint(std::size_t joint, const actuator::Actuator& actuator) {
    joint_ = joint;
    const double sign = actuator.transmission.ratio < 0.0 ? -1.0 : 1.0;
    check_current(actuator);
    check_speed(actuator, Quantity::kOutputPosition, Quantity::kOutputVelocity, 1.0);
    check_speed(actuator, Quantity::kMotorPosition, Quantity::kMotorVelocity,
                std::abs(actuator.transmission.ratio));
    check_velocity(actuator, Quantity::kOutputVelocity, 1.0);
    check_velocity(actuator, Quantity::kMotorVelocity, std::abs(actuator.transmission.ratio));
    check_motor_side(Quantity::kMotorPosition, Quantity::kOutputPosition, sign);
    check_motor_side(Quantity::kMotorVelocity, Quantity::kOutputVelocity, sign);
    for (const Quantity torque : {Quantity::kOutputTorque, Quantity::kReportedTorque}) {
      check_torque(torque, Quantity::kMotorCurrent, sign);
      check_torque(torque, Quantity::kCommandedTorque, 1.0);
    }
    check_drive(sign);
  }

  void finish() {
    if (!faults_.empty()) throw io::SpecError(std::move(faults_));
  }

 private:
  void warn(std::string sentence) {
    log_.findings.push_back({Weight::kWarning, std::move(sentence)});
  }
  void refuse(Quantity quantity, std::string message) {
    faults_.push_back({rig_.file, path_of({joint_, quantity}, rig_), std::move(message)});
  }
  bool is_uncertain(const char* pointer) const {
    return std::find(rig_.uncertain.begin(), rig_.uncertain.end(), pointer) != rig_.uncertain.end();
  }
  std::string name(Quantity quantity) const { return describe({joint_, quantity}, rig_); }
  bool has(const Run& run, Quantity quantity) const { return run.joints[joint_].has(quantity); }
  const std::vector<double>& values(const Run& run, Quantity quantity) const {
    return run.joints[joint_][quantity];
  }

  /// The magnitude that nearly all samples of all runs stay below, of what `values` says of a run.
  template <typename Values>
  double upper_end(Quantity quantity, const Values& values) const {
    if (!log_.runs.has(joint_, quantity)) return 0.0;
    LargestValues largest(log_.runs.rows(), kUpperEnd);
    for (const Run& run : log_.runs) {
      for (const double value : values(run)) largest.add(std::abs(value));
    }
    return largest.count() > 0 ? largest.quantile(kUpperEnd) : 0.0;
  }

  void check_current(const actuator::Actuator& actuator) {
    const double reached_A = upper_end(Quantity::kMotorCurrent, [&](const Run& run) {
      return values(run, Quantity::kMotorCurrent);
    });
    const double peak_A = actuator.drive.peak_current_A;
    if (reached_A > kMilliamperes * peak_A) {
      refuse(Quantity::kMotorCurrent,
             fmt::format("{} reaches {:.4g} A, the drive's peak is {:.4g} A: it looks like mA; {}",
                         name(Quantity::kMotorCurrent), reached_A, peak_A,
                         remedy({joint_, Quantity::kMotorCurrent}, rig_, 0.001)));
    } else if (reached_A > kBeyondPeak * peak_A) {
      warn(
          fmt::format("{} reaches {:.4g} A, beyond the {:.4g} A of the drive's peak_current_A; is "
                      "it in the convention of the torque constant?",
                      name(Quantity::kMotorCurrent), reached_A, peak_A));
    }
  }

  void check_speed(const actuator::Actuator& actuator, Quantity position, Quantity velocity,
                   double ratio) {
    const double reached_rad_s = upper_end(position, [&](const Run& run) {
      if (run.time_s.empty() || !has(run, position)) return std::vector<double>();
      return slopes(run, values(run, position), values(run, position)).slope;
    });
    const double limit_rad_s = kDegrees * no_load_speed_rad_s(actuator) * ratio;
    if (reached_rad_s <= limit_rad_s) return;
    const bool both = log_.runs.has(joint_, velocity);
    const std::string sentence = fmt::format(
        "d({})/dt reaches {:.4g} rad/s, {:.1f} times the actuator's no-load speed: it looks like "
        "degrees; {}{}",
        name(position), reached_rad_s, kDegrees * reached_rad_s / limit_rad_s,
        remedy({joint_, position}, rig_, kRadPerDegree), both ? ", and the velocity's alike" : "");
    if (is_uncertain("/motor/torque_constant_Nm_A")) {
      warn(sentence);
    } else {
      refuse(position, sentence);
    }
  }

  /// A velocity without a position that could show its unit.
  void check_velocity(const actuator::Actuator& actuator, Quantity velocity, double ratio) {
    const double reached_rad_s = upper_end(velocity, [&](const Run& run) {
      return has(run, velocity) ? values(run, velocity) : std::vector<double>();
    });
    const double no_load = no_load_speed_rad_s(actuator) * ratio;
    if (reached_rad_s <= kBeyondNoLoad * no_load) return;
    const io::Unit rpm = *io::find_unit("rpm"), degrees = *io::find_unit("deg/s");
    const bool may_be_rpm = reached_rad_s * rpm.in_SI <= kBeyondNoLoad * no_load;
    const io::Unit& unit = may_be_rpm ? rpm : degrees;
    const std::string sentence = fmt::format(
        "{} reaches {:.4g} rad/s, {:.1f} times the actuator's no-load speed: it looks like {}; "
        "{}",
        name(velocity), reached_rad_s, reached_rad_s / no_load, unit.name,
        remedy_by_unit({joint_, velocity}, rig_, unit));
    if (reached_rad_s <= kDegrees * no_load || is_uncertain("/motor/torque_constant_Nm_A")) {
      warn(sentence);
    } else {
      refuse(velocity, sentence);
    }
  }

  /// Over all runs: `second` times `sign` against `first`.
  Agreement compare(Quantity first, Quantity second, double sign, bool as_slopes) const {
    AgreementSums sums;
    if (!log_.runs.has(joint_, first) || !log_.runs.has(joint_, second)) return sums.result();
    for (const Run& run : log_.runs) {
      if (!has(run, first) || !has(run, second)) continue;
      if (as_slopes && run.time_s.empty()) continue;
      Means both = as_slopes ? slopes_of_both(run, first, second)
                             : means(run, values(run, first), values(run, second));
      for (double& value : both.second) value *= sign;
      sums.add(both.first, both.second);
    }
    return sums.result();
  }

  Means slopes_of_both(const Run& run, Quantity first, Quantity second) const {
    return {slopes(run, values(run, first), values(run, first)).slope,
            slopes(run, values(run, second), values(run, second)).slope};
  }

  void check_motor_side(Quantity motor, Quantity output, double sign) {
    const Agreement found = compare(motor, output, sign, motor == Quantity::kMotorPosition);
    if (found.samples < kFewestWindows || found.correlation > -kClear) return;
    refuse(motor,
           fmt::format("{} moves against {} (correlation {:.2f}), though the gearbox's ratio "
                       "is {}; {}",
                       name(motor), name_of(output), found.correlation,
                       sign > 0.0 ? "positive" : "negative", remedy({joint_, motor}, rig_, -1.0)));
  }

  void check_torque(Quantity torque, Quantity drive, double sign) {
    const Agreement found = compare(torque, drive, sign, false);
    if (found.samples < kFewestWindows || found.correlation > -kSuspect) return;
    warn(fmt::format(
        "{} goes against {} (correlation {:.2f}): a torque of the wrong sign is "
        "suspected; it must be what the actuator exerts on the load. If so, {}; if the torque is "
        "right, the sign of {} is wrong: {}",
        name(torque), name_of(drive), found.correlation, remedy({joint_, torque}, rig_, -1.0),
        name_of(drive), remedy({joint_, drive}, rig_, -1.0)));
  }

  /// On a load that only stores and loses energy the drive puts in more than it takes back.
  void check_drive(double sign) {
    if (rig_.load.type == LoadType::kDynamometer) return;
    constexpr std::array kDrives = {Quantity::kMotorCurrent, Quantity::kReportedTorque,
                                    Quantity::kOutputTorque};
    for (const Quantity drive : kDrives) {
      if (!log_.runs.has(joint_, drive) || !log_.runs.has(joint_, Quantity::kOutputPosition)) {
        continue;
      }
      AgreementSums sums;
      for (const Run& run : log_.runs) {
        if (run.time_s.empty() || !has(run, drive) || !has(run, Quantity::kOutputPosition))
          continue;
        Slopes both = slopes(run, values(run, Quantity::kOutputPosition), values(run, drive));
        for (double& value : both.mean) value *= drive == Quantity::kMotorCurrent ? sign : 1.0;
        sums.add(both.slope, both.mean);
      }
      const Agreement found = sums.result();
      if (found.samples < kFewestWindows || found.correlation > -kSuspectDrive) continue;
      warn(
          fmt::format("{} works against the motion all in all (correlation with the speed {:.2f}), "
                      "which a load that only stores and loses energy does not allow: a wrong sign "
                      "is suspected",
                      name(drive), found.correlation));
    }
  }

  Log& log_;
  const Rig& rig_;
  std::size_t joint_ = 0;
  std::vector<io::Fault> faults_;
};

}  // namespace

void check_against(Log& log, const Rig& rig, const std::vector<actuator::Actuator>& actuators) {
  Comparison comparison(log, rig);
  for (std::size_t joint = 0; joint < std::min(rig.joints.size(), actuators.size()); ++joint) {
    comparison.joint(joint, actuators[joint]);
  }
  comparison.finish();
}

}  // namespace torquewright::identification
