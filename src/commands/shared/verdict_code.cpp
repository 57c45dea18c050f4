// SPDX-License-Identifier: Apache-2.0
#include "src/commands/shared/verdict_code.hpp"

namespace torquewright::cli {

ExitCode verdict_code(actuator::Verdict verdict) {
  switch (verdict) {
    case actuator::Verdict::kPass:
      return ExitCode::kPasses;
    case actuator::Verdict::kFail:
      return ExitCode::kFails;
    case actuator::Verdict::kUndecided:
      break;
  }
  return ExitCode::kUndecided;
}

}  // namespace torquewright::cli
