// SPDX-License-Identifier: Apache-2.0
#include "identification/findings/verdict.hpp"

#include <algorithm>

namespace torquewright::identification {

Verdict verdict_of(const EquationResult& result, bool is_searched) {
  if (!result.not_one_rig.empty()) return Verdict::kCannotTell;
  if (!is_searched || result.added.empty()) {
    return result.is_noise_before ? Verdict::kNothingMissing : Verdict::kUnexplained;
  }
  const bool is_sure =
      std::all_of(result.added.begin(), result.added.end(),
                  [&](const NamedEffect& each) { return is_certain(result, each.effect); });
  if (!is_sure) return Verdict::kCannotTell;
  const bool is_all = result.is_noise_after && !result.has_tentative;
  return is_all ? Verdict::kExplained : Verdict::kPartlyExplained;
}

}  // namespace torquewright::identification
