// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace torquewright::optimization {

/// How a search for a local optimum ended.
enum class NonlinearStatus {
  kSolved,      ///< First-order conditions hold to the tolerance.
  kAcceptable,  ///< They hold to a hundred times the tolerance and would not get better.
  /// The search ended where no step makes the violation less. This proves nothing about other
  /// places.
  kLocallyInfeasible,
  kIterationLimit,
  kTimeLimit,
  kInterrupted,
  kDiverged,     ///< The unknowns grew without bound.
  kStalled,      ///< Steps became too small, or restoration failed.
  kBadNumbers,   ///< A row or a derivative is not finite.
  kOverdefined,  ///< More equations than unknowns.
};
std::string_view name_of(NonlinearStatus status);

}  // namespace torquewright::optimization
