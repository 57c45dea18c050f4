// SPDX-License-Identifier: Apache-2.0
#include "tests/actuator/dq_oracle.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace torquewright::oracles {
namespace {

struct Trial {
  bool is_possible;
  double torque_Nm;
};

Trial try_current(const actuator::PhaseModel& m, double w, double d, double q) {
  const double p = m.pole_pairs;
  const double lambda = m.back_emf_V_s_rad / p;
  const double vd = m.resistance_ohm * d - p * w * m.inductance_q_H * q;
  const double vq = m.resistance_ohm * q + p * w * (m.inductance_d_H * d + lambda);
  const double torque =
      m.torque_constant_Nm_A * q + 1.5 * p * (m.inductance_d_H - m.inductance_q_H) * d * q;
  const double power = 1.5 * (vd * d + vq * q);  // volts times amperes of three phases
  const double voc = m.supply.open_circuit_V;
  const double radicand = voc * voc - 4.0 * m.supply.resistance_ohm * power;
  if (radicand < 0.0) return {false, torque};
  const double bus = (voc + std::sqrt(radicand)) / 2.0;
  const bool fits = std::sqrt(vd * vd + vq * vq) <= m.phase_volts_per_bus_volt * bus &&
                    power <= m.supply.greatest_power_W && power >= m.supply.least_power_W &&
                    -d <= m.demagnetisation_current_A;
  return {fits, torque};
}

}  // namespace

std::optional<TorqueRange> brute_force_range(const actuator::PhaseModel& model, double speed_rad_s,
                                             int rings, int rays) {
  std::optional<TorqueRange> range;
  const int used_rays = model.field_weakening ? rays : 2;
  for (int ring = 0; ring <= rings; ++ring) {
    const double amplitude = model.current_limit_A * ring / rings;
    for (int ray = 0; ray < used_rays; ++ray) {
      const double angle = model.field_weakening ? 2.0 * std::numbers::pi * ray / rays
                                                 : std::numbers::pi * (0.5 + ray);
      const double d = model.field_weakening ? amplitude * std::cos(angle) : 0.0;
      const Trial trial = try_current(model, speed_rad_s, d, amplitude * std::sin(angle));
      if (!trial.is_possible) continue;
      if (!range) range = TorqueRange{trial.torque_Nm, trial.torque_Nm};
      range->least_Nm = std::min(range->least_Nm, trial.torque_Nm);
      range->greatest_Nm = std::max(range->greatest_Nm, trial.torque_Nm);
    }
  }
  return range;
}

}  // namespace torquewright::oracles
