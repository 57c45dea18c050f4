// SPDX-License-Identifier: Apache-2.0
#include "actuator/lint/every_check.hpp"
#include "actuator/lint/quantities.hpp"

namespace torquewright::actuator::lint {
namespace {

/// Electrical time constants of servo motors, from coreless to large slow ones.
constexpr double kShortest_s = 2e-5;
constexpr double kLongest_s = 2e-2;
/// Less than this part of the characteristic current weakens the field by less than 5 %.
constexpr double kUsefulShare = 0.05;
constexpr const char* kDemagnetisation = "/motor/demagnetisation_current_A";

/// L / R of one phase, the longer of both axes.
std::optional<RoundedInterval> electrical_expected(const Interpretation& interpretation) {
  const Motor& motor = interpretation.document.motor;
  const bool is_q = motor.inductance_q_H >= motor.inductance_d_H;
  const RoundedInterval inductance_H =
      is_q ? inductance_q(interpretation.document) : inductance_d(interpretation.document);
  if (inductance_H.value == 0.0) return std::nullopt;
  return derive([](double henry, double ohms) { return henry / ohms; }, inductance_H,
                phase_resistance(interpretation.document));
}

/// J R / (Kt Ke), of the rotor alone.
std::optional<RoundedInterval> mechanical_expected(const Interpretation& interpretation) {
  const double inertia_kg_m2 = interpretation.document.motor.rotor_inertia_kg_m2;
  if (inertia_kg_m2 == 0.0) return std::nullopt;
  return derive([](double inertia, double ohms, double torque_constant,
                   double back_emf) { return inertia * ohms / (torque_constant * back_emf); },
                printed(interpretation.document, inertia_kg_m2, "/motor/rotor_inertia_kg_m2"),
                phase_resistance(interpretation.document),
                phase_torque_constant(interpretation.document), phase_back_emf(interpretation));
}

std::optional<RoundedInterval> plausible_inductance(const Interpretation& interpretation) {
  const RoundedInterval ohms = phase_resistance(interpretation.document);
  RoundedInterval expected = ohms;
  expected.value = 1e-3 * ohms.value;
  expected.low = kShortest_s * ohms.low;
  expected.high = kLongest_s * ohms.high;
  return expected;
}

bool weakens(const Actuator& document) {
  return document.drive.field_weakening && document.motor.inductance_d_H > 0.0;
}

/// Ke / (p L_d), in the amperes of the drive's peak current, times the useful share.
std::optional<RoundedInterval> least_useful_current(const Interpretation& interpretation) {
  const Motor& motor = interpretation.document.motor;
  if (!weakens(interpretation.document)) return std::nullopt;
  return derive(
      [](double back_emf, double pole_pairs, double henry, double amperes) {
        return kUsefulShare * back_emf / (pole_pairs * henry * amperes);
      },
      phase_back_emf(interpretation), exact(motor.pole_pairs, "/motor/pole_pairs"),
      inductance_d(interpretation.document),
      phase_current(interpretation,
                    torque_constant_amperes(interpretation, exact(1.0), "/drive/peak_current_A")));
}

RoundedInterval printed_peak_current(const Actuator& document) {
  return condition(document, document.drive.peak_current_A, "/drive/peak_current_A");
}

}  // namespace

const Check electrical_time_constant = {
    .rule = "electrical-time-constant",
    .unit = "s",
    .equation = "L / R of one phase",
    .demand = Demand::kEqual,
    .weight = Weight::kContradiction,
    .stated =
        [](const Actuator& document) {
          return sheet_number(document, &Datasheet::electrical_time_constant_s,
                              "electrical_time_constant_s");
        },
    .expected = electrical_expected,
    .interpreters = {ohm_interpretations},
    .tolerance = catalogue,
};

const Check mechanical_time_constant = {
    .rule = "mechanical-time-constant",
    .unit = "s",
    .equation = "J R / (Kt Ke)",
    .demand = Demand::kEqual,
    .weight = Weight::kContradiction,
    .stated =
        [](const Actuator& document) {
          return sheet_number(document, &Datasheet::mechanical_time_constant_s,
                              "mechanical_time_constant_s");
        },
    .expected = mechanical_expected,
    .interpreters = {ohm_interpretations, speed_interpretations},
    .tolerance = catalogue,
};

const Check winding_inductance = {
    .rule = "winding-inductance",
    .unit = "H",
    .equation = "R of one phase times 20 us to 20 ms",
    .demand = Demand::kEqual,
    .weight = Weight::kPlausibility,
    .stated = [](const Actuator& document) -> std::optional<RoundedInterval> {
      if (document.motor.inductance_q_H == 0.0) return std::nullopt;
      return inductance_q(document);
    },
    .expected = plausible_inductance,
    .interpreters = {ohm_interpretations},
};

const Check characteristic_current = {
    .rule = "characteristic-current",
    .unit = "A",
    .equation = "5 % of the characteristic current Ke / (p L_d): less hardly weakens the field",
    .demand = Demand::kAtLeast,
    .weight = Weight::kPlausibility,
    .stated =
        [](const Actuator& document) { return std::optional(printed_peak_current(document)); },
    .expected = least_useful_current,
    .interpreters = {},
};

const Check magnet_limit = {
    .rule = "magnet-limit",
    .unit = "A",
    .equation = "the drive's peak current, which field weakening would turn against the magnets",
    .demand = Demand::kAtLeast,
    .weight = Weight::kPlausibility,
    .stated = [](const Actuator& document) -> std::optional<RoundedInterval> {
      if (document.motor.demagnetisation_current_A == kUnlimited) return std::nullopt;
      return printed(document, document.motor.demagnetisation_current_A, kDemagnetisation);
    },
    .expected = [](const Interpretation& interpretation) -> std::optional<RoundedInterval> {
      if (!weakens(interpretation.document)) return std::nullopt;
      return printed_amperes(interpretation, peak_current(interpretation), kDemagnetisation);
    },
    .interpreters = {},
};

}  // namespace torquewright::actuator::lint
