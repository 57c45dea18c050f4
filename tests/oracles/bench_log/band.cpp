// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/bench_log/band.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace torquewright::oracles {
namespace {

struct Biquad {
  double b0, b1, b2, a1, a2;
};

Biquad butterworth(double sample_rate_Hz, double edge_Hz) {
  const double k = std::tan(std::numbers::pi * edge_Hz / sample_rate_Hz);
  const double norm = 1.0 / (1.0 + std::numbers::sqrt2 * k + k * k);
  return {k * k * norm, 2.0 * k * k * norm, k * k * norm, 2.0 * (k * k - 1.0) * norm,
          (1.0 - std::numbers::sqrt2 * k + k * k) * norm};
}

// Starts as if the first value had stood for ever.
void pass(std::vector<double>& signal, const Biquad& f) {
  double x1 = signal.front(), x2 = x1, y1 = x1, y2 = x1;
  for (double& value : signal) {
    const double x = value;
    value = f.b0 * x + f.b1 * x1 + f.b2 * x2 - f.a1 * y1 - f.a2 * y2;
    x2 = x1;
    x1 = x;
    y2 = y1;
    y1 = value;
  }
}

const std::vector<double>& residual_of(const CleanRun& run, const std::string& equation) {
  if (equation == "torque") return run.torque_residual;
  if (equation == "kinematic") return run.kinematic_residual;
  if (equation == "electrical") return run.electrical_residual;
  if (equation == "bus") return run.bus_residual;
  if (equation == "velocity") return run.velocity_residual;
  throw std::invalid_argument("no equation " + equation);
}

/// Noise of the channels per sample; infinite where there is none.
struct Sigmas {
  const Bench& bench;
  double of(const std::string& quantity) const {
    for (const Channel& channel : bench.channels) {
      if (channel.quantity != quantity) continue;
      return std::sqrt(channel.sigma * channel.sigma +
                       channel.resolution * channel.resolution / 12.0);
    }
    return kInfinity;
  }
  bool has(const std::string& quantity) const { return of(quantity) < kInfinity; }
  /// rms in the band of the n-th derivative.
  double derivative(const std::string& quantity, int n) const {
    const double share = kBand_Hz / (0.5 * sample_rate_Hz(bench));
    return of(quantity) * std::pow(2.0 * std::numbers::pi * kBand_Hz, n) *
           std::sqrt(share / (2.0 * n + 1.0));
  }
};

double torque_floor(const Bench& bench, const Sigmas& sigmas, const std::string& position,
                    const std::string& speed, const std::string& torque) {
  const Machine& model = bench.nominal;
  const double speed_noise = std::min(sigmas.derivative(position, 1), sigmas.derivative(speed, 0));
  const double acceleration_noise =
      std::min(sigmas.derivative(position, 2), sigmas.derivative(speed, 1));
  const bool has_sensor = sigmas.has(torque);
  const double inertia =
      model.motor_inertia_kg_m2() + (has_sensor ? 0.0 : model.load.inertia_kg_m2);
  const double current =
      sigmas.derivative("motor_current_A", 0) * model.ratio * model.torque_constant_Nm_A;
  const double viscous = model.friction.viscous_positive_Nm_s_rad * speed_noise;
  const double gravity = has_sensor ? 0.0 : model.load.gravity_Nm * sigmas.derivative(position, 0);
  const double sensor = has_sensor ? sigmas.derivative(torque, 0) : 0.0;
  return std::hypot(std::hypot(current, viscous, gravity), sensor, inertia * acceleration_noise);
}

}  // namespace

std::vector<double> in_band(const std::vector<double>& signal, double sample_rate_Hz,
                            double edge_Hz) {
  const Biquad filter = butterworth(sample_rate_Hz, edge_Hz);
  std::vector<double> low = signal;
  pass(low, filter);
  std::reverse(low.begin(), low.end());
  pass(low, filter);
  std::reverse(low.begin(), low.end());
  return low;
}

double residual_rms(const std::vector<CleanRun>& runs, const std::string& equation,
                    double sample_rate_Hz) {
  double sum = 0.0;
  double count = 0.0;
  for (const CleanRun& run : runs) {
    for (const double value : in_band(residual_of(run, equation), sample_rate_Hz)) {
      sum += value * value;
      count += 1.0;
    }
  }
  return std::sqrt(sum / count);
}

std::map<std::string, double> noise_floors(const Bench& bench) {
  const Sigmas sigmas{bench};
  const Machine& model = bench.nominal;
  const bool is_linear = model.load.type == Load::Type::kLinearAxis;
  const std::string position = is_linear ? "linear_position_m" : "output_position_rad";
  const std::string speed = is_linear ? "linear_velocity_m_s" : "output_velocity_rad_s";
  const std::string torque = is_linear ? "linear_force_N" : "output_torque_Nm";
  const bool has_motion = sigmas.has(position) || sigmas.has(speed);
  std::map<std::string, double> floors;
  if (sigmas.has("motor_current_A") && has_motion) {
    floors["torque"] = torque_floor(bench, sigmas, position, speed, torque);
  }
  if (sigmas.has("motor_position_rad") && sigmas.has(position)) {
    floors["kinematic"] = std::hypot(sigmas.derivative("motor_position_rad", 0) / model.ratio,
                                     sigmas.derivative(position, 0));
  }
  if (sigmas.has("winding_voltage_V") && sigmas.has("motor_current_A")) {
    const double motor_speed = std::min({sigmas.derivative("motor_velocity_rad_s", 0),
                                         model.ratio * sigmas.derivative(speed, 0),
                                         model.ratio * sigmas.derivative(position, 1)});
    floors["electrical"] =
        std::hypot(sigmas.derivative("winding_voltage_V", 0),
                   model.resistance_ohm * sigmas.derivative("motor_current_A", 0),
                   model.torque_constant_Nm_A * motor_speed);
  }
  if (sigmas.has("bus_voltage_V")) floors["bus"] = sigmas.derivative("bus_voltage_V", 0);
  if (sigmas.has(speed) && sigmas.has(position)) {
    floors["velocity"] = std::hypot(sigmas.derivative(speed, 0), sigmas.derivative(position, 1));
  }
  return floors;
}

}  // namespace torquewright::oracles
