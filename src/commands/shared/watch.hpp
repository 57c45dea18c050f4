// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "src/exit_code.hpp"

namespace torquewright::cli {

/// Does the work, and again each time that a file that it read changes, until Ctrl-C; returns the
/// last one's code. What the first time refuses is thrown; later it is said, and the next change is
/// waited for.
ExitCode watch(const std::function<ExitCode()>& work);

}  // namespace torquewright::cli
