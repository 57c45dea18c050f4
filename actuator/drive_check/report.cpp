// SPDX-License-Identifier: Apache-2.0
#include "actuator/drive_check/report.hpp"

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

std::optional<double> ContinuousUse::margin() const {
  if (!limit) return std::nullopt;
  return *limit - rms;
}

bool ContinuousUse::is_passed() const {
  constexpr double kRounding = 1e-9;  // of the limit
  return limit && !(rms <= *limit * (1.0 + kRounding));
}

bool fails(const CheckedInterpretation& interpretation) {
  if (interpretation.clipped_samples > 0) return true;
  if (interpretation.continuous_current.is_passed()) return true;
  if (interpretation.continuous_torque.is_passed()) return true;
  return interpretation.winding &&
         !(interpretation.winding->peak_K <= interpretation.winding->limit_K);
}

}  // namespace torquewright::actuator
