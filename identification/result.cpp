// SPDX-License-Identifier: Apache-2.0
#include "identification/result.hpp"

namespace torquewright::identification {

std::string_view name_of(EffectFamily family) {
  switch (family) {
    case EffectFamily::kActuator:
      return "actuator";
    case EffectFamily::kRig:
      return "rig";
    case EffectFamily::kLog:
      return "log";
  }
  return "";
}

std::string_view name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::kExplained:
      return "explained";
    case Verdict::kPartlyExplained:
      return "partly_explained";
    case Verdict::kUnexplained:
      return "unexplained";
    case Verdict::kNothingMissing:
      return "nothing_missing";
    case Verdict::kCannotTell:
      return "cannot_tell";
  }
  return "";
}

}  // namespace torquewright::identification
