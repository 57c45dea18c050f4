// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace torquewright::cli {

/// What to say where `ulimit -s` leaves less than the program needs; empty: it is enough. Whoever
/// runs out of stack ends by a signal, in the middle of a search for a plan.
std::string_view stack_complaint();

}  // namespace torquewright::cli
