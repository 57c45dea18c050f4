// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

#include "tests/oracles/bench_log/bench.hpp"

namespace torquewright::oracles {
namespace {

using Series = std::vector<double>;

// Catmull and Rom's cubic between knots; the first and last value beyond the ends.
double at_knot(const Series& series, double knot) {
  const double last = static_cast<double>(series.size() - 1);
  const double inside = std::clamp(knot, 0.0, last);
  const auto k = std::min(static_cast<std::size_t>(inside), series.size() - 2);
  const double s = inside - static_cast<double>(k);
  const double before = series[k == 0 ? 0 : k - 1];
  const double after = series[std::min(k + 2, series.size() - 1)];
  const double m0 = 0.5 * (series[k + 1] - before);
  const double m1 = 0.5 * (after - series[k]);
  const double rise = series[k + 1] - series[k];
  return series[k] + s * (m0 + s * (3.0 * rise - 2.0 * m0 - m1 + s * (m0 + m1 - 2.0 * rise)));
}

Series sampled(const Series& series, int every, double late_s) {
  Series samples;
  samples.reserve(series.size() / static_cast<std::size_t>(every) + 1);
  for (std::size_t k = 0; k < series.size(); k += static_cast<std::size_t>(every)) {
    samples.push_back(late_s == 0.0 ? series[k]
                                    : at_knot(series, static_cast<double>(k) - late_s / kTick_s));
  }
  return samples;
}

double faulty_current_A(const LogFaults& faults, double current_A) {
  if (current_A < 0.0) current_A *= faults.current_negative_gain;
  if (faults.current_dead_zone_A > 0.0) {
    current_A =
        std::copysign(std::max(0.0, std::abs(current_A) - faults.current_dead_zone_A), current_A);
  }
  return current_A + faults.current_offset_A;
}

// A stop that is dragged along over the span, as the load goes up and down.
void add_hysteresis(Series& torque, const LogFaults& faults) {
  if (faults.hysteresis_Nm == 0.0) return;
  double middle = torque.front();
  for (double& value : torque) {
    middle =
        std::clamp(middle, value - faults.hysteresis_span_Nm, value + faults.hysteresis_span_Nm);
    value += faults.hysteresis_Nm * (value - middle) / faults.hysteresis_span_Nm;
  }
}

const Series* plain_channel(const Trace& trace, const std::string& quantity) {
  if (quantity == "output_position_rad" || quantity == "linear_position_m") {
    return &trace.position_rad;
  }
  if (quantity == "motor_position_rad") return &trace.motor_position_rad;
  if (quantity == "motor_velocity_rad_s") return &trace.motor_speed_rad_s;
  if (quantity == "winding_voltage_V") return &trace.voltage_V;
  if (quantity == "bus_voltage_V") return &trace.bus_V;
  if (quantity == "winding_temperature_K") return &trace.winding_K;
  if (quantity == "case_temperature_K") return &trace.case_K;
  return nullptr;
}

Series true_channel(const Bench& bench, const Trace& trace, const std::string& quantity) {
  const LogFaults& faults = bench.faults;
  const double late_s = faults.late_channel == quantity ? faults.late_s : 0.0;
  const int every = bench.ticks_per_sample;
  if (const Series* plain = plain_channel(trace, quantity)) return sampled(*plain, every, late_s);
  if (quantity == "output_velocity_rad_s" || quantity == "linear_velocity_m_s") {
    Series speed = sampled(trace.speed_rad_s, every, late_s + faults.velocity_late_s);
    for (double& value : speed) value *= faults.velocity_scale;
    return speed;
  }
  if (quantity == "motor_current_A") {
    Series current = sampled(trace.current_A, every, late_s);
    for (double& value : current) value = faulty_current_A(faults, value);
    return current;
  }
  if (quantity == "output_torque_Nm" || quantity == "linear_force_N") {
    Series torque = trace.torque_Nm;
    add_hysteresis(torque, faults);
    torque = sampled(torque, every, late_s);
    for (double& value : torque) value += faults.torque_offset;
    return torque;
  }
  if (quantity == "duty") {
    Series duty = trace.voltage_V;
    for (std::size_t k = 0; k < duty.size(); ++k) duty[k] /= trace.bus_V[k];
    return sampled(duty, every, late_s);
  }
  throw std::invalid_argument("no channel " + quantity);
}

/// The samples the residuals are made of: measured where there is a channel, else the truth.
struct Seen {
  Series position, speed, acceleration, motor_position, motor_speed, current, torque, voltage, bus,
      winding;
};

Seen what_is_seen(const Bench& bench, const Trace& trace, const CleanRun& run) {
  const int every = bench.ticks_per_sample;
  const LogFaults& faults = bench.faults;
  const bool is_late =
      faults.late_channel == "output_position_rad" || faults.late_channel == "linear_position_m";
  const double late_s = is_late ? faults.late_s : 0.0;
  Seen seen{sampled(trace.position_rad, every, late_s),
            sampled(trace.speed_rad_s, every, late_s),
            sampled(trace.acceleration_rad_s2, every, late_s),
            sampled(trace.motor_position_rad, every, 0.0),
            sampled(trace.motor_speed_rad_s, every, 0.0),
            sampled(trace.current_A, every, 0.0),
            sampled(trace.torque_Nm, every, 0.0),
            sampled(trace.voltage_V, every, 0.0),
            sampled(trace.bus_V, every, 0.0),
            sampled(trace.winding_K, every, 0.0)};
  for (std::size_t c = 0; c < bench.channels.size(); ++c) {
    const std::string& quantity = bench.channels[c].quantity;
    if (quantity == "motor_current_A") seen.current = run.columns[c];
    if (quantity == "output_torque_Nm" || quantity == "linear_force_N") {
      seen.torque = run.columns[c];
    }
    if (quantity == "winding_voltage_V") seen.voltage = run.columns[c];
  }
  return seen;
}

bool is_measured(const Bench& bench, const std::string& quantity) {
  return std::any_of(bench.channels.begin(), bench.channels.end(),
                     [&](const Channel& channel) { return channel.quantity == quantity; });
}

// What the nominal model says the load gets, less what it gets; nothing where the drive rests.
double torque_residual(const Bench& bench, const Seen& seen, std::size_t k, double time_s) {
  const Machine& model = bench.nominal;
  const double speed = seen.speed[k];
  if (std::abs(speed) < 1e-9) return 0.0;
  const double way = speed > 0.0 ? 1.0 : -1.0;
  const double net = motor_torque_Nm(model, seen.current[k], seen.winding[k]) -
                     model.motor_inertia_kg_m2() * seen.acceleration[k];
  const Situation at{seen.position[k], speed, seen.winding[k], time_s, 1e9};
  const double given = way * through_gear_Nm(model, way * net - friction_Nm(model, at, way));
  if (model.load.type == Load::Type::kDynamometer || is_measured(bench, "output_torque_Nm") ||
      is_measured(bench, "linear_force_N")) {
    return given - seen.torque[k];
  }
  return given - model.load.inertia_kg_m2 * seen.acceleration[k] -
         model.load.gravity_Nm * std::sin(seen.position[k]);
}

void add_residuals(const Bench& bench, const Trace& trace, CleanRun& run) {
  const Seen seen = what_is_seen(bench, trace, run);
  const Machine& model = bench.nominal;
  for (std::size_t k = 0; k < run.time_s.size(); ++k) {
    run.torque_residual.push_back(torque_residual(bench, seen, k, run.time_s[k]));
    run.kinematic_residual.push_back(seen.motor_position[k] / model.ratio - seen.position[k]);
    run.electrical_residual.push_back(seen.voltage[k] - winding_voltage_V(model, seen.current[k],
                                                                          seen.motor_speed[k],
                                                                          seen.winding[k]));
    run.bus_residual.push_back(model.bus_V - seen.bus[k]);
  }
  const Series logged =
      sampled(trace.speed_rad_s, bench.ticks_per_sample, bench.faults.velocity_late_s);
  for (std::size_t k = 0; k < run.time_s.size(); ++k) {
    run.velocity_residual.push_back(bench.faults.velocity_scale * logged[k] - seen.speed[k]);
  }
}

}  // namespace

double sample_rate_Hz(const Bench& bench) {
  return 1.0 / (kTick_s * static_cast<double>(bench.ticks_per_sample));
}

CleanRun measure(const Bench& bench, const Trace& trace) {
  CleanRun run;
  const auto every = static_cast<std::size_t>(bench.ticks_per_sample);
  for (std::size_t k = 0; k < trace.position_rad.size(); k += every) {
    run.time_s.push_back(kTick_s * static_cast<double>(k));
  }
  for (const Channel& channel : bench.channels) {
    run.columns.push_back(true_channel(bench, trace, channel.quantity));
  }
  add_residuals(bench, trace, run);
  return run;
}

LogRun with_noise(const Bench& bench, const CleanRun& run, const std::string& name,
                  Chance& chance) {
  LogRun log{name, {run.time_s}};
  for (std::size_t c = 0; c < run.columns.size(); ++c) {
    const Channel& channel = bench.channels[c];
    Series column = run.columns[c];
    for (double& value : column) {
      value += channel.sigma * chance.normal();
      if (channel.resolution > 0.0) {
        value = channel.resolution * std::round(value / channel.resolution);
      }
      value /= channel.column_scale;
    }
    log.columns.push_back(std::move(column));
  }
  return log;
}

}  // namespace torquewright::oracles
