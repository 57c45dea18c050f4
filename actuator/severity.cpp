// SPDX-License-Identifier: Apache-2.0
#include "actuator/severity.hpp"

namespace torquewright::actuator {

std::string_view name_of(Severity severity) {
  switch (severity) {
    case Severity::kNote:
      return "note";
    case Severity::kWarning:
      return "warning";
    case Severity::kViolation:
      break;
  }
  return "violation";
}

}  // namespace torquewright::actuator
