// SPDX-License-Identifier: Apache-2.0
#include "actuator/region/current_plane.hpp"

#include <cmath>

#include "actuator/unlimited.hpp"

namespace torquewright::actuator {
namespace {

/// a f + b g.
Bent combined(double a, const Bent& f, double b, const Bent& g) {
  return {a * f.value + b * g.value, a * f.d + b * g.d,   a * f.q + b * g.q,
          a * f.dd + b * g.dd,       a * f.dq + b * g.dq, a * f.qq + b * g.qq};
}

Bent product(const Bent& f, const Bent& g) {
  return {f.value * g.value,
          f.d * g.value + f.value * g.d,
          f.q * g.value + f.value * g.q,
          f.dd * g.value + 2.0 * f.d * g.d + f.value * g.dd,
          f.dq * g.value + f.d * g.q + f.q * g.d + f.value * g.dq,
          f.qq * g.value + 2.0 * f.q * g.q + f.value * g.qq};
}

/// A function with these derivatives, of f.
Bent composed(double value, double first, double second, const Bent& f) {
  return {value,
          first * f.d,
          first * f.q,
          first * f.dd + second * f.d * f.d,
          first * f.dq + second * f.d * f.q,
          first * f.qq + second * f.q * f.q};
}

Bent square_of(const Current& i) {
  return {i.d_A * i.d_A + i.q_A * i.q_A, 2.0 * i.d_A, 2.0 * i.q_A, 2.0, 0.0, 2.0};
}
Bent root_of(const Bent& f) {
  const double root = std::sqrt(f.value);
  return composed(root, 0.5 / root, -0.25 / (root * f.value), f);
}

/// |v|^2 of eq. (2) and (3). With u the voltage without dead time and V_dead along i it is
/// |u|^2 + 2 V_dead u i/|i| + V_dead^2, where u i = R |i|^2 + p w (L_d - L_q) i_d i_q + K_e w i_q.
Bent voltage_square(const PhaseModel& model, const Current& i, double speed_rad_s,
                    const Bent& amplitude_A) {
  const double w = model.pole_pairs * speed_rad_s;
  const double R = model.resistance_ohm;
  const double X_d = w * model.inductance_d_H;
  const double X_q = w * model.inductance_q_H;
  const double emf_V = model.back_emf_V_s_rad * speed_rad_s;
  const double v_d = R * i.d_A - X_q * i.q_A;
  const double v_q = R * i.q_A + X_d * i.d_A + emf_V;
  const Bent without{v_d * v_d + v_q * v_q,       2.0 * (R * v_d + X_d * v_q),
                     2.0 * (R * v_q - X_q * v_d), 2.0 * (R * R + X_d * X_d),
                     2.0 * R * (X_d - X_q),       2.0 * (R * R + X_q * X_q)};
  if (model.dead_time_V == 0.0) return without;
  const double X = X_d - X_q;
  const Bent reactive{(X * i.d_A + emf_V) * i.q_A, X * i.q_A, X * i.d_A + emf_V, 0.0, X, 0.0};
  const double a = amplitude_A.value;
  const Bent inverse = composed(1.0 / a, -1.0 / (a * a), 2.0 / (a * a * a), amplitude_A);
  const Bent along = combined(R, amplitude_A, 1.0, product(reactive, inverse));
  Bent sum = combined(1.0, without, 2.0 * model.dead_time_V, along);
  sum.value += model.dead_time_V * model.dead_time_V;
  return sum;
}

/// (c V)^2 with V of eq. (5), where V^2 = V_oc V - R_b P.
std::optional<Bent> supplied_square(const PhaseModel& model, const Bent& power_W) {
  const Supply& supply = model.supply;
  const double c2 = model.phase_volts_per_bus_volt * model.phase_volts_per_bus_volt;
  const double open_V = supply.open_circuit_V;
  const double R_b = supply.resistance_ohm;
  if (R_b == 0.0) return Bent{.value = c2 * open_V * open_V};
  const double radicand = open_V * open_V - 4.0 * R_b * power_W.value;
  if (!(radicand > 0.0)) return std::nullopt;
  const double root_V = std::sqrt(radicand);
  const double bus_V = 0.5 * (open_V + root_V);
  return composed(c2 * bus_V * bus_V, -2.0 * c2 * bus_V * R_b / root_V,
                  -2.0 * c2 * open_V * R_b * R_b / (radicand * root_V), power_W);
}

}  // namespace

SaturatedCurrent saturated_current(const PhaseModel& model, double q_A) {
  if (model.saturation_current_A == 0.0 || q_A == 0.0) return {q_A, 1.0, 0.0};
  const double p = model.saturation_exponent;
  const double filled = std::pow(std::abs(q_A) / model.saturation_current_A, p);
  const double factor = std::pow(1.0 + filled, -1.0 / p);
  const double slope = factor / (1.0 + filled);
  return {factor * q_A, slope, -(1.0 + p) * filled / (q_A * (1.0 + filled)) * slope};
}

std::optional<CurrentPlane> current_plane_at(const PhaseModel& model, const Current& current,
                                             double speed_rad_s) {
  const SaturatedCurrent filled = saturated_current(model, current.q_A);
  const double r = model.reluctance_Nm_A2();
  const Bent per_ampere{.value = model.torque_constant_Nm_A + r * current.d_A, .d = r};
  CurrentPlane plane;
  plane.torque_Nm =
      product({.value = filled.A, .q = filled.slope, .qq = filled.bend_1_A}, per_ampere);
  const Bent square = square_of(current);
  const Bent induced_Nm =
      product({.value = current.q_A, .q = 1.0},
              {.value = 1.5 * model.back_emf_V_s_rad + r * current.d_A, .d = r});
  plane.power_W = combined(speed_rad_s, induced_Nm, 1.5 * model.resistance_ohm, square);
  Bent amplitude;
  if (model.dead_time_V > 0.0) {
    amplitude = root_of(square);
    plane.power_W = combined(1.0, plane.power_W, 1.5 * model.dead_time_V, amplitude);
  }
  const std::optional<Bent> supplied = supplied_square(model, plane.power_W);
  if (!supplied) return std::nullopt;
  plane.room_V2 =
      combined(1.0, *supplied, -1.0, voltage_square(model, current, speed_rad_s, amplitude));
  return plane;
}

double room_V2_at(const PhaseModel& model, const Current& i, double speed_rad_s) {
  const double w = model.pole_pairs * speed_rad_s;
  const double R = model.resistance_ohm;
  const double square = i.d_A * i.d_A + i.q_A * i.q_A;
  const double amplitude_A = model.dead_time_V > 0.0 ? std::sqrt(square) : 0.0;
  // Dead time is a further resistance along the current.
  const double drop_ohm = amplitude_A > 0.0 ? R + model.dead_time_V / amplitude_A : R;
  const double v_d = drop_ohm * i.d_A - w * model.inductance_q_H * i.q_A;
  const double v_q =
      drop_ohm * i.q_A + w * model.inductance_d_H * i.d_A + model.back_emf_V_s_rad * speed_rad_s;
  double bus_V = model.supply.open_circuit_V;
  if (model.supply.resistance_ohm > 0.0) {
    const double power_W = induced_Nm(model, i) * speed_rad_s + 1.5 * drop_ohm * square;
    const auto sagged_V = bus_voltage_V(model.supply, power_W);
    if (!sagged_V) return -kUnlimited;
    bus_V = *sagged_V;
  }
  const double phase_V = model.phase_volts_per_bus_volt * bus_V;
  return phase_V * phase_V - v_d * v_d - v_q * v_q;
}

}  // namespace torquewright::actuator
