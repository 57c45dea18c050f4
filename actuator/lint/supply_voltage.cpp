// SPDX-License-Identifier: Apache-2.0
#include "actuator/lint/supply_voltage.hpp"

#include <fmt/format.h>

#include <cmath>

#include "actuator/lint/every_check.hpp"
#include "actuator/lint/quantities.hpp"

namespace torquewright::actuator::lint {
namespace {

constexpr const char* kCell = "/battery/cell_open_circuit_V";

/// The pack without load when it is full (`index` the last entry) or at another entry of its curve.
RoundedInterval pack_voltage(const Battery& battery, std::size_t index) {
  return derive(product, exact(battery.series_cells, "/battery/series_cells"),
                rounded(battery.cell_open_circuit[index].voltage_V, kCell));
}

std::optional<RoundedInterval> full_pack(const Actuator& document) {
  if (!document.battery || document.battery->cell_open_circuit.empty()) return std::nullopt;
  return pack_voltage(*document.battery, document.battery->cell_open_circuit.size() - 1);
}

std::vector<Interpretation> charge_interpretations(const Interpretation& stated) {
  std::vector<Interpretation> interpretations;
  if (!stated.document.battery) return interpretations;
  for (std::size_t left = stated.document.battery->cell_open_circuit.size(); left > 1; --left) {
    Interpretation interpretation = stated;
    interpretation.document.battery->cell_open_circuit.resize(left - 1);
    const double charge = interpretation.document.battery->cell_open_circuit.back().state_of_charge;
    interpretation.sentence = fmt::format("the battery at a state of charge of {:g}", charge);
    interpretations.push_back(interpretation);
  }
  return interpretations;
}

/// A cell that is neither empty nor full: the bus may be stated for its nominal voltage.
constexpr double kEmptyCell_V = 2.5;
constexpr double kFullCell_V = 4.4;

std::vector<Explanation> nominal_cell(const Actuator& document, const RoundedInterval& stated,
                                      const RoundedInterval& /*expected*/) {
  const double cell_V = stated.value / document.battery->series_cells;
  const bool is_cell = cell_V >= kEmptyCell_V && cell_V <= kFullCell_V;
  return {
      {fmt::format("a bus stated for cells of {:.4g} V (nominal, or at another charge)", cell_V),
       std::nullopt, is_cell ? Agreement::kFits : Agreement::kExcludes}};
}

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

const Check bus_voltage = {
    .rule = "bus-voltage",
    .unit = "V",
    .equation = "cells in series times the full cell's open-circuit voltage",
    .demand = Demand::kEqual,
    .weight = Weight::kContradiction,
    .stated =
        [](const Actuator& document) {
          return std::optional(rounded(document.drive.bus_voltage_V, "/drive/bus_voltage_V"));
        },
    .expected =
        [](const Interpretation& interpretation) { return full_pack(interpretation.document); },
    .interpreters = {charge_interpretations},
    .further = nominal_cell,
};

const Check charge_voltage = {
    .rule = "charge-voltage",
    .unit = "V",
    .equation = "open-circuit voltage of the full pack",
    .demand = Demand::kAtLeast,
    .weight = Weight::kContradiction,
    .stated = [](const Actuator& document) -> std::optional<RoundedInterval> {
      if (!document.battery || document.battery->maximum_voltage_V == kUnlimited) {
        return std::nullopt;
      }
      return rounded(document.battery->maximum_voltage_V, "/battery/maximum_voltage_V");
    },
    .expected =
        [](const Interpretation& interpretation) { return full_pack(interpretation.document); },
    .interpreters = {charge_interpretations},
};

}  // namespace torquewright::actuator::lint
