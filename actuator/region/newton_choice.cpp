// SPDX-License-Identifier: Apache-2.0
#include "actuator/region/newton_choice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "actuator/region/current_plane.hpp"

namespace torquewright::actuator {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kMostSteps = 100;
constexpr double kShortStep = 1e-8;  // relative; the next one would be its square

/// A slope and its own derivative.
struct Slope {
  double value;
  double change;
};

/// Where the slope, which falls from plus to minus, crosses zero between two points; else the end.
template <typename Function>
double top_between(const Function& slope, double low, double high) {
  if (!(low < high)) return high;
  if (slope(low).value <= 0.0) return low;
  const double shortest = kShortStep * std::max(std::abs(low), std::abs(high));
  double point = high;
  for (int step = 0; step < kMostSteps && high - low > shortest; ++step) {
    const Slope at = slope(point);
    if (at.value == 0.0) return point;
    if (at.value > 0.0 && point == high) return high;
    (at.value > 0.0 ? low : high) = point;
    const double newton = point - at.value / at.change;
    const bool is_inside = newton > low && newton < high;
    if (is_inside && std::abs(newton - point) <= shortest) return newton;
    point = is_inside ? newton : 0.5 * (low + high);
  }
  return point;
}

/// The q current of a torque and its first two derivatives by i_d, on f(i_q) (K + r i_d) = T with
/// the saturation in f.
struct QCurrent {
  double A, first, second;
};

QCurrent q_of(const PhaseModel& model, double torque_Nm, double d_A) {
  const double q_A = q_current_A(model, torque_Nm, d_A);
  const double r = model.reluctance_Nm_A2();
  if (r == 0.0 || q_A == 0.0 || !std::isfinite(q_A)) return {q_A, 0.0, 0.0};
  const double share = r / (model.torque_constant_Nm_A + r * d_A);
  const SaturatedCurrent f = saturated_current(model, q_A);
  const double first = -share * f.A / f.slope;
  return {q_A, first, -(2.0 * share + f.bend_1_A / f.slope * first) * first};
}

/// d/di_d of the phase voltage's amplitude, eq. (2) and (3).
Slope voltage_slope(const PhaseModel& model, const QCurrent& q, double d_A, double speed_rad_s) {
  const double w = model.pole_pairs * speed_rad_s;
  const double R = model.resistance_ohm;
  const double wL_d = w * model.inductance_d_H;
  const double wL_q = w * model.inductance_q_H;
  const double v_d = R * d_A - wL_q * q.A;
  const double v_q = R * q.A + wL_d * d_A + model.back_emf_V_s_rad * speed_rad_s;
  const double v_d_first = R - wL_q * q.first;
  const double v_q_first = R * q.first + wL_d;
  const double square = v_d * v_d + v_q * v_q;
  const double product = v_d * v_d_first + v_q * v_q_first;
  const double bend =
      v_d_first * v_d_first + v_q_first * v_q_first + q.second * (R * v_q - wL_q * v_d);
  if (square == 0.0) return {0.0, 1.0};
  const double amplitude = std::sqrt(square);
  return {product / amplitude, (bend - product * product / square) / amplitude};
}

/// d/di_d of the bus voltage that the power leaves, eq. (5). Where the supply cannot deliver it,
/// rising: less current is the way back.
Slope bus_slope(const PhaseModel& model, const QCurrent& q, double d_A, double speed_rad_s) {
  const Supply& supply = model.supply;
  if (supply.resistance_ohm == 0.0) return {0.0, 0.0};
  const double R = model.resistance_ohm;
  const double power_W = bus_power_W(model, {d_A, q.A}, speed_rad_s);
  const double square =
      supply.open_circuit_V * supply.open_circuit_V - 4.0 * supply.resistance_ohm * power_W;
  if (!(square > 0.0)) return {kInfinity, 1.0};
  const double root = std::sqrt(square);
  // The induced part is w (1.5 K_e + r i_d) i_q with i_q a function of i_d.
  const double r = model.reluctance_Nm_A2();
  const double per_q = 1.5 * model.back_emf_V_s_rad + r * d_A;
  const double first_W =
      3.0 * R * (d_A + q.A * q.first) + speed_rad_s * (per_q * q.first + r * q.A);
  const double second_W = 3.0 * R * (1.0 + q.first * q.first + q.A * q.second) +
                          speed_rad_s * (per_q * q.second + 2.0 * r * q.first);
  const double per_W = -supply.resistance_ohm / root;
  return {per_W * first_W, per_W * second_W - 2.0 * per_W * per_W * first_W * first_W / root};
}

}  // namespace

bool has_smooth_choice(const PhaseModel& model) { return model.dead_time_V == 0.0; }

double least_current_d_A(const PhaseModel& model, double torque_Nm, double low_A, double high_A) {
  const double r = model.reluctance_Nm_A2();
  const double K = model.torque_constant_Nm_A;
  // Beyond the pole of T/(K + r i_d) there is no torque of that sign.
  if (r > 0.0) low_A = std::max(low_A, -K / r);
  if (r < 0.0) high_A = std::min(high_A, -K / r);
  const auto slope = [&](double d_A) -> Slope {
    const QCurrent q = q_of(model, torque_Nm, d_A);
    if (!std::isfinite(q.A)) return {r > 0.0 ? kInfinity : -kInfinity, 1.0};
    return {-(d_A + q.A * q.first), -(1.0 + q.first * q.first + q.A * q.second)};
  };
  return top_between(slope, low_A, high_A);
}

double greatest_margin_d_A(const PhaseModel& model, double torque_Nm, double speed_rad_s,
                           double low_A, double high_A) {
  const double volts = model.phase_volts_per_bus_volt;
  const auto slope = [&](double d_A) -> Slope {
    const QCurrent q = q_of(model, torque_Nm, d_A);
    if (!std::isfinite(q.A)) return {kInfinity, 1.0};
    const Slope bus = bus_slope(model, q, d_A, speed_rad_s);
    const Slope phase = voltage_slope(model, q, d_A, speed_rad_s);
    return {volts * bus.value - phase.value, volts * bus.change - phase.change};
  };
  return top_between(slope, low_A, high_A);
}

std::optional<double> first_room_d_A(const PhaseModel& model, double torque_Nm, double speed_rad_s,
                                     double from_A) {
  const double shortest_A = kShortStep * model.current_limit_A;
  double d_A = from_A;
  for (int step = 0; step < kMostSteps; ++step) {
    const auto plane =
        current_plane_at(model, {d_A, q_current_A(model, torque_Nm, d_A)}, speed_rad_s);
    if (!plane) return std::nullopt;
    const Bent& room = plane->room_V2;
    const double slope = room.d - room.q * plane->torque_Nm.d / plane->torque_Nm.q;
    const double step_A = -room.value / slope;
    if (!(slope < 0.0 && step_A <= shortest_A)) return std::nullopt;
    d_A += step_A;
    if (d_A < -model.current_limit_A) return std::nullopt;
    if (-step_A <= shortest_A) return d_A;
  }
  return std::nullopt;
}

double greatest_torque_d_A(const PhaseModel& model, double low_A) {
  const double r = model.reluctance_Nm_A2();
  const double K = model.torque_constant_Nm_A;
  const double I = model.current_limit_A;
  if (r == 0.0) return 0.0;
  // d/di_d of (K + r i_d) sqrt(I^2 - i_d^2): 2 r i_d^2 + K i_d - r I^2 = 0.
  const double d_A = 2.0 * r * I * I / (K + std::sqrt(K * K + 8.0 * r * r * I * I));
  if (model.saturation_current_A == 0.0) return std::max(d_A, low_A);
  // d/di_d of f(i_q) (K + r i_d), over f', with i_q on the limit.
  const auto slope = [&](double at_A) -> Slope {
    const double q_A = std::sqrt(std::max(0.0, I * I - at_A * at_A));
    if (q_A == 0.0) return {at_A < 0.0 ? kInfinity : -kInfinity, -1.0};
    const SaturatedCurrent f = saturated_current(model, q_A);
    const double per_ampere = K + r * at_A;
    const double q_first = -at_A / q_A;
    const double q_second = -(1.0 + q_first * q_first) / q_A;
    return {f.A * r / f.slope + q_first * per_ampere,
            r * q_first * (2.0 - f.A * f.bend_1_A / (f.slope * f.slope)) + q_second * per_ampere};
  };
  // Saturation takes from i_q what it adds: never nearer to zero than without it.
  return d_A < 0.0 ? top_between(slope, low_A, std::max(low_A, d_A)) : top_between(slope, d_A, I);
}

}  // namespace torquewright::actuator
