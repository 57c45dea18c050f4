// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "actuator/drive_check/report.hpp"
#include "src/exit_code.hpp"

namespace torquewright::cli {

/// What a check says to whoever called it.
ExitCode verdict_code(actuator::Verdict verdict);

}  // namespace torquewright::cli
