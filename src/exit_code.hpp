// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace torquewright::cli {

/// What a command says to whoever called it. docs: README, "Exit codes".
enum class ExitCode {
  kPasses = 0,
  kFails = 1,  ///< Infeasible, or a check fails.
  kBadInput = 2,
  kUndecided = 3,  ///< A limit was reached, or the data cannot tell.
};

}  // namespace torquewright::cli
