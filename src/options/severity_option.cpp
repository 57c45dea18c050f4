// SPDX-License-Identifier: Apache-2.0
#include "src/options/severity_option.hpp"

namespace torquewright::cli {

void add_severity_option(command_line::Command& command, SeverityOption& option) {
  command
      .add_option("--severity", option.word,
                  "Print findings of this severity and worse ones alone; JSON keeps all. error: "
                  "violations")
      .one_of({"error", "warning", "note"});
}

actuator::Severity least_severity(const SeverityOption& option) {
  if (option.word == "note") return actuator::Severity::kNote;
  return option.word == "warning" ? actuator::Severity::kWarning : actuator::Severity::kViolation;
}

bool is_filter(const SeverityOption& option) { return option.word != "note"; }

}  // namespace torquewright::cli
