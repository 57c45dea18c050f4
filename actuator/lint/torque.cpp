// SPDX-License-Identifier: Apache-2.0
#include "actuator/lint/torque.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "actuator/lint/every_check.hpp"
#include "actuator/lint/quantities.hpp"

namespace torquewright::actuator::lint {
namespace {

constexpr const char* kPeakCurrent = "/datasheet/peak_torque_current_A";
constexpr const char* kContinuousCurrent = "/drive/continuous_current_A";
constexpr const char* kNoLoadCurrent = "/datasheet/no_load_current_A";

std::optional<RoundedInterval> stated_peak(const Actuator& document) {
  return sheet_number(document, &Datasheet::peak_torque_Nm, "peak_torque_Nm");
}

std::optional<RoundedInterval> stated_peak_current(const Actuator& document) {
  return sheet_condition(document, &Datasheet::peak_torque_current_A, "peak_torque_current_A");
}

std::optional<RoundedInterval> peak_expected(const Interpretation& interpretation) {
  const std::optional<RoundedInterval> stated_A = stated_peak_current(interpretation.document);
  return sheet_torque(interpretation,
                      stated_A ? torque_constant_amperes(interpretation, *stated_A, kPeakCurrent)
                               : peak_current(interpretation),
                      "peak_torque_Nm");
}

std::optional<RoundedInterval> stated_rated(const Actuator& document) {
  return sheet_number(document, &Datasheet::rated_torque_Nm, "rated_torque_Nm");
}

std::optional<RoundedInterval> rated_expected(const Interpretation& interpretation) {
  const std::optional<double>& current_A = interpretation.document.drive.continuous_current_A;
  if (!current_A) return std::nullopt;
  const RoundedInterval amperes = torque_constant_amperes(
      interpretation, condition(interpretation.document, *current_A, kContinuousCurrent),
      kContinuousCurrent);
  return sheet_torque(interpretation, less_drag(interpretation, amperes), "rated_torque_Nm");
}

std::optional<RoundedInterval> stated_braking(const Actuator& document) {
  return sheet_number(document, &Datasheet::peak_braking_torque_Nm, "peak_braking_torque_Nm");
}

/// Driving: eta_f N tau. Driven back: N tau / eta_b. So their ratio is 1 / (eta_f eta_b).
std::optional<RoundedInterval> braking_expected(const Interpretation& interpretation) {
  const Transmission& gear = interpretation.document.transmission;
  const std::optional<RoundedInterval> driving = stated_peak(interpretation.document);
  if (!driving || !(gear.backward_efficiency > 0.0)) return std::nullopt;
  return derive([](double torque_Nm, double forward,
                   double backward) { return torque_Nm / (forward * backward); },
                *driving, efficiency(gear.forward_efficiency, "/gearbox/forward_efficiency"),
                efficiency(gear.backward_efficiency, "/gearbox/backward_efficiency"));
}

}  // namespace

RoundedInterval sheet_torque(const Interpretation& interpretation, const RoundedInterval& current_A,
                             const char* name) {
  return derive([](double constant_Nm_A, double amperes,
                   double factor) { return constant_Nm_A * amperes * factor; },
                sheet_torque_constant(interpretation.document, name), current_A,
                exact(interpretation.current_factor));
}

RoundedInterval less_drag(const Interpretation& interpretation, RoundedInterval current_A) {
  const std::optional<RoundedInterval> drag_A =
      sheet_number(interpretation.document, &Datasheet::no_load_current_A, "no_load_current_A");
  if (!drag_A) return current_A;
  const RoundedInterval taken_A = torque_constant_amperes(interpretation, *drag_A, kNoLoadCurrent);
  current_A.low = std::max(0.0, current_A.low - taken_A.high);
  current_A.pointers = united(current_A.pointers, drag_A->pointers);
  return current_A;
}

std::vector<Explanation> losses(const Actuator& /*document*/, const RoundedInterval& stated,
                                const RoundedInterval& expected) {
  if (!lies_above(expected, stated)) return {};
  const RoundedInterval share =
      derive([](double is, double was) { return 100.0 * (1.0 - is / was); }, stated, expected);
  if (share.low > kGreatestLoss_percent) return {};
  return {
      {fmt::format("friction, gear losses or saturation that take {:.1f} % ({:.1f} to {:.1f} %)",
                   share.value, share.low, share.high),
       std::nullopt, Agreement::kFits}};
}

const Check peak_torque = {
    .rule = "peak-torque",
    .unit = "Nm",
    .equation = "eta N Kt I",
    .demand = Demand::kEqual,
    .weight = Weight::kContradiction,
    .stated = stated_peak,
    .expected = peak_expected,
    .interpreters = {loss_interpretations, side_interpretations, ampere_interpretations},
    .further = losses,
    .tolerance = peak_torques,
};

const Check peak_torque_current = {
    .rule = "peak-torque-current",
    .unit = "A",
    .equation = "the drive's peak current",
    .demand = Demand::kAtMost,
    .weight = Weight::kPlausibility,
    .stated = stated_peak_current,
    .expected =
        [](const Interpretation& interpretation) {
          const RoundedInterval limit_A = derive(product, peak_current(interpretation),
                                                 exact(1.0 / interpretation.current_factor));
          return std::optional(printed_amperes(interpretation, limit_A, kPeakCurrent));
        },
    .interpreters = {ampere_interpretations},
};

const Check rated_torque = {
    .rule = "rated-torque",
    .unit = "Nm",
    .equation = "eta N Kt I, I the continuous current",
    .demand = Demand::kEqual,
    .weight = Weight::kContradiction,
    .stated = stated_rated,
    .expected = rated_expected,
    .interpreters = {loss_interpretations, side_interpretations, ampere_interpretations},
    .further = losses,
    .tolerance = rated_torques,
};

const Check peak_braking_torque = {
    .rule = "peak-braking-torque",
    .unit = "Nm",
    .equation = "peak torque / (eta_f eta_b)",
    .demand = Demand::kEqual,
    .weight = Weight::kContradiction,
    .stated = stated_braking,
    .expected = braking_expected,
    .interpreters = {loss_interpretations},
};

}  // namespace torquewright::actuator::lint
