// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/oracles/loop_bench/situation.hpp"

namespace torquewright::oracles::loop {

/// Fits the true law, with a delay of the current, to the log by least squares from the truth on:
/// fills the sizes of the hidden laws and whether the log holds them.
void recover(Made& made);

}  // namespace torquewright::oracles::loop
