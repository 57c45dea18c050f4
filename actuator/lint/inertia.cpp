// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "actuator/lint/every_check.hpp"
#include "actuator/lint/quantities.hpp"

namespace torquewright::actuator::lint {
namespace {

RoundedInterval gear_inertia(const Transmission& gear) {
  if (gear.inertia_kg_m2 == 0.0) return exact(0.0);
  return gear.source.empty() ? rounded(gear.inertia_kg_m2, "/gearbox/inertia_kg_m2")
                             : exact(gear.inertia_kg_m2, "/gearbox/file");
}

/// N^2 J + J_gear.
std::optional<RoundedInterval> expected(const Interpretation& interpretation) {
  const Actuator& document = interpretation.document;
  if (document.motor.rotor_inertia_kg_m2 == 0.0) return std::nullopt;
  const int power = interpretation.ratio_power_of_inertia;
  return derive([power](double turns, double rotor,
                        double gears) { return std::pow(turns, power) * rotor + gears; },
                ratio(document),
                printed(document, document.motor.rotor_inertia_kg_m2, "/motor/rotor_inertia_kg_m2"),
                gear_inertia(document.transmission));
}

std::vector<Interpretation> inertia_interpretations(const Interpretation& stated) {
  Interpretation rotor = stated;
  rotor.ratio_power_of_inertia = 0;
  rotor.sentence = "the rotor's own inertia, not carried to the joint";
  Interpretation once = stated;
  once.ratio_power_of_inertia = 1;
  once.sentence = "carried over by the ratio instead of its square";
  Interpretation bare = stated;
  bare.document.transmission.inertia_kg_m2 = 0.0;
  bare.sentence = "without the gears' own inertia";
  return {rotor, once, bare};
}

/// More than the rotor's: what the gears would have to add.
std::vector<Explanation> further(const Actuator& /*document*/, const RoundedInterval& stated,
                                 const RoundedInterval& expected) {
  if (!lies_above(stated, expected) || stated.low > 2.0 * expected.high) return {};
  RoundedInterval missing =
      derive([](double all, double rotor) { return all - rotor; }, stated, expected);
  return {{"inertia of the gears beyond what is stated, of", missing, Agreement::kFits}};
}

}  // namespace

const Check reflected_inertia = {
    .rule = "reflected-inertia",
    .unit = "kg m^2",
    .equation = "N^2 J + gears",
    .demand = Demand::kEqual,
    .weight = Weight::kContradiction,
    .stated =
        [](const Actuator& document) {
          return sheet_number(document, &Datasheet::reflected_inertia_kg_m2,
                              "reflected_inertia_kg_m2");
        },
    .expected = expected,
    .interpreters = {inertia_interpretations},
    .further = further,
    .tolerance = catalogue,
};

}  // namespace torquewright::actuator::lint
