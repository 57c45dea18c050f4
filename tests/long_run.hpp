// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdlib>

namespace torquewright::test {

/// Whether studies run that take half a minute each and repeat what a quicker test asks of a
/// smaller problem: where TORQUEWRIGHT_LONG is set. Others say that they were left out.
inline bool is_long_run() { return std::getenv("TORQUEWRIGHT_LONG") != nullptr; }

inline constexpr const char* kLeftOut = "takes half a minute: TORQUEWRIGHT_LONG=1 runs it";

}  // namespace torquewright::test
