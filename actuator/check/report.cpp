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

bool fails(const Reading& reading) {
  if (reading.clipped_samples > 0) return true;
  return reading.winding && !(reading.winding->peak_K <= reading.winding->limit_K);
}

}  // namespace torquewright::actuator
