// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tests/oracles/loop_bench/draws.hpp"
#include "tests/oracles/loop_bench/situation.hpp"

namespace torquewright::oracles::loop {

/// Laws of which a current that is logged while a flywheel turns one way tells no more than their
/// sum; the drag ones among them are one where it turns at one speed.
std::vector<std::string> names_of_one_way();
std::vector<std::string> names_of_one_speed();

/// Makes a flywheel's situation one in which the hidden law is the same column as others: all runs
/// turn one way, every second situation at one speed.
void draw_undecidable(double scale_Nm, double share_factor, Draws& draws, Situation& it);

}  // namespace torquewright::oracles::loop
