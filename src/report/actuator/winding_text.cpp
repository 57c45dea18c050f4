// SPDX-License-Identifier: Apache-2.0
#include "src/report/actuator/winding_text.hpp"

#include <fmt/format.h>

#include <cmath>

namespace torquewright::report {
namespace {

std::string row(std::string_view name, const actuator::WindingInterval& interval,
                std::string_view unit) {
  const std::string to =
      std::isfinite(interval.high) ? fmt::format("{:.4g}", interval.high) : "no limit known";
  return fmt::format("  {:<34}{:.4g} to {} {}\n", name, interval.low, to, unit);
}

}  // namespace

std::string winding_text(const actuator::WindingEstimate& estimate) {
  std::string text = "\nwinding behind the curve, at the motor's shaft, as one (dc) winding\n";
  if (!estimate.contradiction.empty()) {
    return text + "  contradiction: the curve's, " + estimate.contradiction +
           " cannot be together; one of them is another\n";
  }
  text += row("torque constant", estimate.torque_constant_Nm_A, "Nm/A") +
          row("resistance between terminals", estimate.resistance_ohm, "ohm") +
          row("voltage", estimate.voltage_V, "V") +
          row("current at the peak torque", estimate.current_A, "A");
  text += "  an estimate, which nothing else of the program reads. It rests on:\n";
  for (const std::string& each : estimate.rests_on) text += "  - " + each + "\n";
  return text;
}

}  // namespace torquewright::report
