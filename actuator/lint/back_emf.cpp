// SPDX-License-Identifier: Apache-2.0
#include <numbers>

#include "actuator/lint/every_check.hpp"
#include "actuator/lint/quantities.hpp"

namespace torquewright::actuator::lint {
namespace {

constexpr double kRpmPerRad_s = 30.0 / std::numbers::pi;

/// What a machine without losses of that torque constant would show: 2/3 Kt per phase.
RoundedInterval phase_back_emf_of_torque_constant(const Actuator& document) {
  return derive(product, phase_torque_constant(document), exact(2.0 / 3.0));
}

std::optional<RoundedInterval> back_emf_expected(const Interpretation& interpretation) {
  return derive(product, phase_back_emf_of_torque_constant(interpretation.document),
                exact(volts_per_phase_volt(interpretation.emf_measure)));
}

/// Kv = 60 / (2 pi Ke), Ke line to line unless read otherwise.
std::optional<RoundedInterval> velocity_constant_expected(const Interpretation& interpretation) {
  return derive([](double back_emf, double volts_per_volt,
                   double turns) { return kRpmPerRad_s / (back_emf * volts_per_volt * turns); },
                phase_back_emf_of_torque_constant(interpretation.document),
                exact(volts_per_phase_volt(interpretation.speed_constant_measure)),
                sheet_ratio(interpretation.document, "velocity_constant_rpm_V"));
}

}  // namespace

const Check back_emf_constant = {
    .rule = "back-emf-constant",
    .unit = "V s/rad",
    .equation = "Kt in its convention",
    .demand = Demand::kEqual,
    .weight = Weight::kContradiction,
    .stated = stated_back_emf,
    .expected = back_emf_expected,
    .interpreters = {emf_interpretations},
    .tolerance = catalogue,
};

const Check velocity_constant = {
    .rule = "velocity-constant",
    .unit = "rpm/V",
    .equation = "60 / (2 pi Ke N), Ke line to line from Kt",
    .demand = Demand::kEqual,
    .weight = Weight::kContradiction,
    .stated =
        [](const Actuator& document) {
          return sheet_number(document, &Datasheet::velocity_constant_rpm_V,
                              "velocity_constant_rpm_V");
        },
    .expected = velocity_constant_expected,
    .interpreters = {emf_interpretations, side_interpretations},
    .tolerance = speeds,
};

}  // namespace torquewright::actuator::lint
