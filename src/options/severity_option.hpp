// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "actuator/severity.hpp"
#include "src/command_line/command_line.hpp"

namespace torquewright::cli {

/// The least severity that an option names, in words: all findings where it is "note".
struct SeverityOption {
  std::string word = "note";
};

void add_severity_option(command_line::Command& command, SeverityOption& option);

actuator::Severity least_severity(const SeverityOption& option);

/// Whether something is left out.
bool is_filter(const SeverityOption& option);

}  // namespace torquewright::cli
