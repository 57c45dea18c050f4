// SPDX-License-Identifier: Apache-2.0
#include "identification/robot/base_motion.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>

#include "actuator/heat/temperature_laws.hpp"
#include "actuator/region/torque_at.hpp"
#include "identification/log/delayed.hpp"
#include "identification/rollout/parabola.hpp"
#include "identification/simulated/rig_plant.hpp"

namespace torquewright::identification {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kLeastCorrelation = 0.6, kLeastShare = 0.3;
constexpr double kLeastTilt_rad = 0.01;  ///< 0.1 m/s2 of push: less is any stand's.
constexpr double kTurning_rad_s = 0.05, kTurn_rad = 1e-3;
constexpr std::size_t kLeastSamples = 100;
/// Of a half's equations: a turn that its joints hardly feel is not read from them.
constexpr double kRidge = 0.05;

/// What is left at the joints at one instant, and what a turn of the base would do there.
struct SwayInstant {
  VectorXd left_Nm;
  MatrixXd by_turn_Nm;      ///< (joints x 2) Roll and pitch, per rad.
  std::vector<bool> moves;  ///< At rest friction holds what it will.
};

class SwayReader {
 public:
  explicit SwayReader(const RobotModel& model) : model_(model), plant_(plant_of(model.load)) {
    Load rolled = model.load, pitched = model.load;
    rolled.roll_rad += kTurn_rad;
    pitched.pitch_rad += kTurn_rad;
    turned_.push_back(plant_of(rolled));
    turned_.push_back(plant_of(pitched));
  }

  SwayInstant at(const Run& run, const std::vector<std::vector<double>>& commands,
                 std::size_t sample, std::size_t half) const {
    const auto count = static_cast<Index>(model_.drives.size());
    VectorXd position(count), speed(count), acceleration(count), bias(count);
    for (Index i = 0; i < count; ++i) {
      const auto joint = static_cast<std::size_t>(i);
      const Motion now =
          parabola(run.time_s, run.joints[joint][Quantity::kOutputPosition], sample, half);
      position[i] = now.position_rad + model_.offset_rad[joint];
      speed[i] = now.speed_rad_s;
      acceleration[i] = now.acceleration_rad_s2;
    }
    SwayInstant instant{VectorXd(count), MatrixXd(count, 2), {}};
    MatrixXd mass(count, count);
    plant_->mass_matrix(position, mass);
    plant_->bias(position, speed, bias);
    const VectorXd bodies = bias + mass * acceleration;
    for (Index turn = 0; turn < 2; ++turn) {
      VectorXd turned(count);
      turned_[static_cast<std::size_t>(turn)]->bias(position, speed, turned);
      instant.by_turn_Nm.col(turn) = (turned - bias) / kTurn_rad;
    }
    for (Index i = 0; i < count; ++i) {
      const auto joint = static_cast<std::size_t>(i);
      const double command = parabola(run.time_s, commands[joint], sample, half).position_rad;
      instant.left_Nm[i] =
          of_drive_Nm(joint, command, position[i], speed[i], acceleration[i]) - bodies[i];
      instant.moves.push_back(std::abs(speed[i]) > kTurning_rad_s);
    }
    return instant;
  }

 private:
  double of_drive_Nm(std::size_t joint, double command_rad, double position_rad, double speed_rad_s,
                     double acceleration_rad_s2) const {
    const actuator::Actuator& drive = model_.drives[joint];
    actuator::Instant at =
        actuator::at_winding_temperature(drive, drive.motor.winding_temperature_K);
    at.speed_rad_s = speed_rad_s;
    at.direction = speed_rad_s < 0.0 ? -1.0 : 1.0;
    at.output_angle_rad = position_rad;
    const double ratio = drive.transmission.ratio;
    return model_.controllers[joint].law.torque_Nm(command_rad + model_.offset_rad[joint],
                                                   position_rad, speed_rad_s) +
           actuator::drag_Nm(drive, at) -
           drive.motor.rotor_inertia_kg_m2 * ratio * ratio * acceleration_rad_s2;
  }

  const RobotModel& model_;
  std::unique_ptr<simulation::Plant> plant_;
  std::vector<std::unique_ptr<simulation::Plant>> turned_;
};

/// The turn that some joints show: least squares, held towards none.
Eigen::Vector2d turn_of(const SwayInstant& instant, const std::vector<std::size_t>& joints,
                        double ridge) {
  Eigen::Matrix2d power = ridge * Eigen::Matrix2d::Identity();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  for (const std::size_t joint : joints) {
    if (!instant.moves[joint]) continue;
    const auto i = static_cast<Index>(joint);
    const Eigen::Vector2d row = instant.by_turn_Nm.row(i).transpose();
    power += row * row.transpose();
    right += row * instant.left_Nm[i];
  }
  return power.ldlt().solve(right);
}

std::vector<SwayInstant> sway_instants(const Run& run, const RobotModel& model,
                                       const SwayReader& reader) {
  std::vector<SwayInstant> instants;
  const std::size_t half = half_of_parabola(run.time_s);
  std::vector<std::vector<double>> commands;
  for (std::size_t joint = 0; joint < model.drives.size(); ++joint) {
    commands.push_back(delayed(run.time_s, run.joints[joint][Quantity::kCommandedPosition],
                               model.controllers[joint].delay_s));
  }
  for (std::size_t at = half; at + half < run.time_s.size(); at += half) {
    const auto begin = run.masked.begin() + static_cast<std::ptrdiff_t>(at - half);
    const auto end = begin + static_cast<std::ptrdiff_t>(2 * half + 1);
    if (std::any_of(begin, end, [](std::uint8_t each) { return each != 0; })) continue;
    instants.push_back(reader.at(run, commands, at, half));
  }
  return instants;
}

/// Less its mean: one that stays is how the base hung.
void center_turns(std::vector<Eigen::Vector2d>& turns) {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& each : turns) mean += each / static_cast<double>(turns.size());
  for (Eigen::Vector2d& each : turns) each -= mean;
}

struct SwaySums {
  double first = 0.0, second = 0.0, both = 0.0, left = 0.0, taken = 0.0;
  std::size_t samples = 0;
};

void add_sway(const std::vector<SwayInstant>& instants,
              const std::array<std::vector<std::size_t>, 3>& of, SwaySums& sums) {
  double feel = 0.0;
  for (const SwayInstant& each : instants) feel += each.by_turn_Nm.squaredNorm();
  const double ridge =
      kRidge * feel / static_cast<double>(std::max<std::size_t>(1, instants.size()));
  std::array<std::vector<Eigen::Vector2d>, 3> turns;
  for (std::size_t part = 0; part < 3; ++part) {
    for (const SwayInstant& each : instants) turns[part].push_back(turn_of(each, of[part], ridge));
    if (!turns[part].empty()) center_turns(turns[part]);
  }
  for (std::size_t k = 0; k < instants.size(); ++k) {
    sums.first += turns[0][k].squaredNorm();
    sums.second += turns[1][k].squaredNorm();
    sums.both += turns[0][k].dot(turns[1][k]);
    for (std::size_t joint = 0; joint < instants[k].moves.size(); ++joint) {
      if (!instants[k].moves[joint]) continue;
      const auto i = static_cast<Index>(joint);
      const double left = instants[k].left_Nm[i];
      const double after = left - instants[k].by_turn_Nm.row(i).dot(turns[2][k]);
      sums.left += left * left;
      sums.taken += left * left - after * after;
    }
    ++sums.samples;
  }
}

}  // namespace

bool BaseMotion::moves() const {
  return correlation > kLeastCorrelation && share > kLeastShare && tilt_rad > kLeastTilt_rad;
}

BaseMotion base_motion(const Log& log, const RobotModel& fitted) {
  const std::vector<Limb> limbs = limbs_of(fitted.load);
  if (limbs.size() < 2) return {};
  std::array<std::vector<std::size_t>, 3> parts;  // one half, the other, all
  for (std::size_t limb = 0; limb < limbs.size(); ++limb) {
    for (const std::size_t joint : limbs[limb].joints) {
      parts[limb % 2].push_back(joint);
      parts[2].push_back(joint);
    }
  }
  const SwayReader reader(fitted);
  SwaySums sums;
  for (const Run& run : log.runs) {
    if (run.time_s.size() < 8) continue;
    add_sway(sway_instants(run, fitted, reader), parts, sums);
  }
  if (sums.samples < kLeastSamples || !(sums.first * sums.second > 0.0)) return {};
  BaseMotion motion;
  motion.correlation = sums.both / std::sqrt(sums.first * sums.second);
  motion.tilt_rad = std::sqrt(std::max(0.0, sums.both) / static_cast<double>(sums.samples));
  motion.share = sums.left > 0.0 ? sums.taken / sums.left : 0.0;
  return motion;
}

}  // namespace torquewright::identification
