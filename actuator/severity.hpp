// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace torquewright::actuator {

/// Severity of a finding, in lint and check alike; docs/lint.md and docs/checks.md say which rule
/// has which.
enum class Severity {
  kNote,       ///< Nothing is wrong, but worth knowing.
  kWarning,    ///< Something does not fit as it stands, and may under another reading.
  kViolation,  ///< It fits under no reading.
};
std::string_view name_of(Severity severity);

}  // namespace torquewright::actuator
