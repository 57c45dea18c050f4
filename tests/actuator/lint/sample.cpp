// SPDX-License-Identifier: Apache-2.0
#include "tests/actuator/lint/sample.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "actuator/motor/actuator_spec.hpp"

namespace torquewright::actuator::lint {
namespace {

template <typename List>
auto of_rule(const List& list, std::string_view rule) {
  using Entry = typename List::value_type;
  const auto place = std::find_if(list.begin(), list.end(),
                                  [rule](const Entry& entry) { return entry.rule == rule; });
  return place == list.end() ? std::optional<Entry>() : std::optional<Entry>(*place);
}

}  // namespace

Actuator sample() {
  Actuator document;
  document.name = "sample";
  document.motor.torque_constant_Nm_A = 0.125;
  document.motor.resistance_ohm = 0.25;
  document.motor.pole_pairs = 10;
  document.motor.rotor_inertia_kg_m2 = 0.00045;
  document.drive.bus_voltage_V = 24;
  document.drive.peak_current_A = 40;
  document.transmission = {.ratio = 10,
                           .forward_efficiency = 0.95,
                           .backward_efficiency = 0.94,
                           .inertia_kg_m2 = 0,
                           .peak_torque_Nm = kUnlimited,
                           .source = ""};
  document.datasheet = Datasheet{};
  document.datasheet->joint_side = true;
  return document;
}

Actuator from_specs(const char* file) {
  const auto folder = std::filesystem::path(TORQUEWRIGHT_SOURCE_DIR) / "specs/actuator";
  return read_actuator(folder / file).actuator;
}

std::optional<Comparison> comparison(const Actuator& document, std::string_view rule) {
  return of_rule(examine(document).comparisons, rule);
}

std::optional<Finding> finding(const Examination& examination, std::string_view rule) {
  return of_rule(examination.findings, rule);
}

std::optional<Finding> finding(const Actuator& document, std::string_view rule) {
  return finding(examine(document), rule);
}

Explanation explanation(const Finding& finding, std::string_view sentence) {
  for (const Explanation& one : finding.explanations) {
    if (one.sentence == sentence) return one;
  }
  ADD_FAILURE() << "no explanation \"" << sentence << "\"";
  return {};
}

}  // namespace torquewright::actuator::lint
