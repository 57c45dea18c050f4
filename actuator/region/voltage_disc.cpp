// SPDX-License-Identifier: Apache-2.0
#include "actuator/region/voltage_disc.hpp"

#include <algorithm>
#include <cmath>

namespace torquewright::actuator {
namespace {

/// Half the chord that a circle cuts from a line at that distance from its centre; negative: none.
double half_chord_A(double radius_A, double distance_A) {
  const double square = (radius_A - distance_A) * (radius_A + distance_A);
  return square < 0.0 ? -1.0 : std::sqrt(square);
}

/// The upper of the points where the disc's circle meets the current limit's.
std::optional<Current> upper_meeting(const VoltageDisc& disc, double limit_A) {
  const double distance_A = std::hypot(disc.d_A, disc.q_A);
  if (distance_A == 0.0) return std::nullopt;
  const double along_A =
      0.5 * (distance_A + (limit_A - disc.radius_A) * (limit_A + disc.radius_A) / distance_A);
  const double across_A = half_chord_A(limit_A, along_A);
  if (across_A < 0.0) return std::nullopt;
  const double cosine = disc.d_A / distance_A;
  const double sine = disc.q_A / distance_A;
  // cosine <= 0, so that this is the upper one.
  return Current{along_A * cosine + across_A * sine, along_A * sine - across_A * cosine};
}

/// The greatest q current with field weakening. Requires that the discs overlap.
std::optional<DiscEnd> weakened_end(const VoltageDisc& disc, const PhaseModel& model) {
  const double limit_A = model.current_limit_A;
  const double floor_A = -std::min(model.demagnetisation_current_A, limit_A);
  // The disc's highest point, or the highest right of the demagnetisation limit.
  const double top_d_A = std::max(disc.d_A, floor_A);
  const double rise_A = half_chord_A(disc.radius_A, top_d_A - disc.d_A);
  const double top_q_A = disc.q_A + rise_A;
  const double room_A = half_chord_A(limit_A, top_d_A);
  if (rise_A >= 0.0 && std::abs(top_q_A) <= room_A) return DiscEnd{{top_d_A, top_q_A}, false};
  const double at_rest_A = half_chord_A(disc.radius_A, disc.d_A);
  if (at_rest_A >= 0.0 && std::abs(limit_A - disc.q_A) <= at_rest_A) {
    return DiscEnd{{0.0, limit_A}, true};
  }
  const std::optional<Current> meeting = upper_meeting(disc, limit_A);
  if (!meeting || meeting->d_A < floor_A || meeting->d_A > 0.0) return std::nullopt;
  return DiscEnd{*meeting, false};
}

DiscEnd turned_over(DiscEnd end) {
  end.current.q_A = -end.current.q_A;
  return end;
}

DiscRange unweakened_range(const VoltageDisc& disc, double limit_A) {
  const double half_A = half_chord_A(disc.radius_A, disc.d_A);
  const double low_A = disc.q_A - half_A;
  const double high_A = disc.q_A + half_A;
  if (half_A < 0.0 || low_A > limit_A || high_A < -limit_A) return {true, {}, {}};
  return {false,
          {{0.0, std::max(low_A, -limit_A)}, low_A <= -limit_A},
          {{0.0, std::min(high_A, limit_A)}, high_A >= limit_A}};
}

}  // namespace

std::optional<VoltageDisc> voltage_disc(const PhaseModel& model, double speed_rad_s,
                                        double slack_V) {
  if (model.inductance_d_H != model.inductance_q_H || model.dead_time_V != 0.0 ||
      model.supply.resistance_ohm != 0.0) {
    return std::nullopt;
  }
  const double R = model.resistance_ohm;
  const double X = model.pole_pairs * speed_rad_s * model.inductance_d_H;
  const double square = R * R + X * X;
  if (square == 0.0) return std::nullopt;
  const double back_emf_V = model.back_emf_V_s_rad * speed_rad_s;
  const double voltage_V = model.phase_volts_per_bus_volt * model.supply.open_circuit_V + slack_V;
  return VoltageDisc{-back_emf_V * X / square, -back_emf_V * R / square,
                     voltage_V / std::sqrt(square)};
}

std::optional<DiscRange> disc_range(const VoltageDisc& disc, const PhaseModel& model) {
  const double limit_A = model.current_limit_A;
  if (!model.field_weakening) return unweakened_range(disc, limit_A);
  if (std::hypot(disc.d_A, disc.q_A) > limit_A + disc.radius_A) return DiscRange{true, {}, {}};
  const std::optional<DiscEnd> greatest = weakened_end(disc, model);
  const std::optional<DiscEnd> least = weakened_end({disc.d_A, -disc.q_A, disc.radius_A}, model);
  if (!greatest || !least) return std::nullopt;
  return DiscRange{false, turned_over(*least), *greatest};
}

double nearest_d_A(const VoltageDisc& disc, double q_A, double floor_A) {
  const double half_A = half_chord_A(disc.radius_A, q_A - disc.q_A);
  return std::clamp(disc.d_A + std::max(0.0, half_A), floor_A, 0.0);
}

}  // namespace torquewright::actuator
