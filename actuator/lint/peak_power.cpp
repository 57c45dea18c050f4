// SPDX-License-Identifier: Apache-2.0
#include "actuator/lint/every_check.hpp"
#include "actuator/lint/quantities.hpp"

namespace torquewright::actuator::lint {
namespace {

/// Greatest power at the shaft, 1.5 i (V - R i): at the current limit, or at half the stall current
/// V / 2R where that is less. Electrical: what the bus delivers at that point, 1.5 V i.
double greatest_power_W(double volts, double ohms, double limit_A, bool is_electrical) {
  const double amperes = std::min(limit_A, 0.5 * volts / ohms);
  return 1.5 * amperes * (is_electrical ? volts : volts - ohms * amperes);
}

std::optional<RoundedInterval> expected(const Interpretation& interpretation) {
  const bool is_electrical = interpretation.power_is_electrical;
  const RoundedInterval gears =
      is_electrical ? exact(1.0) : sheet_efficiency(interpretation.document, "peak_power_W");
  return derive(
      [is_electrical](double volts, double ohms, double limit_A, double efficiency) {
        return efficiency * greatest_power_W(volts, ohms, limit_A, is_electrical);
      },
      phase_voltage(interpretation.document), phase_resistance(interpretation.document),
      phase_current(interpretation, peak_current(interpretation)), gears);
}

std::vector<Interpretation> electrical_interpretations(const Interpretation& stated) {
  Interpretation interpretation = stated;
  interpretation.power_is_electrical = true;
  interpretation.sentence = "power drawn from the bus, not at the shaft";
  return {interpretation};
}

}  // namespace

const Check peak_power = {
    .rule = "peak-power",
    .unit = "W",
    .equation = "eta I (V - R I), I the lesser of peak current and V / 2R",
    .demand = Demand::kAtMost,  // a limit of the speed, or of heat, may keep it below
    .weight = Weight::kContradiction,
    .stated =
        [](const Actuator& document) {
          return sheet_number(document, &Datasheet::peak_power_W, "peak_power_W");
        },
    .expected = expected,
    .interpreters = {electrical_interpretations, loss_interpretations, ohm_interpretations,
                     speed_interpretations, ampere_interpretations},
    .tolerance = peak_torques,
};

}  // namespace torquewright::actuator::lint
