// SPDX-License-Identifier: Apache-2.0
#include "identification/preparation/output_motion.hpp"

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>

#include "identification/log/spread_runs.hpp"
#include "identification/signals/signal.hpp"

namespace torquewright::identification {
namespace {

constexpr double kDrift_Hz = 0.5;

std::vector<double> divided(std::vector<double> values, double by) {
  for (double& value : values) value /= by;
  return values;
}

/// Before the filter. Empty where no position was logged.
std::vector<double> read_position(ChannelGrid& grid, double ratio) {
  for (const Quantity quantity : {Quantity::kOutputPosition, Quantity::kLinearPosition}) {
    if (grid.has(quantity)) return grid.read_unfiltered(quantity);
  }
  if (!grid.has(Quantity::kMotorPosition)) return {};
  return divided(grid.read_unfiltered(Quantity::kMotorPosition), ratio);
}

/// Before the filter.
std::vector<double> read_velocity(ChannelGrid& grid, double ratio) {
  for (const Quantity quantity : {Quantity::kOutputVelocity, Quantity::kLinearVelocity}) {
    if (grid.has(quantity)) return grid.read_unfiltered(quantity);
  }
  return divided(grid.read_unfiltered(Quantity::kMotorVelocity), ratio);
}

/// By the trapezoidal rule. Only differences of the angle mean something then.
std::vector<double> integrated(const std::vector<double>& velocity, double step_s) {
  std::vector<double> position(velocity.size(), 0.0);
  for (std::size_t i = 1; i < velocity.size(); ++i) {
    position[i] = position[i - 1] + 0.5 * (velocity[i - 1] + velocity[i]) * step_s;
  }
  return position;
}

/// The velocity's integral where it is fast, and the position where that would drift: below a
/// frequency of which every block of evidence (1.5 s) still holds most of a period.
std::vector<double> guided(std::vector<double> position, const std::vector<double>& moved,
                           double step_s) {
  for (std::size_t i = 0; i < moved.size(); ++i) position[i] -= moved[i];
  LowPass(kDrift_Hz, 1.0 / step_s).apply(position);
  for (std::size_t i = 0; i < moved.size(); ++i) position[i] += moved[i];
  return position;
}

constexpr double kBandOfEquations_Hz = 8.0;
/// Noise that is white in fifth differences may be three times as much in the band.
constexpr double kMuchLess = 3.0;
constexpr double kErrors = 3.0;
constexpr double kSameScale = 0.005;  ///< Beyond errors: what no sensor is better than.

struct Shaft {
  Quantity position, velocity;
};

/// The one whose position tells the output's; nothing where its velocity was not logged.
std::optional<Shaft> shaft_with_both(const Channels& channels) {
  for (const Shaft& shaft : {Shaft{Quantity::kOutputPosition, Quantity::kOutputVelocity},
                             Shaft{Quantity::kLinearPosition, Quantity::kLinearVelocity},
                             Shaft{Quantity::kMotorPosition, Quantity::kMotorVelocity}}) {
    if (!channels.has(shaft.position)) continue;
    return channels.has(shaft.velocity) ? std::optional(shaft) : std::nullopt;
  }
  return std::nullopt;
}

bool has_velocity(const Channels& channels) {
  return channels.has(Quantity::kOutputVelocity) || channels.has(Quantity::kLinearVelocity) ||
         channels.has(Quantity::kMotorVelocity);
}

/// Least squares of dq/dt = scale v + early dv/dt, all below the band of the equations.
class VelocityAgainstPosition {
 public:
  void add(const Log& log, std::size_t run, std::size_t joint, const Shaft& shaft) {
    const Run& rows = log.runs[run];
    if (rows.time_s.size() < kLeastRows) return;
    PreparationOptions options;
    options.cutoff_Hz = kBandOfEquations_Hz;
    std::mt19937_64 unused;
    ChannelGrid grid(rows, joint, options, unused);
    const std::vector<double> derived = derivative(grid.read(shaft.position), grid.step_s());
    const std::vector<double> speed = grid.read(shaft.velocity);
    const std::vector<double> rate = derivative(speed, grid.step_s());
    step_s_ = std::max(step_s_, grid.step_s());
    const double independent = std::min(1.0, 2.0 * kBandOfEquations_Hz * grid.step_s());
    const std::size_t edge = LowPass(options.cutoff_Hz, 1.0 / grid.step_s()).settling();
    for (std::size_t i = edge; i + edge < speed.size(); ++i) {
      if (grid.masked()[i] != 0) continue;
      const Eigen::Vector2d row(speed[i], rate[i]);
      squares_ += independent * row * row.transpose();
      products_ += independent * row * derived[i];
      total_ += independent * derived[i] * derived[i];
      samples_ += independent;
    }
  }

  bool agree() const {
    if (samples_ < kFewest) return false;
    const Eigen::Matrix2d inverse = squares_.inverse();
    const Eigen::Vector2d found = inverse * products_;
    const double left = std::max(0.0, total_ - found.dot(products_)) / samples_;
    const double scale_error = std::sqrt(left * inverse(0, 0));
    const double early_error_s = std::sqrt(left * inverse(1, 1));
    return std::isfinite(early_error_s) &&
           std::abs(found[0] - 1.0) <= kErrors * scale_error + kSameScale &&
           std::abs(found[1]) <= kErrors * early_error_s + 0.5 * step_s_;
  }

 private:
  static constexpr std::size_t kLeastRows = 16;
  static constexpr double kFewest = 10.0;  ///< Independent samples.
  Eigen::Matrix2d squares_ = Eigen::Matrix2d::Zero();
  Eigen::Vector2d products_ = Eigen::Vector2d::Zero();
  double total_ = 0.0, samples_ = 0.0, step_s_ = 0.0;
};

}  // namespace

JointMotion read_motion(ChannelGrid& grid, const actuator::Actuator& actuator, bool by_velocity,
                        RawMotion* raw) {
  const double ratio = actuator.transmission.ratio;
  JointMotion motion;
  motion.position_rad = read_position(grid, ratio);
  const bool is_known = !motion.position_rad.empty();
  if (raw != nullptr && !by_velocity) raw->values = motion.position_rad;
  if (is_known && !by_velocity) motion.position_rad = grid.filtered(motion.position_rad);
  if (grid.is_map()) {
    motion.velocity_rad_s =
        by_velocity ? read_velocity(grid, ratio) : std::vector<double>(grid.count(), 0.0);
    motion.acceleration_rad_s2.assign(grid.count(), 0.0);
    motion.position_rad.resize(grid.count(), 0.0);
    return motion;
  }
  if (is_known && !by_velocity) {
    motion.velocity_rad_s = derivative(motion.position_rad, grid.step_s());
  } else {
    std::vector<double> speed = read_velocity(grid, ratio);
    motion.velocity_rad_s = grid.filtered(speed);
    if (raw != nullptr && by_velocity) raw->values = std::move(speed);
    const std::vector<double> moved = integrated(motion.velocity_rad_s, grid.step_s());
    motion.position_rad = is_known ? guided(motion.position_rad, moved, grid.step_s()) : moved;
  }
  motion.acceleration_rad_s2 = derivative(motion.velocity_rad_s, grid.step_s());
  return motion;
}

bool tells_motion_better(const Log& log, const Bench& bench, const NoiseLevels& levels) {
  if (bench.rig->load.is_steady) return has_velocity(log.runs.front().joints[bench.joint]);
  const auto shaft = shaft_with_both(log.runs.front().joints[bench.joint]);
  if (!shaft || log.runs.head(0).is_map) return false;
  const double position = levels[static_cast<std::size_t>(shaft->position)];
  const double velocity = levels[static_cast<std::size_t>(shaft->velocity)];
  const double derived =
      position * 2.0 * std::numbers::pi * kBandOfEquations_Hz / std::numbers::sqrt3;
  if (kMuchLess * velocity >= derived) return false;
  VelocityAgainstPosition both;
  for (const std::size_t run : spread_runs(log.runs)) both.add(log, run, bench.joint, *shaft);
  return both.agree();
}

}  // namespace torquewright::identification
