// SPDX-License-Identifier: Apache-2.0
#include "actuator/lint/few_digits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>

#include "actuator/lint/quantities.hpp"
#include "actuator/lint/tolerance.hpp"
#include "actuator/motor/statement.hpp"

namespace torquewright::actuator::lint {
namespace {

struct Constant {
  const char* pointer;
  const char* unit;
  std::optional<double> value;
};

std::vector<Constant> constants(const Actuator& document) {
  const Motor& motor = document.motor;
  return {{"/motor/torque_constant_Nm_A", "Nm/A", motor.torque_constant_Nm_A},
          {"/motor/back_emf_constant_V_s_rad", "V s/rad", motor.back_emf_constant_V_s_rad},
          {"/motor/resistance_ohm", "ohm", motor.resistance_ohm},
          {"/datasheet/velocity_constant_rpm_V", "rpm/V",
           document.datasheet ? document.datasheet->velocity_constant_rpm_V : std::nullopt}};
}

/// Itself, or what it stands in.
bool is_assumed(const Actuator& document, const std::string& pointer) {
  return std::any_of(
      document.assumed.begin(), document.assumed.end(),
      [&](const std::string& each) { return pointer == each || pointer.starts_with(each + "/"); });
}

bool says_enough(const Actuator& document, const Constant& constant) {
  const Statement* statement = find_statement(document, constant.pointer);
  const bool is_said = statement != nullptr && (statement->tolerance || statement->bound);
  return is_said || is_assumed(document, constant.pointer);
}

Finding note_on(const Actuator& document, const Constant& constant, const RoundedInterval& known) {
  Finding finding;
  finding.rule = "few-digits";
  finding.actuator = document.name;
  finding.unit = constant.unit;
  finding.stated = known;
  finding.expected = exact(known.value);
  // One more digit, a zero that was lost on reading.
  const double tolerance = 0.1 * (known.high - known.value) / known.value;
  finding.sentence = fmt::format(
      "{} says {}: its decimals leave so much open that little can contradict it; if a zero more "
      "was printed, state {{\"value\": {:g}, \"tolerance\": {:.3g}}}.",
      constant.pointer, with_interval(known, constant.unit), known.value, tolerance);
  return finding;
}

}  // namespace

std::vector<Finding> few_digits(const Actuator& document) {
  std::vector<Finding> notes;
  for (const Constant& constant : constants(document)) {
    if (!constant.value || says_enough(document, constant)) continue;
    const RoundedInterval known = printed(document, *constant.value, constant.pointer);
    if (known.high - known.value > kCatalogueShare * known.value) {
      notes.push_back(note_on(document, constant, known));
    }
  }
  return notes;
}

}  // namespace torquewright::actuator::lint
