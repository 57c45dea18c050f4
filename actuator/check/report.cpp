// SPDX-License-Identifier: Apache-2.0
#include "actuator/check/report.hpp"

namespace torquewright::actuator {

std::string_view name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::kPass:
      return "pass";
    case Verdict::kFail:
      return "fail";
    case Verdict::kUndecided:
      break;
  }
  return "undecided";
}

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

bool fails(const Reading& reading) {
  if (reading.clipped_samples > 0) return true;
  return reading.winding && !(reading.winding->peak_K <= reading.winding->limit_K);
}

}  // namespace torquewright::actuator
