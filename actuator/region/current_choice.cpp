// SPDX-License-Identifier: Apache-2.0
#include "actuator/region/current_choice.hpp"

#include <algorithm>
#include <cmath>

#include "actuator/region/bracketed_search.hpp"
#include "actuator/region/newton_choice.hpp"
#include "actuator/region/voltage_disc.hpp"

namespace torquewright::actuator {
namespace {

constexpr double kCurrentTolerance =
    1e-10;  // of the current limit; golden section's own floor 1e-8

bool is_salient(const PhaseModel& model) { return model.inductance_d_H != model.inductance_q_H; }

double tolerance_A(const PhaseModel& model) { return kCurrentTolerance * model.current_limit_A; }

double least_d_A(const PhaseModel& model) {
  return -std::min(model.demagnetisation_current_A, model.current_limit_A);
}

/// The d current down to which the limits allow weakening at that torque; at most `from_A`.
double weakest_d_A(const PhaseModel& model, double torque_Nm, double from_A) {
  const double limit_A = model.current_limit_A;
  const auto room = [&](double d_A) {
    const double q_A = q_current_A(model, torque_Nm, d_A);
    return limit_A * limit_A - d_A * d_A - q_A * q_A;
  };
  const double floor_A = least_d_A(model);
  if (floor_A >= from_A || room(floor_A) >= 0.0) return std::min(floor_A, from_A);
  if (room(from_A) < 0.0) return from_A;
  if (is_salient(model)) return last_nonnegative(room, from_A, floor_A, tolerance_A(model));
  const double q_A = q_current_A(model, torque_Nm, 0.0);
  return std::max(floor_A, -std::sqrt(std::max(0.0, limit_A * limit_A - q_A * q_A)));
}

Current with_d(const PhaseModel& model, double torque_Nm, double d_A) {
  return {d_A, q_current_A(model, torque_Nm, d_A)};
}

}  // namespace

Current greatest_torque_current(const PhaseModel& model) {
  const double limit_A = model.current_limit_A;
  if (!is_salient(model)) return {0.0, limit_A};
  const auto at_limit = [&](double d_A) {
    return Current{d_A, std::sqrt(std::max(0.0, limit_A * limit_A - d_A * d_A))};
  };
  return at_limit(greatest_torque_d_A(model, least_d_A(model)));
}

Current least_current(const PhaseModel& model, double torque_Nm) {
  if (!is_salient(model)) return with_d(model, torque_Nm, 0.0);
  const double d_A = least_current_d_A(model, torque_Nm, least_d_A(model), model.current_limit_A);
  return with_d(model, torque_Nm, d_A);
}

Current gentlest_current(const PhaseModel& model, double torque_Nm, double speed_rad_s) {
  const Current least = least_current(model, torque_Nm);
  if (!model.field_weakening) return least;
  const double floor_A = weakest_d_A(model, torque_Nm, least.d_A);
  if (floor_A >= least.d_A) return least;
  if (const auto disc = voltage_disc(model, speed_rad_s, 0.0)) {
    return {std::clamp(disc->d_A, floor_A, least.d_A), least.q_A};
  }
  if (has_smooth_choice(model)) {
    const double d_A = greatest_margin_d_A(model, torque_Nm, speed_rad_s, floor_A, least.d_A);
    return with_d(model, torque_Nm, d_A);
  }
  const auto margin_V = [&](double d_A) {
    return voltage_margin_V(model, with_d(model, torque_Nm, d_A), speed_rad_s);
  };
  return with_d(model, torque_Nm, greatest_point(margin_V, floor_A, least.d_A, tolerance_A(model)));
}

Current chosen_current(const PhaseModel& model, double torque_Nm, double speed_rad_s) {
  const Current least = least_current(model, torque_Nm);
  const auto margin_V = [&](double d_A) {
    return voltage_margin_V(model, with_d(model, torque_Nm, d_A), speed_rad_s);
  };
  if (!model.field_weakening || margin_V(least.d_A) >= 0.0) return least;
  if (const auto disc = voltage_disc(model, speed_rad_s, 0.0)) {
    const double floor_A = weakest_d_A(model, torque_Nm, least.d_A);
    return {nearest_d_A(*disc, least.q_A, floor_A), least.q_A};
  }
  if (const auto d_A = first_room_d_A(model, torque_Nm, speed_rad_s, least.d_A)) {
    if (*d_A >= weakest_d_A(model, torque_Nm, least.d_A)) return with_d(model, torque_Nm, *d_A);
  }
  const Current gentlest = gentlest_current(model, torque_Nm, speed_rad_s);
  if (margin_V(gentlest.d_A) < 0.0) return gentlest;
  return with_d(model, torque_Nm,
                last_nonnegative(margin_V, gentlest.d_A, least.d_A, tolerance_A(model)));
}

}  // namespace torquewright::actuator
