// SPDX-License-Identifier: Apache-2.0
#include "identification/replay/replay.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "identification/simulated/rig_plant.hpp"
#include "simulation/run/simulate.hpp"

namespace torquewright::identification {
namespace {

constexpr double kWindow_s = 1.0;
constexpr double kSettling_s = 0.1;  ///< Of the filters, at both ends of a stretch.
constexpr double kStep_s = 2e-3;
constexpr int kRestSamples = 3;  ///< In a row: a reversal has fewer.

bool is_at_rest(const actuator::Instant& at) { return std::abs(at.direction) < 1.0; }

/// For longer than the sample in which a motion reverses.
bool rests(std::vector<actuator::Instant>::const_iterator begin,
           std::vector<actuator::Instant>::const_iterator end) {
  int together = 0;
  for (auto at = begin; at != end && together < kRestSamples; ++at) {
    together = is_at_rest(*at) ? together + 1 : 0;
  }
  return together >= kRestSamples;
}

void add_windows(const Signals& stretch, ReplayWindow window, std::vector<ReplayWindow>& windows) {
  if (!(stretch.step_s > 0.0)) return;
  const auto length = static_cast<std::size_t>(std::lround(kWindow_s / stretch.step_s));
  const auto margin = static_cast<std::size_t>(std::ceil(kSettling_s / stretch.step_s));
  for (std::size_t first = margin; first + length + margin < stretch.size(); first += length) {
    const auto begin = static_cast<std::ptrdiff_t>(first);
    const auto end = static_cast<std::ptrdiff_t>(first + length + 1);
    if (std::any_of(stretch.masked.begin() + begin, stretch.masked.begin() + end,
                    [](std::uint8_t each) { return each != 0; })) {
      continue;
    }
    window.first = first;
    window.last = first + length;
    window.rests = rests(stretch.at.begin() + begin, stretch.at.begin() + end);
    windows.push_back(window);
  }
}

/// The drive of a window, from its first sample on.
simulation::Excitation excitation_of(const Bench& bench, const Signals& stretch,
                                     const ReplayWindow& window, double offset_A) {
  simulation::JointDrive drive;
  drive.kind = bench.drive == Drive::kVoltage ? simulation::DriveKind::kVoltage
                                              : simulation::DriveKind::kCurrent;
  simulation::Excitation excitation;
  for (std::size_t i = window.first; i <= window.last; ++i) {
    excitation.time_s.push_back(stretch.time_s[i]);
    drive.value.push_back(bench.drive == Drive::kVoltage ? stretch.voltage_V[i]
                                                         : stretch.at[i].current_A - offset_A);
    drive.winding_K.push_back(stretch.at[i].winding_temperature_K);
  }
  excitation.joints.push_back(std::move(drive));
  return excitation;
}

/// Half the gap, on the side on which the motor drives the load.
double motor_ahead_rad(const actuator::Actuator& actuator, double load_Nm) {
  for (const actuator::Effect& effect : actuator.effects) {
    if (effect.kind->in_train != actuator::TrainPart::kGap) continue;
    return std::copysign(effect.kind->twist_rad(effect, 1.0), load_Nm);
  }
  return 0.0;
}

}  // namespace

std::vector<ReplayWindow> replay_windows(const std::vector<Signals>& signals,
                                         const std::vector<bool>& held_out, std::size_t most) {
  std::vector<ReplayWindow> all;
  for (std::size_t s = 0; s < signals.size(); ++s) {
    ReplayWindow window;
    window.stretch = s;
    window.is_held_out = held_out[signals[s].run];
    add_windows(signals[s], window, all);
  }
  if (all.size() <= most) return all;
  std::vector<ReplayWindow> spread;
  for (std::size_t k = 0; k < most; ++k) spread.push_back(all[k * all.size() / most]);
  return spread;
}

Replay::Replay(const Bench& bench, const std::vector<Signals>& signals, double offset_A)
    : bench_(bench), signals_(signals), offset_A_(offset_A) {
  for (const Signals& stretch : signals) {
    plants_.push_back(plant_of(load_of(*bench.rig, stretch.run_name)));
  }
}

bool Replay::can_replay(const Bench& bench) {
  const LoadType load = bench.rig->load.type;
  return bench.drive && load != LoadType::kDynamometer && !has_joints(load);
}

Eigen::VectorXd Replay::errors(const actuator::Actuator& actuator,
                               const ReplayWindow& window) const {
  const Signals& stretch = signals_[window.stretch];
  const actuator::Instant& from = stretch.at[window.first];
  simulation::JointStart start;
  start.position_rad = from.output_angle_rad;
  start.speed_rad_s = is_at_rest(from) ? 0.0 : from.speed_rad_s;
  start.motor_ahead_rad = motor_ahead_rad(actuator, stretch.load_side_Nm[window.first]);
  const bool sees_motor = bench_.encoders == Encoders::kMotor;
  if (sees_motor) start.position_rad -= start.motor_ahead_rad;
  simulation::SimulationOptions options;
  options.longest_step_s = kStep_s;
  const simulation::SimulatedRun simulated =
      simulation::simulate(*plants_[window.stretch], {&actuator},
                           excitation_of(bench_, stretch, window, offset_A_), {start}, options);
  const simulation::JointTrace& trace = simulated.joints[0];
  const std::vector<double>& position = sees_motor ? trace.motor_position_rad : trace.position_rad;
  const double per_rad = sees_motor ? 1.0 / actuator.transmission.ratio : 1.0;
  const std::size_t count = window.last - window.first + 1;
  Eigen::VectorXd errors(static_cast<Eigen::Index>(count));
  for (std::size_t k = 0; k < count; ++k) {
    const bool there = k < position.size() && std::isfinite(position[k]);
    const double measured = stretch.at[window.first + k].output_angle_rad;
    errors[static_cast<Eigen::Index>(k)] =
        there ? per_rad * position[k] - measured : std::numbers::pi;
  }
  return errors;
}

}  // namespace torquewright::identification
