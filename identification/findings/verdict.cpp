// SPDX-License-Identifier: Apache-2.0
#include "identification/findings/verdict.hpp"

#include <algorithm>

namespace torquewright::identification {

Verdict verdict_of(const EquationResult& result, bool is_searched) {
  if (!result.not_one_rig.empty()) return Verdict::kCannotTell;
  if (!is_searched || result.added.empty()) {
    return result.is_noise_before ? Verdict::kNothingMissing : Verdict::kUnexplained;
  }
  // What no log of such a rig tells apart is no fault of this one.
  const bool is_ambiguous = std::any_of(result.confounded.begin(), result.confounded.end(),
                                        [](const Confounded& group) { return !group.exact; });
  const bool is_refuted = std::any_of(result.added.begin(), result.added.end(),
                                      [](const NamedEffect& each) { return each.is_refuted; });
  if (is_ambiguous || is_refuted) return Verdict::kCannotTell;
  const bool is_all = result.is_noise_after && !result.has_tentative;
  return is_all ? Verdict::kExplained : Verdict::kPartlyExplained;
}

}  // namespace torquewright::identification
