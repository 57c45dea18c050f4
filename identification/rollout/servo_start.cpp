// SPDX-License-Identifier: Apache-2.0
#include "identification/rollout/servo_start.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "identification/log/delayed.hpp"
#include "identification/rollout/free_values.hpp"
#include "identification/rollout/parabola.hpp"
#include "identification/rollout/windows.hpp"
#include "identification/simulated/rig_plant.hpp"

namespace torquewright::identification {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kMoving_rad_s = 0.05;  ///< Less is rest, where friction holds what it will.
constexpr double kLatestTried_s = 0.12, kTriedBy_s = 0.01;
constexpr double kTold = 5.0;          ///< Standard errors of 1/gain.
constexpr double kGain_Nm_rad = 20.0;  ///< Where nothing at all says one.
constexpr Index kColumns = 5;          ///< Bodies' torque, acceleration, speed, direction, one.
enum Column : Index { kTorque, kAcceleration, kSpeed, kDirection };

/// Of one joint, what the law's lead and the robot's motion say, row by row, for several delays.
struct Evidence {
  std::vector<MatrixXd> power;  ///< (columns + lead) squared, by delay.
  double rows = 0.0;
};

struct Ratios {
  VectorXd values = VectorXd::Zero(kColumns);
  VectorXd errors = VectorXd::Zero(kColumns);
  double left = 0.0;  ///< Sum of squares.
};

/// Least squares in which the first four are not negative.
Ratios ratios_of(const MatrixXd& power, double rows) {
  Ratios ratios;
  std::vector<Index> used = {0, 1, 2, 3, 4};
  for (;;) {
    const auto count = static_cast<Index>(used.size());
    MatrixXd own(count, count);
    VectorXd right(count);
    for (Index a = 0; a < count; ++a) {
      right[a] = power(used[static_cast<std::size_t>(a)], kColumns);
      for (Index b = 0; b < count; ++b) {
        own(a, b) = power(used[static_cast<std::size_t>(a)], used[static_cast<std::size_t>(b)]);
      }
      own(a, a) *= 1.0 + 1e-12;
    }
    const Eigen::LDLT<MatrixXd> factor(own);
    const VectorXd found = factor.solve(right);
    Index least = -1;
    for (Index a = 0; a < count; ++a) {
      const bool is_signed = used[static_cast<std::size_t>(a)] == kColumns - 1;
      if (!is_signed && found[a] < 0.0 && (least < 0 || found[a] < found[least])) least = a;
    }
    if (least >= 0) {
      used.erase(used.begin() + least);
      continue;
    }
    ratios.left = std::max(0.0, power(kColumns, kColumns) - found.dot(right));
    const MatrixXd spread = factor.solve(MatrixXd::Identity(count, count));
    for (Index a = 0; a < count; ++a) {
      const Index column = used[static_cast<std::size_t>(a)];
      ratios.values[column] = found[a];
      ratios.errors[column] = std::sqrt(spread(a, a) * ratios.left / std::max(rows, 1.0));
    }
    return ratios;
  }
}

std::vector<double> delays_s(const RobotModel& model) {
  const bool finds = std::any_of(model.controllers.begin(), model.controllers.end(),
                                 [](const JointController& each) { return each.finds_delay; });
  std::vector<double> delays;
  for (double late = 0.0; finds && late < kLatestTried_s; late += kTriedBy_s)
    delays.push_back(late);
  if (!finds) delays.push_back(model.controllers.front().delay_s);
  return delays;
}

class ServoStart {
 public:
  ServoStart(const Log& log, const RobotModel& stated)
      : log_(log), model_(stated), delays_s_(delays_s(stated)), joints_(stated.drives.size()) {
    for (Evidence& each : joints_) {
      each.power.assign(delays_s_.size(), MatrixXd::Zero(kColumns + 1, kColumns + 1));
    }
  }

  RobotModel found() {
    for (std::size_t run = 0; run < log_.runs.size(); ++run) {
      if (!is_held_out(log_, log_.runs.head(run).name)) read(log_.runs[run]);
    }
    const std::size_t delay = best_delay();
    std::vector<Ratios> ratios;
    for (const Evidence& each : joints_) ratios.push_back(ratios_of(each.power[delay], each.rows));
    for (JointController& each : model_.controllers) {
      if (each.finds_delay) each.delay_s = delays_s_[delay];
    }
    set_gains(ratios);
    return std::move(model_);
  }

 private:
  void read(const Run& run) {
    const std::size_t count = run.time_s.size();
    if (count < 8) return;
    const std::size_t half = half_of_parabola(run.time_s);
    const std::size_t stride = std::max<std::size_t>(1, half / 2);
    const std::unique_ptr<simulation::Plant> plant = plant_of(model_.load);
    const std::vector<std::vector<std::vector<double>>> commands = late_commands(run);
    for (std::size_t at = half; at + half < count; at += stride) {
      if (is_masked(run, at, half)) continue;
      add_sample(run, *plant, commands, at, half);
    }
  }

  static bool is_masked(const Run& run, std::size_t at, std::size_t half) {
    const auto begin = run.masked.begin() + static_cast<std::ptrdiff_t>(at - half);
    return std::any_of(begin, begin + static_cast<std::ptrdiff_t>(2 * half + 1),
                       [](std::uint8_t each) { return each != 0; });
  }

  /// By joint and delay.
  std::vector<std::vector<std::vector<double>>> late_commands(const Run& run) const {
    std::vector<std::vector<std::vector<double>>> commands(joints_.size());
    for (std::size_t joint = 0; joint < joints_.size(); ++joint) {
      for (const double late_s : delays_s_) {
        commands[joint].push_back(
            delayed(run.time_s, run.joints[joint][Quantity::kCommandedPosition], late_s));
      }
    }
    return commands;
  }

  void add_sample(const Run& run, simulation::Plant& plant,
                  const std::vector<std::vector<std::vector<double>>>& commands, std::size_t at,
                  std::size_t half) {
    const auto count = static_cast<Index>(joints_.size());
    VectorXd position(count), speed(count), acceleration(count), torque(count);
    for (Index i = 0; i < count; ++i) {
      const auto joint = static_cast<std::size_t>(i);
      const Motion now =
          parabola(run.time_s, run.joints[joint][Quantity::kOutputPosition], at, half);
      position[i] = now.position_rad;
      speed[i] = now.speed_rad_s;
      acceleration[i] = now.acceleration_rad_s2;
    }
    MatrixXd mass(count, count);
    plant.mass_matrix(position, mass);
    plant.bias(position, speed, torque);
    torque += mass * acceleration;
    for (Index i = 0; i < count; ++i) {
      if (std::abs(speed[i]) < kMoving_rad_s) continue;
      Evidence& evidence = joints_[static_cast<std::size_t>(i)];
      VectorXd row(kColumns + 1);
      row << torque[i], acceleration[i], speed[i], std::copysign(1.0, speed[i]), 1.0, 0.0;
      for (std::size_t d = 0; d < delays_s_.size(); ++d) {
        row[kColumns] =
            parabola(run.time_s, commands[static_cast<std::size_t>(i)][d], at, half).position_rad -
            position[i];
        evidence.power[d] += row * row.transpose();
      }
      ++evidence.rows;
    }
  }

  /// Shares of what each joint's lead is, so that none outweighs the others.
  std::size_t best_delay() const {
    std::size_t best = 0;
    double least = 0.0;
    for (std::size_t d = 0; d < delays_s_.size(); ++d) {
      double left = 0.0;
      for (const Evidence& each : joints_) {
        const double whole = each.power.front()(kColumns, kColumns);
        if (whole > 0.0) left += ratios_of(each.power[d], each.rows).left / whole;
      }
      if (d > 0 && left >= least) continue;
      best = d;
      least = left;
    }
    return best;
  }

  /// Of joints whose gain is told; the middle one of them.
  double told_gain(const std::vector<Ratios>& ratios) const {
    std::vector<double> told;
    for (std::size_t joint = 0; joint < joints_.size(); ++joint) {
      const Ratios& own = ratios[joint];
      if (!model_.controllers[joint].finds_stiffness) continue;
      if (own.values[kTorque] > kTold * own.errors[kTorque] && own.values[kTorque] > 0.0)
        told.push_back(1.0 / own.values[kTorque]);
    }
    if (told.empty()) return 0.0;
    std::nth_element(told.begin(), told.begin() + static_cast<std::ptrdiff_t>(told.size() / 2),
                     told.end());
    return told[told.size() / 2];
  }

  double gain_of(std::size_t joint, const Ratios& own, double of_others) const {
    const JointController& stated = model_.controllers[joint];
    if (own.values[kTorque] > kTold * own.errors[kTorque] && own.values[kTorque] > 0.0)
      return 1.0 / own.values[kTorque];
    if (stated.states_stiffness && stated.law.stiffness_Nm_rad > 0.0)
      return stated.law.stiffness_Nm_rad;
    if (of_others > 0.0) return of_others;
    const double rotor_kg_m2 = rotor_at_output(joint);
    if (rotor_kg_m2 > 0.0 && own.values[kAcceleration] > 0.0)
      return rotor_kg_m2 / own.values[kAcceleration];
    return kGain_Nm_rad;
  }

  double rotor_at_output(std::size_t joint) const {
    const actuator::Actuator& drive = model_.drives[joint];
    return drive.motor.rotor_inertia_kg_m2 * drive.transmission.ratio * drive.transmission.ratio;
  }

  void set_gains(const std::vector<Ratios>& ratios) {
    const double of_others = told_gain(ratios);
    const std::vector<FreeValue> values = free_values(model_);
    for (std::size_t joint = 0; joint < joints_.size(); ++joint) {
      JointController& controller = model_.controllers[joint];
      if (!controller.finds_stiffness || joints_[joint].rows < 10.0) continue;
      const double gain = gain_of(joint, ratios[joint], of_others);
      controller.law.stiffness_Nm_rad = gain;
      const double ratio = model_.drives[joint].transmission.ratio;
      for (const FreeValue& each : values) {
        if (each.joint != joint) continue;
        const VectorXd& own = ratios[joint].values;
        const auto set = [&](double value) {
          set_value(model_, each, std::max(each.lowest, value));
        };
        if (each.of == FreeValue::Of::kRotor) set(gain * own[kAcceleration] / (ratio * ratio));
        if (each.name == "viscous_Nm_s_rad")
          set(gain * own[kSpeed] - controller.law.damping_Nm_s_rad);
        if (each.name == "coulomb_Nm") set(gain * own[kDirection]);
      }
    }
  }

  const Log& log_;
  RobotModel model_;
  std::vector<double> delays_s_;
  std::vector<Evidence> joints_;
};

}  // namespace

RobotModel servo_start(const Log& log, const RobotModel& stated) {
  return ServoStart(log, stated).found();
}

}  // namespace torquewright::identification
