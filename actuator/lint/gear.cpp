// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "actuator/lint/every_check.hpp"
#include "actuator/lint/quantities.hpp"

namespace torquewright::actuator::lint {
namespace {

/// What the gears carry, at the data sheet's side.
std::optional<RoundedInterval> gear_peak(const Interpretation& interpretation) {
  const Actuator& document = interpretation.document;
  if (document.transmission.peak_torque_Nm == kUnlimited) return std::nullopt;
  return derive([](double torque_Nm, double turns,
                   double sheet_turns) { return torque_Nm * sheet_turns / turns; },
                rounded(document.transmission.peak_torque_Nm, "/gearbox/peak_torque_Nm"),
                ratio(document), sheet_ratio(document, "peak_torque_Nm"));
}

/// N Kt I at the joint.
std::optional<RoundedInterval> motor_peak(const Interpretation& interpretation) {
  const Actuator& document = interpretation.document;
  return derive([](double turns, double constant_Nm_A,
                   double amperes) { return turns * constant_Nm_A * amperes; },
                ratio(document), torque_constant(document), peak_current(interpretation));
}

/// With the same friction F at the same output torque T both ways, eta_f = T / (T + F) and
/// eta_b = (T - F) / T = 2 - 1 / eta_f: 0 (self-locking) from eta_f = 1/2 down.
double equal_loss_backward(double forward) { return std::max(0.0, 2.0 - 1.0 / forward); }

/// Friction differs between the directions; by more than this factor is not plausible. Nor is a
/// gearbox that loses less when driven back.
constexpr double kLossFactor = 1.5;

std::optional<RoundedInterval> backward_expected(const Interpretation& interpretation) {
  const Transmission& gear = interpretation.document.transmission;
  if (!gear.source.empty()) return std::nullopt;  // computed from teeth, nothing is stated twice
  const RoundedInterval forward =
      efficiency(gear.forward_efficiency, "/gearbox/forward_efficiency");
  RoundedInterval expected = derive(equal_loss_backward, forward);
  expected.low = std::max(0.0, 1.0 - kLossFactor * (1.0 - expected.low));
  expected.high = forward.value > 0.5 ? forward.high : expected.high;
  return expected;
}

/// The gap of the declared effect, at the output as the data sheet's.
std::optional<RoundedInterval> declared_gap(const Interpretation& interpretation) {
  const std::vector<Effect>& effects = interpretation.document.effects;
  for (std::size_t i = 0; i < effects.size(); ++i) {
    const auto& parameters = effects[i].kind->parameters;
    if (parameters.empty() || parameters.front().name != "gap_rad") continue;
    return rounded(effects[i].values[0], fmt::format("/effects/{}/parameters/gap_rad", i));
  }
  return std::nullopt;
}

}  // namespace

const Check gear_backlash = {
    .rule = "gear-backlash",
    .unit = "rad",
    .equation = "the gap of the declared effect",
    .demand = Demand::kEqual,
    .weight = Weight::kPlausibility,
    .stated =
        [](const Actuator& document) {
          return sheet_number(document, &Datasheet::backlash_rad, "backlash_rad");
        },
    .expected = declared_gap,
    .interpreters = {},
};

const Check gear_limit = {
    .rule = "gear-limit",
    .unit = "Nm",
    .equation = "peak torque of the gears, at the data sheet's side",
    .demand = Demand::kAtMost,
    .weight = Weight::kContradiction,
    .stated =
        [](const Actuator& document) {
          return sheet_number(document, &Datasheet::peak_torque_Nm, "peak_torque_Nm");
        },
    .expected = gear_peak,
    .interpreters = {side_interpretations},
};

const Check motor_against_gear = {
    .rule = "motor-against-gear",
    .unit = "Nm",
    .equation = "N Kt I at the drive's peak current",
    .demand = Demand::kAtLeast,
    .weight = Weight::kPlausibility,
    .stated = [](const Actuator& document) -> std::optional<RoundedInterval> {
      if (document.transmission.peak_torque_Nm == kUnlimited) return std::nullopt;
      return rounded(document.transmission.peak_torque_Nm, "/gearbox/peak_torque_Nm");
    },
    .expected = motor_peak,
    .interpreters = {},
};

const Check backward_efficiency = {
    .rule = "backward-efficiency",
    .unit = "",
    .equation =
        "2 - 1 / eta_f (equal friction both ways), at most eta_f, at least with 1.5 times the loss",
    .demand = Demand::kEqual,
    .weight = Weight::kPlausibility,
    .stated =
        [](const Actuator& document) {
          return std::optional(efficiency(document.transmission.backward_efficiency,
                                          "/gearbox/backward_efficiency"));
        },
    .expected = backward_expected,
    .interpreters = {},
};

}  // namespace torquewright::actuator::lint
