// SPDX-License-Identifier: Apache-2.0
#include "identification/preparation/preparation.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "actuator/region/gear_losses.hpp"
#include "actuator/region/torque_at.hpp"
#include "actuator/region/winding.hpp"
#include "identification/log/piece.hpp"
#include "identification/preparation/channel_grid.hpp"
#include "identification/preparation/output_motion.hpp"
#include "identification/preparation/winding_channels.hpp"
#include "identification/signals/direction.hpp"
#include "identification/signals/load_model.hpp"
#include "identification/signals/rest_mask.hpp"
#include "identification/signals/signal.hpp"
#include "identification/signals/signs.hpp"
#include "identification/signals/thinning.hpp"

namespace torquewright::identification {
namespace {

constexpr double kEnabled = 0.99;  ///< Below, the filter has seen a drive that was off.

/// With what rows leave out around a masked sample, 0.3 periods of 8 Hz, the time in which a
/// low-pass of 8 Hz settles to 1 % (LowPass::settling).
constexpr double kAroundOff_s = (1.1 - 0.3) / 8.0;

constexpr double kStickBand = 2.0;       ///< Times the cut-off, where sticking is looked for.
constexpr double kLeastStick_s = 0.005;  ///< A shorter one moves a reversal by less than a sample.
constexpr double kShortestStretch_s = 0.5;
constexpr std::size_t kLeastOfStretch = 16;

constexpr double kAround_s = 1.0;
constexpr std::size_t kThinned = 120;
constexpr double kSameStep = 1e-6;  ///< Relative.

double torque_per_ampere_Nm_A(const actuator::Actuator& actuator) {
  return actuator.transmission.ratio * actuator.motor.torque_constant_Nm_A;
}

/// Everything of an instant but its current, load and state.
std::vector<actuator::Instant> instants(const JointMotion& motion,
                                        const std::vector<double>& direction,
                                        const std::vector<double>& motor_angle_rad,
                                        const std::vector<double>& temperature_K,
                                        const actuator::Actuator& actuator) {
  std::vector<actuator::Instant> all(direction.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    actuator::Instant& at = all[i];
    at.speed_rad_s = motion.velocity_rad_s[i];
    at.direction = direction[i];
    at.acceleration_rad_s2 = motion.acceleration_rad_s2[i];
    at.output_angle_rad = motion.position_rad[i];
    at.motor_angle_rad = motor_angle_rad.empty()
                             ? motion.position_rad[i] * actuator.transmission.ratio
                             : motor_angle_rad[i];
    at.winding_temperature_K = temperature_K[i];
    at.reference_temperature_K = actuator.motor.winding_temperature_K;
  }
  return all;
}

/// But for the one that tells the motion: it would be compared with itself.
void read_logged_speeds(ChannelGrid& grid, const Bench& bench, Signals& signals) {
  const bool is_by_motor = bench.moves_by_velocity && bench.encoders == Encoders::kMotor;
  if (!bench.moves_by_velocity || is_by_motor) {
    signals.logged_velocity_rad_s =
        grid.read_if_any(grid.has(Quantity::kOutputVelocity) ? Quantity::kOutputVelocity
                                                             : Quantity::kLinearVelocity);
  }
  if (!is_by_motor) signals.motor_velocity_rad_s = grid.read_if_any(Quantity::kMotorVelocity);
}

/// Where both sides' positions were logged.
void set_twist(const ChannelGrid& grid, const std::vector<double>& motor_angle_rad, double ratio,
               const JointMotion& motion, Signals& signals) {
  const bool has_output =
      grid.has(Quantity::kOutputPosition) || grid.has(Quantity::kLinearPosition);
  if (motor_angle_rad.empty() || !has_output) return;
  for (std::size_t i = 0; i < motor_angle_rad.size(); ++i) {
    signals.twist_rad.push_back(motor_angle_rad[i] / ratio - motion.position_rad[i]);
  }
  if (grid.is_map()) return;
  signals.motor_acceleration_rad_s2 =
      derivative(derivative(motor_angle_rad, grid.step_s()), grid.step_s());
  for (double& each : signals.motor_acceleration_rad_s2) each /= ratio;
}

/// Of the winding: what is asked of its volts is fast only where they are the drive's channel.
void set_voltage(ChannelGrid& grid, const Bench& bench, Signals& signals) {
  WindingVoltage voltage = winding_voltage(grid, bench.actuator());
  signals.voltage_V = std::move(voltage.filtered_V);
  if (bench.drive == Drive::kVoltage) signals.fast_voltage_V = std::move(voltage.fast_V);
}

/// What a winding's volts have of its current beyond R i: a bridge's dead time, and inductance.
void set_current_beside_voltage(const ChannelGrid& grid, const std::vector<double>& unfiltered_A,
                                const std::vector<double>& current_A, double deviation_A,
                                double cutoff_Hz, Signals& signals) {
  if (signals.voltage_V.empty() || grid.is_map()) return;
  signals.filtered_current_sign =
      grid.filtered(mean_signs_of(unfiltered_A, deviation_A, cutoff_Hz, grid.step_s()));
  signals.current_rate_A_s = derivative(current_A, grid.step_s());
}

std::vector<double> read_drive(ChannelGrid& grid, const Bench& bench, const NoiseLevels& levels,
                               double cutoff_Hz, Signals& signals) {
  if (bench.drive == Drive::kVoltage) return signals.voltage_V;
  const std::vector<double> unfiltered = grid.read_unfiltered(bench.drive_channel);
  std::vector<double> drive = grid.filtered(unfiltered);
  if (bench.drive == Drive::kCurrent) {
    const double deviation_A = levels[static_cast<std::size_t>(bench.drive_channel)];
    set_current_beside_voltage(grid, unfiltered, drive, deviation_A, cutoff_Hz, signals);
  }
  return drive;
}

/// The motor's current by the drive's channel, and its torque at the output by the stated constant.
void set_drive(ChannelGrid& grid, const Bench& bench, const NoiseLevels& levels, double cutoff_Hz,
               Signals& signals) {
  const actuator::Actuator& actuator = bench.actuator();
  const double ratio = actuator.transmission.ratio;
  const actuator::Winding winding = actuator::winding_of(actuator);
  std::vector<double> drive;
  if (bench.drive) drive = read_drive(grid, bench, levels, cutoff_Hz, signals);
  signals.motor_side_Nm.resize(signals.size());
  for (std::size_t i = 0; i < signals.size(); ++i) {
    actuator::Instant& at = signals.at[i];
    if (bench.drive == Drive::kCurrent) at.current_A = drive[i];
    if (bench.drive == Drive::kTorque) at.current_A = drive[i] / torque_per_ampere_Nm_A(actuator);
    if (bench.drive == Drive::kVoltage) {
      at.current_A = (drive[i] - winding.back_emf_V_s_rad * ratio * at.speed_rad_s) /
                     actuator::resistance_ohm(actuator, winding, at);
    }
    signals.motor_side_Nm[i] = torque_per_ampere_Nm_A(actuator) * at.current_A;
  }
}

/// The speed by which direction and rest are told. In a band narrower than the signals' own a rest
/// lasts longer until it shows.
struct SeenSpeed {
  std::vector<double> values_rad_s;
  double cutoff_Hz = 0.0;
  double longer = 1.0;  ///< How many times.
};

SeenSpeed seen_speed(const ChannelGrid& grid, const JointMotion& motion, const RawMotion& raw,
                     double cutoff_Hz) {
  const double seen_Hz = grid.is_map() ? cutoff_Hz : raw.seen_below_Hz(cutoff_Hz);
  if (seen_Hz == cutoff_Hz) return {motion.velocity_rad_s, cutoff_Hz, 1.0};
  return {raw.speed_below(seen_Hz), seen_Hz, cutoff_Hz / seen_Hz};
}

/// Below the seen speed's cut-off; and, where the motion is not imposed and may stick for a moment
/// as it reverses, in a wider band, in which such a rest is not yet smeared.
std::vector<std::uint8_t> rests(const ChannelGrid& grid, const Bench& bench, const SeenSpeed& seen,
                                const RawMotion& raw, double play_rad) {
  std::vector<std::uint8_t> rest =
      rest_mask(seen.values_rad_s, play_rad, grid.step_s(), seen.longer * kStandstill_s);
  if (raw.values.empty() || bench.load_side != LoadSide::kModel) return rest;
  const std::vector<double> wide = raw.speed_below(kStickBand * seen.cutoff_Hz);
  const std::vector<std::uint8_t> sticks =
      rest_mask(wide, play_rad, grid.step_s(), seen.longer * kLeastStick_s);
  for (std::size_t i = 0; i < rest.size(); ++i) rest[i] = rest[i] != 0 || sticks[i] != 0;
  return rest;
}

/// Reads the motion and, unfiltered with its noise, what it comes from.
JointMotion read_own_motion(ChannelGrid& grid, const Bench& bench, const NoiseLevels& levels,
                            RawMotion& raw) {
  JointMotion motion = read_motion(grid, bench.actuator(), bench.moves_by_velocity, &raw);
  raw.is_speed = bench.moves_by_velocity;
  raw.deviation = raw.is_speed ? speed_deviation(bench, levels)
                               : position_play(bench, levels) / kPlayDeviations;
  raw.step_s = grid.step_s();
  return motion;
}

/// How far the output may seem to move by noise alone within the time that makes a rest.
double play_of(const RawMotion& raw, const SeenSpeed& seen) {
  const bool is_by_speed = raw.is_speed || seen.longer > 1.0;
  const double moved =
      is_by_speed ? raw.speed_noise(seen.cutoff_Hz) * kStandstill_s : raw.deviation;
  return kPlayDeviations * moved;
}

/// Marks samples around those where the drive is off: what it did there stays in the filters of an
/// equation until they have settled.
void mask_around_off(const ChannelGrid& grid, const std::vector<double>& enabled,
                     std::vector<std::uint8_t>& usable) {
  const auto around =
      grid.is_map() ? 0 : static_cast<std::size_t>(std::ceil(kAroundOff_s / grid.step_s()));
  std::size_t marked = 0;  // Samples before it were looked at.
  for (std::size_t i = 0; i < enabled.size(); ++i) {
    if (enabled[i] >= kEnabled) continue;
    const std::size_t until = std::min(usable.size(), i + around + 1);
    for (std::size_t k = std::max(marked, i - std::min(i, around)); k < until; ++k) usable[k] = 0;
    marked = until;
  }
}

void set_usable(ChannelGrid& grid, const std::vector<std::uint8_t>& rest, Signals& signals) {
  signals.masked = grid.masked();
  // A drive that is off leaves its winding open: nothing says what the motor does.
  const std::vector<double> enabled = grid.read_if_any(Quantity::kEnabled);
  for (std::size_t i = 0; i < enabled.size(); ++i) {
    if (enabled[i] < kEnabled) signals.masked[i] = 1;
  }
  signals.usable.resize(grid.count());
  for (std::size_t i = 0; i < grid.count(); ++i) {
    signals.usable[i] = signals.masked[i] == 0 && (rest.empty() || rest[i] == 0);
  }
  mask_around_off(grid, enabled, signals.usable);
}

void set_time(const ChannelGrid& grid, Signals& signals) {
  signals.step_s = grid.step_s();
  signals.sample_step_s = grid.is_map() ? 0.0 : grid.step_s();
  signals.start_s = grid.start_s();
  signals.time_s.resize(grid.count());
  for (std::size_t i = 0; i < grid.count(); ++i) {
    const auto sample = static_cast<double>(i);
    signals.time_s[i] = grid.is_map() ? sample : grid.start_s() + sample * grid.step_s();
  }
}

/// Of states, each by itself; 0 of one at rest.
std::vector<double> signs(const std::vector<double>& speeds) {
  std::vector<double> signs;
  for (const double speed : speeds) {
    signs.push_back(speed == 0.0 ? 0.0 : std::copysign(1.0, speed));
  }
  return signs;
}

/// One stretch, still at the raw rate. The order of reads: see ChannelGrid.
Signals raw_signals(ChannelGrid& grid, const Bench& bench, const NoiseLevels& levels,
                    const PreparationOptions& options) {
  const actuator::Actuator& actuator = bench.actuator();
  RawMotion raw;
  const JointMotion motion = read_own_motion(grid, bench, levels, raw);
  const SeenSpeed seen = seen_speed(grid, motion, raw, options.cutoff_Hz);
  const std::vector<double> direction = grid.is_map()
                                            ? signs(motion.velocity_rad_s)
                                            : directions(seen.values_rad_s, raw, seen.cutoff_Hz);
  Signals signals;
  signals.pole_pairs = actuator.motor.pole_pairs;
  signals.is_steady = bench.rig->load.is_steady;
  set_time(grid, signals);
  if (!grid.is_map()) signals.cutoff_Hz = options.cutoff_Hz;
  const std::vector<double> temperature_K = winding_temperature_K(grid, actuator);
  const std::vector<double> motor_angle_rad = grid.read_if_any(Quantity::kMotorPosition);
  signals.at = instants(motion, direction, motor_angle_rad, temperature_K, actuator);
  signals.filtered_direction = grid.filtered(direction);
  set_voltage(grid, bench, signals);
  signals.bus_V = grid.read_if_any(Quantity::kBusVoltage);
  read_logged_speeds(grid, bench, signals);
  set_twist(grid, motor_angle_rad, actuator.transmission.ratio, motion, signals);
  set_drive(grid, bench, levels, options.cutoff_Hz, signals);
  std::vector<std::uint8_t> rest;
  if (bench.rig->load.is_steady && bench.moves_by_velocity) {
    // What friction holds at rest is anything up to its level.
    for (const double each : direction) rest.push_back(each == 0.0);
  }
  if (!grid.is_map()) rest = rests(grid, bench, seen, raw, play_of(raw, seen));
  set_usable(grid, rest, signals);
  const bool is_known =
      bench.drive == Drive::kCurrent || bench.drive == Drive::kVoltage ||
      (bench.drive == Drive::kTorque && bench.drive_channel == Quantity::kReportedTorque);
  if (!signals.bus_V.empty() && is_known) {
    signals.bus_A = bus_current_A(grid, actuator, signals);
  }
  if (bench.load_side == LoadSide::kSensor) signals.load_side_Nm = grid.read(bench.load_channel);
  return signals;
}

JointMotion own_motion(const Signals& signals) {
  JointMotion motion;
  for (const actuator::Instant& at : signals.at) {
    motion.position_rad.push_back(at.output_angle_rad);
    motion.velocity_rad_s.push_back(at.speed_rad_s);
    motion.acceleration_rad_s2.push_back(at.acceleration_rad_s2);
  }
  return motion;
}

/// Of every joint of a serial arm or a robot.
void set_arm(const Run& run, const Bench& bench, const PreparationOptions& options,
             std::mt19937_64& random, Signals& signals) {
  if (!has_joints(bench.rig->load.type)) return;
  for (std::size_t j = 0; j < bench.actuators.size(); ++j) {
    if (j == bench.joint) {
      signals.arm.push_back(own_motion(signals));
      continue;
    }
    ChannelGrid grid(run, j, options, random);
    signals.arm.push_back(read_motion(grid, *bench.actuators[j]));
  }
}

/// With the load's side known, the load that gears carry: never from the measured target itself.
void set_loads(Signals& signals, const Bench& bench) {
  const actuator::Actuator& actuator = bench.actuator();
  const bool is_sensor = bench.load_side == LoadSide::kSensor;
  for (std::size_t i = 0; i < signals.size(); ++i) {
    actuator::Instant& at = signals.at[i];
    if (is_sensor) {
      at.load_torque_Nm = actuator::output_torque_Nm(actuator, at);
    } else if (!signals.load_side_Nm.empty()) {
      at.load_torque_Nm = signals.load_side_Nm[i];
    }
  }
}

bool is_long_enough(const Run& run) {
  if (run.masked.size() < kLeastOfStretch) return false;
  return run.time_s.empty() || run.time_s.back() - run.time_s.front() >= kShortestStretch_s;
}

/// Of samples, so that the rate does not fall below the least. The pieces of a stretch, whose steps
/// differ by round-off, all get the same.
std::size_t thinning_factor(double step_s, double least_rate_Hz, bool is_piece) {
  const double factor = 1.0 / (step_s * least_rate_Hz);
  return static_cast<std::size_t>(
      std::max(1.0, std::floor(is_piece ? factor * (1.0 + kSameStep) : factor)));
}

/// Samples around a piece: so long that nothing of the slowest filter's settling, nor of what is
/// masked at ends, reaches into it. A multiple of what signals and rows are usually thinned by.
std::size_t samples_around(const RunHead& head) {
  if (head.is_map || head.samples < 2) return 0;
  const double step_s = (head.end_s - head.begin_s) / static_cast<double>(head.samples - 1);
  return kThinned * static_cast<std::size_t>(std::ceil(kAround_s / step_s / kThinned));
}

/// In samples that were thinned by a factor, the first at or behind `sample`.
std::size_t thinned(std::size_t sample, std::size_t factor) {
  return (sample + factor - 1) / factor;
}

}  // namespace

std::optional<Signals> prepare_run(const Log& log, std::size_t index, const Bench& bench,
                                   const NoiseLevels& levels, const PreparationOptions& options,
                                   std::mt19937_64& random) {
  const RunHead& head = log.runs.head(index);
  const Piece piece = with_neighbours(log.runs, index, samples_around(head));
  const Run& run = piece.run;
  if (!is_long_enough(run)) return std::nullopt;
  ChannelGrid grid(run, bench.joint, options, random);
  Signals signals = raw_signals(grid, bench, levels, options);
  signals.run = index;
  signals.run_name = head.name;
  set_arm(run, bench, options, random, signals);
  if (bench.load_side == LoadSide::kModel) {
    signals.load_side_Nm = model_load_Nm(*bench.rig, bench.joint, signals);
  }
  const bool is_piece = head.continues || piece.end < run.masked.size();
  std::size_t factor = 1;
  if (!grid.is_map()) {
    factor = thinning_factor(signals.step_s, options.least_rate_Hz, is_piece);
    thin(signals, factor);
  }
  set_loads(signals, bench);
  signals.core_begin = thinned(grid.sample_of(piece.begin), factor);
  signals.core_end = thinned(grid.sample_of(piece.end), factor);
  return signals;
}

std::vector<Signals> prepare(const Log& log, const Bench& bench, const NoiseLevels& levels,
                             const PreparationOptions& options) {
  std::vector<Signals> all;
  std::mt19937_64 random(options.seed);
  for (std::size_t r = 0; r < log.runs.size(); ++r) {
    auto signals = prepare_run(log, r, bench, levels, options, random);
    if (signals) all.push_back(*std::move(signals));
  }
  return all;
}

}  // namespace torquewright::identification
