// SPDX-License-Identifier: Apache-2.0
#include "actuator/lint/other_voltage.hpp"

#include <fmt/format.h>

#include <cmath>

namespace torquewright::actuator::lint {
namespace {

/// IEC 60038:2009, table 6: preferred nominal voltages below 120 V d.c., in V.
constexpr double kPreferred_V[] = {6, 12, 24, 36, 48, 60, 72, 96, 110};

double sheet_voltage_V(const Actuator& document) {
  const double bus_V = document.drive.bus_voltage_V;
  return document.datasheet ? document.datasheet->voltage_V.value_or(bus_V) : bus_V;
}

}  // namespace

std::vector<Explanation> other_voltage(const Actuator& document, const RoundedInterval& stated,
                                       const RoundedInterval& expected) {
  if (expected.low <= 0.0) return {};
  const double volts = sheet_voltage_V(document);
  const RoundedInterval needed_V =
      derive([volts](double is, double was) { return volts * is / was; }, stated, expected);
  const auto explains = [&](double other_V) {  // what tolerance takes needs no other voltage
    return std::abs(other_V / volts - 1.0) > kCatalogueShare && needed_V.low <= other_V &&
           other_V <= needed_V.high;
  };
  const auto explanation = [](double other_V) {
    return std::vector<Explanation>{
        {fmt::format("stated at {:g} V", other_V), std::nullopt, Agreement::kFits}};
  };
  if (explains(document.drive.bus_voltage_V)) return explanation(document.drive.bus_voltage_V);
  for (const double preferred_V : kPreferred_V) {
    if (explains(preferred_V)) return explanation(preferred_V);
  }
  return {};
}

}  // namespace torquewright::actuator::lint
