// SPDX-License-Identifier: Apache-2.0
#include "identification/forward/torque_prediction.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "actuator/effects/acting.hpp"
#include "actuator/region/gear_losses.hpp"
#include "actuator/region/torque_at.hpp"
#include "identification/forward/backlash_residual.hpp"
#include "identification/forward/drive_side.hpp"
#include "identification/forward/histories.hpp"
#include "identification/preparation/balance.hpp"
#include "identification/signals/load_model.hpp"
#include "identification/signals/signal.hpp"

namespace torquewright::identification {
namespace {

using actuator::Acts;
using actuator::Actuator;
using actuator::Instant;

constexpr double kMostTurnsPerSample = 0.5;  ///< Of a wave: faster, it would fold.
constexpr double kMostGain = 20.0;           ///< Of a mesh that nearly locks.

/// What drives, moves and loads a stretch, each as it was before its channel was late.
struct Motion {
  std::vector<Instant> at;
  std::vector<double> drive;  ///< Ampere, or volt.
  std::vector<double> load_Nm;
  std::vector<double> motor_acceleration_rad_s2;
  double drive_late_s = 0.0;
};

double delay_of_motion_s(const Hypothesis& hypothesis) {
  double delay_s = 0.0;
  for (const Quantity each :
       {Quantity::kOutputPosition, Quantity::kOutputVelocity, Quantity::kLinearPosition,
        Quantity::kLinearVelocity, Quantity::kMotorPosition, Quantity::kMotorVelocity}) {
    delay_s += hypothesis.log.delay_s[static_cast<std::size_t>(each)];
  }
  return delay_s;
}

template <typename Field>
void advance_field(std::vector<Instant>& at, Field Instant::*field, double delay_s, double step_s) {
  std::vector<double> values(at.size());
  for (std::size_t i = 0; i < at.size(); ++i) values[i] = at[i].*field;
  values = advanced(values, delay_s, step_s);
  for (std::size_t i = 0; i < at.size(); ++i) at[i].*field = values[i];
}

void advance_motion(std::vector<Instant>& at, double delay_s, double step_s) {
  for (auto field : {&Instant::speed_rad_s, &Instant::acceleration_rad_s2,
                     &Instant::output_angle_rad, &Instant::motor_angle_rad, &Instant::direction}) {
    advance_field(at, field, delay_s, step_s);
  }
}

bool is_same_load(const Rig& a, const Rig& b) { return a.load == b.load && a.loads == b.loads; }

std::vector<double> load_of(const Bench& bench, const Hypothesis& hypothesis,
                            const Signals& signals) {
  if (bench.load_side == LoadSide::kSensor || is_same_load(hypothesis.rig, *bench.rig)) {
    return signals.load_side_Nm;
  }
  return model_load_Nm(hypothesis.rig, bench.joint, signals);
}

Motion motion_of(const Bench& bench, const Hypothesis& hypothesis, const Signals& signals) {
  Motion motion{
      signals.at, {}, load_of(bench, hypothesis, signals), signals.motor_acceleration_rad_s2, 0.0};
  motion.drive.resize(signals.size());
  const bool is_filtered = !signals.filtered_direction.empty();
  for (std::size_t i = 0; i < signals.size(); ++i) {
    if (is_filtered) motion.at[i].direction = signals.filtered_direction[i];
    motion.drive[i] =
        bench.drive == Drive::kVoltage ? signals.voltage_V[i] : signals.at[i].current_A;
  }
  const double step_s = signals.step_s;
  const double moved_s = delay_of_motion_s(hypothesis);
  if (moved_s != 0.0) {
    advance_motion(motion.at, moved_s, step_s);
    if (!motion.motor_acceleration_rad_s2.empty()) {
      motion.motor_acceleration_rad_s2 =
          advanced(motion.motor_acceleration_rad_s2, moved_s, step_s);
    }
    if (bench.load_side == LoadSide::kModel)
      motion.load_Nm = advanced(motion.load_Nm, moved_s, step_s);
  }
  const auto& delay_s = hypothesis.log.delay_s;
  motion.drive_late_s =
      delay_s[static_cast<std::size_t>(bench.drive_channel)] + hypothesis.log.instant_s;
  if (motion.drive_late_s != 0.0) {
    motion.drive = advanced(motion.drive, motion.drive_late_s, step_s);
  }
  if (bench.load_side == LoadSide::kSensor) {
    const double load_s = delay_s[static_cast<std::size_t>(bench.load_channel)];
    if (load_s != 0.0) motion.load_Nm = advanced(motion.load_Nm, load_s, step_s);
  }
  return motion;
}

/// Torque after over torque before the mesh, by whether the motor drives; the same at every load.
struct Mesh {
  double driving, driven;
  explicit Mesh(const Actuator& actuator)
      : driving(std::min(kMostGain, actuator::after_mesh_Nm(actuator, 1.0, 1.0))),
        driven(std::min(kMostGain, actuator::after_mesh_Nm(actuator, 1.0, -1.0))) {}
  double after(double before_Nm, double direction) const {
    return before_Nm * (before_Nm * direction > 0.0 ? driving : driven);
  }
  double before(double after_Nm, double direction) const {
    return after_Nm / (after_Nm * direction > 0.0 ? driving : driven);
  }
};

/// The mean over both directions by their shares of the instant's time; leaves it in the last one.
template <typename Law>
double over_directions(Instant& at, const Law& law) {
  const double forward = 0.5 * (1.0 + at.direction);
  double sum = 0.0;
  if (forward != 0.0) {
    at.direction = 1.0;
    sum += forward * law(at);
  }
  if (forward != 1.0) {
    at.direction = -1.0;
    sum += (1.0 - forward) * law(at);
  }
  return sum;
}

/// Torque at the output by its angle: what is there without a load, and in proportion to it.
struct Ripple {
  double alone_Nm = 0.0, per_load = 0.0;
};
Ripple ripple_of(const Actuator& actuator, Instant at) {
  at.load_torque_Nm = 0.0;
  const double alone_Nm = actuator::ripple_Nm(actuator, at);
  at.load_torque_Nm = 1.0;
  return {alone_Nm, actuator::ripple_Nm(actuator, at) - alone_Nm};
}

bool acts_on_output(const Actuator& actuator) {
  return std::any_of(
      actuator.effects.begin(), actuator.effects.end(),
      [](const actuator::Effect& each) { return each.kind->acts == Acts::kOutputTorque; });
}

/// What gravity adds on the output beyond the rig's model.
double imbalance_Nm(const Hypothesis& hypothesis, double angle_rad) {
  if (hypothesis.imbalance_sine_Nm == 0.0 && hypothesis.imbalance_cosine_Nm == 0.0) return 0.0;
  return hypothesis.imbalance_sine_Nm * std::sin(angle_rad) +
         hypothesis.imbalance_cosine_Nm * std::cos(angle_rad);
}

/// Removes what a gap between motor and output does, where one is supposed and can be felt.
void subtract_gap(const Bench& bench, const Hypothesis& hypothesis, const Signals& signals,
                  std::vector<double>& balance_Nm) {
  for (const actuator::Effect& effect : hypothesis.actuator.effects) {
    const bool is_gap = effect.kind->in_train == actuator::TrainPart::kGap;
    if (!is_gap || effect.values[0] <= 0.0 || !shows_backlash(bench)) continue;
    Bench with_gap = bench;
    with_gap.in_gap = std::make_shared<const Actuator>(hypothesis.actuator);
    const std::vector<double> gap_Nm =
        backlash_residual_Nm(Balance(with_gap), effect.values[0], signals);
    for (std::size_t i = 0; i < balance_Nm.size(); ++i) balance_Nm[i] -= gap_Nm[i];
  }
}

/// An actuator whose waves are as large as the signals' low-pass leaves them, and as nothing where
/// they turn so fast that they would fold.
class SeenWaves {
 public:
  SeenWaves(const Actuator& actuator, const Signals& signals)
      : all_(actuator), seen_(actuator), step_s_(signals.step_s) {
    if (signals.cutoff_Hz > 0.0) filter_.emplace(signals.cutoff_Hz, 1.0 / signals.sample_step_s);
    has_waves_ = std::any_of(all_.effects.begin(), all_.effects.end(),
                             [](const auto& effect) { return !effect.harmonics.empty(); });
  }

  /// Valid until the next call.
  const Actuator& at(double speed_rad_s) {
    if (!has_waves_) return all_;
    for (std::size_t e = 0; e < all_.effects.size(); ++e) {
      const actuator::Effect& effect = all_.effects[e];
      for (std::size_t h = 0; h < effect.harmonics.size(); ++h) {
        const actuator::Harmonic& wave = effect.harmonics[h];
        seen_.effects[e].harmonics[h].amplitude =
            wave.amplitude * gain(turns_per_rad(effect, wave) * std::abs(speed_rad_s));
      }
    }
    return seen_;
  }

 private:
  double turns_per_rad(const actuator::Effect& effect, const actuator::Harmonic& wave) const {
    const bool is_of_motor = effect.kind->acts == Acts::kMotorSideTorque;
    return wave.order * (is_of_motor ? std::abs(all_.transmission.ratio) : 1.0) /
           (2.0 * std::numbers::pi);
  }
  double gain(double frequency_Hz) const {
    if (frequency_Hz * step_s_ > kMostTurnsPerSample) return 0.0;
    return filter_ ? filter_->gain(frequency_Hz) : 1.0;
  }

  const Actuator& all_;
  Actuator seen_;
  double step_s_;
  std::optional<LowPass> filter_;
  bool has_waves_ = false;
};

}  // namespace

std::vector<double> torque_balance_Nm(const Bench& bench, const Hypothesis& hypothesis,
                                      const Signals& signals) {
  Motion motion = motion_of(bench, hypothesis, signals);
  const std::size_t n = signals.size();
  const bool is_sensor = bench.load_side == LoadSide::kSensor;
  const DriveSide drive(bench, hypothesis, signals, motion.drive, motion.at, motion.drive_late_s);
  std::vector<double> motor_Nm(n), stated_per_own(n, 1.0);
  for (std::size_t i = 0; i < n; ++i) {
    Instant& at = motion.at[i];
    motor_Nm[i] = drive.motor_Nm(i, at);
    if (!is_sensor) stated_per_own[i] = drive.stated_over_own_slope(i, at);
  }
  const std::vector<double> histories_Nm = torque_of_histories_Nm(
      hypothesis.actuator, motion.at, motor_Nm, signals.step_s, signals.cutoff_Hz);
  const Mesh mesh(hypothesis.actuator);
  const double inertia_kg_m2 = actuator::reflected_inertia_kg_m2(hypothesis.actuator);
  std::vector<double> balance_Nm(n);
  const bool has_ripple = acts_on_output(hypothesis.actuator);
  SeenWaves waves(hypothesis.actuator, signals);
  for (std::size_t i = 0; i < n; ++i) {
    Instant& at = motion.at[i];
    const Actuator& actuator = waves.at(at.speed_rad_s);
    const double imbalance = imbalance_Nm(hypothesis, at.output_angle_rad);
    const double acceleration_rad_s2 = motion.motor_acceleration_rad_s2.empty()
                                           ? at.acceleration_rad_s2
                                           : motion.motor_acceleration_rad_s2[i];
    const double smooth_Nm = motor_Nm[i] + histories_Nm[i] +
                             actuator::periodic_motor_torque_Nm(actuator, at) -
                             inertia_kg_m2 * acceleration_rad_s2;
    if (is_sensor) {
      const double predicted_Nm = over_directions(at, [&](Instant& now) {
        now.load_torque_Nm =
            mesh.after(smooth_Nm + actuator::drag_Nm(actuator, now), now.direction);
        return now.load_torque_Nm + actuator::ripple_Nm(actuator, now);
      });
      balance_Nm[i] =
          motion.load_Nm[i] - hypothesis.log.torque_offset_Nm - imbalance - predicted_Nm;
      continue;
    }
    const Ripple ripple = has_ripple ? ripple_of(actuator, at) : Ripple{};
    const double load_Nm =
        (motion.load_Nm[i] - imbalance - ripple.alone_Nm - hypothesis.log.torque_offset_Nm) /
        (1.0 + ripple.per_load);
    balance_Nm[i] = over_directions(at,
                                    [&](const Instant& now) {
                                      return mesh.before(load_Nm, now.direction) -
                                             actuator::drag_Nm(actuator, now);
                                    }) -
                    smooth_Nm;
    balance_Nm[i] *= stated_per_own[i];
  }
  subtract_gap(bench, hypothesis, signals, balance_Nm);
  return balance_Nm;
}

}  // namespace torquewright::identification
