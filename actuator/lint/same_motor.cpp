// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "actuator/lint/common_convention.hpp"
#include "actuator/lint/quantities.hpp"

namespace torquewright::actuator::lint {
namespace {

/// A number of the data sheet as it would be at the rotor.
struct AtRotor {
  const char* rule;
  const char* unit;
  std::optional<RoundedInterval> (*interval)(const Actuator& document);
};

std::optional<RoundedInterval> scaled(const Actuator& document, SheetKey key, const char* name,
                                      double (*scale)(double number, double turns)) {
  const std::optional<RoundedInterval> number = sheet_number(document, key, name);
  if (!number) return std::nullopt;
  return derive(scale, *number, sheet_ratio(document, name));
}

const AtRotor kNumbers[] = {
    {"same-motor-speed", "rad/s",
     [](const Actuator& document) {
       return scaled(document, &Datasheet::no_load_speed_rad_s, "no_load_speed_rad_s",
                     [](double speed_rad_s, double turns) { return speed_rad_s * turns; });
     }},
    {"same-motor-torque", "Nm",
     [](const Actuator& document) {
       std::optional<RoundedInterval> torque =
           scaled(document, &Datasheet::peak_torque_Nm, "peak_torque_Nm",
                  [](double torque_Nm, double turns) { return torque_Nm / turns; });
       if (!torque) return torque;
       return std::optional(
           derive([](double after, double efficiency) { return after / efficiency; }, *torque,
                  sheet_efficiency(document, "peak_torque_Nm")));
     }},
    {"same-motor-inertia", "kg m^2",
     [](const Actuator& document) -> std::optional<RoundedInterval> {
       const auto inertia =
           sheet_number(document, &Datasheet::reflected_inertia_kg_m2, "reflected_inertia_kg_m2");
       if (!inertia) return std::nullopt;
       return derive([](double joint, double turns) { return joint / (turns * turns); }, *inertia,
                     ratio(document));
     }},
};

bool is_same_motor(const Actuator& one, const Actuator& other) {
  return one.motor.torque_constant_Nm_A == other.motor.torque_constant_Nm_A &&
         one.motor.torque_constant_convention == other.motor.torque_constant_convention &&
         one.motor.resistance_ohm == other.motor.resistance_ohm &&
         one.motor.rotor_inertia_kg_m2 == other.motor.rotor_inertia_kg_m2 &&
         one.drive.bus_voltage_V == other.drive.bus_voltage_V &&
         one.drive.peak_current_A == other.drive.peak_current_A &&
         one.transmission.ratio != other.transmission.ratio;
}

/// Rotor J and one gear inertia G at the joint: N^2 J + G for both.
std::vector<Explanation> gear_inertia(const Actuator& one, const Actuator& other) {
  const double first = ratio(one).value * ratio(one).value;
  const double second = ratio(other).value * ratio(other).value;
  const double at_first = *one.datasheet->reflected_inertia_kg_m2;
  const double at_second = *other.datasheet->reflected_inertia_kg_m2;
  const double rotor = (at_second - at_first) / (second - first);
  const double gears = at_first - first * rotor;
  const bool is_possible = rotor > 0.0 && gears >= 0.0;
  return {{fmt::format("a rotor of {:.4g} kg m^2 and gears of {:.4g} kg m^2 at each joint", rotor,
                       gears),
           std::nullopt, is_possible ? Agreement::kFits : Agreement::kExcludes}};
}

std::optional<Finding> compare(const AtRotor& number, const Actuator& one, const Actuator& other) {
  const std::optional<RoundedInterval> first = number.interval(one);
  const std::optional<RoundedInterval> second = number.interval(other);
  if (!first || !second || overlap(*first, *second)) return std::nullopt;
  Finding finding;
  finding.rule = number.rule;
  finding.actuator = one.name + ", " + other.name;
  finding.unit = number.unit;
  finding.stated = *second;
  finding.expected = *first;
  if (finding.rule == "same-motor-inertia") finding.explanations = gear_inertia(one, other);
  finding.severity = contradiction(finding.explanations);
  finding.sentence = fmt::format(
      "{} and {} state one motor on two ratios, but {} gives {} at the rotor of the first and {} "
      "at "
      "that of the second: correct one, or state what differs between the motors.",
      one.name, other.name, first->pointers.front(), with_interval(*first, number.unit),
      with_interval(*second, number.unit));
  return finding;
}

}  // namespace

std::vector<Finding> same_motor(std::span<const Actuator> documents) {
  std::vector<Finding> findings;
  for (std::size_t i = 0; i < documents.size(); ++i) {
    for (std::size_t j = i + 1; j < documents.size(); ++j) {
      if (!is_same_motor(documents[i], documents[j])) continue;
      for (const AtRotor& number : kNumbers) {
        if (auto finding = compare(number, documents[i], documents[j]))
          findings.push_back(*finding);
      }
    }
  }
  return findings;
}

}  // namespace torquewright::actuator::lint
