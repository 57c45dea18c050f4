// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/mujoco_bench/balance.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/oracles/mujoco_bench/laws.hpp"
#include "tests/oracles/mujoco_bench/plant.hpp"

namespace torquewright::oracles::mujoco_bench {
namespace {

using Numbers = std::vector<double>;

/// y[k] = b0 x[k] + b1 x[k-1] + b2 x[k-2] - a1 y[k-1] - a2 y[k-2], begun at rest on the first
/// value.
Numbers filtered(const Numbers& x, double step_s) {
  const double k = std::tan(std::numbers::pi * kBand_hz * step_s);
  const double norm = 1 / (1 + std::numbers::sqrt2 * k + k * k);
  const double b0 = k * k * norm, a1 = 2 * (k * k - 1) * norm;
  const double a2 = (1 - std::numbers::sqrt2 * k + k * k) * norm;
  Numbers y(x.size());
  double x1 = x.front(), x2 = x1, y1 = x1, y2 = x1;
  for (std::size_t n = 0; n < x.size(); ++n) {
    y[n] = b0 * (x[n] + 2 * x1 + x2) - a1 * y1 - a2 * y2;
    x2 = x1, x1 = x[n], y2 = y1, y1 = y[n];
  }
  return y;
}

Numbers slope(const Numbers& numbers, double step_s) {
  Numbers rate(numbers.size(), 0);
  for (std::size_t k = 1; k + 1 < numbers.size(); ++k)
    rate[k] = (numbers[k + 1] - numbers[k - 1]) / (2 * step_s);
  return rate;
}

/// The channel where the log has it, else nothing.
const Numbers* find(const Channels& channels, const std::string& quantity) {
  const auto found = channels.find(quantity);
  return found == channels.end() ? nullptr : &found->second;
}

/// What the log says of the output's angle.
Numbers logged_position(const World& world, const Channels& channels) {
  if (const Numbers* output = find(channels, "output_position_rad")) return *output;
  if (const Numbers* axis = find(channels, "linear_position_m")) return *axis;
  Numbers position = *find(channels, "motor_position_rad");
  for (double& q : position) q /= world.motor.ratio;
  return position;
}

/// True motion, and the motion that the log shows.
struct Moves {
  Numbers position, true_speed, speed, acceleration, temperature;
};

Moves moves(const World& world, const LogFormat& format, const Record& record,
            const Channels& channels) {
  const auto thin = [&](const Numbers& numbers) {
    return thinned(numbers, format.records_per_row);
  };
  Moves seen{.position = logged_position(world, channels),
             .true_speed = thin(record.speed_rad_s),
             .speed = {},
             .acceleration = thin(record.acceleration_rad_s2),
             .temperature = thin(record.temperature_K)};
  seen.speed = seen.true_speed;
  Numbers error = thin(record.position_rad);
  for (std::size_t k = 0; k < error.size(); ++k) error[k] = seen.position[k] - error[k];
  const Numbers rate = slope(in_band(error, format.row_s()), format.row_s());
  const Numbers change = slope(rate, format.row_s());
  for (std::size_t k = 0; k < error.size(); ++k) {
    seen.speed[k] += rate[k];
    seen.acceleration[k] += change[k];
  }
  if (const Numbers* logged = find(channels, "winding_temperature_K"))
    seen.temperature = *logged;
  else
    std::fill(seen.temperature.begin(), seen.temperature.end(),
              world.motor.reference_temperature_K);
  return seen;
}

/// Between the drive's terminals, as the log and the world's sag and dead time have it.
Numbers applied_voltage(const World& world, const Channels& channels, const Numbers& current) {
  if (const Numbers* winding = find(channels, "winding_voltage_V")) return *winding;
  const Numbers& duty = *find(channels, "duty");
  const Numbers* bus = find(channels, "bus_voltage_V");
  Numbers voltage(duty.size());
  for (std::size_t k = 0; k < duty.size(); ++k) {
    const double sagged = world.motor.bus_voltage_V - world.laws.sag_ohm * duty[k] * current[k];
    voltage[k] = duty[k] * (bus != nullptr ? (*bus)[k] : sagged);
  }
  return voltage;
}

double back_emf(const World& world, const Moves& seen, std::size_t k) {
  return world.motor.torque_constant_Nm_A * magnet_factor(world, seen.temperature[k]) *
         world.motor.ratio * seen.speed[k];
}

/// Logged, or what the voltage drives through the winding.
Numbers logged_current(const World& world, const LogFormat& format, const Record& record,
                       const Channels& channels, const Moves& seen) {
  if (const Numbers* current = find(channels, "motor_current_A")) return *current;
  const Numbers truth = thinned(record.current_A, format.records_per_row);
  Numbers current = applied_voltage(world, channels, truth);
  const bool behind_bridge = find(channels, "winding_voltage_V") != nullptr;
  for (std::size_t k = 0; k < current.size(); ++k) {
    const double driving = current[k] - back_emf(world, seen, k);
    const double lost = behind_bridge ? 0 : world.laws.dead_time_V;
    const double left = std::max(0.0, std::abs(driving) - lost);
    current[k] = std::copysign(left, driving) / resistance_ohm(world, seen.temperature[k]);
  }
  return current;
}

double needed_torque(const World& world, const Record& record, const Moves& seen, std::size_t k) {
  const Load& load = world.load;
  const double share =
      load.payload_share.empty() ? 0 : load.payload_share[record.index % load.payload_share.size()];
  if (load.type == "free") return load.inertia_kg_m2 * (1 + share) * seen.acceleration[k];
  const double mass = load.mass_kg * (1 + share);
  if (load.type == "linear_axis") return mass * seen.acceleration[k];
  return (load.inertia_kg_m2 + mass * load.length_m * load.length_m) * seen.acceleration[k] +
         mass * kGravity_m_s2 * load.length_m * std::sin(seen.position[k]);
}

/// History of what has one: the torque's lag and the presliding contact.
class Histories {
 public:
  Histories(const World& world, double step_s) : world_(world), step_s_(step_s) {}

  double lagged(double asked) {
    const double lag = world_.laws.lag_s;
    if (lag <= 0) return asked;
    // Exact for a command that runs straight between samples.
    const double fade = std::exp(-step_s_ / lag), rate = (asked - asked_) / step_s_;
    torque_ = begun_ ? asked - rate * lag + (torque_ - asked_ + rate * lag) * fade : asked;
    asked_ = asked, begun_ = true;
    return torque_;
  }

  double presliding(double speed, double temperature_K) {
    const Laws& laws = world_.laws;
    if (laws.presliding_Nm <= 0) return 0;
    const double warmer = temperature_K - world_.motor.reference_temperature_K;
    contact_ =
        dahl_Nm(contact_, speed * step_s_, laws.presliding_Nm * (1 + laws.grease_1_K * warmer),
                laws.presliding_stiffness_Nm_rad);
    return contact_;
  }

 private:
  const World& world_;
  double step_s_;
  bool begun_ = false;
  double asked_ = 0, torque_ = 0, contact_ = 0;
};

/// Torque on the load that springs and stops add.
double held_torque(const World& world, double position) {
  const Load& load = world.load;
  const double beyond = std::max(0.0, std::abs(position) - load.stop_rad);
  return -load.spring_Nm_rad * (position - load.spring_rest_rad) -
         std::copysign(beyond * load.stop_stiffness_Nm_rad, position);
}

Numbers torque_residual(const World& world, const LogFormat& format, const Record& record,
                        const Channels& channels, const Moves& seen) {
  const Numbers current = logged_current(world, format, record, channels, seen);
  const Numbers* torque = find(channels, "output_torque_Nm");
  const double armature = world.motor.armature_kg_m2() + world.laws.extra_inertia_kg_m2;
  const Numbers carried = thinned(record.torque_Nm, format.records_per_row);
  Histories histories(world, format.row_s());
  Numbers left(current.size(), 0);
  for (std::size_t k = 0; k < left.size(); ++k) {
    const double q = seen.position[k], w = seen.true_speed[k];
    const double direction = std::abs(w) < 1e-9 ? 0 : w > 0 ? 1 : -1;
    const Sliding state{seen.speed[k],       q,          current[k],
                        seen.temperature[k], carried[k], format.row_s() * static_cast<double>(k)};
    const double push =
        histories.lagged(motor_torque_Nm(world, current[k], seen.temperature[k])) +
        sum_of(world.laws.cogging, world.motor.ratio * q) - armature * seen.acceleration[k] -
        histories.presliding(w, seen.temperature[k]) - direction * drag_Nm(world, state, direction);
    // At rest dry friction takes whatever is left: there is no equation.
    if (direction == 0) continue;
    const double mesh = push / mesh_gain(world, push, direction);
    const double predicted =
        mesh * load_ripple_factor(world, q) + flange_torque_Nm(world, q) + held_torque(world, q);
    left[k] =
        (torque != nullptr ? (*torque)[k] : needed_torque(world, record, seen, k)) - predicted;
  }
  return left;
}

Numbers twist_residual(const World& world, const LogFormat& format, const Record& record,
                       const Channels& channels) {
  const Numbers& motor = *find(channels, "motor_position_rad");
  const Numbers output = logged_position(world, channels);
  const Numbers torque = thinned(record.torque_Nm, format.records_per_row);
  Numbers left(motor.size());
  for (std::size_t k = 0; k < left.size(); ++k)
    left[k] = motor[k] / world.motor.ratio - output[k] - torque[k] / world.laws.stiffness_Nm_rad -
              std::copysign(world.laws.gap_rad / 2, torque[k]);
  return left;
}

Numbers velocity_residual(const World& world, const Channels& channels, const Moves& seen) {
  const Numbers* logged = find(channels, "output_velocity_rad_s");
  if (logged == nullptr) logged = find(channels, "linear_velocity_m_s");
  const double over = logged == nullptr ? world.motor.ratio : 1;
  if (logged == nullptr) logged = find(channels, "motor_velocity_rad_s");
  Numbers left(logged->size());
  for (std::size_t k = 0; k < left.size(); ++k) left[k] = (*logged)[k] / over - seen.speed[k];
  return left;
}

Numbers voltage_residual(const World& world, const Channels& channels, const Moves& seen) {
  const Numbers& current = *find(channels, "motor_current_A");
  Numbers left = applied_voltage(world, channels, current);
  const bool behind_bridge = find(channels, "winding_voltage_V") != nullptr;
  for (std::size_t k = 0; k < left.size(); ++k) {
    left[k] -= resistance_ohm(world, seen.temperature[k]) * current[k] + back_emf(world, seen, k);
    if (!behind_bridge) left[k] -= std::copysign(world.laws.dead_time_V, current[k]);
  }
  return left;
}

Numbers bus_residual(const World& world, const LogFormat& format, const Record& record,
                     const Channels& channels) {
  const Numbers& bus = *find(channels, "bus_voltage_V");
  const Numbers drawn = thinned(record.current_A, format.records_per_row);
  const Numbers duty = thinned(record.duty, format.records_per_row);
  Numbers left(bus.size());
  for (std::size_t k = 0; k < left.size(); ++k)
    left[k] = bus[k] - world.motor.bus_voltage_V + world.laws.sag_ohm * duty[k] * drawn[k];
  return left;
}

/// Adds up squares over records.
class MeanSquares {
 public:
  explicit MeanSquares(double step_s) : step_s_(step_s) {}

  void add(const Residuals& more, const Residuals& less) {
    for (const auto& [equation, numbers] : more) {
      Numbers difference = numbers;
      for (std::size_t k = 0; k < difference.size(); ++k) difference[k] -= less.at(equation)[k];
      for (const double x : in_band(difference, step_s_)) squares_[equation] += x * x;
      counts_[equation] += static_cast<double>(numbers.size());
    }
  }

  Levels roots() const {
    Levels levels;
    for (const auto& [equation, sum] : squares_)
      levels[equation] = std::sqrt(sum / counts_.at(equation));
    return levels;
  }

 private:
  double step_s_;
  Levels squares_, counts_;
};

}  // namespace

Numbers in_band(const Numbers& numbers, double step_s) {
  Numbers once = filtered(numbers, step_s);
  std::reverse(once.begin(), once.end());
  Numbers twice = filtered(once, step_s);
  std::reverse(twice.begin(), twice.end());
  return twice;
}

Residuals residuals(const World& world, const LogFormat& format, const Record& record,
                    const Channels& channels) {
  const Moves seen = moves(world, format, record, channels);
  Residuals left;
  const bool has_volts = format.has("duty") || format.has("winding_voltage_V");
  if (format.has("motor_current_A") || has_volts)
    left["torque_Nm"] = torque_residual(world, format, record, channels, seen);
  if (format.has("motor_position_rad") &&
      (format.has("output_position_rad") || format.has("linear_position_m")))
    left["twist_rad"] = twist_residual(world, format, record, channels);
  if (format.has("output_velocity_rad_s") || format.has("motor_velocity_rad_s") ||
      format.has("linear_velocity_m_s"))
    left["velocity_rad_s"] = velocity_residual(world, channels, seen);
  if (has_volts && format.has("motor_current_A"))
    left["voltage_V"] = voltage_residual(world, channels, seen);
  if (format.has("bus_voltage_V")) left["bus_V"] = bus_residual(world, format, record, channels);
  return left;
}

Levels noise_levels(const World& world, const LogFormat& format, const std::vector<Record>& records,
                    Draws draws) {
  MeanSquares squares(format.row_s());
  for (const Record& record : records) {
    const Channels clean = sense(world, format, record);
    Channels noisy = clean;
    add_noise(noisy, format, draws);
    squares.add(residuals(world, format, record, noisy), residuals(world, format, record, clean));
  }
  return squares.roots();
}

Levels differences(const World& with, const World& without, const LogFormat& format,
                   const std::vector<Record>& records) {
  MeanSquares squares(format.row_s());
  for (const Record& record : records)
    squares.add(residuals(without, format, record, sense(with, format, record)),
                residuals(with, format, record, sense(without, format, record)));
  return squares.roots();
}

double floors(const Levels& levels, const Levels& noise) {
  double greatest = 0;
  for (const auto& [equation, level] : levels)
    greatest = std::max(greatest, level / noise.at(equation));
  return greatest;
}

}  // namespace torquewright::oracles::mujoco_bench
