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

bool fails(const CheckedInterpretation& interpretation) {
  if (interpretation.clipped_samples > 0) return true;
  return interpretation.winding &&
         !(interpretation.winding->peak_K <= interpretation.winding->limit_K);
}

}  // namespace torquewright::actuator
