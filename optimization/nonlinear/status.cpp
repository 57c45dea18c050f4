// SPDX-License-Identifier: Apache-2.0
#include "optimization/nonlinear/status.hpp"

#include <stdexcept>

namespace torquewright::optimization {

std::string_view name_of(NonlinearStatus status) {
  switch (status) {
    case NonlinearStatus::kSolved:
      return "solved";
    case NonlinearStatus::kAcceptable:
      return "acceptable";
    case NonlinearStatus::kLocallyInfeasible:
      return "locally infeasible";
    case NonlinearStatus::kIterationLimit:
      return "iteration limit";
    case NonlinearStatus::kTimeLimit:
      return "time limit";
    case NonlinearStatus::kInterrupted:
      return "interrupted";
    case NonlinearStatus::kDiverged:
      return "diverged";
    case NonlinearStatus::kStalled:
      return "stalled";
    case NonlinearStatus::kBadNumbers:
      return "bad numbers";
    case NonlinearStatus::kOverdefined:
      return "overdefined";
  }
  throw std::invalid_argument("a status of a nonlinear search that is none");
}

}  // namespace torquewright::optimization
