// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace torquewright::cli {

/// Where results state the options that several commands have, before a command's own at 0: which
/// columns and rows are read, and under which conditions the drives work.
constexpr int kInputsPlace = -1;

}  // namespace torquewright::cli
