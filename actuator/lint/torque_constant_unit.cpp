// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "actuator/lint/every_check.hpp"
#include "actuator/lint/quantities.hpp"

namespace torquewright::actuator::lint {
namespace {

/// Torque per root of copper loss, Kt / sqrt(1.5 R) in amplitudes, grows with a motor's size: some
/// 0.005 for the smallest, 10 for a hub motor of 50 kg.
constexpr double kGreatestMotorConstant_Nm_sqrtW = 20.0;
/// A motor that turns no faster without load, at the rotor, is none.
constexpr double kSlowest_rad_s = 5.0;
constexpr double kMilli = 1e-3;

/// The greatest torque constant that a motor of that winding and voltage has; only said where it is
/// exceeded, since it is no statement of the document.
std::optional<RoundedInterval> greatest_plausible(const Interpretation& interpretation) {
  const Actuator& document = interpretation.document;
  const double stated_Nm_A = document.motor.torque_constant_Nm_A;
  const double per_phase = phase_torque_constant(document).value / stated_Nm_A;
  RoundedInterval limit = phase_resistance(document);
  limit.value = std::min(kGreatestMotorConstant_Nm_sqrtW * std::sqrt(1.5 * limit.value) / per_phase,
                         document.drive.bus_voltage_V / kSlowest_rad_s);
  if (stated_Nm_A <= limit.value) return std::nullopt;
  limit.low = 0.0;
  limit.high = limit.value;
  limit.pointers.emplace_back("/drive/bus_voltage_V");
  return limit;
}

std::vector<Explanation> further(const Actuator& /*document*/, const RoundedInterval& stated,
                                 const RoundedInterval& expected) {
  RoundedInterval in_milli = stated;
  for (double* value : {&in_milli.value, &in_milli.low, &in_milli.high}) *value *= kMilli;
  const bool fits = in_milli.value <= expected.value;
  return {
      {"written in mNm/A: then it is", in_milli, fits ? Agreement::kFits : Agreement::kExcludes}};
}

}  // namespace

const Check torque_constant_unit = {
    .rule = "torque-constant-unit",
    .unit = "Nm/A",
    .equation = "the most that motors of that resistance and voltage have",
    .demand = Demand::kAtMost,
    .weight = Weight::kContradiction,
    .stated = [](const Actuator& document) -> std::optional<RoundedInterval> {
      return torque_constant(document);
    },
    .expected = greatest_plausible,
    .interpreters = {},
    .stands_alone = true,
    .further = further,
};

}  // namespace torquewright::actuator::lint
