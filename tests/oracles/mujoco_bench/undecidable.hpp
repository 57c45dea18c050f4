// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/oracles/mujoco_bench/completion.hpp"

namespace torquewright::oracles::mujoco_bench {

/// A log whose excitation is poor by design: `accept` has every name that would do.
std::optional<Made> draw_undecidable(Draws& draws, std::uint64_t turn);

}  // namespace torquewright::oracles::mujoco_bench
